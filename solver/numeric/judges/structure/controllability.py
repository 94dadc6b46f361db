"""Controllability and its dual judged: Krylov's matrix, hidden modes, and the parameters for which a rank falls.

Hidden modes are judged by their polynomial in an orthonormal basis found with 50 digits. Conditions for parameters are
judged on points that satisfy them, and by all the falls of the rank on random lines through the space of parameters.
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

from solver.numeric.evaluation.arithmetic import Array, multiple
from solver.numeric.evaluation.compare import Point, worst_of
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.inside import admits
from solver.numeric.evaluation.points import SEED, PointSource, free_symbols
from solver.numeric.evaluation.ranks import rank, rank_at
from solver.numeric.evaluation.values import NotEvaluable
from solver.numeric.judges.linear_algebra.eigen import spectrum_residual
from solver.words import Phrase

DIGITS = 50
ZERO = mpmath.mpf(10) ** -25
LINES = 3
NEAR = 1e-10
"""Eigenvalues nearer to the boundary of the region of stability count as on it."""


def krylov_matrix(A: Any, B: Any) -> Any:
    """Return [B, AB, …, Aⁿ⁻¹B], multiplied out by sympy."""
    blocks = [sp.Matrix(B)]
    for _ in range(A.rows - 1):
        blocks.append(A * blocks[-1])
    return sp.ImmutableMatrix(sp.Matrix.hstack(*blocks))


def hidden_modes_residual(A: Any, B: Any, modes: Sequence[Any]) -> float:
    """Return how far Π(x − λᵢ) is from the characteristic polynomial of what B does not reach, relatively.

    Infinite if the number of modes is wrong. Raises NotEvaluable.
    """
    symbols = free_symbols([A, B, list(modes)])
    worst = 0.0
    for point in PointSource(symbols).several(2 if symbols else 1):
        exact = {symbol: sp.Rational(value.real) for symbol, value in _complex(point).items()}
        H = _unreached(A.xreplace(exact), B.xreplace(exact))
        if len(modes) != H.rows:
            return float("inf")
        if H.rows:
            here = [mode.xreplace(exact) for mode in modes]
            worst = worst_of((worst, spectrum_residual(H, here)))
    return worst


def hidden_modes_decay(A: Any, B: Any, *, discrete: bool) -> bool:
    """Whether all that B does not reach decays, at random values of the parameters.

    Raises NotEvaluable where it depends on them.
    """
    symbols = free_symbols([A, B])
    found = set()
    for point in PointSource(symbols).several(5 if symbols else 1):
        exact = {symbol: sp.Rational(value.real) for symbol, value in _complex(point).items()}
        found.add(_decays(_unreached(A.xreplace(exact), B.xreplace(exact)), discrete=discrete))
    if len(found) > 1:
        raise NotEvaluable("it depends on the values of the parameters")
    return found.pop()


def _decays(H: Any, *, discrete: bool) -> bool:
    """Whether the eigenvalues are inside the region of stability; those that may be on its boundary are not."""
    if H.rows == 0:
        return True
    mp = multiple(2 * DIGITS).context
    M = value_of(H, Environment.at([{}], multiple(2 * DIGITS))).value[0]
    values = mp.eig(mp.matrix(M.tolist()), right=False) if len(M) > 1 else [M[0, 0]]
    return all((abs(value) - 1 if discrete else mp.re(value)) < -NEAR * (1 + abs(value)) for value in values)


def _complex(point: Mapping[Any, Any]) -> dict[Any, complex]:
    return {symbol: complex(value) for symbol, value in point.items()}


def hidden_of_both_residual(A: Any, B: Any, C: Any, modes: Sequence[Any]) -> float:
    """Return what `hidden_modes_residual` does, for the modes that B does not reach or C does not see.

    B or C is None where it does not matter. Those are the modes that B does not reach, and of the part that it reaches
    those that C does not see.
    """
    symbols = free_symbols([A, list(modes), *(M for M in (B, C) if M is not None)])
    worst = 0.0
    for point in PointSource(symbols).several(2 if symbols else 1):
        exact = {symbol: sp.Rational(value.real) for symbol, value in _complex(point).items()}
        hidden, F, H = [], A.xreplace(exact), C.xreplace(exact) if C is not None else None
        if B is not None:
            hidden = [_unreached(F, B.xreplace(exact))]
            F, H = _restricted(F, B.xreplace(exact), H)
        if H is not None:
            hidden.append(_unreached(F.T, H.T))
        whole = sp.ImmutableMatrix(sp.diag(*hidden))
        if len(modes) != whole.rows:
            return float("inf")
        if whole.rows:
            worst = worst_of(
                (worst, spectrum_residual(whole, [(sp.Integer(0) + mode).xreplace(exact) for mode in modes]))
            )
    return worst


def _unreached(A: Any, B: Any) -> Any:
    """N A Nᴴ with orthonormal rows N of the complement of the span of B, AB, …, in decimals."""
    F, _, outside = _bases(A, B)
    return _in_basis(F, outside)


def _bases(A: Any, B: Any) -> tuple[Array, list[Array], list[Array]]:
    """Return A with many digits, an orthonormal basis of the span of B, AB, …, and one of its complement."""
    many = multiple(DIGITS)
    F, G = (value_of(M, Environment.at([{}], many)).value[0] for M in (A, B))
    noise = _noise(F)
    reached: list[Array] = []
    fresh = [G[:, j] for j in range(G.shape[1])]
    while fresh:
        added = [q for v in fresh if (q := _added(reached, v, many.context)) is not None]
        fresh = [v for q in added if float(np.max(many.size(v := F @ q))) > noise]
    whole = list(reached)
    unit = many.array(np.eye(len(F)))
    return F, reached, [q for j in range(len(F)) if (q := _added(whole, unit[:, j], many.context)) is not None]


def _noise(F: Array) -> float:
    return 1e-40 * float(np.max(multiple(DIGITS).size(F), initial=0.0))


def _in_basis(F: Array, basis: list[Array]) -> Any:
    """Qᴴ F Q in decimals."""
    k, noise = len(basis), _noise(F)
    rows = [[sum(a.conjugate() * b for a, b in zip(q, F @ p, strict=True)) for p in basis] for q in basis]
    return sp.ImmutableMatrix(k, k, [_decimal(entry) if abs(entry) > noise else 0 for row in rows for entry in row])


def _restricted(A: Any, B: Any, C: Any) -> tuple[Any, Any]:
    """Return A and C (or None) on the span of B, AB, …, in an orthonormal basis of it, in decimals."""
    F, reached, _ = _bases(A, B)
    if C is None or not reached:
        return _in_basis(F, reached), None
    H = value_of(C, Environment.at([{}], multiple(DIGITS))).value[0]
    columns = [H @ q for q in reached]
    seen = sp.ImmutableMatrix(len(H), len(columns), lambda i, j: _decimal(columns[j][i]))
    return _in_basis(F, reached), seen


def _added(basis: list[Array], v: Array, mp: Any) -> Array | None:
    """Make v orthonormal to the basis and append it; None if it lies in its span."""
    length = mp.sqrt(sum(abs(a) ** 2 for a in v))
    if length == 0:
        return None
    v = v / length
    for _ in range(2):  # twice is enough (Kahan)
        for q in basis:
            v = v - q * sum(a.conjugate() * b for a, b in zip(q, v, strict=True))
    length = mp.sqrt(sum(abs(a) ** 2 for a in v))
    if length < ZERO:
        return None
    basis.append(v / length)
    return basis[-1]


def _decimal(number: Any) -> Any:
    real = sp.Float(number.real, DIGITS)
    return real if not number.imag else real + sp.I * sp.Float(number.imag, DIGITS)


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
    general = {symbol: sp.Rational(value.real) for symbol, value in _complex(PointSource(symbols).draw()).items()}
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
    return {symbol: _number(value) for symbol, value in point.items()}


def _number(value: Any) -> Any:
    found = mpmath.mp.clone()
    found.dps = DIGITS + 10
    real, imaginary = sp.N(value, DIGITS + 10).as_real_imag()
    return found.mpc(*(sp.Float(part, DIGITS + 10)._to_mpmath(300) for part in (real, imaginary)))


def _root(f: Any, x: Any) -> Any:
    """A root in decimals: of a polynomial the first one, real if there is one; else by the secant method."""
    roots = _roots(f, x)
    if roots:
        return min(roots, key=lambda z: (abs(sp.im(z)) > 1e-30, sp.re(z)))
    raise NotEvaluable("no point was found that satisfies the condition")


def _roots(f: Any, x: Any) -> list[Any]:
    """The distinct roots of the numerator of a rational function, with 60 digits."""
    above, _ = sp.fraction(sp.together(f))
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

    With `along`, only this parameter varies. Parameters take real values as assumed. Raises NotEvaluable.
    """
    r = rank(M)
    return all(
        _holds_somewhere(conditions, point) for tau, line in _lines(M, along) for point in _falls(M, r, tau, line)
    )


