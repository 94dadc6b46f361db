"""Whether points are all the real solutions of equations: put into them with 30 digits, and searched for by numbers.

Unknowns may be free (a point then has their own symbol), and whole numbers may stand in the points.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from random import Random
from typing import Any

import numpy as np
import sympy as sp
from sympy.solvers.solveset import NonlinearError

from solver.numeric.evaluation.points import SEED, PointSource
from solver.numeric.evaluation.values import NotEvaluable
from solver.numeric.judges.modelling.compiled import Function, compiled
from solver.numeric.judges.modelling.families import Family

DIGITS = 30
TRIALS = 3
DRAWS = 24
WHOLE = 6
STARTS = 240
STEPS = 60
REACH = 100
"""Where roots are searched without limits, as those that no formula gives; of algebraic equations anywhere."""
FAR, CLOSE = 1e9, 12
NEAR_SINGULAR = 1e-4
"""Newton's method comes near to a multiple root only."""
Point = Mapping[Any, Any]
Vectors = Any


def substitution_residual(
    equations: Sequence[Any], point: Point, parameters: Sequence[Any], hidden: Sequence[Any] = ()
) -> float:
    """Return how far the equations are from holding at a point, in comparison to their terms, with 30 digits.

    What is free, whole numbers and parameters are random. Where roots and inverse functions need parameters of certain
    signs the equations hold for these only: the residual is that of the third best of many draws. `hidden` are unknowns
    that the point does not tell: they are found from the equations that have one of them, and put into the others.
    """
    if hidden:
        return _best_of_hidden(equations, point, parameters, hidden)
    whole, found = Random(SEED), []  # noqa: S311 - nothing secret
    source = PointSource([*parameters, *_symbols_of(point, parameters)])
    for _ in range(DRAWS):
        try:
            drawn = source.draw()
        except NotEvaluable:
            break
        residuals = [_at(equations, point, numbers) for numbers in _numbers(drawn, whole)]
        found.append(max((each for each in residuals if each is not None), default=np.inf))
        if not source.symbols or sum(each < 1e-20 for each in found) == TRIALS:
            break
    return sorted(found)[min(TRIALS, len(found)) - 1] if found else np.inf


def _numbers(drawn: Mapping[Any, Any], whole: Random) -> Iterator[dict[Any, Any]]:
    """Numbers for all symbols: whole numbers of every parity beside the others as they are drawn."""
    integers = [s for s in drawn if s.is_integer]
    for i in range(WHOLE if integers else 1):
        own = {s: sp.Integer(i if j == 0 and i < 2 else whole.randint(-7, 7)) for j, s in enumerate(integers)}
        yield {s: own[s] if s in own else _number(v) for s, v in drawn.items()}


def _at(equations: Sequence[Any], point: Point, numbers: Mapping[Any, Any]) -> float | None:
    """The worst residual with these numbers; infinite where a value is not what is assumed of its unknown.

    None where an equation is not defined there, as sin(x)/x is not at 0.
    """
    at = {x: v.xreplace(dict(numbers)) for x, v in point.items()}
    if not all(map(_is_allowed, at, at.values())):
        return np.inf
    found = [_misfit(e, {**numbers, **at}) for e in equations]
    return (
        None if any(each is None for each in found) else max((each for each in found if each is not None), default=0.0)
    )


def _best_of_hidden(equations: Sequence[Any], point: Point, parameters: Sequence[Any], hidden: Sequence[Any]) -> float:
    """The residual of the third best draw, with the hidden unknowns as Newton's method finds them with doubles."""
    source, whole = PointSource([*parameters, *_symbols_of(point, parameters)]), Random(SEED)  # noqa: S311
    found: list[float] = []
    for _ in range(DRAWS):
        try:
            drawn = source.draw()
        except NotEvaluable:
            break
        found.append(max(_with_hidden(equations, point, numbers, hidden) for numbers in _numbers(drawn, whole)))
        if sum(each < 1e-20 for each in found) == TRIALS:
            break
    return sorted(found)[min(TRIALS, len(found)) - 1] if found else np.inf


def _with_hidden(equations: Sequence[Any], point: Point, numbers: Mapping[Any, Any], hidden: Sequence[Any]) -> float:
    at = {**numbers, **{x: v.xreplace(dict(numbers)) for x, v in point.items()}}
    real = [e.xreplace(at) for e in equations]
    left = [e for e in real if e.free_symbols & set(hidden)]
    misfits = [_misfit(e, {}) for e in real if not e.free_symbols]
    fixed = max((np.inf if each is None else each for each in misfits), default=0.0)
    asked = [x for x in hidden if any(e.has(x) for e in left)]
    if not left:
        return fixed
    exactly = _are_consistent(left, asked)
    return fixed if (len(_solutions(left, asked, {}, 1e9)) if exactly is None else exactly) else np.inf


