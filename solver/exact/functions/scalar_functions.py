"""A function f of one variable at the eigenvalues of a matrix: its value and derivatives, real and imaginary parts.

Square roots, logarithms and other powers are principal values: they are analytic off the negative real axis only.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import sympy as sp

from solver.exact.linear_algebra.fields import NotExact
from solver.exact.linear_algebra.spectrum import DIGITS, Root

CUT = (sp.log, sp.atan, sp.asin, sp.acos)


@dataclass(frozen=True)
class ScalarFunction:
    """The function `expression` of the symbol `variable`."""

    expression: sp.Expr
    variable: sp.Symbol

    @cached_property
    def rational(self) -> tuple[sp.Expr, sp.Expr] | None:
        """Numerator and denominator of a rational function; None for another."""
        if not self.expression.is_rational_function(self.variable):
            return None
        numerator, denominator = sp.fraction(sp.together(self.expression))
        polynomial = numerator.is_polynomial(self.variable) and denominator.is_polynomial(self.variable)
        return (numerator, denominator) if polynomial else None

    @cached_property
    def power_exponent(self) -> sp.Symbol | None:
        """The symbol k where the function is xᵏ; None for another."""
        base, exponent = self.expression.as_base_exp()
        return exponent if base == self.variable and isinstance(exponent, sp.Symbol) else None

    def derivative(self, order: int) -> sp.Expr:
        """The derivative as a function of the variable."""
        found: sp.Expr = sp.diff(self.expression, self.variable, order) if order else self.expression
        return found

    def at(self, value: sp.Expr, order: int = 0) -> sp.Expr:
        """The derivative of an order at a number; raises NotExact where there is none, or no principal value."""
        self._check_cut(value, order)
        found: sp.Expr = self.derivative(order).subs(self.variable, value)
        if found.has(sp.zoo, sp.nan, sp.oo):
            raise NotExact("functions/undefined", order=order, value=value)
        if value.has(sp.Float):
            found = found.evalf(DIGITS)
        return found

    def _check_cut(self, value: sp.Expr, order: int) -> None:
        """Refuse arguments on the negative real axis of what is cut there, and zero where no derivative exists."""
        for node in self.expression.atoms(sp.Pow, sp.log):
            root = isinstance(node, sp.Pow)
            if root and (node.exp.is_Integer or node.exp.has(self.variable) or not node.base.has(self.variable)):
                continue
            inner = node.args[0].subs(self.variable, value)
            if root and inner == 0 and order == 0 and node.exp.is_positive:
                continue
            if root and node.exp.is_Symbol:
                continue  # a whole power
            self._refuse("root" if root else "logarithm", value, inner)

    def _refuse(self, what: str, value: sp.Expr, inner: sp.Expr) -> None:
        if inner.is_zero:
            raise NotExact("functions/not_differentiable", function=what, value=value, argument=inner)
        if inner.is_nonpositive:
            raise NotExact("functions/on_the_cut", function=what, value=value, argument=inner)


def at_root(f: ScalarFunction, root: Root, order: int) -> tuple[sp.Expr, sp.Expr | None]:
    """The derivative at an eigenvalue; real and imaginary part for a root that is not real, (value, None) otherwise."""
    value = f.at(root.value, order)
    if root.kind not in ("complex", "decimal") or root.shift == 0:
        return value, None
    return parts(value)


def parts(value: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Real and imaginary part, all symbols taken as real."""
    names = {symbol: sp.Dummy(str(symbol), real=True) for symbol in value.free_symbols if not symbol.is_real}
    real, imaginary = _square_roots(value.xreplace(names)).as_real_imag()
    back = {dummy: symbol for symbol, dummy in names.items()}
    return multiplied_out(real).xreplace(back), multiplied_out(imaginary).xreplace(back)


def multiplied_out(e: sp.Expr) -> sp.Expr:
    """The expression expanded, with exponentials of sums left as they are."""
    found: sp.Expr = sp.expand(e, power_exp=False, power_base=False, log=False)
    return found


def _square_roots(value: sp.Expr) -> sp.Expr:
    """√(a + jb) as √((r + a)/2) ± j√((r − a)/2), r = |a + jb|."""
    roots = [each for each in value.atoms(sp.Pow) if each.exp == sp.S.Half and each.base.has(sp.I)]
    for each in roots:
        a, b = sp.expand(each.base, complex=True).as_real_imag()
        r = sp.sqrt(sp.expand(a**2 + b**2))
        sign = sp.sign(b)
        if sign not in (1, -1):
            continue
        value = value.subs(
            each, sp.sqrtdenest(sp.sqrt((r + a) / 2)) + sp.I * sign * sp.sqrtdenest(sp.sqrt((r - a) / 2))
        )
    return value