def _lines(M: Any, along: Any) -> Iterator[tuple[Any, dict[Any, Any]]]:
    """Lines p + qτ with rational p, q."""
    symbols = sorted(free_symbols(M), key=str)
    tau, random = sp.Dummy("tau"), Random(SEED)  # noqa: S311 - nothing secret
    if along is not None or len(symbols) < 2:
        x = along if along is not None else symbols[0] if symbols else tau
        others = {y: sp.Rational(random.randint(10, 40), random.randint(7, 13)) for y in symbols if y != x}
        yield tau, {**{y: _as_assumed(y, v) for y, v in others.items()}, x: tau}
        return
    for _ in range(LINES):
        starts = [sp.Rational(random.randint(-30, 30), 7) for _ in symbols]
        slopes = [sp.Rational(random.randint(1, 20) * random.choice((-1, 1)), 3) for _ in symbols]
        yield tau, {y: p + q * tau for y, p, q in zip(symbols, starts, slopes, strict=True)}


def _as_assumed(symbol: Any, value: Any) -> Any:
    return -value if symbol.is_negative else value


def _falls(M: Any, r: int, tau: Any, line: Mapping[Any, Any]) -> Iterator[dict[Any, Any]]:
    """The points of the line, admissible for all parameters, at which the rank of M is below r."""
    random = Random(SEED)  # noqa: S311 - nothing secret
    U = DomainMatrix.from_Matrix(sp.Matrix(r, M.rows, [random.randint(-9, 9) for _ in range(r * M.rows)]))
    W = DomainMatrix.from_Matrix(sp.Matrix(M.cols, r, [random.randint(-9, 9) for _ in range(r * M.cols)]))
    on_line = sp.Matrix(M).xreplace(dict(line))
    if not all(entry.is_rational_function(tau) for entry in on_line.flat()):
        raise NotEvaluable("the entries are not rational in the parameters")
    D = DomainMatrix.from_Matrix(on_line, extension=True)
    U, D, W = (each.convert_to(D.domain) for each in (U, D, W))
    minor = (U * D * W).to_field()
    for root in _roots(minor.domain.to_sympy(minor.det()), tau):
        if abs(sp.im(root)) > 1e-30:
            continue
        point = {y: sp.N(value.xreplace({tau: sp.re(root)}), DIGITS + 10) for y, value in line.items()}
        if _admissible(point) and rank_at(M, {y: _number(value) for y, value in point.items()}) < r:
            yield point


def _admissible(point: Mapping[Any, Any]) -> bool:
    """Whether real values are as assumed of their symbols."""
    for symbol, value in point.items():
        small = abs(value) < 1e-25
        if (symbol.is_positive and (small or value < 0)) or (symbol.is_negative and (small or value > 0)):
            return False
        if symbol.is_zero is False and small:
            return False
    return admits(point)


def _holds_somewhere(conditions: Sequence[Any], point: Mapping[Any, Any]) -> bool:
    return any(all(_vanishes(f, point) for f in _equations(condition)) for condition in conditions)


def _vanishes(f: Any, point: Mapping[Any, Any]) -> bool:
    size = sum((abs(sp.N(term.xreplace(dict(point)), 30)) for term in sp.Add.make_args(sp.expand(f))), sp.Float(0))
    known = max([1e-15, *(10 * 2.0 ** -int(number._prec) for number in f.atoms(sp.Float))])
    return bool(abs(sp.N(f.xreplace(dict(point)), 30)) <= known * (1 + size))
