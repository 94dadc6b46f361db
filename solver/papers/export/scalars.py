"""Expressions that are told by numbers in a normal form: a number, a polynomial, a quotient of polynomials.

Of each kind: how many fields it has, the numbers in them, how they are laid out, and how the whole is typed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import sympy as sp

from solver.papers.export.decimals import complex_parts, exactly
from solver.papers.export.quiz import Field, Fixed
from solver.symbols import COMPLEX

Numbers = list[Fraction]
Words = tuple[str, dict[str, str]]
"""A phrase and its values, which tell what one of several fields is."""

Cells = tuple[Field | Fixed, ...]

MOST_DEGREE = 12

PARTS = "A complex number has a field for its real and one for its imaginary part, which is 0 where it is real."
COEFFICIENTS = "The fields are the coefficients, each with its sign; one that is missing is 0."
COEFFICIENT = "coefficient of {power}"
ABOVE = "numerator, coefficient of {power}"
BELOW = "denominator, coefficient of {power}"
QUOTIENT = "It is asked for in lowest terms, the leading coefficient of the denominator being 1."


@dataclass(frozen=True)
class Real:
    """A real number."""

    count: int = 1
    told: tuple[str, ...] = ()

    def numbers(self, value: Any) -> Numbers | None:
        """Return the numbers in the fields, None where the value is not of this kind."""
        number = exactly(value)
        return None if number is None else [number]

    @property
    def parts(self) -> list[Words]:
        """Return what each field is, in words."""
        return [("", {})]

    def lines(self, lead: str, fields: Sequence[Field]) -> list[Cells]:
        """Return the fields behind what says what they are (LaTeX)."""
        return [(Fixed(f"{lead} ="), fields[0])]

    def typed(self, texts: Sequence[str]) -> str:
        """Return the value as a student types it."""
        return texts[0]


@dataclass(frozen=True)
class Complex:
    """A complex number by its real and its imaginary part."""

    count: int = 2
    told: tuple[str, ...] = (PARTS,)

    def numbers(self, value: Any) -> Numbers | None:
        """Return the two parts."""
        parts = complex_parts(value)
        return None if parts is None else list(parts)

    @property
    def parts(self) -> list[Words]:
        """Return what each field is, in words."""
        return [("real part", {}), ("imaginary part", {})]

    def lines(self, lead: str, fields: Sequence[Field]) -> list[Cells]:
        """Return a + b j."""
        return [(Fixed(f"{lead} ="), fields[0], Fixed("+"), fields[1], Fixed("j"))]

    def typed(self, texts: Sequence[str]) -> str:
        """Return the value as a student types it."""
        return texts[0] if texts[1] == "0" else f"{texts[0]} + ({texts[1]})*j"


@dataclass(frozen=True)
class Polynomial:
    """A polynomial of a degree; a `monic` one has no field for its leading coefficient."""

    variable: str
    degree: int
    monic: bool
    told: tuple[str, ...] = (COEFFICIENTS,)

    @property
    def count(self) -> int:
        """The number of fields."""
        return self.degree + (not self.monic)

    def numbers(self, value: Any) -> Numbers | None:
        """Return the coefficients, the highest first."""
        poly = polynomial(value, self.variable)
        if poly is None or poly.degree() != self.degree or (self.monic and poly.LC() != 1):
            return None
        return _all(exactly(each) for each in poly.all_coeffs()[self.monic :])

    @property
    def parts(self) -> list[Words]:
        """Return what each field is, in words."""
        return _powers(COEFFICIENT, self.variable, self.count)

    def lines(self, lead: str, fields: Sequence[Field]) -> list[Cells]:
        """Return s^2 + [ ] s + [ ]."""
        return [_sum(f"{lead} =", self.variable, self.degree, self.monic, fields)]

    def typed(self, texts: Sequence[str]) -> str:
        """Return the value as a student types it."""
        return _typed_sum(self.variable, self.degree, ["1", *texts] if self.monic else texts)


@dataclass(frozen=True)
class Quotient:
    """A quotient of polynomials in lowest terms, its denominator monic."""

    variable: str
    above: int
    below: int
    told: tuple[str, ...] = (QUOTIENT, COEFFICIENTS)

    @property
    def count(self) -> int:
        """The number of fields."""
        return self.above + 1 + self.below

    def numbers(self, value: Any) -> Numbers | None:
        """Return the coefficients of numerator and denominator, the highest first."""
        terms = quotient(value, self.variable)
        if terms is None or [each.degree() for each in terms] != [self.above, self.below]:
            return None
        coefficients = [*terms[0].all_coeffs(), *terms[1].all_coeffs()[1:]]
        return _all(exactly(each) for each in coefficients)

    @property
    def parts(self) -> list[Words]:
        """Return what each field is, in words."""
        return [*_powers(ABOVE, self.variable, self.above + 1), *_powers(BELOW, self.variable, self.below)]

    def lines(self, lead: str, fields: Sequence[Field]) -> list[Cells]:
        """Return the numerator on a line and the denominator on the next."""
        above, below = fields[: self.above + 1], fields[self.above + 1 :]
        return [
            _sum(rf"{lead} = \frac{{b}}{{a}},\quad b =", self.variable, self.above, False, above),
            _sum("a =", self.variable, self.below, True, below),
        ]

    def typed(self, texts: Sequence[str]) -> str:
        """Return the value as a student types it."""
        above, below = texts[: self.above + 1], ["1", *texts[self.above + 1 :]]
        named = self.variable
        return f"({_typed_sum(named, self.above, above)})/({_typed_sum(named, self.below, below)})"


Scalar = Real | Complex | Polynomial | Quotient


def scalar_of(value: Any) -> Scalar | None:
    """Return the kind of an expression, None where it has letters, functions, or another form is asked for."""
    if exactly(value) is not None:
        return Real()
    if complex_parts(value) is not None:
        return Complex()
    variable = _variable(value)
    if variable is None or (isinstance(value, sp.Add) and not value.is_polynomial(sp.Symbol(variable))):
        return None  # a sum of fractions is asked for as it stands
    if (poly := polynomial(value, variable)) is not None:
        found: Scalar = Polynomial(variable, poly.degree(), bool(poly.LC() == 1))
    elif (terms := quotient(value, variable)) is not None:
        found = Quotient(variable, *(each.degree() for each in terms))
    else:
        return None
    return found if found.numbers(value) is not None else None


def _variable(value: Any) -> str | None:
    if not isinstance(value, sp.Expr) or len(value.free_symbols) != 1:
        return None
    name = str(next(iter(value.free_symbols)))
    return name if name in COMPLEX else None


def polynomial(value: Any, variable: str) -> sp.Poly | None:
    """Return an expression as a polynomial with numbers for coefficients, None where it is none."""
    x = sp.Symbol(variable)
    if not isinstance(value, sp.Expr) or not value.is_polynomial(x) or value.free_symbols != {x}:
        return None
    poly = sp.Poly(value, x)
    return poly if 1 <= poly.degree() <= MOST_DEGREE else None


def quotient(value: Any, variable: str) -> tuple[sp.Poly, sp.Poly] | None:
    """Return numerator and monic denominator in lowest terms, None where it is no proper quotient of polynomials."""
    x = sp.Symbol(variable)
    if not isinstance(value, sp.Expr) or not value.is_rational_function(x) or value.free_symbols != {x}:
        return None
    above, below = (sp.Poly(each, x) for each in sp.fraction(sp.together(value)))
    if not _decimal(above, below):
        above, below = _reduced(above, below)
    if below.degree() < 1 or max(above.degree(), below.degree()) > MOST_DEGREE or above.is_zero:
        return None
    leading = below.LC()
    return above.quo_ground(leading), below.quo_ground(leading)


def _decimal(*polys: sp.Poly) -> bool:
    """Whether some coefficient is a decimal: nothing is cancelled then, as nothing is known to be equal."""
    return any(coefficient.has(sp.Float) for poly in polys for coefficient in poly.all_coeffs())


def _reduced(above: sp.Poly, below: sp.Poly) -> tuple[sp.Poly, sp.Poly]:
    first, second = above.unify(below)
    common = first.to_field().gcd(second.to_field())
    return first.to_field().quo(common), second.to_field().quo(common)


def _all(numbers: Any) -> Numbers | None:
    found = list(numbers)
    return None if None in found else found


def _sum(lead: str, variable: str, degree: int, monic: bool, fields: Sequence[Field]) -> Cells:
    """Return the coefficients in fields between the powers."""
    cells: list[Field | Fixed] = []
    between, left = lead, list(fields)
    for power in range(degree, -1, -1):
        shown = "" if power == 0 else _power(variable, power)
        if monic and power == degree:
            between = f"{between} {shown}"
        else:
            cells += [Fixed(between), left.pop(0)]
            between = shown
        between = f"{between} +" if power else ""
    return tuple(cells)


def _powers(pattern: str, variable: str, count: int) -> list[Words]:
    """Return what the coefficients of so many powers are, the highest first, in plain words."""
    letter = "λ" if variable == "lamda" else variable
    powers = [letter if i == 1 else f"{letter}^{i}" for i in reversed(range(count))]
    return [(pattern, {"power": power}) for power in powers]


def _power(variable: str, power: int) -> str:
    letter = r"\lambda" if variable == "lamda" else variable
    return letter if power == 1 else f"{letter}^{{{power}}}"


def _typed_sum(variable: str, degree: int, texts: Sequence[str]) -> str:
    return " + ".join(f"({text})*{variable}^{degree - i}" for i, text in enumerate(texts))
