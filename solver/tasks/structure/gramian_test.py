"""The Gramian: over an infinite time from its Lyapunov equation, over a finite one from the integral or the sum."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.arithmetic.determinants import leading_minors
from solver.arithmetic.equations import eliminated
from solver.arithmetic.exactness import where_exact
from solver.arithmetic.integrals import integrated
from solver.arithmetic.products import multiplied
from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, exponential, power, product, total
from solver.stated.calculus import integral
from solver.stated.lists import summation
from solver.stated.matrices import determinant, rank, transpose
from solver.tasks.linear_algebra.eigenstructure import eigenvalues_of
from solver.tasks.structure.pairs import Pair
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

LISTED = 6
"""A sum of more terms is not written out."""

MOST_EQUATIONS = 10
"""More linear equations than this are not written out."""


@lemma("gramian_test")
def infinite_gramian_of(pair: Pair) -> Derivation[ImmutableMatrix]:
    """A W + W Aᵀ = −B Bᵀ (dual: with Aᵀ and Cᵀ; discrete: A W Aᵀ − W = −B Bᵀ), for a stable A only."""
    yield from eigenvalues_of(pair.A)
    where = exact.location(pair.A, discrete=pair.discrete)
    outside = [each.root.value for each in where.placed if each.position in (0, 1)]
    undecided = [each.root.value for each in where.placed if each.position is None]
    yield Step(
        "existence",
        unclaimed="the eigenvalues are checked above",
        outside=outside,
        undecided=undecided,
        dual=pair.dual,
        discrete=pair.discrete,
    )
    if outside:
        raise Unsolved("gramian/grows_without_bound", outside=outside, discrete=pair.discrete)
    Q = exact.multiply(pair.G, pair.G.T)
    W = exact.lyapunov(pair.F, Q, dual=True, discrete=pair.discrete)
    asked = _equation(pair, Q)
    yield asked
    F, Ft = (transpose(pair.A), pair.A) if pair.dual else (pair.A, transpose(pair.A))
    minus = sp.ImmutableMatrix(-Q)
    left = difference(product(F, W, Ft), W) if pair.discrete else total(product(F, W), product(W, Ft))
    yield Step(
        "solution",
        claims={"equation": Claim(left, minus, "Lyapunov equation of the Gramian")},
        steps=_solved(asked, W),
        W=W,
        dual=pair.dual,
        discrete=pair.discrete,
    )
    yield _definite(pair, W)
    return W


@where_exact
def _solved(asked: Step, W: ImmutableMatrix) -> tuple[Step, ...]:
    """The elimination, where the equations are written out."""
    n, unknown, equations = W.rows, asked.values["unknown"], asked.values["equations"]
    places = [(i, j) for i in range(n) for j in range(i, n)]
    return eliminated(equations, [unknown[at] for at in places], [W[at] for at in places]) if equations else ()


def _equation(pair: Pair, Q: ImmutableMatrix) -> Step:
    """The integral, the equation it satisfies, and the linear equations for the entries of W."""
    n = pair.n
    names = {(i, j): sp.Symbol(f"w_{i + 1}{j + 1}") for i in range(n) for j in range(i, n)}
    unknown = sp.Matrix(n, n, lambda i, j: names[min(i, j), max(i, j)])
    left = pair.F * unknown * pair.F.T - unknown if pair.discrete else pair.F * unknown + unknown * pair.F.T
    equations = [(sp.expand(left[i, j]), -Q[i, j]) for i, j in names]
    square = product(transpose(pair.other), pair.other) if pair.dual else product(pair.other, transpose(pair.other))
    return Step(
        "equation",
        claims={"square": Claim(square, Q, "right side of the Lyapunov equation")},
        steps=_sides(pair, sp.ImmutableMatrix(unknown)) if len(equations) <= MOST_EQUATIONS else (),
        equations=equations if len(equations) <= MOST_EQUATIONS else [],
        count=len(equations),
        unknown=sp.ImmutableMatrix(unknown),
        dual=pair.dual,
        discrete=pair.discrete,
    )


@where_exact
def _sides(pair: Pair, unknown: ImmutableMatrix) -> tuple[Step, ...]:
    """The products of the left side: of the two that are transposes of each other only one."""
    FW = sp.ImmutableMatrix((pair.F * unknown).applyfunc(sp.expand))
    lines = multiplied(pair.F, unknown, FW, "A^{T}W_{o}" if pair.dual else "AW_{c}")
    if pair.discrete:
        lines += multiplied(FW, sp.ImmutableMatrix(pair.F.T), sp.ImmutableMatrix((FW * pair.F.T).applyfunc(sp.expand)))
    return lines


def _definite(pair: Pair, W: ImmutableMatrix) -> Step:
    """The leading principal minors where all are positive; the rank of W in any case."""
    r = exact.rank(W)
    claims = {"rank": Claim(rank(W), sp.Integer(r), "rank of the Gramian")}
    if r == pair.n:
        for k in range(1, pair.n + 1):
            minor = sp.ImmutableMatrix(W[:k, :k])
            value = sp.factor(exact.determinant(minor))
            claims[f"minor{k}"] = Claim(determinant(minor), value, Phrase("leading minor {k} of the Gramian", k=k))
    minors = [claims[f"minor{k}"].right for k in range(1, pair.n + 1)] if r == pair.n else []
    blocks = [sp.ImmutableMatrix(W[:k, :k]) for k in range(1, len(minors) + 1)]
    return Step(
        "definite",
        claims=claims,
        steps=leading_minors(blocks, minors),
        W=W,
        minors=minors,
        r=r,
        n=pair.n,
        dual=pair.dual,
    )


@lemma("gramian_test")
def finite_gramian_of(pair: Pair, horizon: Any) -> Derivation[ImmutableMatrix]:
    """∫₀ᵀ e^{At} B Bᵀ e^{Aᵀt} dt (dual: e^{Aᵀt} Cᵀ C e^{At}); discrete: the sum of as many terms."""
    if pair.discrete:
        return (yield from _sum_of(pair, int(horizon)))
    t = sp.Symbol("t")
    response = exact.input_response(pair.F, pair.G, t)
    moved = pair.turned(response.matrix)
    e = exponential(product(pair.A, t))
    motion = product(pair.other, e) if pair.dual else product(e, pair.other)
    yield Step("response", claims={"motion": Claim(motion, moved, "response of the modes")}, dual=pair.dual)
    W = exact.finite_gramian(pair.F, pair.G, horizon)
    squared = product(transpose(moved), moved) if pair.dual else product(moved, transpose(moved))
    claim = Claim(integral(squared, t, sp.Integer(0), horizon), W, "integral of the Gramian")
    square = sp.ImmutableMatrix((moved.T * moved if pair.dual else moved * moved.T).applyfunc(sp.expand))
    worked_out = integrated(square, t, sp.Integer(0), horizon, W)
    claims = {"integral": claim, "square": Claim(squared, square, "what is integrated")}
    yield Step("integral", claims=claims, steps=worked_out, horizon=horizon, W=W, dual=pair.dual)
    stacked = pair.turned(response.stacked)
    r = exact.rank(stacked)
    yield Step(
        "independence",
        claims={"rank": Claim(rank(stacked), sp.Integer(r), "rank of the coefficients of the modes")},
        functions=response.functions,
        stacked=stacked,
        r=r,
        n=pair.n,
        dual=pair.dual,
    )
    return W


def _sum_of(pair: Pair, steps: int) -> Derivation[ImmutableMatrix]:
    """Σ_{k<N} Aᵏ B Bᵀ (Aᵀ)ᵏ: written out where it is short."""
    W = exact.discrete_gramian(pair.F, pair.G, steps)
    r = exact.rank(W)
    claims = {"rank": Claim(rank(W), sp.Integer(r), "rank of the Gramian")}
    if steps <= LISTED:
        terms = []
        M = pair.G
        for _ in range(steps):
            shown = pair.turned(M)
            terms.append(product(transpose(shown), shown) if pair.dual else product(shown, transpose(shown)))
            M = exact.multiply(pair.F, M)
        claims["sum"] = Claim(total(*terms), W, "sum of the Gramian")
    else:
        claims["sum"] = Claim(_summation(pair.F, pair.G, sp.Symbol("k"), steps), W, "sum of the Gramian")
    yield Step("sum", claims=claims, count=steps, W=W, listed=steps <= LISTED, r=r, n=pair.n, dual=pair.dual)
    return W


def _summation(F: ImmutableMatrix, G: ImmutableMatrix, k: Any, steps: int) -> Any:
    """Σ_{k<N} Fᵏ G Gᵀ (Fᵀ)ᵏ as stated."""
    term = product(power(F, k), G, transpose(G), power(transpose(F), k))
    return summation(term, k, sp.Integer(0), sp.Integer(steps - 1))
