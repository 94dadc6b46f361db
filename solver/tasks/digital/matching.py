"""Lemma: a transfer function in discrete time by matched poles and zeros."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, exponential, power, product, quotient, total
from solver.stated.calculus import value_at
from solver.stated.matrices import inverse
from solver.tasks.figures import plane, roots
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix


@lemma("matching")
def matched_of(G: Expr, T: Expr, *, states: bool) -> Derivation[Answers]:
    """Poles, zeros and gain of the discrete plant; of one in state space a realization besides."""
    s, z = sp.Symbol("s"), sp.Symbol("z")
    found = exact.matched(G, s, T)
    yield Step("poles", **_mapped("pole {i}", found.poles, T))
    infinite, below = max(found.excess, 0), found.at_minus_one
    yield Step("zeros", **_mapped("zero {i}", found.zeros, T), infinite=infinite, at_minus_one=below)
    yield _gain(G, found, T)
    whole = found.expression(z)
    yield Step("matched", unclaimed="poles, zeros and gain put together", G_d=whole, z=z, figures=_figure(found, T))
    if not states:
        return Answers(G=whole)
    A, B, C, D = _companion(*found.coefficients())
    pencil = difference(product(z, sp.ImmutableMatrix(sp.eye(A.rows))), A)
    claim = Claim(total(product(C, inverse(pencil), B), D), whole, "the realization")
    yield Step("realized", claims={"G": claim}, A_d=A, B_d=B, C_d=C, D_d=D)
    return Answers(A=A, B=B, C=C, D=D, G=whole)


def _companion(above: Sequence[Expr], below: Sequence[Expr]) -> tuple[ImmutableMatrix, ...]:
    """The controllable canonical form of a quotient of polynomials by their coefficients, the highest first."""
    n = len(below) - 1
    a, b = below[:0:-1], [*([sp.S.Zero] * (n + 1 - len(above))), *above]
    through = b[0]
    A = sp.Matrix(n, n, lambda i, j: -a[j] if i == n - 1 else sp.Integer(int(j == i + 1)))
    C = [sp.expand(c - through * d, power_exp=False) for c, d in zip(b[:0:-1], a, strict=True)]
    last = [sp.Integer(int(i == n - 1)) for i in range(n)]
    return (sp.ImmutableMatrix(A), sp.ImmutableMatrix(n, 1, last), sp.ImmutableMatrix([C]),
            sp.ImmutableMatrix([[through]]))  # fmt: skip


def _mapped(says: str, found: Sequence[exact.MappedRoot], T: Expr) -> dict[str, Any]:
    """Where the poles, or zeros, go: the facts of a step; each is called as the pattern `says`."""
    z = sp.Symbol("z")
    claims = {}
    for i, each in enumerate(found, 1):
        name = Phrase(says, i=i)
        image, p = exponential(product(each.root, T)), each.polynomial(z)
        if each.pair:
            mirror = exponential(product(each.mirror, T))
            claims[f"root{i}"] = Claim(product(difference(z, image), difference(z, mirror)), p, name)
        else:
            claims[f"root{i}"] = Claim(image, each.base.radius, name)
    unclaimed = "" if claims else "there are none"
    return {"claims": claims, "unclaimed": unclaimed, "found": list(found), "T": T, "z": z}


def _gain(G: Expr, found: exact.Matched, T: Expr) -> Step:
    """What the gain must be for both to agree at low frequencies."""
    s, z, r = sp.Symbol("s"), sp.Symbol("z"), found.order
    cleared = sp.cancel(s**r * G)
    rest = found.cleared(z)
    scale = power(T, r) if r and T != 1 else None
    unscaled = value_at(rest, z, sp.S.One)
    claims = {
        "wanted": Claim(value_at(cleared, s, sp.S.Zero), found.wanted, "the continuous plant at low frequencies"),
        "unscaled": Claim(unscaled if scale is None else quotient(unscaled, scale), found.unscaled,
                          "the fraction without its gain"),
        "gain": Claim(quotient(found.wanted, found.unscaled), found.gain, "the gain"),
    }  # fmt: skip
    return Step("gain", claims=claims, order=r, T=T, z=z, cleared=cleared, rest=rest, K=found.gain)


def _figure(found: exact.Matched, T: Expr) -> Any:
    """Poles and zeros of the discrete plant, where all is numbers."""
    if T.free_symbols or any(each.root.free_symbols for each in (*found.poles, *found.zeros)):
        return ()
    sets = [[sp.exp(root * T) for each in side for root in _both(each) for _ in range(each.multiplicity)]
            for side in (found.poles, found.zeros)]  # fmt: skip
    sets[1] += [sp.S.NegativeOne] * found.at_minus_one
    return plane("Poles and zeros of the discrete plant", roots("poles", sets[0]),
                 roots("zeros", sets[1], "ring") if sets[1] else None, discrete=True)  # fmt: skip


def _both(each: exact.MappedRoot) -> list[Expr]:
    return [each.root] if each.mirror is None else [each.root, each.mirror]