def _are_consistent(equations: Sequence[Any], unknowns: Sequence[Any]) -> bool | None:
    """Whether linear equations have a solution, exactly; None where they are not linear in rational numbers."""
    try:
        A, b = sp.linear_eq_to_matrix(equations, unknowns)
    except NonlinearError:
        return None
    whole = A.row_join(b)
    return bool(A.rank() == whole.rank()) if all(each.is_Rational for each in whole) else None


def _symbols_of(point: Point, known: Sequence[Any]) -> list[Any]:
    inside = {s for v in point.values() for s in getattr(v, "free_symbols", ())}
    return sorted(inside - set(known), key=str)


def _number(value: Any) -> Any:
    return sp.Rational(value.real if isinstance(value, complex) else value)


def _is_allowed(unknown: Any, value: Any) -> bool:
    """Whether a number is what is assumed of the unknown: real, of a sign."""
    number = value.evalf(DIGITS, maxn=200)
    if not number.is_number:
        return False
    real, imaginary = number.as_real_imag()
    if unknown.is_real is None:
        return True
    signs = not (unknown.is_positive and real <= 0) and not (unknown.is_negative and real >= 0)
    signs = signs and not (unknown.is_nonzero and real == 0)
    return bool(abs(imaginary) <= abs(real) * sp.Float(10) ** -20 + sp.Float(10) ** -20 and signs)


def _misfit(equation: Any, numbers: Mapping[Any, Any]) -> float | None:
    terms = [_evaluated(term, numbers) for term in sp.Add.make_args(equation)]
    whole = _evaluated(equation, numbers)
    if whole is None or any(term is None for term in terms):
        return None
    size = max([1.0, *(abs(complex(term)) for term in terms)])
    return float(abs(complex(whole)) / size)


def _evaluated(expression: Any, numbers: Mapping[Any, Any]) -> Any:
    value = expression.xreplace(dict(numbers)).evalf(DIGITS, maxn=200)
    return value if value.is_number and value.is_finite else None


# ---- other solutions ----


def missing(
    equations: Sequence[Any],
    unknowns: Sequence[Any],
    points: Sequence[Point],
    between: Mapping[Any, tuple[Any, Any]],
    hidden: Sequence[Any] = (),
    leading: Any = None,
) -> list[dict[Any, Any]]:
    """Return real solutions that Newton's method finds from many starting points, and that are none of the points.

    They are searched between the limits given for an unknown, else within ±100 (of algebraic ones anywhere); `hidden`
    are unknowns of the equations that points do not tell. Where the matrix `leading` is singular there is no point.
    """
    every = [*unknowns, *hidden]
    reach = FAR if all(_is_algebraic(e, every) for e in equations) else REACH
    lost: list[dict[Any, Any]] = []
    for numbers in _draws([*equations, *(leading or ())], every):
        real = [e.xreplace(numbers) for e in equations]
        solutions = _solutions(real, every, between, reach)
        own = [Family(point, unknowns, numbers) for point in points]
        for at in solutions:
            told = at[: len(unknowns)]
            if leading is not None and _is_singular(leading.xreplace(numbers), _put(every, at), NEAR_SINGULAR):
                continue
            if not any(each.holds(told) for each in own):
                lost.append(dict(zip(unknowns, told.tolist(), strict=True)))
        if lost:
            break
    return lost


def is_regular_at(matrix: Any, point: Point) -> bool:
    """Return whether a matrix is regular at a point, for random values of what is free."""
    whole = Random(SEED)  # noqa: S311 - nothing secret
    source = PointSource(sorted(matrix.free_symbols | set(_symbols_of(point, ())), key=str))
    for _ in range(DRAWS):
        try:
            drawn = source.draw()
        except NotEvaluable:
            return False
        for numbers in _numbers(drawn, whole):
            at = {x: value.xreplace(numbers) for x, value in point.items()}
            if not _is_singular(matrix.xreplace({s: v for s, v in numbers.items() if s not in at}), at):
                return True
        if not source.symbols:
            break
    return False


def _put(unknowns: Sequence[Any], at: Vectors) -> dict[Any, Any]:
    return {x: sp.Float(value) for x, value in zip(unknowns, at.real.tolist(), strict=True)}


def _is_singular(matrix: Any, at: Mapping[Any, Any], share: float = 1e-9) -> bool:
    """Whether a matrix loses rank at values of its symbols, beside what it is at other ones."""
    elsewhere = {x: sp.Rational(7 + 4 * i, 9) for i, x in enumerate(at)}
    there, usual = (np.array(matrix.xreplace(dict(v)).evalf().tolist(), dtype=complex) for v in (at, elsewhere))
    sizes = np.abs(usual).max(axis=1, keepdims=True)
    least, usually = (np.linalg.svd(each / sizes, compute_uv=False)[-1] for each in (there, usual))
    return bool(not np.isfinite(least) or least < share * usually)


