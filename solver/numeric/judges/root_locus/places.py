"""Points and directions of root loci judged: where branches meet, cross the boundary, leave poles, reach zeros."""

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


def boundary_points(locus: Locus) -> list[tuple[Any, Any]] | None:
    """Return the points of the boundary, not below the real axis, with K > 0, each with its gain.

    None where branches lie on the boundary. They are roots of Im(D N*) on it, a polynomial in ω, on the circle in z.
    """
    product = _on_circle(locus) if locus.discrete else _imaginary_part(locus)
    if not any(abs(c) > NEAR for c in product):
        return None
    while abs(product[-1]) <= NEAR:
        product.pop()
    while product and abs(product[0]) <= NEAR:
        del product[0]
    ends = [MP.mpc(1), MP.mpc(-1)] if locus.discrete else [MP.mpc(0)]
    for end in ends if locus.discrete else []:
        product = _without(product, end)
    roots = MP.polyroots(product, maxsteps=1000, extraprec=1000) if len(product) > 1 else []
    found: list[tuple[Any, Any]] = []
    for point in [*ends, *(each for root in roots for each in _placed_on_boundary(root, discrete=locus.discrete))]:
        gain = locus.gain(point)
        new = all(abs(point - other) > MP.sqrt(NEAR) for other, _ in found)
        if new and NEAR < MP.re(gain) < MP.inf and abs(MP.im(gain)) < MP.sqrt(NEAR) * (1 + abs(gain)):
            found.append((point, MP.re(gain)))
    return found


def _placed_on_boundary(root: Any, *, discrete: bool) -> list[Any]:
    """The point of a root of that polynomial, if it lies on the boundary and not below the real axis."""
    if not discrete:
        real = abs(MP.im(root)) < NEAR * (1 + abs(root)) and MP.re(root) >= 0
        return [MP.mpc(0, MP.re(root))] if real else []
    on = abs(abs(root) - 1) < NEAR and MP.im(root) > 0
    return [root / abs(root)] if on else []


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


def _on_circle(locus: Locus) -> list[Any]:
    """The coefficients of zⁿ(D(z) N(1/z) − D(1/z) N(z)), highest power first; n is the larger degree."""
    D, N = (list(reversed(p)) for p in (locus.denominator, locus.numerator))
    n = max(len(D), len(N)) - 1
    total = [MP.mpf(0)] * (2 * n + 1)
    for i, a in enumerate(D):
        for k, b in enumerate(N):
            total[n + i - k] += a * b
            total[n - i + k] -= a * b
    return total[::-1]


def _without(p: list[Any], root: Any) -> list[Any]:
    """A polynomial divided by all factors of a real root."""
    x = MP.re(root)
    while len(p) > 1 and abs(MP.polyval(p, x)) < NEAR * sum(map(abs, p)):
        rest = p[:1]
        for c in p[1:-1]:
            rest.append(c + x * rest[-1])
        p = rest
    return p


ALIKE = 0.05
"""Frequencies ω and −ω' are meant as one pair where they differ by no more, relatively; both are judged."""


def crossings_residual(locus: Locus, points: Sequence[Any] | None, gains: Sequence[Any] | None) -> float:
    """Return how far points are from those where branches meet the boundary for K > 0, and gains from theirs.

    Points are both of each pair, on the axis also frequencies ω or ±ω; a gain counts once for a pair, or for each.
    """
    wanted = boundary_points(locus)
    if wanted is None:  # whole branches lie on the boundary; it is reached at its real points only
        ends = [MP.mpc(1), MP.mpc(-1)] if locus.discrete else [MP.mpc(0)]
        reached = [(end, MP.re(locus.gain(end))) for end in ends]
        wanted = [pair for pair in reached if NEAR < pair[1] < MP.inf] if points or gains else []
    worst = 0.0
    if points is not None:
        sides = _sides([number(each) for each in points], discrete=locus.discrete)
        if sides is None:
            return float("inf")
        worst = max(_matched([(point, None) for point in side], wanted) for side in sides)
    if gains is not None:
        of_pairs = [each for each in wanted if MP.im(each[0]) > NEAR]
        wanted = [*wanted, *of_pairs] if len(gains) == len(wanted) + len(of_pairs) else wanted
        worst = max(worst, _matched([(None, number(each)) for each in gains], wanted))
    return worst


def _sides(points: Sequence[Any], *, discrete: bool) -> tuple[list[Any], list[Any]] | None:
    """The points above the real axis, those below mirrored, each with the real ones; None where one is off the axis.

    On the axis a real number is a frequency, for both points ±jω, or one of both, ω and −ω.
    """
    upper = [each for each in points if each.imag > NEAR]
    lower = [MP.conj(each) for each in points if each.imag < -NEAR]
    real = [MP.mpc(each.real) for each in points if abs(each.imag) <= NEAR]
    if discrete:
        return upper + real, lower + real
    off = any(abs(each.real) > NEAR * abs(each) for each in (*upper, *lower))
    rising = [each.real for each in real if each.real >= 0]
    mirrored, lone = list(rising), []
    for each in (-each.real for each in real if each.real < 0):
        i = next((i for i, other in enumerate(rising) if abs(other - each) <= ALIKE * each), None)
        if i is None:
            lone.append(-each)
        else:
            mirrored[i] = each
    turned, back = ([MP.mpc(0, each) for each in (*side, *lone)] for side in (rising, mirrored))
    return None if off else (upper + turned, lower + back)


def directions_residual(locus: Locus, angles: Sequence[Any], *, poles: bool) -> float:
    """Return how far angles are from those in which branches leave poles (reach zeros) above the real axis.

    At a distance of 10^−FAR, −D/N times that distance to the power of the multiplicity m (of a zero divided by it)
    tells the m directions in which it is positive. Twice as many angles are those of the poles below the axis too.
    """
    wanted: list[Any] = []
    for root, m in locus.poles if poles else locus.zeros:
        if MP.im(root) > NEAR:
            near = root + MP.mpf(10) ** -FAR
            turn = MP.degrees(MP.arg(locus.gain_by_factors(near)))
            wanted += [((-turn if poles else turn) + 360 * q) / m for q in range(m)]
    found = [number(each) for each in angles]
    if len(found) == 2 * len(wanted):  # those of the mirror images too
        wanted += [-each for each in wanted]
    if len(found) != len(wanted):
        return float("inf")
    worst = 0.0
    for each in found:
        best = min(range(len(wanted)), key=lambda i: apart(wanted[i], each))
        worst = max(worst, float(apart(wanted[best], each) / max(1, abs(each))))
        del wanted[best]
    return worst
