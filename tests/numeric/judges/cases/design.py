"""A = [[0, 1], [−2, −3]], B = [0; 1], C = [1, 0] with poles −4 and −5: K = [18, 6], F = [1; 0], N = 2, by hand."""

import sympy as sp

from solver.numeric.judges.optimal import Weights
from tests.numeric.judges.cases import Case, corruptions, lists_near

M = sp.ImmutableMatrix
A, B, C, D = M([[0, 1], [-2, -3]]), M([0, 1]), M([[1, 0]]), M([[0]])
K, LOOP, POLES = M([[18, 6]]), M([[0, 1], [-20, -9]]), [-4, -5]
REST = M([[0, 1, 0], [-2, -3, 1], [1, 0, 0]])
"""[[A, B], [C, D]]: at rest, with y = 1, x = [1; 0] and u = 2."""

x, k_1, k_2 = sp.symbols("x k_1 k_2")
CHI = x**2 + 9 * x + 20
APART = (M(sp.diag(-1, -2)), M([1, 0]))
EVERYTHING = M([1, 0, 2])
INTEGRATORS = Weights(M([[0, 1], [0, 0]]), M([0, 1]), M(sp.diag(1, 0)), M([[1]]))
AT_REST = M([[0, 1, 0], [0, 0, 1], [1, 0, 0]])
"""Two integrators hold y = 1 with x = [1; 0] and u = 0; the optimal K is [1, √2]."""

CASES = [
    Case("placed_residual", lambda K: (A, B, K, POLES), (K, K.evalf(15)), tuple(corruptions(K))),
    Case("placed_residual", lambda poles: (A, B, K, poles), (POLES, POLES[::-1]), tuple(lists_near(POLES))[:6]),
    Case(
        "placed_matrix_residual",
        lambda loop: (A, B, loop, POLES),
        (LOOP, LOOP.evalf(15)),
        tuple(each for each in corruptions(LOOP) if each.charpoly(x) != LOOP.charpoly(x)),
    ),
    Case(
        "range_residual",
        lambda loop: (A, B, loop),
        (LOOP, A, M([[0, 1], [7, -1]])),
        (M([[0, 2], [-20, -9]]), M([[1, 1], [-20, -9]]), LOOP.T, -LOOP),
    ),
    Case(
        "fit_residual",
        lambda row: (M([[k_1, 2 * k_1]]), [k_1], row),
        (M([[3, 6]]), M([[0, 0]]), M([[-1, -2]])),
        (M([[3, -6]]), M([[6, 3]]), M([[1000, 2001]])),
    ),
    Case("fixed_modes_residual", lambda modes: (*APART, modes), ([-2],), ([2], [-1], [], [-1, -2], [-2, -2])),
    Case(
        "roots_residual",
        lambda p: (p, x, A, B, POLES),
        (CHI, (x + 4) * (x + 5), x * (x + 9) + 20),
        (x**2 - 9 * x + 20, x**2 + 9 * x - 20, x**2 + 20 * x + 9, 2 * CHI, CHI + sp.Rational(1, 1000), CHI * (x + 1)),
    ),
    Case(
        "shape_residual",
        lambda conditions: (A, B, M([[k_1, k_2]]), [k_1, k_2], conditions, POLES),
        ([k_1 - 18, k_2 - 6], [k_2 - 6, 18 - k_1], [k_1 - 3 * k_2, k_1 + k_2 - 24]),
        ([k_1 + 18, k_2 - 6], [k_1 - 6, k_2 - 18], [k_1 - 18], [k_1 - 18, k_2 - sp.Rational(6006, 1000)]),
    ),
    Case(
        "set_point_residual",
        lambda X: (REST, 1, [(sp.eye(3), X)]),
        (EVERYTHING, EVERYTHING.evalf(15)),
        tuple(corruptions(EVERYTHING))[1:],
    ),
    Case(
        "set_point_residual",
        lambda N: (REST, 1, [(M([[0, 0, 1]]), M([[N]]))]),
        (2,),
        (-2, 1, 0, sp.Rational(2001, 1000)),
    ),
    Case(
        "feedforward_residual",
        lambda gain: ((A, B, C, D), M([[gain]]), K, {"discrete": False}),
        (20, sp.Float(20)),
        (-20, 2, 18, sp.Rational(20020, 1000)),
    ),
    Case(
        "feedforward_residual",
        lambda gain: ((A, B, C, D), M([[gain]]), None, POLES, {"discrete": False}),
        (20,),
        (-20, 2, 18, sp.Rational(20020, 1000)),
    ),
    Case(
        "steady_residual",
        lambda known: ((A, B, C, D), known, {"discrete": False}),
        ({"F": M([1, 0])}, {"N": M([[2]])}, {"F": M([1, 0]), "N": M([[2]])}),
        ({"F": M([0, 1])}, {"F": M([-1, 0])}, {"N": M([[-2]])}, {"F": M([1, 0]), "N": M([[1]])}),
    ),
    Case(
        "completed_residual",
        lambda known: (A, B, known, POLES),
        ({0: 18}, {1: 6}, {0: 18, 1: 6}),
        ({0: -18}, {0: 6}, {1: 18}, {0: 18, 1: -6}, {1: sp.Rational(6006, 1000)}),
    ),
    Case("matched_residual", lambda K: ((A, B, C, D), K, 20 / CHI, x), (K,), tuple(corruptions(K))),
    Case(
        "row_space_residual",
        lambda X: (X, M([[1, 2]])),
        (M([[3, 6]]), M([[-1, -2], [0, 0]])),
        (M([[1, -2]]), M([[2, 1]])),
    ),
    Case(
        "joined_spectrum_residual",
        lambda found: (found, [LOOP, M([[-7]])]),
        ([-7, -4, -5],),
        tuple(lists_near([-4, -5, -7])),
    ),
    Case(
        "realization_residual",
        lambda matrices: (matrices, (sp.Integer(1), x**2 + 3 * x + 2), x),
        ((A, B, C, D), (A.T, C.T, B.T, D), (M(sp.diag(-1, -2)), M([1, 1]), M([[1, -1]]), D)),
        ((A, -B, C, D), (A, 2 * B, C, D), (A, C.T, B.T, D), (A.T, B, C, D), (A, B, C, M([[1]])), (-A, B, C, D)),
    ),
    Case(
        "matching_possible",
        lambda target: ((x + 1, x**2 + 3 * x + 7), target, x, {"discrete": False}),
        ((x + 1) / (x**2 + 2 * x + 5), 1 / (x + 3)),
        ((x - 1) / (x**2 + 2 * x + 5), 1 / (x + 3) ** 2, (x + 1) / (x + 3)),
    ),
    Case(
        "reference_residual_at_optimum",
        lambda gain: (INTEGRATORS, AT_REST, 1, gain),
        (M([[1]]), M([[sp.Float(1)]])),
        (M([[-1]]), M([[2]]), M([[sp.sqrt(2)]]), M([[sp.Rational(1001, 1000)]]), M([[1, 1]])),
    ),
]
