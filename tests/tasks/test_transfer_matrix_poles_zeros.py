"""Poles and zeros of several inputs and outputs: textbook values, scipy's pencils, corruptions, marking, parameters."""

import numpy as np
import pytest
import scipy.linalg
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.classroom import Verdict
from solver.derivation import CheckStatus, Status
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.systems import TransferFunction
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected, system
from tests.helpers.marked import verdict
from tests.helpers.strategies import systems
from tests.helpers.tried import tried

TASK = "transfer_matrix_poles_zeros"
METHODS = ("minors", "smith_mcmillan", "rosenbrock")
M = sp.Matrix
s, z, k = sp.symbols("s z k")


def matrix(rows, *, x=s):
    """The transfer matrix with these entries."""
    G = sp.ImmutableMatrix(rows)
    pairs = [[sp.fraction(sp.together(entry)) for entry in row] for row in G.tolist()]
    tops, bottoms = (tuple(tuple(sp.expand(pair[i]) for pair in row) for row in pairs) for i in (0, 1))
    return TransferFunction(G.applyfunc(sp.cancel), tops, bottoms, x, discrete=str(x) == "z")


def sorted_values(values):
    """Values in an order of their own."""
    return sorted((complex(value) for value in values), key=lambda each: (round(each.real, 6), round(each.imag, 6)))


# Skogestad and Postlethwaite, Multivariable Feedback Control (2005), section 4.5
EXAMPLE_4_10 = matrix([[(s - 1) / (s + 2), 4 / (s + 2)], [sp.Rational(9, 2) / (s + 2), 2 * (s - 1) / (s + 2)]])
EXAMPLE_4_13 = matrix([[(s - 1) / (s - 2), 0], [0, (s - 2) / (s - 1)]])
SHARED = matrix([[(s + 2) / (s + 1), 0], [0, (s + 1) / (s + 2)]])
LOW_RANK = matrix([[1 / (s + 1), 2 / (s + 1)], [2 / (s + 1), 4 / (s + 1)]])
HIDDEN = system(
    sp.diag(-1, -2, -3, -4), B=[[1, 0], [0, 1], [0, 0], [0, 0]], C=[[1, 1, 1, 0], [1, -1, 0, 0]], D=[[0, 0], [0, 0]]
)
COURSE = system([[0, 1, 0], [0, 0, 1], [6, -11, 6]], B=[[1, 0], [0, 1], [1, 1]], C=[[1, 0, 0], [0, 0, 1]])


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    ("plant", "poles", "zeros", "rank"),
    [
        (EXAMPLE_4_10, [-2], [4], 2),
        (EXAMPLE_4_13, [1, 2], [1, 2], 2),
        (SHARED, [-2, -1], [-2, -1], 2),
        (LOW_RANK, [-1], [], 1),
        (COURSE, [1, 2, 3], [12], 2),
        (HIDDEN, [-2, -1], [], 2),
        (matrix([[1 / (s + 1), 1 / (s + 1)], [1 / (s + 1), 0]]), [-1, -1], [], 2),
        (matrix([[1 / (s + 1)], [1 / (s + 2)]]), [-2, -1], [], 1),
        (matrix([[(s + 3) / (s + 1)], [(s + 3) / (s + 2)]]), [-2, -1], [-3], 1),
        (matrix([[1, 2], [3, 4]]), [], [], 2),
        (matrix([[(s - 1) ** 2 / (s + 1) ** 2]]), [-1, -1], [1, 1], 1),
        (matrix([[0, 0], [0, 0]]), [], [], 0),
    ],
)
def test_known_poles_and_zeros(plant, poles, zeros, rank, method):
    result = ask(TASK, plant, method)
    assert result.status is Status.VERIFIED, result.reason or [
        c for c in result.checks if c.status is CheckStatus.FAILED
    ]
    assert sorted_values(result.answers["poles"]) == poles
    assert sorted_values(result.answers["zeros"]) == zeros
    assert result.answers["normal_rank"] == rank


