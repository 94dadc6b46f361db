"""One place decides how a number is shown: as an integer, a fraction or a decimal, and with how many digits."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import sympy as sp
from mpmath.libmp import libmpf

from solver.formula import latex
from solver.formula.building import row
from solver.formula.nodes import Row

if TYPE_CHECKING:
    from solver.problem.model import Display

LONGEST_TYPED = 6
"""Significant digits that a number of a file with decimals keeps, which others are rounded to fewer."""

FIXED_POINT = (-4, 6)
"""Exponents of ten between which a decimal is written without a power of ten: 10⁻⁴ ≤ |x| < 10⁶."""


@dataclass(frozen=True, slots=True)
class NumberFormat:
    """How numbers are shown.

    `mode` is "exact" (fractions and roots), "decimal" (every constant that is not an integer as a decimal) or "both"
    (exact, and the decimal beside answers). `digits` is the number of significant digits of decimals; zeros at the end
    are dropped. `as_typed` leaves unrounded what could have been typed so.
    """

    mode: str = "exact"
    digits: int = 5
    as_typed: bool = False

    @staticmethod
    def of(display: Display) -> NumberFormat:
        """Return the format that the problem asks for."""
        if display.mode != "typed":
            return NumberFormat(display.mode, display.digits)
        return NumberFormat("decimal" if display.decimals_typed else "exact", display.digits, display.decimals_typed)

    @property
    def all_decimal(self) -> bool:
        """Whether every constant that is not an integer is a decimal, roots included."""
        return self.mode == "decimal"

    def shows_decimal(self, number: sp.Rational) -> bool:
        """Whether this fraction is printed as a decimal (an integer never is)."""
        return self.all_decimal and number.q != 1

    def parts(self, number: Any) -> tuple[str, int]:
        """Return digits and power of ten of a real number: ("0.25", 0), ("-1.2", -7); the sign is in the digits."""
        digits = self.digits
        if self.as_typed and isinstance(number, sp.Rational) and typed_length(number.p, number.q) <= LONGEST_TYPED:
            digits = max(digits, LONGEST_TYPED)
        return _decimal_parts(_mpf(number), digits)

    def formula(self, number: Any) -> Row:
        r"""Return a real number as a decimal: `0.25`, `-1.2 \cdot 10^{-7}`, `10^{-7}`."""
        digits, exponent = self.parts(number)
        if digits.endswith(("inf", "nan")):
            return row({"+inf": r"\infty", "-inf": r"-\infty"}.get(digits, r"\text{nan}"))
        if not exponent:
            return row(digits)
        power = rf"10^{{{exponent}}}"
        return row(f"{digits[:-1]}{power}" if digits.lstrip("-") == "1" else rf"{digits} \cdot {power}")

    def decimal(self, number: Any) -> str:
        """Return the same as LaTeX."""
        return latex(self.formula(number))

    def text(self, number: Any) -> str:
        """Return a real number as plain text: `3`, `3/4`, `0.25`, `1.2e-7`."""
        if isinstance(number, sp.Rational) and not self.shows_decimal(number):
            return str(number)
        digits, exponent = self.parts(number)
        return f"{digits}e{exponent}" if exponent else digits


def typed_length(p: int, q: int) -> float:
    """Return the number of significant digits of the decimal p/q; infinity if it does not terminate."""
    twos = fives = 0
    rest = q
    while rest % 2 == 0:
        rest, twos = rest // 2, twos + 1
    while rest % 5 == 0:
        rest, fives = rest // 5, fives + 1
    if rest != 1:
        return float("inf")
    places = max(twos, fives)
    return len(str(abs(p) * 10**places // q).rstrip("0"))


def _mpf(number: Any) -> Any:
    """Return a real number as mpmath's raw binary number, with far more bits than are printed."""
    if isinstance(number, sp.Float):
        return number._mpf_
    if isinstance(number, sp.Rational | Fraction | int):
        fraction = Fraction(int(number.p), int(number.q)) if isinstance(number, sp.Rational) else Fraction(number)
        return libmpf.from_rational(fraction.numerator, fraction.denominator, 200, "n")
    return libmpf.from_float(float(number))


@lru_cache(maxsize=4096)
def _decimal_parts(mpf: Any, digits: int) -> tuple[str, int]:
    text = libmpf.to_str(mpf, digits, strip_zeros=True, min_fixed=FIXED_POINT[0] - 1, max_fixed=FIXED_POINT[1])
    mantissa, _, exponent = text.partition("e")
    mantissa = mantissa.removesuffix(".0")
    return ("0" if mantissa == "-0" else mantissa), int(exponent or 0)
