"""Points and directions of root loci judged: where branches meet, cross the axis, leave poles, reach zeros."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from solver.numeric.judges.root_locus.loci import FAR, MP, NEAR, Locus, apart, number, relative


def meeting_points(locus: Locus) -> list[tuple[Any, Any]]:
    """Return the points where branches meet for K ≥ 0, each with its gain."""
    found = []
    for root, _ in locus.turning:
        gain = locus.gain(root)
        if any(abs(root - zero) < NEAR * (1 + abs(zero)) for zero, _ in locus.zeros):
            continue
        if abs(MP.im(gain)) < NEAR * (1 + abs(gain)) and MP.re(gain) > -NEAR:
            found.append((root, MP.re(gain)))
    return found


def breakaway_residual(locus: Locus, points: Sequence[Any] | None, gains: Sequence[Any] | None) -> float:
    """Return how far points are from those where branches meet, and their gains from theirs, in the same order.

    Of either alone it is judged whether they are these. Multiple poles, where branches meet for K = 0, may be left out.
    """
    wanted = meeting_points(locus)
    at = None if points is None else [number(each) for each in points]
    values = None if gains is None else [number(each) for each in gains]
    if at is not None and values is not None:
        if len(at) != len(values):
            return float("inf")
        return _matched(list(zip(at, values, strict=True)), wanted)
    if at is not None:
        return _matched([(each, None) for each in at], wanted)
    several = {MP.nstr(gain, 25) for _, gain in wanted}
    if len(values or ()) < len(wanted) and len(values or ()) == len(several):  # of a pair the gain is told once
        kept: list[tuple[Any, Any]] = []
        for point, gain in wanted:
            kept += [] if any(abs(gain - each) < NEAR for _, each in kept) else [(point, gain)]
        wanted = kept
    return _matched([(None, each) for each in values or ()], [(None, gain) for _, gain in wanted])


def _matched(found: list[tuple[Any, Any]], wanted: list[tuple[Any, Any]]) -> float:
    """The largest difference of pairs matched one to one; those with the gain zero may be left out, all of them."""
    left, worst = list(wanted), 0.0
    for pair in found:
        sizes = [_differ(pair, other) for other in left]
        if not sizes:
            return float("inf")
        best = min(range(len(left)), key=sizes.__getitem__)
        worst = max(worst, sizes[best])
        del left[best]
    optional = sum(gain is not None and gain <= NEAR for _, gain in wanted)
    return worst if not left or (len(left) == optional and all(gain <= NEAR for _, gain in left)) else float("inf")


def _differ(a: tuple[Any, Any], b: tuple[Any, Any]) -> float:
    return max(relative(x, y) for x, y in zip(a, b, strict=True) if x is not None and y is not None)


def axis_points(locus: Locus) -> list[tuple[Any, Any]] | None:
    """Return the ω ≥ 0 with K(jω) > 0, each with its gain; None where branches lie on the axis.

    They are real roots of Im(D(jω) N(−jω)), which is a polynomial in ω.
    """
    product = _imaginary_part(locus)
    if not any(abs(c) > NEAR for c in product):
        return None
    while abs(product[-1]) <= NEAR:
        product.pop()
    while product and abs(product[0]) <= NEAR:
        del product[0]
    roots = MP.polyroots(product, maxsteps=1000, extraprec=1000) if len(product) > 1 else []
    found: list[tuple[Any, Any]] = []
    for root in [MP.mpf(0), *roots]:
        omega = MP.re(root)
        gain = locus.gain(MP.mpc(0, omega))
        real = abs(MP.im(root)) < NEAR * (1 + abs(root)) and omega >= 0
        new = all(abs(omega - other) > MP.sqrt(NEAR) for other, _ in found)
        if real and new and NEAR < MP.re(gain) < MP.inf and abs(MP.im(gain)) < MP.sqrt(NEAR) * (1 + abs(gain)):
            found.append((omega, MP.re(gain)))
    return found


def _imaginary_part(locus: Locus) -> list[Any]:
    """The coefficients in ω of Im(D(jω) N(−jω)), highest power first."""
    j = MP.mpc(0, 1)
    D, N = ([c * j ** (len(p) - 1 - i) for i, c in enumerate(p)] for p in (locus.denominator, locus.numerator))
    N = [MP.conj(c) for c in N]
    total = [MP.mpc(0)] * (len(D) + len(N) - 1)
    for i, a in enumerate(D):
        for k, b in enumerate(N):
            total[i + k] += a * b
    return [MP.im(c) for c in total]


def crossings_residual(locus: Locus, points: Sequence[Any] | None, gains: Sequence[Any] | None) -> float:
    """Return how far points are from those where branches meet the imaginary axis for K > 0, and gains from theirs.

    Points are ±jω, both, or frequencies ω; a gain counts once for a pair.
    """
    wanted = axis_points(locus)
    if wanted is None:  # whole branches lie on the axis; it is reached at the origin only
        origin = MP.re(locus.gain(MP.mpf(0)))
        wanted = [(MP.mpf(0), origin)] if NEAR < origin < MP.inf and (points or gains) else []
    worst = 0.0
    if points is not None:
        sides = _frequencies([number(each) for each in points])
        if sides is None:
            return float("inf")
        worst = max(_matched([(omega, None) for omega in side], wanted) for side in sides)
    if gains is not None:
        worst = max(worst, _matched([(None, number(each)) for each in gains], wanted))
    return worst


def _frequencies(points: Sequence[Any]) -> tuple[list[Any], list[Any]] | None:
    """The ω of points jω and those of −jω, with what is told as a frequency; None where a point lies off the axis."""
    upper, lower = ([abs(each.imag) for each in points if sign * each.imag > NEAR] for sign in (1, -1))
    real = [each.real for each in points if abs(each.imag) <= NEAR]
    off = any(abs(each.real) > NEAR * abs(each) for each in points if abs(each.imag) > NEAR)
    return None if off else (upper + real, lower + real)


def directions_residual(locus: Locus, angles: Sequence[Any], *, poles: bool) -> float:
    """Return how far angles are from those in which branches leave poles (reach zeros) above the real axis.

    At a distance of 10^−FAR, −D/N times that distance to the power of the multiplicity m (of a zero divided by it)
    tells the m directions in which it is positive.
    """
    wanted: list[Any] = []
    for root, m in locus.poles if poles else locus.zeros:
        if MP.im(root) > NEAR:
            near = root + MP.mpf(10) ** -FAR
            turn = MP.degrees(MP.arg(locus.gain(near)))
            wanted += [((-turn if poles else turn) + 360 * q) / m for q in range(m)]
    found = [number(each) for each in angles]
    if len(found) != len(wanted):
        return float("inf")
    worst = 0.0
    for each in found:
        best = min(range(len(wanted)), key=lambda i: apart(wanted[i], each))
        worst = max(worst, float(apart(wanted[best], each) / max(1, abs(each))))
        del wanted[best]
    return worst
