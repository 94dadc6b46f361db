"""What is said of crossings of a loop, judged by its values: lists, directions, equations, half turns at infinity."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import mpmath
import numpy as np
import sympy as sp

from solver.numeric.judges.frequency.loops import WORKING, NumericLoop
from solver.numeric.judges.frequency.roots import top_between

NEAR = mpmath.mpf(10) ** -18
SAMPLES = ("0.37", "1.91", "5.3", "17.7")
BESIDE = mpmath.mpf(10) ** -6


def decimal(value: Any) -> Any:
    """A number with 40 digits."""
    return mpmath.mpmathify(sp.N(value, WORKING))


def list_residual(wanted: Sequence[Any], found: Sequence[Any]) -> float:
    """The largest relative difference of two lists of numbers, item by item; infinite where their lengths differ."""
    if len(wanted) != len(found):
        return float("inf")
    pairs = [(each, decimal(own)) for each, own in zip(wanted, found, strict=True)]
    return max((float(abs(a - b) / (abs(a) or 1)) for a, b in pairs), default=0.0)


def is_real(loop: NumericLoop) -> bool:
    """Whether L(jω) is real at several frequencies."""
    values = [loop.value(mpmath.mpf(w)) for w in SAMPLES]
    return all(abs(mpmath.im(value)) < NEAR * abs(value) for value in values)


def is_everywhere(loop: NumericLoop, level: Any) -> bool:
    """Whether |L(jω)| has a value at several frequencies."""
    return all(abs(abs(loop.value(mpmath.mpf(w))) - decimal(level)) < NEAR for w in SAMPLES)


def _ratios(loop: NumericLoop, p: Any, w: Any, wanted: Any) -> bool:
    """Whether a polynomial in ω², or cos ωT, is a multiple of what is wanted at several frequencies."""
    at = [mpmath.mpf(omega) for omega in SAMPLES]
    found = [decimal(p.subs(w, sp.Float(loop.place(omega), WORKING))) / wanted(omega) for omega in at]
    return all(abs(each - found[0]) < NEAR * abs(found[0]) for each in found)


def _parts(loop: NumericLoop, omega: Any) -> tuple[Any, Any]:
    s = loop.point(omega)
    return mpmath.polyval(loop.N, s), mpmath.polyval(loop.D, s)


def is_size_equation(loop: NumericLoop, p: Any, w: Any, level: Any) -> bool:
    """Whether p at ω², or cos ωT, is a multiple of |N|² − level² |D|²."""

    def wanted(omega: Any) -> Any:
        above, below = _parts(loop, omega)
        return abs(above) ** 2 - decimal(level) ** 2 * abs(below) ** 2

    with mpmath.workdps(WORKING):
        return _ratios(loop, p, w, wanted)


def is_slope_equation(loop: NumericLoop, p: Any, w: Any) -> bool:
    """Whether ω p(ω²), or sin ωT p(cos ωT), is a multiple of the imaginary part of N times the conjugate of D."""

    def wanted(omega: Any) -> Any:
        above, below = _parts(loop, omega)
        return mpmath.im(above * mpmath.conj(below)) / loop.unit(omega)

    with mpmath.workdps(WORKING):
        return _ratios(loop, p, w, wanted)


def fits(loop: NumericLoop, omega: Any, square: Any, magnitude: Any, phase: Any, size: Any) -> bool:
    """Whether ω² (cos ωT), |L| and the phase in degrees, in (−180, 180], belong to a frequency; |L| must be `size`."""
    with mpmath.workdps(WORKING):
        at = decimal(omega)
        value = loop.value(at) if at else loop.at_rest
        turned = mpmath.degrees(mpmath.arg(-value)) - decimal(phase) - 180
        return bool(
            abs(loop.place(at) - decimal(square)) < NEAR * (1 + at**2)
            and abs(abs(value) - decimal(magnitude)) < NEAR * (1 + abs(value))
            and abs(turned - 360 * mpmath.nint(turned / 360)) < NEAR * 1000
            and -180 < decimal(phase) <= 180
            and (size is None or abs(size - decimal(magnitude)) < NEAR * (1 + size))
        )


def has_phase(loop: NumericLoop, omega: Any, degrees: Any) -> bool:
    """Whether the phase at a frequency is a value in degrees, up to full turns."""
    with mpmath.workdps(WORKING):
        turned = mpmath.degrees(mpmath.arg(loop.value(decimal(omega)))) - decimal(degrees)
        return bool(abs(turned - 360 * mpmath.nint(turned / 360)) < NEAR * 1000)


def direction(loop: NumericLoop, omega: Any) -> int:
    """How L passes the negative real axis as ω rises: 1 from below to above, −1 the other way, 0 if it touches it."""
    with mpmath.workdps(WORKING):
        at = decimal(omega)
        if at == 0:
            return int(mpmath.sign(mpmath.im(loop.value(BESIDE))))
        before, after = (mpmath.im(loop.value(at * each)) for each in (1 - BESIDE, 1 + BESIDE))
        return int(mpmath.sign(after - before)) if before * after < 0 else 0


def are_half_turns(
    numerator: Any, denominator: Any, s: Any, found: Sequence[tuple[Any, int]], sample_time: Any = None
) -> bool:
    """Whether there is an arc for each pole on the axis (circle), with as many half turns as its multiplicity."""
    if sample_time is not None:
        return _are_half_turns_on_circle(numerator, denominator, s, found, float(sample_time))
    _, below = sp.fraction(sp.cancel(numerator / denominator))
    listed = [complex(c) for c in sp.Poly(below, s).all_coeffs()]
    roots = np.roots(listed)
    on = [z for z in roots if abs(z.real) < 1e-4 * (1 + abs(z)) and z.imag >= -1e-4]
    if sum(count for _, count in found) != len([z for z in on if _vanishes(below, s, z)]):
        return False
    return all(any(abs(z.imag - float(omega)) < 1e-3 * (1 + abs(z)) for z in on) for omega, _ in found)


def _are_half_turns_on_circle(N: Any, D: Any, z: Any, found: Sequence[tuple[Any, int]], period: float) -> bool:
    """The poles on the circle are those whose reciprocals are poles too, and of size one."""
    _, below = sp.fraction(sp.cancel(N / D))
    p = sp.Poly(below, z)
    shared = p.gcd(sp.Poly(list(reversed(p.all_coeffs())), z)) if p.degree() else p
    on = [
        (abs(np.angle(root)), times)
        for part, times in (shared.sqf_list()[1] if shared.degree() else ())
        for root in np.roots([complex(c) for c in part.all_coeffs()])
        if abs(abs(root) - 1) < 1e-7 and np.angle(root) > -1e-9
    ]
    ours = sorted((float(omega) * period, count) for omega, count in found)
    wanted = sorted(on)
    return len(ours) == len(wanted) and all(
        abs(a - b) < 1e-6 and m == n for (a, m), (b, n) in zip(ours, wanted, strict=True)
    )


def peak_of(loop: NumericLoop) -> Any:
    """The frequency of the largest magnitude; None where it is largest at an end."""
    omega, sizes = loop.sampled
    i = int(np.argmax(sizes))
    if loop.last is not None and i == len(omega) - 1:
        return loop.last
    if i in (0, len(omega) - 1):
        return None
    with mpmath.workdps(WORKING):
        a = top_between(omega, i, loop.value)
        top = abs(loop.value(a))
        ends = [abs(loop.at_rest), abs(loop.value(mpmath.mpf(omega[-1])))]
        return a if top > max(ends) * (1 + mpmath.mpf(10) ** -11) else None


def has_no_peak(loop: NumericLoop) -> bool:
    """Whether the magnitude grows without bound somewhere, or does not change."""
    _, sizes = loop.sampled
    return bool(
        np.max(sizes) > 1e3 * np.median(sizes) or not np.all(np.isfinite(sizes)) or np.ptp(sizes) < 1e-9 * np.max(sizes)
    )


def are_flat(loop: NumericLoop, found: Sequence[Any], p: Any, w: Any) -> bool:
    """Whether the slope of |L| is zero at these frequencies, which are all those at which a polynomial is zero."""
    with mpmath.workdps(WORKING):
        for omega in map(decimal, found):
            step = omega * mpmath.mpf(10) ** -10
            rise = abs(loop.value(omega + step)) - abs(loop.value(omega - step))
            if abs(rise) > mpmath.mpf(10) ** -15 * abs(loop.value(omega)):
                return False
        listed = [decimal(c) for c in sp.Poly(p, w).all_coeffs()]
        zeros = np.roots([float(c / max(map(abs, listed))) for c in listed])
        positive = [z for z in zeros if loop.is_place(z)]
        distinct = [z for i, z in enumerate(positive) if all(abs(z - other) > 1e-5 * abs(z) for other in positive[:i])]
        return len(distinct) == len(found)


def _vanishes(p: Any, s: Any, z: complex) -> bool:
    """Whether a polynomial is zero where the axis is nearest to a rough root."""
    even, odd = (sp.Poly(part, s) for part in (p + p.subs(s, -s), p - p.subs(s, -s)))
    common = even.gcd(odd)
    if common.degree() <= 0:
        return False
    roots = np.roots([complex(c) for c in common.all_coeffs()])
    return any(abs(z - root) < 1e-2 * (1 + abs(z)) and abs(root.real) < 1e-4 * (1 + abs(root)) for root in roots)


__all__ = [
    "are_flat",
    "are_half_turns",
    "decimal",
    "direction",
    "fits",
    "has_no_peak",
    "has_phase",
    "is_everywhere",
    "is_real",
    "is_size_equation",
    "is_slope_equation",
    "list_residual",
    "peak_of",
]  # fmt: skip
