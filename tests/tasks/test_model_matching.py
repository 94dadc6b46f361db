"""Model matching: the course's example, plants of any kind, targets out of reach, corruptions."""

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.derivation import Status
from solver.systems import TransferFunction
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected, system
from tests.helpers.tried import tried

s = sp.Symbol("s")


def plant(numerator, denominator):
    fraction = sp.cancel(numerator / denominator)
    return TransferFunction(
        sp.ImmutableMatrix([[fraction]]), ((sp.expand(numerator),),), ((sp.expand(denominator),),), s
    )


COURSE = plant((s - 1) * (s + 2), (s + 1) * (s - 2) * (s + 3))
TARGET = (s - 1) / ((s + 2) * (s + 3))


def test_the_example_of_the_course():
    result = ask("model_matching", COURSE, target=TARGET)
    assert result.status is Status.VERIFIED, result.reason
    answers = result.answers
    assert answers["feasible"] is True
    assert sp.cancel(answers["compensator"] - (s + 1) * (s - 2) / (s + 2) ** 2) == 0
    assert answers["A"] == sp.ImmutableMatrix([[-2, 5, 6], [1, 0, 0], [0, 1, 0]])
    assert answers["C"] == sp.ImmutableMatrix([[1, 1, -2]])
    assert answers["K"] == sp.ImmutableMatrix([[5, 21, 18]])


@pytest.mark.parametrize(
    ("target", "why"),
    [
        ((s - 1) * (s + 4) / ((s + 2) ** 2 * (s + 3)), "a zero that the plant does not have"),
        (1 / ((s + 2) * (s + 3)), "the hidden zero at 1 is not stable"),
        (1 / (s + 3), "no zero at 1"),
        ((s - 1) / ((s + 2) * (s + 3) * (s + 4)), "another relative degree"),
    ],
)
def test_targets_out_of_reach(target, why):
    result = ask("model_matching", COURSE, target=target)
    assert result.status is Status.VERIFIED, why
    assert result.answers["feasible"] is False
    assert "K" not in result.answers
    assert not rejected("model_matching", COURSE, {"feasible": False}, target=target)
    assert rejected("model_matching", COURSE, {"feasible": True}, target=target)


@tried(15)
@given(
    st.lists(st.integers(-4, -1), min_size=0, max_size=2),
    st.lists(st.integers(-4, 3), min_size=2, max_size=4),
    st.data(),
)
def test_any_poles_can_be_matched_with_the_zeros_kept(zeros, poles, data):
    if len(zeros) > len(poles):
        zeros = zeros[: len(poles)]
    wanted = data.draw(st.lists(st.integers(-7, -5), min_size=len(poles), max_size=len(poles)))
    gain = data.draw(st.sampled_from([sp.S(1), sp.Rational(3, 2)]))
    N = sp.prod([s - z for z in zeros])
    target = gain * N / sp.prod([s - p for p in wanted])
    result = ask("model_matching", plant(2 * N, sp.prod([s - p for p in poles])), target=sp.cancel(target))
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["feasible"] is True
    A, B, K = (result.answers[name] for name in "ABK")
    assert sp.expand(sp.Matrix(A - B * K).charpoly(s).as_expr() - sp.prod([s - p for p in wanted])) == 0


def test_a_plant_in_state_space_keeps_its_realization():
    own = system([[1, 2], [3, 1]], B=[0, 1], C=[[1, 0]])
    result = ask("model_matching", own, target=sp.sympify("2/((s+3)*(s+4))", locals={"s": s}))
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["A"] == own.A


def test_a_direct_term_is_kept():
    biproper = plant((s + 1) * (s + 4), (s - 1) * (s + 2))
    result = ask("model_matching", biproper, target=sp.cancel((s + 1) / (s + 3)))
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["feasible"] is True


def test_several_inputs_are_refused():
    many = system([[0, 1], [0, 0]], B=[[1, 0], [0, 1]], C=[[1, 0]])
    assert list(catalogue()["model_matching"].refused(many, {"target": TARGET}))


CORRUPTIONS = {
    "feasible": [lambda value: not value],
    "compensator": [lambda value: 2 * value, lambda value: 1 / value, lambda value: value + 1],
    "K": [lambda value: -value, lambda value: value + sp.ImmutableMatrix([[0, 0, sp.Rational(1, 100)]]), lambda v: v.T],
}


@pytest.mark.parametrize("name", CORRUPTIONS)
def test_each_answer_alone_is_accepted_and_each_corruption_rejected(name):
    answer = ask("model_matching", COURSE, target=TARGET).answers[name]
    assert not rejected("model_matching", COURSE, {name: answer}, target=TARGET)
    for corrupt in CORRUPTIONS[name]:
        assert rejected("model_matching", COURSE, {name: corrupt(answer)}, target=TARGET)


def test_another_realization_with_its_own_gain_is_right():
    answers = ask("model_matching", COURSE, target=TARGET).answers
    T = sp.Matrix([[1, 1, 0], [0, 1, 0], [2, 0, 1]])
    A, B, C, K = (answers[name] for name in "ABCK")
    other = {"A": T * A * T.inv(), "B": T * B, "C": C * T.inv(), "K": K * T.inv()}
    other = {name: sp.ImmutableMatrix(M) for name, M in other.items()}
    assert not rejected("model_matching", COURSE, other, target=TARGET)
    for name in "ABCK":
        wrong = {**other, name: sp.ImmutableMatrix(other[name] + sp.ones(*other[name].shape) / 50)}
        assert rejected("model_matching", COURSE, wrong, target=TARGET), name
