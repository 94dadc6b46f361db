"""Whether an answer with many right values is right, by numpy from the definition; for tests of marking.

Nothing of the solver's oracles takes part. Each judge gets the question's system and options and the value; None where
it says nothing about this answer.
"""

import numpy as np
import sympy as sp

CLOSE = 1e-7
POINT = (0.7310, 1.3170, -0.6130, 2.1190, 0.3710)


def numbers(M, symbols=()):
    """A matrix as complex numbers; symbols get fixed values, the same ones everywhere."""
    if M is None:
        return None
    at = dict(zip(sorted(symbols, key=str), POINT * 3, strict=False))
    return np.array(sp.Matrix(M).subs(at).evalf(20).tolist(), dtype=complex).reshape(M.shape)


def still_right(task, name, given, ours, value):
    """Whether a matrix is right: by the definition of a free answer, else by being the same; corners by the roots."""
    if (task, name) == ("bode", "corner_frequencies"):
        return _corners(given.system, value)
    symbols = set().union(*(getattr(each, "free_symbols", set()) for each in [value, ours, *_matrices(given.system)]))
    judge = JUDGES.get((task, name))
    if judge is None or not isinstance(value, sp.MatrixBase):
        return None
    if value.shape != ours.shape:
        return False
    plant = {key: numbers(M, symbols) for key, M in zip("ABCD", _matrices(given.system), strict=True)}
    with np.errstate(all="ignore"):
        right = judge(plant, numbers(value, symbols), numbers(ours, symbols), given)
    return None if right is None else bool(right)


def _matrices(system):
    return [getattr(system, key, None) for key in "ABCD"]


def _corners(loop, value):
    """The sizes of the roots; those of pairs stand once, or all of them twice."""
    factors = [each for p in (loop.numerator, loop.denominator) for each in sp.Poly(p, loop.variable).factor_list()[1]]
    roots = [z for factor, power in factors for z in factor.nroots() * power if z != 0]
    once = [float(abs(z)) for z in roots if sp.im(z) >= 0]
    found = [float(each) for each in value]
    return any(
        len(found) == len(right) and np.allclose(found, sorted(right), atol=0, rtol=CLOSE)
        for right in (once, [float(abs(z)) for z in roots])
    )


def _same_polynomial(A, B):
    return A.shape == B.shape and np.allclose(np.poly(A), np.poly(B), atol=CLOSE, rtol=CLOSE)


def _eigenvectors(plant, V, ours, given, *, rows=False):
    """V⁻¹ A V is a Jordan form: eigenvalues on the diagonal, ones or zeros above it, and nothing else."""
    A, V = (plant["A"].T, V.T) if rows else (plant["A"], V)
    if np.linalg.matrix_rank(V, tol=CLOSE) < len(V):
        return False
    J = np.linalg.solve(V, A @ V)
    above = np.diag(J, -1 if rows else 1)
    off = J - np.diag(np.diag(J)) - np.diag(above, -1 if rows else 1)
    d = np.diag(J)
    linked = [abs(x) < CLOSE or (abs(x - 1) < CLOSE and abs(d[i] - d[i + 1]) < CLOSE) for i, x in enumerate(above)]
    ranks = all(
        np.linalg.matrix_rank(J - x * np.eye(len(J)), tol=CLOSE)
        == np.linalg.matrix_rank(A - x * np.eye(len(A)), tol=CLOSE)
        for x in d
    )
    return bool(np.abs(off).max(initial=0) < CLOSE and all(linked) and ranks)


def _spans(plant, M, ours, given):
    """The same space as ours, by independent columns."""
    rank = np.linalg.matrix_rank
    return bool(rank(M) == M.shape[1] == rank(np.hstack([M, ours])))


def _places(plant, K, ours, given, *, dual=False):
    A, B = (plant["A"].T, plant["C"].T) if dual else (plant["A"], plant["B"])
    K, ours = (K.T, ours.T) if dual else (K, ours)
    return _same_polynomial(A - B @ K, A - B @ ours)


def _closed(plant, loop, ours, given, *, dual=False):
    """The right polynomial, and A − BK for some K."""
    A, B = (plant["A"].T, plant["C"].T) if dual else (plant["A"], plant["B"])
    loop, ours = (loop.T, ours.T) if dual else (loop, ours)
    return _same_polynomial(loop, ours) and np.linalg.matrix_rank(np.hstack([B, A - loop])) == np.linalg.matrix_rank(B)


def _follows(plant, F, ours, given):
    """C F + D N = I and A F + B N = 0 for some N."""
    A, B, C = plant["A"], plant["B"], plant["C"]
    D = plant["D"] if plant["D"] is not None else np.zeros((len(C), B.shape[1]))
    left, right = np.vstack([B, D]), np.vstack([-A @ F, np.eye(len(C)) - C @ F])
    N = np.linalg.lstsq(left, right, rcond=None)[0]
    return bool(np.allclose(left @ N, right, atol=CLOSE))


def _similar_block_triangular(plant, M, ours, given):
    """The eigenvalues of each diagonal block of ours, and its zeros."""
    part = given.options.part
    if part == "full":
        return None
    n, r = len(M), _visible(plant, part)
    zero = M[r:, :r] if part == "controllable" else M[:r, r:]
    blocks = (slice(0, r), slice(r, n))
    return bool(
        np.abs(zero).max(initial=0) < CLOSE
        and all(_same_polynomial(M[b, b], ours[b, b]) for b in blocks if b.stop > b.start)
    )


def _visible(plant, part):
    A, B = (plant["A"], plant["B"]) if part == "controllable" else (plant["A"].T, plant["C"].T)
    return np.linalg.matrix_rank(np.hstack([np.linalg.matrix_power(A, i) @ B for i in range(len(A))]), tol=CLOSE)


def _coordinates(plant, T, ours, given):
    part = given.options.part
    if np.linalg.matrix_rank(T, tol=CLOSE) < len(T):
        return False
    if part == "full":
        return None
    A, B, C = plant["A"], plant["B"], plant["C"]
    r = _visible(plant, part)
    transformed = np.linalg.solve(T, A @ T)
    if part == "controllable":
        zeros = [transformed[r:, :r], np.linalg.solve(T, B)[r:]]
    else:
        zeros = [transformed[:r, r:], (C @ T)[:, r:]]
    return bool(all(np.abs(zero).max(initial=0) < CLOSE for zero in zeros))


JUDGES = {
    ("eigenstructure", "right_eigenvectors"): _eigenvectors,
    ("eigenstructure", "left_eigenvectors"): lambda *of: _eigenvectors(*of, rows=True),
    **{("fundamental_subspaces", f"{name}_space"): _spans for name in ("null", "column", "row", "left_null")},
    ("pole_placement", "K"): _places,
    ("pole_placement", "closed_loop_A"): _closed,
    ("observer", "L"): lambda *of: _places(*of, dual=True),
    ("observer", "error_A"): lambda *of: _closed(*of, dual=True),
    ("reference_tracking", "K"): _places,
    ("reference_tracking", "F"): _follows,
    ("optimal_tracking", "F"): _follows,
    ("kalman_decomposition", "A"): _similar_block_triangular,
    ("kalman_decomposition", "T"): _coordinates,
}
