r"""Exact objects as LaTeX in a small dialect that MathML, TeX and people read alike.

`tex` is the only way from a value to a formula. Differences from sympy's own printer: terms in the order of a person,
`e^{-2t}`, `(t)` without `\left`, one decision about decimals (`NumberFormat`), square brackets around matrices, j for
the imaginary unit. Sums are printed directly, term by term, without sympy's general (and slow) route.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import sympy as sp
from sympy.printing.latex import LatexPrinter

from solver.formula.pieces import as_base, as_factor, joined, parenthesized, summed
from solver.render.latex_objects import FUNCTIONS, ObjectPrinter
from solver.render.numbers import NumberFormat
from solver.render.order import ordered_terms
from solver.render.symbols import name_tex
from solver.render.terms import Term, common_fraction, evaluated, like_terms_added, split
from solver.stated import Stated, operation_named

REMEMBERED = 20_000
"""Expressions whose LaTeX a printer keeps."""


class Printer(ObjectPrinter):
    """Prints one value; made by `tex`. What is not overridden here is printed by sympy."""

    printmethod = ""  # else sympy's π would print itself, and know nothing of decimals

    def __init__(self, numbers: NumberFormat) -> None:
        LatexPrinter.__init__(self, {"imaginary_unit": "j", "ln_notation": True, "mat_str": "bmatrix", "mat_delim": ""})
        self.numbers = numbers
        self._memo: dict[tuple[Any, bool, str], str] = {}

    def _print(self, expr: Any, **kwargs: Any) -> str:
        if isinstance(expr, sp.Integer):
            return str(expr.p)
        if not isinstance(expr, sp.Expr):
            return str(super()._print(expr, **kwargs))
        key = (expr, self._inline, self.numbers.mode)
        known = self._memo.get(key)
        if known is None:
            known = self._memo[key] = str(super()._print(expr, **kwargs))
        return known

    def doprint_value(self, value: Any) -> str:
        """Print a value from the start; what was printed before need not be printed again, for the pages repeat it."""
        if len(self._memo) > REMEMBERED:
            self._memo.clear()
        self._inline = False
        return self._print(sp.Float(value) if isinstance(value, float) else value)

    # Sums, products and powers

    def _print_Add(self, expr: Any, _order: Any = None) -> str:
        if expr.is_number:
            return self._constant_sum(expr)
        terms = list(expr.args)
        if self.numbers.all_decimal or self._rounds(expr):
            terms = like_terms_added(terms)
        return summed([self._print(term) for term in ordered_terms(terms)])

    def _constant_sum(self, expr: Any) -> str:
        if self.numbers.all_decimal or expr.has(sp.Float) or self._rounds(expr):
            value = evaluated(expr)
            return summed([self._print(part) for part in value.args]) if value.is_Add else self._print(value)
        fraction = common_fraction(expr)
        if fraction is not None:
            return self._print_Mul(fraction)
        return summed([self._print(term) for term in ordered_terms(expr.args)])

    def _rounds(self, expr: Any) -> bool:
        """Whether a number of the expression is shown rounded; then its constants are added up."""
        return self.numbers.rounds_any(expr)

    def _print_Mul(self, expr: Any) -> str:
        return self._term(split(expr))

    def _print_Pow(self, expr: Any) -> str:
        return self._term(split(expr))

    def _print_exp(self, expr: Any, exp: Any = None) -> str:
        exponent = expr.args[0] if exp is None else None
        if exponent is None:
            return f"{parenthesized(self._print(expr))}^{{{exp}}}"
        return f"e^{{{self._exponent(exponent)}}}"

    def _print_ExpBase(self, expr: Any, exp: Any = None) -> str:
        return self._print_exp(expr, exp)

    def _term(self, term: Term) -> str:
        """Write a product: sign, number, fraction, functions."""
        decimal = self._decimal_constant(term)  # it knows the sign of a sum of roots
        sign = "-" if term.negative else ""
        if decimal is None:
            above, below = self._constants(term)
        else:
            above, below = [decimal] if decimal != "1" else [], []
        j = ["j"] if term.imaginary else []
        variables = [self._power(*factor) for factor in term.above]
        functions = [self._power(*factor) for factor in term.functions]
        if term.below:
            below += [self._power(*factor) for factor in term.below]
            return sign + joined([self._fraction([*above, *j, *variables], below), *self._factors(functions, 2)])
        rest = j + variables + functions
        if below:
            if self._inline:
                return sign + self._fraction([*above, *rest], below)
            rest = [self._fraction(above, below), *rest]
        elif term.imaginary and term.roots and decimal is None:
            numbers = above[: -len(term.roots)]
            rest = [*numbers, *j, *above[len(numbers) :], *variables, *functions]
        else:
            rest = above + rest
        return sign + (joined(self._factors(rest, len(rest))) or "1")

    def _decimal_constant(self, term: Term) -> str | None:
        """Return the whole constant as a decimal, if that is how it is shown."""
        number, roots = term.number, term.roots or term.roots_below
        long = number.is_Rational and self.numbers.rounds(number)
        long = long or any(self.numbers.rounds_root(base) for base, _ in roots)
        if roots and (self.numbers.all_decimal or number.is_Float or long):
            above = sp.Mul(*(base**exponent for base, exponent in term.roots))
            value = evaluated(number * above / sp.Mul(*(base**exponent for base, exponent in term.roots_below)))
            if value.is_Float:
                term.negative, value = term.negative != bool(value < 0), abs(value)
                return self.numbers.decimal(value)
            return as_factor(self._print(value))
        kept = bool(roots or term.below) and not self.numbers.all_decimal and not long
        if number.is_Float or (not kept and number.is_Rational and self.numbers.shows_decimal(number)):
            return self.numbers.decimal(number)
        return None

    def _constants(self, term: Term) -> tuple[list[str], list[str]]:
        """Return the factors of the exact constant above and below the bar; 1 is left out."""
        above, below = [], [self._power(*factor) for factor in term.roots_below]
        number = term.number
        if number.is_Rational:
            above += [str(number.p)] * (number.p != 1)
            below = [str(number.q)] * (number.q != 1) + below
        else:
            above.append(self._print(number))
        return above + [self._power(*factor) for factor in term.roots], below

    def _fraction(self, above: list[str], below: list[str]) -> str:
        numerator = joined(self._factors(above, len(above))) or "1"
        denominator = joined(self._factors(below, len(below)))
        if not self._inline:
            return rf"\frac{{{numerator}}}{{{denominator}}}"
        over = denominator if len(below) == 1 and as_base(denominator) == denominator else f"({denominator})"
        return f"{as_factor(numerator) if len(above) == 1 else numerator}/{over}"

    @staticmethod
    def _factors(factors: list[str], count: int) -> list[str]:
        """Put the sums among several factors in parentheses."""
        return [as_factor(factor) for factor in factors] if count > 1 else factors

    def _power(self, base: Any, exponent: Any) -> str:
        if exponent is sp.S.One:
            return self._print(base)
        if exponent.is_Rational and exponent.p == 1 and not self._inline:
            root = "" if exponent.q == 2 else f"[{exponent.q}]"
            return rf"\sqrt{root}{{{self._print(base)}}}"
        if exponent == sp.S.Half:
            return rf"\sqrt{{{self._print(base)}}}"
        above = self._exponent(exponent)
        name = type(base).__name__
        if name in FUNCTIONS and FUNCTIONS[name].startswith("\\") and len(base.args) == 1 and exponent.is_Integer:
            return rf"{FUNCTIONS[name]}^{{{above}}}{self._arguments(base)}"
        return f"{as_base(self._print(base))}^{{{above}}}"

    def _exponent(self, exponent: Any) -> str:
        outside, self._inline = self._inline, True
        try:
            return self._print(exponent)
        finally:
            self._inline = outside

    # Numbers and names

    def _print_Integer(self, expr: Any) -> str:
        return str(expr)

    def _print_Rational(self, expr: Any) -> str:
        if self.numbers.shows_decimal(expr):
            return self.numbers.decimal(expr)
        sign = "-" if expr.p < 0 else ""
        return sign + self._fraction([str(abs(expr.p))], [str(expr.q)])

    def _print_Float(self, expr: Any) -> str:
        return self.numbers.decimal(expr)

    def _print_Exp1(self, expr: Any, exp: Any = None) -> str:
        tex = self.numbers.decimal(expr.evalf(30)) if self.numbers.all_decimal else "e"
        return f"{tex}^{{{exp}}}" if exp else tex

    def _print_Pi(self, expr: Any) -> str:
        return self.numbers.decimal(expr.evalf(30)) if self.numbers.all_decimal else r"\pi"

    def _print_Infinity(self, _expr: Any) -> str:
        return r"\infty"

    def _print_NegativeInfinity(self, _expr: Any) -> str:
        return r"-\infty"

    def _print_ImaginaryUnit(self, _expr: Any) -> str:
        return "j"

    def _print_Symbol(self, expr: Any, _style: str = "plain") -> str:
        return name_tex(expr.name)

    def _print_ComplexRootOf(self, expr: Any) -> str:
        return self._print(evaluated(expr))

    def _print_Stated(self, expr: Stated) -> str:
        return operation_named(expr.operation).printer(self._print, *expr.operands)


@lru_cache(maxsize=16)
def _printer(numbers: NumberFormat) -> Printer:
    return Printer(numbers)


DEFAULT = NumberFormat()

SHORT = 100
"""A fraction of whole numbers up to this needs no decimal beside it."""


def tex(value: Any, numbers: NumberFormat = DEFAULT) -> str:
    """Return LaTeX (without dollar signs) of an expression, matrix, list, condition, truth value, text or formula.

    A Python truth value is "yes" or "no"; a condition that sympy found true or false is "always" or "never".
    """
    return _printer(numbers).doprint_value(value)


def tex_answer(value: Any, numbers: NumberFormat = DEFAULT) -> str:
    """Return the value of an answer as LaTeX; in the mode "both" its decimals follow, unless they say nothing new."""
    exact = tex(value, numbers)
    if numbers.mode != "both" or not _wants_decimal(value):
        return exact
    decimal = tex(value, NumberFormat("decimal", numbers.digits))
    return exact if decimal == exact else rf"{exact} \approx {decimal}"


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