def test_example_4_8_of_skogestad_and_postlethwaite():
    """Poles −1, 1, −2, −2: the minors of second order count the pole −2 twice; the zero 1 is where a pole is."""
    half = (s + 1) * (s + 2) * (s - 1)
    G = matrix([[(s - 1) * (s + 2), 0, (s - 1) ** 2], [-(s + 1) * (s + 2), (s - 1) * (s + 1), (s - 1) * (s + 1)]])
    G = matrix((G.matrix / half).applyfunc(sp.cancel))
    for method in METHODS:
        answers = ask(TASK, G, method).answers
        assert sorted_values(answers["poles"]) == [-2, -2, -1, 1]
        assert answers["zeros"] == [1]


def test_all_minors_are_listed_in_lowest_terms():
    steps = {step.kind: step for step in ask(TASK, EXAMPLE_4_10, "minors").steps}
    assert [*steps][:6] == ["monic", "lowest", "entries", "minors", "pole_polynomial", "zero_polynomial"]
    assert sp.cancel(steps["minors"].claims["minor1"].right - 2 * (s - 4) / (s + 2)) == 0
    assert steps["pole_polynomial"].claims["expanded"].right.expand() == s + 2


def test_decoupling_zeros_are_named():
    for method in METHODS:
        answers = ask(TASK, HIDDEN, method).answers
        assert sorted(answers["invariant_zeros"]) == [-4, -3]
        assert sorted(answers["input_decoupling_zeros"]) == [-4, -3]
        assert answers["output_decoupling_zeros"] == [-4]
    step = next(step for step in ask(TASK, HIDDEN, "rosenbrock").steps if step.kind == "decoupling_zeros")
    assert step.values["both"] == [-4]


def test_directions_are_sent_to_zero():
    answers = ask(TASK, EXAMPLE_4_10).answers
    u = answers["zero_directions"]
    assert (EXAMPLE_4_10.matrix.subs(s, 4) * u).is_zero_matrix
    assert "zero_directions" not in ask(TASK, SHARED).answers  # a zero on a pole: G has no value there


def test_the_quadruple_tank_has_its_zero_cross_the_axis():
    names = "alpha1 alpha2 alpha5 alpha6 A1 A2 A3 A4 gamma1 gamma2 k1 k2"
    a1, a2, a5, a6, A1, A2, A3, A4, g1, g2, k1, k2 = sp.symbols(names, positive=True)
    plant = system(
        [[-a1, 0, a5 * A3 / A1, 0], [0, -a2, 0, a6 * A4 / A2], [0, 0, -a5, 0], [0, 0, 0, -a6]],
        B=[[g1 * k1 / A1, 0], [0, g2 * k2 / A2], [0, (1 - g2) * k2 / A3], [(1 - g1) * k1 / A4, 0]],
        C=[[1, 0, 0, 0], [0, 1, 0, 0]],
    )
    for method in ("minors", "rosenbrock"):
        result = ask(TASK, plant, method)
        assert result.status is Status.VERIFIED
        expected = s**2 + (a5 + a6) * s + a5 * a6 * (g1 + g2 - 1) / (g1 * g2)
        assert sp.cancel(result.answers["zero_polynomial"] - expected) == 0
        where = next(step for step in result.steps if step.kind == "inside_where")
        assert where.values["condition"] == (g1 + g2 - 1 > 0)
        assert where.values["edge"] == [sp.Eq(g1 + g2 - 1, 0)]
        exceptions = next(step for step in result.steps if step.kind == "exceptions")
        assert set(exceptions.values["conditions"]) == {sp.Eq(g1 - 1, 0), sp.Eq(g2 - 1, 0)}


def test_a_parameter_that_takes_a_zero_to_infinity_is_named():
    plant = matrix([[1 / (s + 1), k / (s + 2)], [1 / (s + 2), 1 / (s + 1)]])
    conditions = next(step for step in ask(TASK, plant).steps if step.kind == "exceptions").values["conditions"]
    assert sp.Eq(1 - k, 0) in conditions or sp.Eq(k - 1, 0) in conditions
    assert sp.Eq(k, 0) in conditions or k.is_zero is None


def test_discrete_systems_use_z():
    result = ask(TASK, matrix([[1 / (z - 2), 0], [0, (z - 3) / z]], x=z))
    assert (sorted(result.answers["poles"]), result.answers["zeros"]) == ([0, 2], [3])
    assert result.status is Status.VERIFIED
    outside = next(step for step in result.steps if step.kind == "outside")
    assert outside.values["discrete"]
    assert outside.values["outside"] == [3]


