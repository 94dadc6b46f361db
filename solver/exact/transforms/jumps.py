"""What inputs do to functions at the time at which they begin: values at 0+, by the series of images at s = ∞.

X(s) = Σ dᵢ sⁱ + Σ x⁽ᵏ⁾(0+)/s^{k+1}, as integration by parts gives; so a division of polynomials gives the values.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from solver.exact.linear_algebra.affine import solve_affine, tidy
from solver.exact.linear_algebra.fields import NotExact
from solver.exact.transforms.images import rational_image
from solver.exact.transforms.operators import Operators, adjugate_and_determinant
from solver.exact.transforms.rules import TransformPiece


@dataclass(frozen=True)
class ActingPiece:
    """What acts from one time T on: functions of the time since T and impulses by inputs, and the values before it."""

    delay: sp.Expr
    functions: tuple[sp.Expr, ...]
    impulses: tuple[sp.Expr, ...]
    images: tuple[sp.Expr, ...]
    first: bool


@dataclass(frozen=True)
class ImpulseBalance:
    """Impulses of one order on both sides of a(D) x = b(D) u: Σ aᵢ Δ(x⁽ᵏ⁾) = `right`; `left` has the pairs (aᵢ, k)."""

    left: tuple[tuple[sp.Expr, int], ...]
    right: sp.Expr


def acting_pieces(inputs: Sequence[Sequence[TransformPiece]], t: sp.Symbol, s: sp.Symbol) -> tuple[ActingPiece, ...]:
    """What acts from each time on, zero first, whether anything acts from there or not."""
    delays = dict.fromkeys([sp.S.Zero, *(piece.delay for pieces in inputs for piece in pieces)])
    found = []
    for delay in delays:
        here = [next((piece for piece in pieces if piece.delay == delay), None) for pieces in inputs]
        found.append(ActingPiece(
            delay,
            tuple(sp.S.Zero if each is None else each.moved for each in here),
            tuple(sp.S.Zero if each is None else each.impulse for each in here),
            tuple(sp.S.Zero if each is None else each.image(t, s) for each in here),
            delay == 0,
        ))  # fmt: skip
    return tuple(found)


def values_after(image: sp.Expr, count: int, s: sp.Symbol) -> tuple[bool, tuple[sp.Expr, ...]]:
    """Whether a rational image has no impulse in it, and x(0+), x'(0+), …, as many as said."""
    if image == 0:
        return True, (sp.S.Zero,) * count
    found = rational_image(image, s)
    numerator, denominator = sp.Poly(found.numerator, s), sp.Poly(found.denominator, s)
    values = []
    rest = numerator.rem(denominator)
    for _ in range(count):
        quotient, rest = (rest * sp.Poly(s, s)).div(denominator)
        values.append(tidy(quotient.as_expr()))
    return not found.direct, tuple(values)


def impulse_balance(
    a: sp.Expr, b: sp.Expr, u: Sequence[sp.Expr], impulse: sp.Expr, s: sp.Symbol
) -> tuple[ImpulseBalance, ...]:
    """The impulses in a(D) x = b(D) u at the start, the highest order first; `u` has u(0+), u'(0+), …."""
    A, B = (list(reversed(sp.Poly(p, s).all_coeffs())) for p in (a, b))
    jumps = {-1: impulse, **dict(enumerate(u))}
    found = []
    for order in range(len(A) - 2, -1, -1):
        left = tuple((A[i], i - 1 - order) for i in range(len(A) - 1, order, -1) if A[i] != 0)
        right = sp.Add(*(B[i] * jumps.get(i - 1 - order, 0) for i in range(order, len(B))))
        found.append(ImpulseBalance(left, tidy(right)))
    return tuple(found)


def right_sides(operators: Operators, piece: ActingPiece, t: sp.Symbol) -> tuple[sp.Expr, ...]:
    """The right side r(t) of det P(D) xⱼ = rⱼ for each unknown after a piece has begun, for smooth functions."""
    s = operators.s
    forced = []
    for i in range(operators.P.rows):
        total = operators.constants[i] if piece.first else sp.S.Zero
        for q, f in zip(operators.Q.row(i), piece.functions, strict=True):
            total += applied(q, f, t, s)
        forced.append(total)
    adjugate, _ = adjugate_and_determinant(operators)
    return tuple(
        sp.expand(sp.Add(*(applied(adjugate[j, i], forced[i], t, s) for i in range(len(forced)))))
        for j in range(len(forced))
    )


def applied(polynomial: sp.Expr, f: sp.Expr, t: sp.Symbol, s: sp.Symbol) -> sp.Expr:
    """p(D) f, D the derivative."""
    if polynomial == 0 or f == 0:
        return sp.S.Zero
    return sp.Add(*(c * sp.diff(f, t, k) for (k,), c in sp.Poly(polynomial, s).terms()))


def fitted_constants(
    general: sp.Expr, constants: Sequence[sp.Symbol], values: Sequence[sp.Expr], t: sp.Symbol
) -> Mapping[sp.Symbol, sp.Expr]:
    """The constants with which a function and its derivatives begin with given values; raises NotExact if none do."""
    sides = [sp.expand(sp.diff(general, t, k).xreplace({t: sp.S.Zero})) for k in range(len(values))]
    M = sp.ImmutableMatrix([[tidy(side.coeff(C, 1)) for C in constants] for side in sides])
    rest = dict.fromkeys(constants, sp.S.Zero)
    right = [tidy(value - side.xreplace(rest)) for value, side in zip(values, sides, strict=True)]
    if M.has(sp.Float):
        return dict(zip(constants, M.LUsolve(sp.Matrix(right)), strict=True))
    solved = solve_affine(M, right, constants)
    if any(solved.residue) or solved.free:
        raise NotExact("differential_equation/singular")
    return {C: tidy(value) for C, value in zip(constants, solved.values, strict=True)}


def jumps_of_inputs(operators: Operators, pieces: Mapping[str, Sequence[TransformPiece]], t: sp.Symbol) -> sp.Expr:
    """Σ q_k (s^{k−1} u(0+) + … + u^{(k−1)}(0+)) of one equation: what the jumps of its inputs at zero bring into it."""
    s, total = operators.s, sp.S.Zero
    for j, name in enumerate(operators.inputs):
        u = next((piece.moved for piece in pieces[name] if piece.delay == 0), sp.S.Zero)
        for (k,), q in sp.Poly(operators.Q[0, j], s).terms():
            starts = (sp.diff(u, t, m).xreplace({t: sp.S.Zero}) for m in range(k))
            total += q * sp.Add(*(s ** (k - 1 - m) * value for m, value in enumerate(starts)))
    return sp.expand(total)
