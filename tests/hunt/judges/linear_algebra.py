"""Judges of linear algebra."""

from typing import Any

import mpmath
import numpy as np
import sympy as sp

from tests.hunt.asked import Point, parsed
from tests.hunt.judges.found import Found, rank
from tests.hunt.plants import matrices


def characteristic_polynomial(point: Point, found: Found) -> None:
    found.polynomial("det(λ − A)", "polynomial", "lamda", matrices(point)[0])


def eigenstructure(point: Point, found: Found) -> None:
    A = matrices(point)[0]
    J, V, W = (found.matrix(name) for name in ("jordan_form", "right_eigenvectors", "left_eigenvectors"))
    values = found.list("eigenvalues")
    found.spectrum("eigenvalues", values, A)
    found.same("diagonal of J", np.diag(J), values)
    found.same("A V = V J", A @ V, V @ J)
    found.same("W A = J W", W @ A, J @ W)
    found.holds("V is singular", rank(V) == len(A))
    found.holds("W is singular", rank(W) == len(A))
    ones = np.diag(J, 1)
    found.holds("J is no Jordan form", np.allclose(J, np.diag(values) + np.diag(ones, 1)) and set(ones) <= {0, 1})
    found.holds("diagonalizable", bool(found.values["diagonalizable"]) == (not np.any(ones)))


def fundamental_subspaces(point: Point, found: Found) -> None:
    M = point.matrix(point.option("matrix") or point.question.system.get("matrix") or point.question.system["A"])
    r = rank(M)
    spaces = {name: found.matrix(name) for name in ("null_space", "column_space", "row_space", "left_null_space")}
    found.holds("rank", found.number("rank") == r)
    dimensions = {"null_space": M.shape[1] - r, "column_space": r, "row_space": r, "left_null_space": M.shape[0] - r}
    for name, dimension in dimensions.items():
        found.holds(f"dimension of {name}", spaces[name].shape[1] == dimension == rank(spaces[name]))
    found.same("M N = 0", M @ spaces["null_space"], np.zeros((len(M), M.shape[1] - r)))
    found.same("Mᵀ L = 0", M.T @ spaces["left_null_space"], np.zeros((M.shape[1], len(M) - r)))
    found.holds("column space", rank(np.hstack([M, spaces["column_space"]])) == r)
    found.holds("row space", rank(np.hstack([M.T, spaces["row_space"]])) == r)


def similarity_transformation(point: Point, found: Found) -> None:
    A, B, C, D = matrices(point)
    T = point.matrix(point.option("T"))
    found.same("T⁻¹AT", found.matrix("A"), np.linalg.solve(T, A @ T))
    for name, theirs in (("B", np.linalg.solve(T, B)), ("C", C @ T), ("D", D)):
        if name in found:
            found.same(name, found.matrix(name), theirs)


def matrix_function(point: Point, found: Found) -> None:
    A = mpmath.matrix(matrices(point)[0].tolist())
    for time in (1, 3) if {"t", "k"} & set(map(str, parsed(point.option("function")).free_symbols)) else (1,):
        with mpmath.workdps(25):
            theirs = np.array(_value(parsed(point.option("function")), A, point, time).tolist(), dtype=complex)
        found.same("f(A)", found.matrix("F", t=time, k=time), theirs.reshape(A.rows, A.cols))


FUNCTIONS: dict[str, Any] = {
    "exp": mpmath.expm,
    "sqrt": mpmath.sqrtm,
    "log": mpmath.logm,
    "sin": mpmath.sinm,
    "cos": mpmath.cosm,
}


def _value(f: sp.Expr, A: Any, point: Point, time: int) -> Any:
    """f(A) by mpmath, operation by operation; numbers are numbers, the letter I the identity."""
    of = [_value(each, A, point, time) for each in f.args] if f.args else []
    if f.is_Symbol:
        known = {"A": A, "I": mpmath.eye(A.rows), "t": mpmath.mpf(time), "k": time}
        return known[f.name] if f.name in known else mpmath.mpmathify(point.number(f))
    if f.is_Add:
        return sum(of[1:], of[0])
    if f.is_Mul:
        total = of[0]
        for each in of[1:]:
            total = total * each
        return total
    if f.is_Pow:
        return mpmath.sqrtm(of[0]) if f.exp == sp.Rational(1, 2) else of[0] ** (time if f.exp.is_Symbol else int(f.exp))
    if f.args:
        name = f.func.__name__
        return mpmath.inverse(of[0]) if name == "inv" else FUNCTIONS[name](of[0])
    return mpmath.mpf(f.p) / f.q if f.is_Rational else mpmath.mpmathify(complex(f))
