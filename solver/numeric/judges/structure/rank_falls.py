"""The parameters for which a rank falls, judged on points that satisfy the conditions named.

All the falls of the rank on random lines through the space of parameters must be among them.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from random import Random
from typing import Any

import mpmath
import numpy as np
import sympy as sp
from mpmath.libmp.libhyper import NoConvergence
from sympy.polys.matrices import DomainMatrix

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.environment import Environment, Point
from solver.numeric.evaluation.exponential_zeros import exponential_zeros
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.inside import admits
from solver.numeric.evaluation.points import SEED, PointSource, free_symbols
from solver.numeric.evaluation.ranks import rank, rank_at
from solver.numeric.evaluation.values import NotEvaluable
from solver.words import Phrase

DIGITS = 50
ZERO = mpmath.mpf(10) ** -25
LINES = 3


def rank_falls_where(M: Any, condition: Any) -> bool:
    """Whether the rank of M is below the generic one where a condition (Eq, or And of some) holds."""
    equations = _equations(condition)
    if condition.has(sp.Float):
        return _falls_close_by(M, equations)
    return rank_at(M, _point_on(equations, free_symbols(M) | free_symbols(condition))) < rank(M)


def _falls_close_by(M: Any, equations: Sequence[Any]) -> bool:
    """Whether the rank falls at a point that satisfies an equation with decimals to the digits these have."""
    if len(equations) != 1 or len(equations[0].free_symbols) != 1:
        raise NotEvaluable("decimals are judged in one equation for one parameter only")
    (x,) = equations[0].free_symbols
    found = [point for tau, line in _lines(M, x) for point in _falls(M, rank(M), tau, line)]
    return any(_vanishes(equations[0], point) for point in found)


def _equations(condition: Any) -> list[Any]:
    """The left sides less the right sides of the equations of a condition."""
    parts: tuple[Any, ...] = condition.args if isinstance(condition, sp.And) else (condition,)
    if not parts or not all(isinstance(part, sp.Eq) for part in parts):
        raise NotEvaluable("only equations are judged as conditions for a fall of the rank")
    return [part.lhs - part.rhs for part in parts]


def _point_on(equations: Iterable[Any], symbols: Iterable[Any]) -> Point:
    """Return values of the symbols, general ones as far as the equations leave them free."""
    general = {symbol: sp.Rational(complex(value).real) for symbol, value in PointSource(symbols).draw().items()}
    known: dict[Any, Any] = {}
    rest = list(equations)
    while rest:
        rest.sort(key=lambda f: len(f.xreplace(known).free_symbols))
        f = rest.pop(0).xreplace(known)
        unknowns = sorted(f.free_symbols, key=lambda x: (not f.is_polynomial(x), str(x)))
        if not unknowns:
            if abs(mpmath.mpmathify(sp.N(f, DIGITS))) > ZERO:
                raise NotEvaluable("no point was found that satisfies the condition")
            continue
        x = unknowns[0]
        others = {y: general[y] for y in unknowns[1:]}
        known |= others
        known[x] = _root(f.xreplace(others), x)
    point = {**general, **known}
    return {symbol: number(value) for symbol, value in point.items()}


def number(value: Any) -> Any:
    """Return a number with the digits in which ranks are found."""
    found = mpmath.mp.clone()
    found.dps = DIGITS + 10
    real, imaginary = sp.N(value, DIGITS + 10).as_real_imag()
    return found.mpc(*(sp.Float(part, DIGITS + 10)._to_mpmath(300) for part in (real, imaginary)))


def _root(f: Any, x: Any) -> Any:
    """A root in decimals: of a polynomial the first one, real if there is one; else by the secant method."""
    roots = roots_of(f, x)
    if roots:
        return min(roots, key=lambda z: (bool(abs(sp.im(z)) > 1e-30), sp.re(z)))
    raise NotEvaluable("no point was found that satisfies the condition")


def roots_of(f: Any, x: Any) -> list[Any]:
    """The distinct roots of the numerator of a rational function, with 60 digits; with exponentials the real ones."""
    above, _ = sp.fraction(sp.together(f))
    if above.has(sp.exp):
        return exponential_zeros(above, x, DIGITS + 10)
    if not above.is_polynomial(x):
        raise NotEvaluable(Phrase("the condition is not rational in {x}", x=str(x)))
    p = sp.Poly(above, x)
    if p.degree() < 1:
        return []
    try:
        return list(p.sqf_part().nroots(n=DIGITS + 10, maxsteps=500))
    except (sp.polys.polyerrors.DomainError, NoConvergence) as failure:
        raise NotEvaluable("the roots of a condition could not be computed") from failure


def all_differ(conditions: Sequence[Any]) -> bool:
    """Whether no two conditions are the same equations, up to constant factors and their order."""
    symbols = frozenset().union(*(condition.free_symbols for condition in conditions))
    points = PointSource(symbols).several(3)
    listed = [[_direction(f, points) for f in _equations(condition)] for condition in conditions]
    return not any(
        len(one) == len(other) and all(any(_parallel(f, g) for g in other) for f in one)
        for i, one in enumerate(listed)
        for other in listed[:i]
    )


def _direction(f: Any, points: Sequence[Point]) -> Array:
    values = np.array([complex(np.ravel(value_of(f, Environment.at([point])).value)[0]) for point in points])
    return values / (np.linalg.norm(values) or 1.0)


def _parallel(one: Array, other: Array) -> bool:
    return bool(np.linalg.norm(one - np.vdot(other, one) * other) < 1e-12)


def every_fall_is_named(M: Any, conditions: Sequence[Any], along: Any = None) -> bool:
    """Whether one of the conditions holds wherever the rank of M falls on random lines in the space of parameters.

    With `along`, only this parameter varies, or these. Parameters take real values as assumed. Raises NotEvaluable.
    """
    r = rank(M)
    return all(
        holds_somewhere(conditions, point) for tau, line in _lines(M, along) for point in _falls(M, r, tau, line)
    )


def _lines(M: Any, along: Any) -> Iterator[tuple[Any, dict[Any, Any]]]:
    """Lines p + qτ with rational p, q; where exponents are products of parameters, one moves at a time."""
    symbols = sorted(free_symbols(M), key=str)
    tau, random = sp.Dummy("tau"), Random(SEED)  # noqa: S311 - nothing secret
    moving = symbols if along is None else [along] if isinstance(along, sp.Basic) else list(along)
    if len(moving) < 2 or any(sp.Poly(f.args[0], *moving).total_degree() > 1 for f in M.atoms(sp.exp)):
        for x in moving or [tau]:
            others = {y: sp.Rational(random.randint(10, 40), random.randint(7, 13)) for y in symbols if y != x}
            yield tau, {**{y: _as_assumed(y, v) for y, v in others.items()}, x: tau}
        return
    for _ in range(LINES):
        starts = [sp.Rational(random.randint(-30, 30), 7) for _ in symbols]
        slopes = [sp.Rational(random.randint(1, 20) * random.choice((-1, 1)), 3) for _ in symbols]
        lines = zip(symbols, starts, slopes, strict=True)
        yield tau, {y: p + q * tau if y in moving else _as_assumed(y, abs(q)) for y, p, q in lines}


def _as_assumed(symbol: Any, value: Any) -> Any:
    return -value if symbol.is_negative else value


def _falls(M: Any, r: int, tau: Any, line: Mapping[Any, Any]) -> Iterator[dict[Any, Any]]:
    """The points of the line, admissible for all parameters, at which the rank of M is below r."""
    random = Random(SEED)  # noqa: S311 - nothing secret
    U = DomainMatrix.from_Matrix(sp.Matrix(r, M.rows, [random.randint(-9, 9) for _ in range(r * M.rows)]))
    W = DomainMatrix.from_Matrix(sp.Matrix(M.cols, r, [random.randint(-9, 9) for _ in range(r * M.cols)]))
    D = _quotients_on(M, tau, line)
    if D is None:
        on_line = sp.Matrix(M).xreplace(dict(line))
        if not all(_is_judged(entry, tau) for entry in on_line.flat()):
            raise NotEvaluable("the entries are not rational in the parameters")
        D = DomainMatrix.from_Matrix(on_line, extension=True)
    if D.shape != (r, r):
        U, D, W = (each.convert_to(D.domain) for each in (U, D, W))
        D = U * D * W
    minor = D.to_field()
    for root in roots_of(minor.domain.to_sympy(minor.det()), tau):
        if abs(sp.im(root)) > 1e-30:
            continue
        point = {y: sp.N(value.xreplace({tau: sp.re(root)}), DIGITS + 10) for y, value in line.items()}
        if is_admissible(point) and rank_at(M, {y: number(value) for y, value in point.items()}) < r:
            yield point


def _quotients_on(M: Any, tau: Any, line: Mapping[Any, Any]) -> Any:
    """M on the line over the quotients of polynomials in τ, worked out entry by entry, where nothing else is in it.

    To multiply out sums of many parameters with p + qτ in place of each would take minutes.
    """
    K = sp.QQ.frac_field(tau)
    known = {y: K.from_sympy(value) for y, value in line.items() if value.is_rational_function(tau)}
    try:
        rows = [[_quotient(entry, known, K) for entry in row] for row in sp.Matrix(M).tolist()]
    except (KeyError, ZeroDivisionError):
        return None
    return DomainMatrix(rows, M.shape, K)


def _quotient(entry: Any, known: Mapping[Any, Any], K: Any) -> Any:
    """An entry in K; raises KeyError where it is no quotient of polynomials with rational numbers."""
    if entry.is_Rational:
        return K.from_sympy(entry)
    if entry.is_Add or entry.is_Mul:
        parts = [_quotient(part, known, K) for part in entry.args]
        found = parts[0]
        for part in parts[1:]:
            found = found + part if entry.is_Add else found * part
        return found
    if entry.is_Pow and entry.exp.is_Integer:
        return _quotient(entry.base, known, K) ** int(entry.exp)
    return known[entry]


def _is_judged(entry: Any, x: Any) -> bool:
    """Whether an entry is rational in x and in exponentials of x."""
    named = {f: sp.Dummy() for f in entry.atoms(sp.exp)}
    return bool(entry.xreplace(named).is_rational_function(x, *named.values()))


def is_admissible(point: Mapping[Any, Any]) -> bool:
    """Whether real values are as assumed of their symbols."""
    for symbol, value in point.items():
        small = abs(value) < 1e-25
        if (symbol.is_positive and (small or value < 0)) or (symbol.is_negative and (small or value > 0)):
            return False
        if symbol.is_zero is False and small:
            return False
    return admits(point)


def holds_somewhere(conditions: Sequence[Any], point: Mapping[Any, Any]) -> bool:
    """Whether all equations of one of the conditions hold at a point."""
    return any(all(_vanishes(f, point) for f in _equations(condition)) for condition in conditions)


def _vanishes(f: Any, point: Mapping[Any, Any]) -> bool:
    size = sum((abs(sp.N(term.xreplace(dict(point)), 30)) for term in sp.Add.make_args(sp.expand(f))), sp.Float(0))
    known = max([1e-15, *(10 * 2.0 ** -int(each._prec) for each in f.atoms(sp.Float))])
    return bool(abs(sp.N(f.xreplace(dict(point)), 30)) <= known * (1 + size))
