"""Damping ratio and natural frequency of s² + 2ζω_n s + ω_n² from two specifications of its step response.

settling time c/(ζω_n), c = 4 (2 % band) or 3 (5 %); peak time π/ω_d; rise time (0–100 %) (π − arccos ζ)/ω_d;
overshoot e^{−πζ/√(1−ζ²)}; ω_d = ω_n √(1 − ζ²). Source: Ogata, Modern Control Engineering, section 5-3.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import mpmath
import sympy as sp

from solver.words import Told

DIGITS = 30

SPECIFICATIONS = (
    "overshoot",
    "settling_time",
    "peak_time",
    "rise_time",
    "damping_ratio",
    "natural_frequency",
)
ABOUT_DAMPING = ("damping_ratio", "overshoot")


class Inconsistent(Told):
    """The specifications contradict each other, or do not fix the poles; the reason says why."""


@dataclass(frozen=True)
class SecondOrder:
    """ζ and ω_n, exact where they have a form; `used` are the two specifications they follow from.

    `angle` is arccos ζ where it was found as the root of an equation in decimals, `decay` is ζω_n where a settling
    time gives it exactly; else None.
    """

    zeta: sp.Expr
    omega_n: sp.Expr
    used: tuple[str, str]
    angle: sp.Expr | None = None
    decay: sp.Expr | None = None

    @property
    def sigma(self) -> sp.Expr:
        """The decay rate ζω_n."""
        return self.decay if self.decay is not None else tidied(self.zeta * self.omega_n)

    @property
    def overdamped(self) -> bool:
        """Whether the poles are known to be real."""
        return bool(self.zeta.is_number and self.zeta >= 1)

    @property
    def omega_d(self) -> sp.Expr:
        """ω_n √(1 − ζ²)."""
        if self.zeta.free_symbols or self.omega_n.free_symbols:
            return self.omega_n * complement(self.zeta)
        return tidied(sp.sqrt(tidied(self.omega_n**2 - self.sigma**2)))

    @property
    def coefficients(self) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
        """1, 2ζω_n, ω_n²."""
        return sp.Integer(1), tidied(2 * self.sigma), tidied(self.omega_n**2)

    @property
    def poles(self) -> list[sp.Expr]:
        """−ζω_n ± jω_d; two real poles for ζ ≥ 1."""
        if self.overdamped:
            apart = tidied(sp.sqrt(tidied(self.sigma**2 - self.omega_n**2)))
            return [-self.sigma - apart, -self.sigma + apart]
        return [-self.sigma + sp.I * self.omega_d, -self.sigma - sp.I * self.omega_d]


def second_order(given: Mapping[str, Any], band: sp.Expr | int = 4) -> SecondOrder:
    """Return ζ and ω_n from the specifications by name; `band` is ζω_n times the settling time. Raises Inconsistent."""
    known = {name: sp.Integer(0) + given[name] for name in SPECIFICATIONS if given.get(name) is not None}
    _check_ranges(known)
    pair = _determining(known)
    found = _solve(pair, known, sp.Integer(0) + band)
    _check_damping(found, known)
    for name in set(known) - set(pair):
        if name == "overshoot" and not known[name]:
            continue  # none: that is so for ζ = 1
        value, asked = sp.N(specified(name, found.zeta, found.omega_n, band)), sp.N(known[name])
        if not (value.is_number and asked.is_number) or abs(value / asked - 1) > sp.Rational(1, 100):
            shown = {"value": sp.N(value, 4), "asked": sp.N(asked, 4)}
            raise Inconsistent("second_order/contradiction", pair=pair, name=name, **shown)
    return found


def _check_ranges(known: Mapping[str, sp.Expr]) -> None:
    for name, value in known.items():
        if value.is_number and (value.is_negative if name == "overshoot" else not value.is_positive):
            raise Inconsistent("second_order/not_positive", name=name)
    overshoot = known.get("overshoot")
    if overshoot is not None and overshoot.is_number and overshoot >= 1:
        raise Inconsistent("second_order/large_overshoot")


def _determining(known: Mapping[str, sp.Expr]) -> tuple[str, str]:
    """Return the two specifications to work from: exact ones first, not both about ζ alone."""
    order = ("damping_ratio", "natural_frequency", "settling_time", "peak_time", "overshoot", "rise_time")
    names = [name for name in order if name in known]
    if len(names) < 2:
        raise Inconsistent("second_order/too_few", name=names[0] if names else "")
    if set(names) <= set(ABOUT_DAMPING):
        raise Inconsistent("second_order/only_damping")
    first = names[0]
    second = next(name for name in names[1:] if not {first, name} <= set(ABOUT_DAMPING))
    return first, second


def damping_of_overshoot(overshoot: sp.Expr) -> sp.Expr:
    """ζ = −ln M/√(π² + ln² M), 1 for M = 0; decimals for a number."""
    if overshoot.is_zero:
        return sp.Integer(1)
    log = sp.log(overshoot)
    zeta = -log / sp.sqrt(sp.pi**2 + log**2)
    return sp.N(zeta, DIGITS) if zeta.is_number else zeta


def _solve(pair: tuple[str, str], known: Mapping[str, sp.Expr], band: sp.Expr) -> SecondOrder:
    """Solve the two equations, by the formula that belongs to the pair."""
    names = set(pair)
    if names & set(ABOUT_DAMPING):
        zeta = known["damping_ratio"] if "damping_ratio" in names else damping_of_overshoot(known["overshoot"])
        if zeta.is_number and zeta >= 1 and names & {"peak_time", "rise_time"}:
            raise Inconsistent("second_order/no_peak")
        other = next(name for name in pair if name not in ABOUT_DAMPING)
        decay = tidied(band / known[other]) if other == "settling_time" else None
        return SecondOrder(zeta, _frequency(other, known[other], zeta, band), pair, decay=decay)
    if "natural_frequency" in names:
        return _with_frequency(pair, known, band)
    if names == {"settling_time", "peak_time"}:
        sigma, omega_d = band / known["settling_time"], sp.pi / known["peak_time"]
        omega_n = tidied(sp.sqrt(sigma**2 + omega_d**2))
        return SecondOrder(tidied(sigma / omega_n), omega_n, pair, decay=sigma)
    if names == {"peak_time", "rise_time"}:
        zeta = _short(sp.cos(sp.pi * (1 - known["rise_time"] / known["peak_time"])))
        return SecondOrder(zeta, _frequency("peak_time", known["peak_time"], zeta, band), pair)
    sigma = band / known["settling_time"]
    a = _decimals(sigma * known["rise_time"])
    angle = _angle(lambda phi: a * mpmath.tan(phi) - mpmath.pi + phi)
    return SecondOrder(tidied(sp.cos(angle)), tidied(sigma / sp.cos(angle)), pair, angle, sigma)


def _frequency(name: str, value: sp.Expr, zeta: sp.Expr, band: sp.Expr) -> sp.Expr:
    """ω_n from ζ and one specification that holds ω_n: all times are proportional to 1/ω_n."""
    if name == "natural_frequency":
        return value
    return tidied(specified(name, zeta, sp.Integer(1), band) / value)


def _with_frequency(pair: tuple[str, str], known: Mapping[str, sp.Expr], band: sp.Expr) -> SecondOrder:
    omega_n = known["natural_frequency"]
    other = next(name for name in pair if name != "natural_frequency")
    value = known[other]
    if other == "settling_time":
        return SecondOrder(tidied(band / (omega_n * value)), omega_n, pair)
    if other == "peak_time":
        square = tidied(1 - (sp.pi / (omega_n * value)) ** 2)
        if square.is_number and not square.is_positive:
            raise Inconsistent("second_order/early_peak")
        return SecondOrder(tidied(sp.sqrt(square)), omega_n, pair)
    a = _decimals(omega_n * value)
    if a <= mpmath.pi / 2:
        raise Inconsistent("second_order/early_rise")
    angle = _angle(lambda phi: mpmath.pi - phi - a * mpmath.sin(phi))
    return SecondOrder(tidied(sp.cos(angle)), omega_n, pair, angle)


def _decimals(value: sp.Expr) -> Any:
    """Return a number of mpmath with more digits than are kept."""
    if not value.is_number:
        raise Inconsistent("second_order/no_formula")
    with mpmath.workdps(DIGITS + 10):
        return mpmath.mpmathify(sp.N(value, DIGITS + 10))


def _angle(equation: Callable[[Any], Any]) -> sp.Expr:
    """Return the angle φ = arccos ζ in (0, π/2) that solves the equation, in decimals, by bisection."""
    with mpmath.workdps(DIGITS + 10):
        low, high = mpmath.mpf(10) ** -DIGITS, mpmath.pi / 2 - mpmath.mpf(10) ** -DIGITS
        rising = equation(high) > 0
        for _ in range(4 * DIGITS):
            middle = (low + high) / 2
            low, high = (low, middle) if (equation(middle) > 0) == rising else (middle, high)
        return sp.Float(low, DIGITS)


def specified(name: str, zeta: Any, omega_n: Any, band: Any = 4) -> Any:
    """Return the quantity that a specification names, from ζ and ω_n."""
    root = complement(zeta)
    match name:
        case "overshoot":
            return sp.exp(-sp.pi * zeta / root)
        case "settling_time":
            return band / (zeta * omega_n)
        case "peak_time":
            return sp.pi / (omega_n * root)
        case "rise_time":
            return (sp.pi - sp.acos(zeta)) / (omega_n * root)
        case "damping_ratio":
            return zeta
    return omega_n


def complement(zeta: sp.Expr) -> sp.Expr:
    """√(1 − ζ²), π/√(π² + ln² M) for the ζ of an overshoot M."""
    square = 1 - zeta**2
    if not zeta.free_symbols or not any(abs(power.exp) == sp.S.Half for power in zeta.atoms(sp.Pow)):
        return sp.sqrt(square)
    above, below = sp.fraction(sp.cancel(square))
    return sp.sqrt(square) if above.is_Add else sp.sqrt(above) / sp.sqrt(below)


def _check_damping(found: SecondOrder, known: Mapping[str, sp.Expr]) -> None:
    zeta = found.zeta
    if not zeta.is_number:
        return
    if zeta <= 0:
        raise Inconsistent("second_order/no_damping", pair=found.used)
    without_peak = {"peak_time", "rise_time"} | ({"overshoot"} if known.get("overshoot") else set())
    if zeta >= 1 and set(known) & without_peak:
        raise Inconsistent("second_order/overdamped", pair=found.used)


def tidied(value: sp.Expr) -> sp.Expr:
    """Return a short exact form; decimals where a number holds decimals, logarithms or an arccosine."""
    if value.is_number and value.has(sp.Float, sp.log, sp.acos):
        return sp.N(value, DIGITS)
    if value.is_number or not value.free_symbols:
        return sp.radsimp(sp.expand(value)) if not value.has(sp.pi) else sp.expand(value)
    return sp.factor(value)


def _short(value: sp.Expr) -> sp.Expr:
    """Return a cosine as it stands where its square is rational, else in decimals."""
    return value if not value.is_number or (value**2).is_Rational else sp.N(value, DIGITS)
