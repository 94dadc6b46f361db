"""The entrywise Riccati equations solved as with a pen: roots of one unknown, factors, substitution, case by case.

It finds all real solutions or gives up (`None`): then the solutions from the Hamiltonian matrix have to do. Whoever
shows a case split compares its ends with these.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from solver.exact.linear_algebra.signs import is_not_zero, is_positive
from solver.exact.optimal.field_roots import known_positive

MOST_NODES = 60
LONGEST = 250
DIGITS = 40
Equations = tuple[sp.Expr, ...]
Known = Mapping[sp.Symbol, sp.Expr]


@dataclass(frozen=True)
class Case:
    """One step of the split, and what follows from each of its outcomes.

    `kind` is "roots" (the equation in one unknown has `values`), "factors" (the equation is the product of `values`),
    "substitute" (the unknown is `values[0]`), "contradiction" (an equation without unknowns is not satisfied) or
    "found" (nothing is left; `known` has all the unknowns). `condition` must not be negative for the roots to be real.
    """

    kind: str
    equation: sp.Expr = sp.S.Zero
    unknown: sp.Symbol | None = None
    values: tuple[sp.Expr, ...] = ()
    following: tuple[Case, ...] = ()
    known: Known | None = None
    condition: sp.Expr | None = None

    def ends(self) -> list[Known]:
        """The solutions that the cases lead to."""
        if self.kind == "found" and self.known is not None:
            return [self.known]
        return [end for case in self.following for end in case.ends()]


class _Stuck(Exception):  # noqa: N818 - a finding
    """No equation gives way to the means used here."""


def case_split(equations: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol]) -> Case | None:
    """Return the cases that solve the equations (each zero) for real unknowns; None if a pen would not do."""
    try:
        return _Solver(tuple(unknowns)).solve(tuple(equations), {})
    except _Stuck:
        return None


class _Solver:
    def __init__(self, unknowns: tuple[sp.Symbol, ...]) -> None:
        self.unknowns = frozenset(unknowns)
        self.order = unknowns
        self.nodes = 0

    def solve(self, equations: Equations, known: Known) -> Case:
        """Take the easiest step and go on with what follows."""
        self.nodes += 1
        if self.nodes > MOST_NODES or any(len(str(equation)) > LONGEST for equation in equations):
            raise _Stuck
        left: list[sp.Expr] = []
        for equation in equations:
            if self._in(equation):
                left.append(equation)
            elif not _is_zero(equation):
                return Case("contradiction", equation)
        if not left:
            if set(known) != self.unknowns:
                raise _Stuck  # some unknown is free
            return Case("found", known=known)
        for attempt in (self._few_roots, self._factors, self._substitution, self._even_roots):
            found = attempt(tuple(left), known)
            if found is not None:
                return found
        raise _Stuck

    def _in(self, equation: sp.Expr) -> list[sp.Symbol]:
        return [x for x in self.order if equation.has(x)]

    def _few_roots(self, equations: Equations, known: Known) -> Case | None:
        """An equation of degree one or two in one unknown."""
        candidates = []
        for equation in equations:
            present = self._in(equation)
            if len(present) == 1:
                coefficients = sp.Poly(equation, present[0]).all_coeffs()
                if len(coefficients) <= 3:
                    candidates.append((len(coefficients), len(str(equation)), equation, present[0], coefficients))
        if not candidates:
            return None
        _, _, equation, x, coefficients = min(candidates, key=lambda each: each[:2])
        if len(coefficients) == 2:
            value = _tidy(-coefficients[1] / coefficients[0])
            return self._substituted(equation, x, value, equations, known)
        a, b, c = coefficients
        middle, square = _tidy(-b / (2 * a)), _tidy((b / (2 * a)) ** 2 - c / a)
        values, condition = _real_pair(middle, square)
        return self._rooted(equation, x, values, condition, equations, known)

    def _even_roots(self, equations: Equations, known: Known) -> Case | None:
        """An equation of degree four in one unknown that has only even powers of its distance from a point."""
        for equation in equations:
            present = self._in(equation)
            if len(present) != 1 or sp.degree(equation, present[0]) != 4:
                continue
            x, y = present[0], sp.Dummy("y")
            a, b, *_ = sp.Poly(equation, x).all_coeffs()
            centre = _tidy(-b / (4 * a))
            shifted = sp.Poly(sp.expand(equation.subs(x, y + centre) / a), y).all_coeffs()
            if not (_is_zero(shifted[1]) and _is_zero(shifted[3])):
                continue
            e, f = shifted[2], shifted[4]
            squares, condition = _real_pair(_tidy(-e / 2), _tidy((e / 2) ** 2 - f))
            if condition is not None:
                raise _Stuck
            pairs = [_real_pair(centre, square) for square in squares]
            if any(needs is not None for _, needs in pairs):
                raise _Stuck
            values = tuple(value for found, _ in pairs for value in found)
            return self._rooted(equation, x, values, None, equations, known)
        return None

    def _factors(self, equations: Equations, known: Known) -> Case | None:
        """An equation that is a product."""
        for equation in equations:
            if any(power.exp.is_Rational and power.exp.q > 1 for power in equation.atoms(sp.Pow)):
                continue
            numerator = sp.numer(sp.together(equation))  # parameters may stand below a line
            factors = [factor for factor, _ in sp.factor_list(numerator)[1] if self._in(factor)]
            if len(factors) > 1:
                others = tuple(each for each in equations if each is not equation)
                following = tuple(self.solve((factor, *others), known) for factor in factors)
                return Case("factors", equation, None, tuple(factors), following)
        return None

    def _substitution(self, equations: Equations, known: Known) -> Case | None:
        """An equation that is linear in an unknown, with a number before it."""
        candidates = []
        for equation in equations:
            for x in self._in(equation):
                if sp.degree(equation, x) != 1:
                    continue
                slope = sp.expand(equation).coeff(x, 1)
                if not self._in(slope) and not _is_zero(slope):
                    value = _tidy(-(equation.coeff(x, 0)) / slope)
                    candidates.append((_degree(value, self._in(value)), len(str(value)), equation, x, value))
        if not candidates:
            return None
        _, _, equation, x, value = min(candidates, key=lambda each: each[:2])
        return self._substituted(equation, x, value, equations, known)

    def _substituted(self, equation: sp.Expr, x: sp.Symbol, value: sp.Expr, equations: Equations, known: Known) -> Case:
        return Case("substitute", equation, x, (value,), (self._with(x, value, equations, equation, known),))

    def _rooted(
        self,
        equation: sp.Expr,
        x: sp.Symbol,
        values: tuple[sp.Expr, ...],
        condition: sp.Expr | None,
        equations: Equations,
        known: Known,
    ) -> Case:
        following = tuple(self._with(x, value, equations, equation, known) for value in values)
        return Case("roots", equation, x, values, following, condition=condition)

    def _with(self, x: sp.Symbol, value: sp.Expr, equations: Equations, used: sp.Expr, known: Known) -> Case:
        """Go on with x = value."""
        rest = tuple(_tidy(each.subs(x, value)) for each in equations if each is not used)
        assigned = {name: _tidy(each.subs(x, value)) for name, each in known.items()}
        return self.solve(rest, {**assigned, x: value})


def _tidy(value: sp.Expr) -> sp.Expr:
    return sp.expand(value)


def _degree(value: sp.Expr, unknowns: list[sp.Symbol]) -> int:
    return int(sp.Poly(value, *unknowns).total_degree()) if unknowns else 0


def _is_zero(value: sp.Expr) -> bool:
    """Whether a constant is zero; with roots in it, to 40 digits. Raises _Stuck where parameters leave it open."""
    if value == 0:
        return True
    if value.free_symbols:
        if value.is_zero is None and sp.factor(value).is_zero is None:
            if is_not_zero(value):
                return False
            raise _Stuck
        return bool(value.is_zero or sp.factor(value).is_zero)
    return bool(abs(sp.N(value, DIGITS)) < sp.Float(10) ** (-DIGITS // 2))


def _root_of_sum(square: sp.Expr) -> sp.Expr:
    """√square with the positive factors that its terms share before it: √(q r + 2√p r^{3/2}) = √r √(q + 2√p √r)."""
    fourths = {x: sp.Dummy(str(x), positive=True) for x in sorted(square.free_symbols, key=str) if x.is_positive}
    above, below = sp.fraction(sp.together(square.subs({x: y**4 for x, y in fourths.items()})))
    number, rest = sp.terms_gcd(sp.expand(above)).as_coeff_Mul()
    positive = frozenset(fourths.values())
    shared, others = sp.sift(
        sp.Mul.make_args(rest), lambda each: not each.is_Add and each.free_symbols <= positive, binary=True
    )
    inner = sp.expand(number * sp.Mul(*others))
    back = {y: sp.root(x, 4) for x, y in fourths.items()}
    return (sp.sqrt(sp.Mul(*shared)) * sp.sqrt(inner) / sp.sqrt(below)).xreplace(back)


def _real_pair(middle: sp.Expr, square: sp.Expr) -> tuple[tuple[sp.Expr, ...], sp.Expr | None]:
    """The real ones among middle ± √square, and what must not be negative for that where parameters leave it open."""
    if not square.free_symbols:
        if _is_zero(square):
            return (middle,), None
        if sp.N(square, DIGITS) < 0:
            return (), None
    elif is_positive(-square) or sp.factor(square).is_negative:
        return (), None
    root = _root_of_sum(square) if square.free_symbols else sp.sqrtdenest(sp.sqrt(square))
    known = not square.free_symbols or is_positive(square) or sp.factor(square).is_positive or _of_positives(square)
    return (_tidy(middle + root), _tidy(middle - root)), None if known else square


def _of_positives(value: sp.Expr) -> bool:
    """Whether a quotient of polynomials has factors only that are known to be positive, or squares."""
    if not value.is_rational_function(*value.free_symbols):
        return False
    above, below = sp.fraction(sp.together(value))
    number, factors = sp.factor_list(sp.expand(above * below))
    return bool(number > 0) and all(power % 2 == 0 or known_positive(factor) for factor, power in factors)
