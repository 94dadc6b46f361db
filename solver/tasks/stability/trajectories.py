"""The figure of a phase portrait: trajectories from the exact e^{At}, lines of eigenvectors, arrows."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation.figures import Curve, Mark, Plot
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.words import Phrase

if TYPE_CHECKING:
    from collections.abc import Iterator

    from sympy import Expr, ImmutableMatrix, Symbol

EDGE = ((1, 0), (1, "1/2"), (1, 1), ("1/2", 1), (0, 1), ("-1/2", 1), (-1, 1), (-1, "1/2"))
"""Half of the points on the edge of the square from which motions start; the others lie opposite."""

SAMPLES = 240
TURNS = 4
ROUND = 5
"""Ellipses longer than this are drawn with a scale of its own for each axis."""


def portrait_of(A: ImmutableMatrix, Phi: ImmutableMatrix, t: Symbol, kind: str) -> Plot:
    """The phase portrait of x' = A x (2×2, numbers); each curve runs over u from 0 to 1."""
    u = sp.Symbol("u")
    curves = [*eigenvector_lines(A, u), *_trajectories(A, Phi, t, u, kind)]
    return Plot(
        Phrase("Phase portrait: {kind}", kind=kind),
        "x_{1}",
        "x_{2}",
        u,
        sp.Integer(0),
        sp.Integer(1),
        tuple(curves),
        marks=(Mark(sp.Integer(0), sp.Integer(0)),),
        equal=_round(A),
    )


def eigenvector_lines(A: ImmutableMatrix, u: Symbol) -> Iterator[Curve]:
    """The lines through the origin along real eigenvectors."""
    structure = exact.eigenstructure(A)
    vectors = [(space.root.value, chain[0]) for space in structure.eigenspaces for chain in space.chains]
    if len(vectors) == 2 and vectors[0][0] == vectors[1][0]:
        return  # every line is one
    for number, (value, v) in enumerate(vectors, 1):
        if not value.has(sp.I):
            size = max(abs(sp.N(entry)) for entry in v.flat())
            x, y = (entry * (2 * u - 1) / _rational(size) * sp.Rational(5, 4) for entry in v.flat())
            yield Curve(y, rf"\nu_{{{number}}}", x, style="dashed")


def _trajectories(A: ImmutableMatrix, Phi: ImmutableMatrix, t: Symbol, u: Symbol, kind: str) -> Iterator[Curve]:
    for x0 in _around_saddle(A) if kind == "saddle" else _starts(kind):
        x = sp.ImmutableMatrix(Phi * x0)
        if x == x0:  # an equilibrium
            continue
        first, last = _times(A, x, t, kind)
        if first == last:
            continue
        moved = x.xreplace({t: first + (last - first) * u})
        yield Curve(moved[1, 0], "", moved[0, 0], style="arrow")


def _starts(kind: str) -> list[ImmutableMatrix]:
    """Where motions pass: the edge of a square; rings for motions that neither begin nor end at the origin."""
    edge = [sp.ImmutableMatrix([sp.Rational(a), sp.Rational(b)]) for a, b in EDGE]
    edge += [sp.ImmutableMatrix(-x) for x in edge]
    if kind == "center":
        return [sp.ImmutableMatrix([sp.Rational(i, 4), 0]) for i in range(1, 5)]
    if kind.endswith("focus"):
        return edge[::2]
    if kind == "shear":
        return [sp.ImmutableMatrix(x * scale) for x in edge for scale in (sp.Rational(1, 3), sp.Rational(2, 3))]
    return edge


def _around_saddle(A: ImmutableMatrix) -> list[ImmutableMatrix]:
    """The tops of the hyperbolas, half way between the lines of the eigenvectors, and points on these lines."""
    vectors = [chain[0] for space in exact.eigenstructure(A).eigenspaces for chain in space.chains]
    v, w = (each / _rational(max(abs(sp.N(entry)) for entry in each.flat())) for each in vectors)
    tops = [
        scale * (v + sign * w)
        for scale in (sp.Rational(1, 8), sp.Rational(1, 4), sp.Rational(2, 5))
        for sign in (1, -1)
    ]
    along = [v / 2, w / 2]
    return [sp.ImmutableMatrix(sign * x) for x in [*tops, *along] for sign in (1, -1)]


def _round(A: ImmutableMatrix) -> bool:
    """Whether trajectories fill the plane well enough to be drawn with equal scales."""
    a, b = (abs(float(sp.N(entry))) for entry in (A[0, 1], A[1, 0]))
    turning = exact.spectrum(A).roots[0].value.has(sp.I)
    return not turning or ROUND**-2 < a / b < ROUND**2


def _times(A: ImmutableMatrix, x: ImmutableMatrix, t: Symbol, kind: str) -> tuple[Expr, Expr]:
    """From when to when a motion is shown: until it is near the origin, round once, or out of the square."""
    values = [complex(sp.N(value)) for value in exact.spectrum(A).eigenvalues]
    if kind == "center":
        return sp.Integer(0), _rational(2 * sp.pi.evalf() / abs(values[0].imag))
    rates = [abs(value.real) for value in values if value.real]
    turning = abs(values[0].imag)
    longest = 5 / min(rates) if rates else 4 / max(abs(float(sp.N(entry))) for entry in A.flat())
    if turning:
        longest = min(longest, TURNS * 6.2832 / turning)
    if kind in ("saddle", "shear"):
        return _rational(-_until_out(x, t, -longest)), _rational(_until_out(x, t, longest))
    grows = any(value.real > 0 for value in values)
    return (_rational(-longest), sp.Integer(0)) if grows else (sp.Integer(0), _rational(longest))


def _until_out(x: ImmutableMatrix, t: Symbol, longest: float) -> float:
    """How long, forward or backward, the motion stays in the square |x₁|, |x₂| ≤ 1."""
    times = [longest * i / SAMPLES for i in range(SAMPLES + 1)]
    sizes = [abs(numeric.values_at(entry, t, sp_array(times))) for entry in x.flat()]
    inside = [time for time, a, b in zip(times, *sizes, strict=True) if max(a, b) > 1]
    return abs(inside[0] if inside else longest)


def sp_array(times: list[float]) -> Any:
    """The times as numpy's array."""
    from numpy import array  # noqa: PLC0415 - task files are importable without numpy

    return array(times)


def _rational(x: Any) -> Expr:
    """A rational number near x, for the exact expressions of curves."""
    return sp.Rational(round(float(x) * 10**6), 10**6)
