"""Realizations: forms by inspection, transfer function by numpy, order kept, refusals, corruptions."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.derivation import CheckStatus, Status
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected, system
from tests.helpers.fractions_of_polynomials import fraction, plant, s, values, z
from tests.helpers.said import page_of
from tests.helpers.tried import tried

FORMS = ("controllable", "observable", "diagonal", "jordan", "modal")
COURSE = plant(2 * s**3 + 5 * s**2 + 3 * s + 1, 4 * s**4 + 2 * s**2 + 3 * s + 6)
POINTS = (0.37 + 0.81j, -2.31 + 0.11j, 5.5)
M = sp.Matrix
R = sp.Rational


def realized(G, form="controllable", **options):
    return ask("realization", G, form=form, **options)


def assert_same(G, answers, **parameters):
    for point in POINTS:
        assert np.allclose(
            values(answers, point, **parameters), fraction(G, point, **parameters), rtol=1e-9, atol=1e-12
        )


def test_the_course_example_in_controllable_form():
    answers = realized(COURSE).answers
    assert answers["A"] == M([[0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1], [-R(3, 2), -R(3, 4), -R(1, 2), 0]])
    assert answers["B"] == M([0, 0, 0, 1])
    assert answers["C"] == M([[R(1, 4), R(3, 4), R(5, 4), R(1, 2)]])
    assert answers["D"] == M([[0]])


def test_the_observable_form_is_the_transposed_controllable_one():
    for convention in ("last_row", "first_row"):
        first = realized(COURSE, "controllable", convention=convention).answers
        second = realized(COURSE, "observable", convention=convention).answers
        assert (second["A"], second["B"], second["C"]) == (first["A"].T, first["C"].T, first["B"].T)


def test_the_first_row_as_in_the_model_matching_example():
    answers = realized(plant((s - 1) * (s + 2), (s + 1) * (s - 2) * (s + 3)), convention="first_row").answers
    assert answers["A"] == M([[-2, 5, 6], [1, 0, 0], [0, 1, 0]])
    assert (answers["B"], answers["C"]) == (M([1, 0, 0]), M([[1, 1, -2]]))


def test_the_discrete_exam_question_keeps_the_cancelled_mode():
    G = plant(z + 2, z**2 + 5 * z + 6, discrete=True)
    diagonal = realized(G, "diagonal").answers
    assert (diagonal["A"], diagonal["B"], diagonal["C"]) == (sp.diag(-3, -2), M([1, 1]), M([[1, 0]]))
    assert realized(G).answers["A"] == M([[0, 1], [-6, -5]])


def test_jordan_chains_below_and_above_the_diagonal():
    G = plant(s**2 + 3 * s + 3, (s + 1) ** 3 * (s + 2))
    lower, upper = (realized(G, "jordan", convention=c).answers for c in ("subdiagonal", "superdiagonal"))
    assert lower["A"] == M([[-2, 0, 0, 0], [0, -1, 0, 0], [0, 1, -1, 0], [0, 0, 1, -1]])
    assert (lower["B"], lower["C"]) == (M([1, 1, 0, 0]), M([[-1, 1, 0, 1]]))
    assert upper["A"] == M([[-2, 0, 0, 0], [0, -1, 1, 0], [0, 0, -1, 1], [0, 0, 0, -1]])
    assert (upper["B"], upper["C"]) == (M([1, 0, 0, 1]), M([[-1, 1, 0, 1]]))


def test_the_residues_are_those_of_sympys_partial_fractions():
    G = plant(3 * s**2 + s + 7, (s + 1) * (s + 2) * (s + 4))
    answers = realized(G, "diagonal").answers
    expansion = sp.apart(G.matrix[0, 0], s)
    found = sum(c / (s - p) for c, p in zip(answers["C"], answers["A"].diagonal(), strict=True))
    assert sp.cancel(found - expansion) == 0


def test_modal_form_is_real_and_has_blocks_of_order_two():
    answers = realized(plant(s + 3, (s + 1) * (s**2 + 2 * s + 5)), "modal").answers
    assert answers["A"] == M([[-1, 0, 0], [0, -1, 2], [0, -2, -1]])
    assert not any(answers[name].has(sp.I) for name in "ABC")


def test_repeated_pairs_have_real_chains():
    G = plant(s + 3, (s**2 + 2 * s + 5) ** 2)
    answers = realized(G, "modal").answers
    assert answers["A"][2:, :2] == sp.eye(2)
    assert not answers["C"].has(sp.I)
    assert_same(G, answers)


def test_pairs_above_the_diagonal_keep_their_states_in_order():
    G = plant(s + 3, (s**2 + 2 * s + 5) ** 2)
    answers = realized(G, "modal", convention="superdiagonal").answers
    assert answers["A"] == M([[-1, 2, 1, 0], [-2, -1, 0, 1], [0, 0, -1, 2], [0, 0, -2, -1]])
    assert_same(G, answers)


def test_a_biproper_plant_is_divided():
    result = realized(plant(2 * s**2 + 1, s**2 + 3 * s + 2))
    assert result.answers["D"] == M([[2]])
    assert result.answers["C"] == M([[-3, -6]])
    assert [step.kind for step in result.steps] == ["as_given", "division", "coefficients", "assembled"]


def test_a_pole_with_a_chain_has_no_diagonal_form():
    result = realized(plant(1, (s + 1) ** 2), "diagonal")
    assert result.status is Status.UNSOLVED
    assert "repeated" in str(result.reason)
    assert result.steps


def test_a_constant_has_no_state():
    result = realized(plant(3, sp.Integer(2)))
    assert result.status is Status.UNSOLVED
    assert "constant" in str(result.reason)


@pytest.mark.parametrize("form", FORMS)
def test_decimal_poles_surds_and_parameters(form):
    a, b = sp.symbols("a b")
    for G, parameters in (
        (COURSE, {}),
        (plant(s + 1, s**2 - 2), {}),
        (plant(s + a, s**2 + b * s + a), {"a": 2.0, "b": 0.7}),
        (plant(s + a, s**2 + b * s + a), {"a": 0.2, "b": 3.0}),
        (plant(a * s**2 + 1, b * s**2 + s + 3), {"a": 2.0, "b": 0.7}),
    ):
        result = realized(G, form)
        assert result.status is Status.VERIFIED, result.reason
        assert_same(G, result.answers, **parameters)


@pytest.mark.parametrize("form", FORMS)
def test_several_inputs_and_outputs(form):
    for G in (
        plant([(1, s + 1), (2, (s + 1) * (s + 2))], [(s, s + 2), (1, s + 3)]),
        plant([(1, s + 1), (2, (s + 1) * (s + 2))]),
        plant([(s + 1, s**2 + 1)], [(3, s**2 + 1)], [(2 * s + 1, s + 4)]),
    ):
        result = realized(G, form)
        assert result.status is Status.VERIFIED, result.reason
        assert_same(G, result.answers)


@pytest.mark.parametrize("shape", [(1, 2), (2, 1), (2, 2)])
def test_repeated_poles_of_transfer_matrices_have_chains(shape):
    rows = [[(1, (s + 1) ** 2), (2, (s + 1) * (s + 2))], [(s, s + 2), (1, (s + 1) ** 3)]]
    G = plant(*[row[: shape[1]] for row in rows[: shape[0]]])
    for form in ("jordan", "modal"):
        for convention in ("subdiagonal", "superdiagonal"):
            result = realized(G, form, convention=convention)
            assert result.status is Status.VERIFIED, result.reason
            assert_same(G, result.answers)


def test_a_state_space_system_keeps_its_order():
    given_plant = system([[0, 1], [-2, -3]], B=[[0], [1]], C=[[1, 1]])  # cancels s + 1
    for form in FORMS:
        result = realized(given_plant, form)
        assert result.status is Status.VERIFIED, result.reason
        assert result.answers["A"].shape == (2, 2)
        assert sorted(result.answers["A"].eigenvals()) == [-2, -1]


def test_several_inputs_in_state_space_keep_the_order_too():
    A, B, C = [[1, 2, 0], [0, 1, 1], [1, 0, 3]], [[1, 0], [0, 1], [0, 0]], [[1, 0, 1], [0, 1, 1]]
    many = system(A, B=B, C=C)
    for form in ("controllable", "observable"):
        for convention in ("last_row", "first_row"):
            result = realized(many, form, convention=convention)
            assert result.status is Status.VERIFIED, result.reason
            assert result.answers["A"].charpoly() == M(A).charpoly()
    assert realized(many).answers["B"] == M([[0, 0], [1, 0], [0, 1]])
    as_given = {**{name: getattr(many, name) for name in "ABC"}, "D": sp.zeros(2)}
    assert rejected("realization", many, as_given, form="controllable", convention="last_row")
    uncontrollable = system(sp.diag(-1, -1, -1), B=[[1, 0], [0, 1], [0, 0]], C=[[1, 1, 1]])
    assert realized(uncontrollable).status is Status.VERIFIED


def test_semisimple_repeated_eigenvalues_are_diagonal():
    result = realized(system([[-1, 0], [0, -1]], B=[[1], [1]], C=[[1, 0]]), "diagonal")
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["A"] == -sp.eye(2)


small = st.integers(-3, 3)


@st.composite
def fractions(draw):
    """A proper fraction: poles real, repeated, in pairs; zeros that may cancel; a leading coefficient."""
    factors = draw(
        st.lists(
            st.sampled_from([s, s + 1, s + 1, s + 2, s - 1, s**2 + 1, s**2 + 2 * s + 5, s**2 - 2]),
            min_size=1,
            max_size=4,
        )
    )
    bottom = sp.expand(draw(st.sampled_from([1, 2, -3])) * sp.Mul(*factors))
    degree = int(sp.degree(bottom, s))
    top = sum(draw(small) * s**k for k in range(draw(st.integers(0, degree)) + 1))
    return plant(top, bottom)


@tried(15)
@given(fractions(), st.sampled_from(FORMS), st.booleans())
def test_every_form_of_every_fraction(G, form, other):
    companion = form in ("controllable", "observable")
    options = {"convention": "first_row" if companion else "superdiagonal"} if other and form != "diagonal" else {}
    result = realized(G, form, **options)
    if result.status is Status.UNSOLVED and form == "diagonal":
        assert "repeated" in str(result.reason)
        return
    assert result.status is Status.VERIFIED, result.reason
    assert {check.status for check in result.checks} == {CheckStatus.PASSED}
    assert result.answers["A"].rows == sp.degree(G.denominators[0][0], s)
    assert_same(G, result.answers)


PLAIN = plant(s**2 + 2, (s + 1) * (s + 2) * (s + 4))


def corruptions(answers):
    """Wrong answers: one sign, one entry, transposed, scaled, states swapped in one matrix only."""
    for name in "ABCD":
        X = answers[name]
        for changed in (X + sp.ones(*X.shape), X * 2, -X, X[::-1, :] if X.rows > 1 else X[:, ::-1]):
            if changed != X:
                yield {**answers, name: sp.ImmutableMatrix(changed)}
    yield {**answers, "B": answers["C"].T, "C": answers["B"].T}
    yield (
        {**answers, "A": sp.ImmutableMatrix(answers["A"].T)}
        if answers["A"] != answers["A"].T
        else {**answers, "A": answers["A"] + sp.eye(3)}
    )


@pytest.mark.parametrize("form", FORMS)
def test_corrupted_answers_are_rejected(form):
    answers = dict(realized(PLAIN, form).answers)
    for wrong in corruptions(answers):
        if form not in ("controllable", "observable") and np.allclose(values(wrong, 0.3), fraction(PLAIN, 0.3)):
            continue
        assert rejected("realization", PLAIN, wrong, form=form, convention="last_row"), wrong


@pytest.mark.parametrize("form", ["controllable", "observable"])
@pytest.mark.parametrize("convention", ["last_row", "first_row"])
def test_the_other_convention_is_another_answer(form, convention):
    other = "first_row" if convention == "last_row" else "last_row"
    answers = realized(PLAIN, form, convention=other).answers
    assert rejected("realization", PLAIN, answers, form=form, convention=convention)


@pytest.mark.parametrize("form", ["controllable", "observable"])
def test_each_answer_alone_is_judged(form):
    answers = realized(PLAIN, form).answers
    for name in "ABCD":
        alone = {name: answers[name]}
        assert not rejected("realization", PLAIN, alone, form=form, convention="last_row")
        wrong = {name: answers[name] + sp.ones(*answers[name].shape)}
        assert rejected("realization", PLAIN, wrong, form=form, convention="last_row")


def test_scaled_and_reordered_modes_are_right():
    answers = {"A": sp.diag(-4, -1, -2), "B": M([2, 1, -1]), "C": M([[R(3, 2), 1, 3]]), "D": M([[0]])}
    assert not rejected("realization", PLAIN, answers, form="diagonal", convention="last_row")
    wrong = {**answers, "A": sp.diag(-1, -4, -2)}
    assert rejected("realization", PLAIN, wrong, form="diagonal", convention="last_row")


def test_a_minimal_realization_is_not_of_the_order_asked_for():
    G = plant(s + 2, s**2 + 5 * s + 6)
    answers = {"A": M([[-3]]), "B": M([[1]]), "C": M([[1]]), "D": M([[0]])}
    assert rejected("realization", G, answers, form="diagonal", convention="last_row")


@pytest.mark.parametrize(
    ("form", "convention"),
    [("controllable", "subdiagonal"), ("jordan", "first_row"), ("diagonal", "superdiagonal")],
)
def test_a_convention_of_another_form_is_refused(form, convention):
    refused = list(catalogue()["realization"].refused(PLAIN, {"form": form, "convention": convention}))
    assert [option for option, _ in refused] == ["convention"]


def test_what_cannot_be_judged_alone_is_not_judged():
    answers = realized(PLAIN, "diagonal").answers
    task = catalogue()["realization"]
    checks = list(task.verify(task.given(PLAIN, {"form": "diagonal"}), {"C": answers["C"]}))
    assert [check.status for check in checks] == [CheckStatus.SKIPPED]


@pytest.mark.parametrize("convention", ["last_row", "first_row"])
@pytest.mark.parametrize(("denominator", "dots"), [(s + 2, False), (s**2 + 3 * s + 2, False), (s**3 + 1, True)])
def test_dots_stand_for_something(denominator, dots, convention):
    page = page_of("realization", "realization", plant(1, denominator), form="controllable", convention=convention)
    assert (r"\cdots" in page) is dots
    assert r"\ldots" not in page or dots
