"""Judges of controllability, observability and what hangs on them: python-control, scipy, ranks by singular values."""

import itertools
from collections.abc import Iterator

import control
import numpy as np
import sympy as sp
from scipy.integrate import quad_vec
from scipy.linalg import expm, solve_continuous_lyapunov, solve_discrete_lyapunov

from tests.hunt.asked import Point, holds
from tests.hunt.judges.found import Found, hidden, krylov, monic, rank
from tests.hunt.plants import matrices


def controllability(point: Point, found: Found) -> None:
    A, B, _, _ = matrices(point)
    _pair(point, found, A, B, ("controllability_matrix", "controllable", "uncontrollable_modes"))


def observability(point: Point, found: Found) -> None:
    A, _, C, _ = matrices(point)
    _pair(point, found, A.T, C.T, ("observability_matrix", "observable", "unobservable_modes"))


def _pair(point: Point, found: Found, A: np.ndarray, B: np.ndarray, names: tuple[str, str, str]) -> None:
    matrix, verdict, modes = names
    dual = matrix == "observability_matrix"
    theirs = control.obsv(A.T, B.T) if dual else control.ctrb(A, B)
    found.same(matrix, found.matrix(matrix), theirs)
    r = rank(krylov(A / max(1.0, np.linalg.norm(A, 2)), B))
    found.holds("rank", found.number("rank") == r)
    found.holds("verdict", bool(found.values[verdict]) == (r == len(A)))
    if "determinant" in found:
        found.same("determinant", found.matrix("determinant"), [[np.linalg.det(theirs)]])
    if modes in found:
        lost = hidden(A, B)
        found.same(modes, monic(found.list(modes)), monic(lost), 1e-6)
    if "gramian" in found:
        found.same("Gramian", found.matrix("gramian"), _gramian(point, A, B), 1e-8)
    if "exceptions" in found:
        _exceptions(point, found, "observability" if dual else "controllability", r)


def _gramian(point: Point, A: np.ndarray, B: np.ndarray) -> np.ndarray:
    horizon = point.option("horizon")
    if horizon is None:
        return solve_discrete_lyapunov(A, B @ B.T) if point.discrete else solve_continuous_lyapunov(A, -B @ B.T)
    until = point.number(horizon).real
    if point.discrete:
        powers = [np.linalg.matrix_power(A, k) @ B for k in range(round(until))]
        return sum(M @ M.T for M in powers)
    return quad_vec(lambda t: (expm(A * t) @ B) @ (expm(A * t) @ B).T, 0, until, epsabs=1e-12, epsrel=1e-11)[0]


def special_points(point: Point) -> Iterator[Point]:
    """Points where a rank may be lower: small integers and equal values, as far as the question allows them."""
    names = point.question.symbols
    if len(names) > 4:
        return
    for values in itertools.product((0, 1, 2, -1), repeat=len(names)):
        special = Point(point.question, dict(zip(names, map(sp.Integer, values), strict=True)))
        assumed = point.question.assume
        signs = all("positive" not in assumed.get(n, "") or v > 0 for n, v in zip(names, values, strict=True))
        try:
            if signs and all(holds(each, special) for each in point.question.conditions):
                matrices(special)
                yield special
        except (ZeroDivisionError, TypeError, OverflowError):
            continue


def _exceptions(point: Point, found: Found, task: str, generic: int) -> None:
    for special in special_points(point):
        A, B, C, _ = matrices(special)
        if not all(np.all(np.isfinite(M)) for M in (A, B, C)):
            continue
        M = krylov(A, B) if task == "controllability" else krylov(A.T, C.T)
        told = any(_true(each.subs(special.values)) for each in found.values["exceptions"])
        found.holds(f"exceptions at {special.values}", told == (rank(M) < generic))


def _true(relation: sp.Basic) -> bool:
    return bool(relation)


def stabilizability(point: Point, found: Found) -> None:
    A, B, _, _ = matrices(point)
    _hidden_modes(point, found, A, B, "stabilizable")


def detectability(point: Point, found: Found) -> None:
    A, _, C, _ = matrices(point)
    _hidden_modes(point, found, A.T, C.T, "detectable")


def _hidden_modes(point: Point, found: Found, A: np.ndarray, B: np.ndarray, verdict: str) -> None:
    lost = hidden(A, B)
    found.same("hidden modes", monic(found.list("hidden_modes")), monic(lost), 1e-6)
    decays = all(abs(mode) < 1 - 1e-9 if point.discrete else mode.real < -1e-9 for mode in lost)
    if "condition" in found:
        found.holds("condition", bool(found.exactly("condition")) == decays)
    elif verdict in found:
        found.holds("verdict", bool(found.values[verdict]) == decays)


def kalman_decomposition(point: Point, found: Found) -> None:
    A, B, C, _ = matrices(point)
    T, new = found.matrix("T"), found.matrix("A")
    found.holds("T is singular", rank(T) == len(A))
    found.same("A T = T Ã", A @ T, T @ new)
    if "B" in found:
        found.same("T B̃ = B", T @ found.matrix("B"), B)
    if "C" in found:
        found.same("C T = C̃", found.matrix("C"), C @ T)
    orders = [int(each) for each in found.values["orders"]]
    part = point.option("part", "controllable")
    r, q = rank(krylov(A, B)), rank(krylov(A.T, C.T))
    if part == "full":
        both = len(A) - len(hidden(*_visible(A, B, C))) - (len(A) - r)
        found.holds("orders", orders == [both, r - both, q - both, len(A) - r - q + both])
    else:
        found.holds("orders", orders == ([r, len(A) - r] if part == "controllable" else [q, len(A) - q]))
    first = orders[0]
    rest = new[first:, first:]
    if part != "full":
        zero = new[first:, :first] if part == "controllable" else new[:first, first:]
        found.same("zero block", zero, np.zeros_like(zero))
    found.same("hidden modes", monic(found.list("hidden_modes")), monic(np.linalg.eigvals(rest)), 1e-6)


def _visible(A: np.ndarray, B: np.ndarray, C: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The controllable part, turned round: what the output does not show of it is what is not reached."""
    U, s, _ = np.linalg.svd(krylov(A, B))
    U = U[:, : int(np.sum(s > 1e-9 * s[0]))]
    return (U.T @ A @ U).T, (C @ U).T


def parameter_condition(point: Point, found: Found) -> None:
    values = found.exactly("values")
    if not isinstance(values, list) or any(value.free_symbols for value in values):
        return
    name = point.option("parameter") or point.question.symbols[0]
    for value in values:
        found.holds(f"{name} = {value} costs nothing", _lost(point, name, value))
    for trial in (0, 1, -1, 2, sp.Rational(1, 2), -2):
        if "positive" in point.question.assume.get(name, "") and trial <= 0:
            continue
        told = any(abs(complex(value.evalf(20)) - trial) < 1e-9 for value in values)
        found.holds(f"{name} = {trial}", _lost(point, name, sp.sympify(trial)) in (told, None))


def _lost(point: Point, name: str, value: sp.Expr) -> bool | None:
    """Whether the property is lost at a value; None where the system is none there."""
    others = {str(letter): each for letter, each in point.values.items()}
    A, B, C, _ = matrices(Point(point.question, others | {name: value}))
    M = krylov(A, B) if point.option("property", "uncontrollable") == "uncontrollable" else krylov(A.T, C.T)
    return rank(M) < len(A) if np.all(np.isfinite(M)) else None