def _draws(equations: Sequence[Any], unknowns: Sequence[Any]) -> Iterator[dict[Any, Any]]:
    inside = {s for e in equations for s in e.free_symbols} - set(unknowns)
    source = PointSource(sorted(inside, key=str))
    for _ in range(2 if inside else 1):
        try:
            yield {s: sp.Rational(v.real if isinstance(v, complex) else v) for s, v in source.draw().items()}
        except NotEvaluable:
            return


def _is_algebraic(equation: Any, unknowns: Sequence[Any]) -> bool:
    """Whether an equation has no functions of the unknowns but powers with rational exponents."""
    inside = {*equation.atoms(sp.Function), *equation.atoms(sp.Pow)}
    return not any(f.has(*unknowns) and not (f.is_Pow and f.exp.is_Rational) for f in inside)


def _solutions(equations: Sequence[Any], unknowns: Sequence[Any], between: Mapping[Any, Any], reach: float) -> Vectors:
    """Newton's method with least squares, from all starting points at once; only what is inside the limits."""
    equations = equations or [sp.S.Zero]  # without any, every value is a solution
    values = [compiled(e) for e in equations]
    slopes = [[compiled(sp.diff(e, x)) for x in unknowns] for e in equations]
    low, high = (
        np.array([float(between[x][i]) if x in between else (-1) ** (i + 1) * reach for x in unknowns]) for i in (0, 1)
    )
    X = _starts(low, high)
    if any(x.is_real is None for x in unknowns):
        X = X + 1j * _starts(low, high)[::-1] * np.array([x.is_real is None for x in unknowns])
    with np.errstate(all="ignore"):
        for _ in range(STEPS):
            at = dict(zip(unknowns, X.T, strict=True))
            F, J = _values(values, at, len(X)), _slopes(slopes, at, len(X))
            good = np.isfinite(F).all(axis=1) & np.isfinite(J).all(axis=(1, 2))
            X, F, J = X[good], F[good], J[good]
            if not len(X):
                return X
            scale = 1 / np.maximum(np.abs(J).max(axis=2, keepdims=True), 1e-300)
            X = X - (np.linalg.pinv(J * scale, rcond=1e-9) @ (F[..., None] * scale))[..., 0]
            X = X[(np.abs(X) < 1e12).all(axis=1)]
        at = dict(zip(unknowns, X.T, strict=True))
        F = _values(values, at, len(X))
        size = np.maximum(1.0, _sizes(equations, at, len(X)))
        inside = ((low <= X.real) & (high >= X.real)).all(axis=1) if len(X) else np.zeros(0, bool)
        for i, x in enumerate(unknowns if len(X) else ()):
            inside &= (X[:, i].real > 0) if x.is_positive else (X[:, i].real < 0) if x.is_negative else True
            if x.is_nonzero:  # Newton's method comes near to a multiple root only
                at_zero = _values(values, {**at, x: np.zeros_like(X[:, i])}, len(X))
                inside &= ~((np.abs(at_zero) <= 1e-10 * size).all(axis=1) & (np.abs(X[:, i]) < 1e-3))
        return X[(np.abs(F) <= 1e-10 * size).all(axis=1) & inside] if len(X) else X


def _starts(low: Vectors, high: Vectors) -> Vectors:
    random = np.random.default_rng(SEED)
    spread = random.uniform(0, 1, (STARTS, len(low)))
    near = random.uniform(-2, 2, (STARTS // 3, len(low)))
    small = random.uniform(-0.2, 0.2, (STARTS // 6, len(low)))
    wide = random.uniform(0, 1, near.shape)
    far = np.exp(random.uniform(0, np.log(1e4), near.shape)) * random.choice([-1, 1], near.shape)
    is_wide = high - low >= 2 * REACH
    a, b = np.where(is_wide, -CLOSE, low), np.where(is_wide, CLOSE, high)
    inside = [a + (b - a) * spread, low + (high - low) * wide if (high - low < FAR).all() else far]
    inside += [np.clip(each, low, high) for each in (near, small, far)]
    return np.vstack(inside)


def _values(functions: Sequence[Function], at: Mapping[Any, Any], count: int) -> Vectors:
    return np.stack([np.broadcast_to(f(at), (count,)) for f in functions], axis=1)


def _slopes(functions: Sequence[Sequence[Function]], at: Mapping[Any, Any], count: int) -> Vectors:
    return np.stack([_values(row, at, count) for row in functions], axis=1)


def _sizes(equations: Sequence[Any], at: Mapping[Any, Any], count: int) -> Vectors:
    terms = [[compiled(term) for term in sp.Add.make_args(e)] for e in equations]
    return np.stack([np.max(np.abs(_values(row, at, count)), axis=1) for row in terms], axis=1)