def scipys_zeros(A, B, C, D):
    """The finite generalized eigenvalues of a square system matrix."""
    A, B, C, D = (np.array(X.tolist(), dtype=float) for X in (A, B, C, D))
    n, m = B.shape
    pencil = np.block([[A, B], [-C, -D]])
    found = scipy.linalg.eigvals(pencil, scipy.linalg.block_diag(np.eye(n), np.zeros((m, m))))
    return [value for value in found if np.isfinite(value) and abs(value) < 1e6]


@tried(12)
@given(systems(4), st.data())
def test_scipy_finds_the_same_invariant_zeros(A, data):
    n, small = A.rows, st.integers(-2, 2)
    B = M(n, 2, lambda i, j: data.draw(small))
    C = M(2, n, lambda i, j: data.draw(small))
    D = M(2, 2, lambda i, j: data.draw(st.sampled_from([0, 0, 1])))
    plant = system(A, B=B, C=C, D=D)
    found = [ask(TASK, plant, method) for method in METHODS]
    for result in found:
        assert result.status is Status.VERIFIED, result.reason
    answers = found[0].answers
    for name in ("pole_polynomial", "zero_polynomial", "normal_rank", "determinant"):
        assert all(sp.cancel(answers[name] - each.answers[name]) == 0 for each in found)
    if answers["normal_rank"] == 2:
        theirs, ours = scipys_zeros(A, B, C, D), answers["invariant_zeros"]
        for point in (0.7 + 1.3j, -3.1 + 0.4j):
            expected = np.prod([point - value for value in theirs])
            mine = np.prod([point - complex(value) for value in ours])
            assert len(theirs) != len(ours) or np.isclose(expected, mine, rtol=1e-3, atol=1e-3)
    count = len(answers["input_decoupling_zeros"]) + len(answers["output_decoupling_zeros"])
    assert n - sp.degree(answers["pole_polynomial"], s) <= count


@tried(8)
@given(st.data())
def test_matrices_that_are_not_square(data):
    p, m = data.draw(st.sampled_from([(1, 2), (2, 1), (2, 3), (3, 2)]))
    factor = data.draw(st.sampled_from([1, s + 3, s - 1]))
    bottoms = st.sampled_from([s + 1, s + 2, (s + 1) * (s + 2), s])
    rows = [[factor * data.draw(st.integers(-2, 2)) / data.draw(bottoms) / (s + 5) for _ in range(m)] for _ in range(p)]
    plant = matrix(rows)
    found = [ask(TASK, plant, method) for method in METHODS]
    assert all(result.status is Status.VERIFIED for result in found), [result.reason for result in found]
    for name in ("pole_polynomial", "zero_polynomial", "normal_rank"):
        assert all(sp.cancel(found[0].answers[name] - each.answers[name]) == 0 for each in found)


WRONG = [
    ("poles", lambda poles: poles[1:]),
    ("poles", lambda poles: [*poles, poles[0]]),  # minors not cancelled
    ("poles", lambda poles: [-pole for pole in poles]),
    ("zeros", lambda zeros: [*zeros, zeros[0]]),
    ("zeros", lambda zeros: []),
    ("zeros", lambda zeros: [1]),  # the zero of an entry
    ("zeros", lambda zeros: [zeros[0] + sp.Rational(1, 1000)]),
    ("zeros", lambda zeros: [4, -2]),  # the uncancelled minor
    ("pole_polynomial", lambda p: s + 3),
    ("pole_polynomial", lambda p: p * (s + 2)),
    ("pole_polynomial", lambda p: p + 1),
    ("zero_polynomial", lambda p: p * (s + 2)),
    ("zero_polynomial", lambda p: 2 * p),
    ("zero_polynomial", lambda p: sp.Integer(1)),
    ("normal_rank", lambda r: r - 1),
    ("determinant", lambda d: d * (s + 2) / (s + 3)),
    ("determinant", lambda d: -d),
    ("zero_directions", lambda u: u + sp.ones(*u.shape)),
    ("zero_directions", lambda u: 0 * u),
]


