r"""Exact objects as formulas, in a form that MathML, TeX and people read alike.

`formula` is the only way from a value to a formula, and `tex` its LaTeX. Differences from sympy's own printer: terms in
the order of a person, `e^{-2t}`, `(t)` without `\left`, one decision about decimals (`NumberFormat`), square brackets
around matrices, j for the imaginary unit. Sums are printed directly, term by term, without sympy's general (and slow)
route.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import sympy as sp

from solver.formula import latex
from solver.formula.building import MINUS, as_factor, is_atom, joined, over, power, row, summed
from solver.formula.nodes import Fenced, Number, Operator, Root, Row, Scripts, Symbol
from solver.render.latex_objects import FUNCTIONS, ObjectPrinter
from solver.render.numbers import NumberFormat
from solver.render.order import is_number, ordered_terms
from solver.render.programs import program_formula
from solver.render.symbols import named
from solver.render.terms import (
    Term,
    common_fraction,
    constants_together,
    evaluated,
    join_roots,
    like_terms_added,
    multiplied_in,
    split,
)
from solver.stated import Stated, operation_named

REMEMBERED = 5_000
"""Expressions whose LaTeX a printer keeps."""


class Printer(ObjectPrinter):
    """Prints one value; made by `formula`. What is not overridden here is printed by sympy."""

    def __init__(self, numbers: NumberFormat) -> None:
        self.numbers = numbers
        self._memo: dict[tuple[Any, bool, str], Row] = {}

    def _print(self, expr: Any) -> Row:
        if isinstance(expr, sp.Integer):
            return _integer(expr.p)
        if not isinstance(expr, sp.Expr):
            return super()._print(expr)
        key = (expr, self._inline, self.numbers.mode)
        known = self._memo.get(key)
        if known is None:
            known = self._memo[key] = super()._print(expr)
        return known

    def print_value(self, value: Any) -> Row:
        """Print a value from the start; what was printed before need not be printed again, for the pages repeat it."""
        if len(self._memo) > REMEMBERED:
            self._memo.clear()
        self._inline = False
        return self._print(sp.Float(value) if isinstance(value, float) else value)

    # Sums, products and powers

    def _print_Add(self, expr: Any) -> Row:
        if is_number(expr):
            return self._constant_sum(expr)
        terms = constants_together(list(expr.args))
        if self.numbers.all_decimal:
            terms = like_terms_added(terms)
        return summed([self._print(term) for term in ordered_terms(terms)])

    def _constant_sum(self, expr: Any) -> Row:
        if self.numbers.all_decimal or expr.has(sp.Float):
            value = evaluated(expr)
            return summed([self._print(part) for part in value.args]) if value.is_Add else self._print(value)
        (whole, *others) = constants_together(list(expr.args))
        if not others:
            return self._print(whole)
        fraction = common_fraction(expr)
        if fraction is not None:
            return self._print_Mul(fraction)
        return summed([self._print(term) for term in ordered_terms(expr.args)])

    def _print_Mul(self, expr: Any) -> Row:
        whole = multiplied_in(expr) if self.numbers.all_decimal else None
        return self._print(whole) if whole is not None else self._term(split(expr))

    def _print_Pow(self, expr: Any) -> Row:
        return self._term(split(expr))

    def _print_exp(self, expr: Any) -> Row:
        if self.numbers.all_decimal and expr.is_real and expr.is_number:
            return self._print(evaluated(expr))
        return row(Scripts(Symbol("e"), None, self._exponent(expr.args[0])))

    _print_ExpBase = _print_exp

    def _term(self, term: Term) -> Row:
        """Write a product: sign, number, fraction, functions."""
        decimal = self._decimal_constant(term)  # it knows the sign of a sum of roots
        join_roots(term, constants=decimal is None)
        sign = [MINUS] if term.negative else []
        if decimal is None:
            above, below = self._constants(term)
        else:
            above, below = [decimal] if decimal != ONE else [], []
        j = [J] if term.imaginary else []
        variables = [self._power(*factor) for factor in term.above]
        functions = [self._power(*factor) for factor in term.functions]
        if term.below:
            below += [self._power(*factor) for factor in term.below]
            whole = [self._fraction([*above, *j, *variables], below), *self._factors(functions, 2)]
            return row(*sign, joined(whole))
        rest = j + variables + functions
        if below:
            if self._inline:
                return row(*sign, self._fraction([*above, *rest], below))
            rest = [self._fraction(above, below), *rest]
        elif term.imaginary and term.roots and decimal is None:
            numbers = above[: -len(term.roots)]
            rest = [*numbers, *j, *above[len(numbers) :], *variables, *functions]
        else:
            rest = above + rest
        return row(*sign, joined(self._factors(rest, len(rest))) if rest else ONE)

    def _decimal_constant(self, term: Term) -> Row | None:
        """Return the whole constant as a decimal, if that is how it is shown."""
        number, roots = term.number, term.roots or term.roots_below
        if roots and (self.numbers.all_decimal or number.is_Float):
            above = sp.Mul(*(base**exponent for base, exponent in term.roots))
            value = evaluated(number * above / sp.Mul(*(base**exponent for base, exponent in term.roots_below)))
            if value.is_Float:
                term.negative, value = term.negative != bool(value < 0), abs(value)
                return self.numbers.formula(value)
            return as_factor(self._print(value))
        if number.is_Float or (number.is_Rational and self.numbers.shows_decimal(number)):
            return self.numbers.formula(number)
        return None

    def _constants(self, term: Term) -> tuple[list[Row], list[Row]]:
        """Return the factors of the exact constant above and below the bar; 1 is left out."""
        above, below = [], [self._power(*factor) for factor in term.roots_below]
        number = term.number
        if number.is_Rational:
            above += [_integer(number.p)] * (number.p != 1)
            below = [_integer(number.q)] * (number.q != 1) + below
        else:
            above.append(self._print(number))
        return above + [self._power(*factor) for factor in term.roots], below

    def _fraction(self, above: list[Row], below: list[Row]) -> Row:
        if (digits := _digits_of(above, below)) and not self._inline:
            return _common(*digits)
        numerator = joined(self._factors(above, len(above))) if above else ONE
        denominator = joined(self._factors(below, len(below)))
        if not self._inline:
            return over(numerator, denominator)
        whole = len(below) == 1 and is_atom(denominator)
        divisor = denominator if whole else Fenced("(", denominator, ")")
        return row(as_factor(numerator) if len(above) == 1 else numerator, Operator("/"), divisor)

    @staticmethod
    def _factors(factors: list[Row], count: int) -> list[Row]:
        """Put the sums among several factors in parentheses."""
        return [as_factor(factor) for factor in factors] if count > 1 else factors

    def _power(self, base: Any, exponent: Any) -> Row:
        if exponent is sp.S.One:
            return self._print(base)
        if exponent.is_Rational and exponent.p == 1 and not self._inline:
            return row(Root(self._print(base), None if exponent.q == 2 else _integer(exponent.q)))
        if exponent == sp.S.Half:
            return row(Root(self._print(base)))
        above = self._exponent(exponent)
        name = type(base).__name__
        if name in FUNCTIONS and len(base.args) == 1 and exponent.is_Integer:
            return row(Scripts(FUNCTIONS[name], None, above), self._arguments(base))
        return power(self._print(base), above)

    def _exponent(self, exponent: Any) -> Row:
        outside, self._inline = self._inline, True
        try:
            return self._print(exponent)
        finally:
            self._inline = outside

    # Numbers and names

    def _print_Integer(self, expr: Any) -> Row:
        return _integer(int(expr))

    _print_int = _print_Integer

    def _print_Rational(self, expr: Any) -> Row:
        if self.numbers.shows_decimal(expr):
            return self.numbers.formula(expr)
        fraction = self._fraction([_integer(abs(expr.p))], [_integer(expr.q)])
        return row(MINUS, fraction) if expr.p < 0 else fraction

    def _print_Float(self, expr: Any) -> Row:
        return self.numbers.formula(expr)

    def _print_Exp1(self, expr: Any) -> Row:
        return self.numbers.formula(expr.evalf(30)) if self.numbers.all_decimal else row("e")

    def _print_Pi(self, expr: Any) -> Row:
        return self.numbers.formula(expr.evalf(30)) if self.numbers.all_decimal else row(r"\pi")

    def _print_Infinity(self, _expr: Any) -> Row:
        return row(r"\infty")

    def _print_NegativeInfinity(self, _expr: Any) -> Row:
        return row(r"-\infty")

    def _print_ImaginaryUnit(self, _expr: Any) -> Row:
        return J

    def _print_Symbol(self, expr: Any) -> Row:
        return named(expr.name)

    def _print_ComplexRootOf(self, expr: Any) -> Row:
        return self._print(evaluated(expr))

    def _print_Program(self, expr: Any) -> Row:
        return program_formula(expr, self._print)

    def _print_Stated(self, expr: Stated) -> Row:
        return operation_named(expr.operation).printer(self._print, *expr.operands)


ONE, J = row("1"), row("j")


@lru_cache(maxsize=1024)  # with what was made of it: pages repeat small numbers
def _integer(number: int) -> Row:
    digits = Number(str(abs(number)))
    return Row((MINUS, digits)) if number < 0 else Row((digits,))


def _digits_of(above: list[Row], below: list[Row]) -> list[str]:
    """Return the digits of a number over a number, nothing where a fraction has anything else in it."""
    items = [item for each in (*(above or (ONE,)), *below) for item in each.items]
    digits = [item.digits for item in items if isinstance(item, Number)]
    return digits if len(digits) == len(items) == 2 else []


@lru_cache(maxsize=1024)  # as above
def _common(above: str, below: str) -> Row:
    return over(Row((Number(above),)), Row((Number(below),)))


@lru_cache(maxsize=16)
def _printer(numbers: NumberFormat) -> Printer:
    return Printer(numbers)


DEFAULT = NumberFormat()

SHORT = 100
"""A fraction of whole numbers up to this needs no decimal beside it."""


def formula(value: Any, numbers: NumberFormat = DEFAULT) -> Row:
    """Return the formula of an expression, matrix, list, condition, truth value, text or `Stated`.

    A Python truth value is "yes" or "no"; a condition that sympy found true or false is "always" or "never".
    """
    return _printer(numbers).print_value(value)


def answer_formula(value: Any, numbers: NumberFormat = DEFAULT) -> Row:
    """Return the value of an answer; in the mode "both" its decimals follow, unless they say nothing new."""
    exact = formula(value, numbers)
    if numbers.mode != "both" or not _wants_decimal(value):
        return exact
    decimal = formula(value, NumberFormat("decimal", numbers.digits))
    return exact if decimal == exact else row(exact, r"\approx", decimal)


def tex(value: Any, numbers: NumberFormat = DEFAULT) -> str:
    """Return the formula of a value as LaTeX, without dollar signs."""
    return latex(formula(value, numbers))


def _wants_decimal(value: Any) -> bool:
    """Whether a value holds a constant that is hard to picture: a root, or a fraction with many digits."""
    if isinstance(value, list | tuple):
        return any(_wants_decimal(item) for item in value)
    if isinstance(value, sp.MatrixBase):
        return any(_wants_decimal(entry) for entry in value.flat())
    if not isinstance(value, sp.Expr):
        return False
    roots = any(power.base.is_number and not power.exp.is_Integer for power in value.atoms(sp.Pow) if power.is_number)
    long = any(number.q > SHORT or abs(number.p) > SHORT for number in value.atoms(sp.Rational) if number.q != 1)
    return roots or long or bool(value.atoms(sp.NumberSymbol))
