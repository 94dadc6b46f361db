"""One place decides how a number is shown: as an integer, a fraction or a decimal, and with how many digits."""

from __future__ import annotations

import math
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
"""A terminating fraction with more significant digits than this stays a fraction in the mode "typed"."""

LONGEST_FRACTION = (5, 3)
"""Digits above and below the bar; a longer fraction tells a reader nothing: it is rounded where decimals were typed."""

FIXED_POINT = (-4, 6)
"""Exponents of ten between which a decimal is written without a power of ten: 10⁻⁴ ≤ |x| < 10⁶."""


@dataclass(frozen=True, slots=True)
class NumberFormat:
    """How numbers are shown.

    `mode` is "typed" (exact, but decimals for what is short as a decimal or long as a fraction where the file held
    decimals), "exact" (fractions and roots),
    "decimal" (every constant that is not an integer as a decimal) or "both" (exact, and the decimal beside answers).
    `digits` is the number of significant digits of decimals; zeros at the end are dropped.
    """

    mode: str = "typed"
    digits: int = 5
    decimals_typed: bool = False

    @staticmethod
    def of(display: Display) -> NumberFormat:
        """Return the format that the problem asks for."""
        return NumberFormat(display.mode, display.digits, display.decimals_typed)

    @property
    def all_decimal(self) -> bool:
        """Whether every constant that is not an integer is a decimal, roots included."""
        return self.mode == "decimal"

    def shows_decimal(self, number: sp.Rational) -> bool:
        """Whether this fraction is printed as a decimal (an integer never is)."""
        if number.q == 1 or self.mode in {"exact", "both"}:
            return False
        if self.all_decimal or self.rounds(number):
            return True
        return self.decimals_typed and typed_length(number.p, number.q) <= LONGEST_TYPED

    def rounds(self, number: sp.Rational) -> bool:
        """Whether this fraction is too long to be read, in a problem that was typed with decimals."""
        if not self.decimals_typed or self.mode != "typed" or number.q == 1:
            return False
        above, below = len(str(abs(number.p))), len(str(number.q))
        long = above > LONGEST_FRACTION[0] or below > LONGEST_FRACTION[1]
        return long and typed_length(number.p, number.q) > LONGEST_TYPED

    def rounds_any(self, expression: Any) -> bool:
        """Whether an expression holds a fraction, or a root of an integer, that is too long to be read."""
        if not self.decimals_typed or self.mode != "typed":
            return False
        return any(map(self.rounds, expression.atoms(sp.Rational))) or any(
            self.rounds_root(power.base) for power in expression.atoms(sp.Pow) if not power.exp.is_Integer
        )

    def rounds_root(self, radicand: Any) -> bool:
        """Whether the root of this integer is too long to be read, in a problem that was typed with decimals."""
        long = radicand.is_Integer and len(str(abs(radicand))) > LONGEST_TYPED
        return bool(long and self.decimals_typed and self.mode == "typed")

    def parts(self, number: Any) -> tuple[str, int]:
        """Return digits and power of ten of a real number: ("0.25", 0), ("-1.2", -7); the sign is in the digits."""
        digits = self.digits
        if isinstance(number, sp.Rational) and not self.all_decimal and typed_length(number.p, number.q) < math.inf:
            digits = max(digits, LONGEST_TYPED)  # as typed: nothing is rounded that has no more digits
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