@pytest.mark.parametrize(("name", "spoil"), WRONG)
def test_a_corrupted_answer_is_rejected(name, spoil):
    value = ask(TASK, EXAMPLE_4_10).answers[name]
    assert not rejected(TASK, EXAMPLE_4_10, {name: value})
    assert rejected(TASK, EXAMPLE_4_10, {name: spoil(value)})


@pytest.mark.parametrize(
    ("name", "wrong"),
    [
        ("invariant_zeros", [-3]),
        ("invariant_zeros", [-3, -3]),
        ("input_decoupling_zeros", [-4]),
        ("input_decoupling_zeros", [-4, -3, -1]),
        ("output_decoupling_zeros", []),
        ("output_decoupling_zeros", [-3]),
        ("zeros", [-4, -3]),
        ("poles", [-1, -2, -3, -4]),
    ],
)
def test_a_corrupted_zero_of_a_system_is_rejected(name, wrong):
    assert not rejected(TASK, HIDDEN, {name: ask(TASK, HIDDEN).answers[name]})
    assert rejected(TASK, HIDDEN, {name: wrong})


def test_a_multiplicity_lost_on_a_pole_is_rejected():
    assert rejected(TASK, SHARED, {"zeros": []})
    assert rejected(TASK, SHARED, {"poles": [-1]})
    assert not rejected(TASK, SHARED, {"zeros": [-1, -2], "poles": [-1, -2]})


def test_too_many_minors_are_refused_in_words():
    plant = matrix(sp.eye(5) / (s + 1) + sp.ones(5) / (s + 2))
    result = ask(TASK, plant, "minors")
    assert result.status in (Status.VERIFIED, Status.UNSOLVED)
    assert ask(TASK, plant, "rosenbrock").status is Status.VERIFIED
    large = matrix(sp.eye(6) / (s + 1))
    refused = ask(TASK, large, "minors")
    assert refused.status is Status.UNSOLVED
    assert "minors" in str(refused.reason)
    assert ask(TASK, large, "smith_mcmillan").answers["poles"] == [-1] * 6


FILE = """
system: {{transfer_matrix: {rows}}}
find: {{a: {{task: transfer_matrix_poles_zeros}}}}
"""
TWO_POLES_TWICE = [["1/(s + 1)", "2/(s + 2)"], ["1/(s + 2)", "1/(s + 1)"]]
ZERO_OF_ENTRIES = [["(s - 1)/((s + 1)(s + 2))", "(s + 3)/(s + 2)"], ["1/(s + 1)", "1/(s + 3)"]]
ON_A_POLE = [["(s + 2)(s - 3)/(s + 1)^2", 0], [0, "(s + 1)/(s + 2)"]]


@pytest.mark.parametrize(
    ("rows", "answers", "words"),
    [
        (TWO_POLES_TWICE, {"poles": [-1, -2]}, "the poles of the entries, each once"),
        (ZERO_OF_ENTRIES, {"zeros": [1, -3]}, "zeros of the entries"),
        (ON_A_POLE, {"zeros": [3]}, "cancels against a pole"),
        ([["1/(s + 1)", "2/(s + 1)"], ["2/(s + 1)", "4/(s + 1)"]], {"poles": [-1, -1]}, "not in lowest terms"),
        ([["(s - 1)^2/(s + 1)^2"]], {"zeros": [1]}, "multiplicities count"),
        ([["1/(s + 1)", "1/(s + 2)"]], {"poles": [-3, -1]}, "finite at"),
        ([["(s - 1)/(s + 1)", "(s - 1)/(s + 2)"]], {"zeros": [4]}, "has the rank"),
    ],
)
def test_usual_mistakes_are_named(rows, answers, words):
    quoted = str([[str(each) for each in row] for row in rows])
    ((name, value),) = answers.items()
    found = verdict(FILE.format(rows=quoted), "a", name, f'"{value}"')
    assert found.verdict is Verdict.WRONG
    assert words in str(found.reason)


def test_an_improper_matrix_is_a_fault_of_the_file():
    with pytest.raises(InputError, match="proper"):
        read_problem(Source("file.yaml", FILE.format(rows='[["s", "1/(s + 1)"]]')), catalogue())
