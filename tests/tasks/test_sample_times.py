"""The sampling period: how it is written, whose it is, and what is wrong with it."""

from dataclasses import dataclass

import pytest
import sympy as sp

from solver.derivation import Options, Task, Unsolved
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.systems import StateSpace
from solver.tasks import catalogue
from solver.tasks.sample_times import sample_time_of, sample_time_option, sample_time_refusals
from tests.helpers.asking import system

PLANT = "system: {A: [[0, 1], [-a, -T]], time: discrete, sample_time: T}\nfind:\n  a: stability\n"


@dataclass(frozen=True, kw_only=True)
class Asked(Options):
    sample_time: sp.Expr | None = sample_time_option()


asked_task: Task[StateSpace, Asked] = Task("asked", title="", doc="", needs=("A",), answers=(), options=Asked)


def sampled(own):
    return StateSpace(sp.ImmutableMatrix([[1]]), discrete=True, sample_time=own)


def read(text):
    return read_problem(Source("file.yaml", text), catalogue())


def test_the_option_wins_where_the_system_says_nothing_and_the_system_where_the_option_does():
    T = sp.Symbol("T", positive=True)
    for plant, options, found in ((sampled(None), {"sample_time": T}, T), (sampled(T), {}, T)):
        assert sample_time_of(asked_task.given(plant, options)) == found
        assert not list(sample_time_refusals(plant, Asked.of(options)))
    assert sample_time_of(asked_task.given(system([[1]]), {"sample_time": T})) == T


def test_a_period_that_is_missing_or_contradicted_is_refused_with_a_hint():
    ((place, reason),) = sample_time_refusals(sampled(None), Asked())
    assert (place, "write sample_time: 0.1" in str(reason), "beside time: discrete" in str(reason)) == ("", True, True)
    ((_, reason),) = sample_time_refusals(system([[1]]), Asked())
    assert "beside time: discrete" not in str(reason)
    with pytest.raises(Unsolved):
        sample_time_of(asked_task.given(sampled(None), {}))
    assert not list(sample_time_refusals(sampled(None), Asked(), needed=False))
    options = Asked.of({"sample_time": sp.Rational(1, 2)})
    ((place, reason),) = sample_time_refusals(sampled(sp.Integer(1)), options)
    assert place == "sample_time"
    assert "leave one of them out" in str(reason)
    assert not list(sample_time_refusals(sampled(sp.Rational(1, 2)), options))


def test_a_name_that_stands_for_a_period_is_positive_everywhere():
    problem = read(PLANT)
    T = sp.Symbol("T", positive=True)
    assert problem.system.sample_time == T
    assert problem.system.A[1, 1] == -T
    assert problem.assumed == {"positive": (T,)}


@pytest.mark.parametrize(
    ("said", "period"),
    [
        ("assume: {T: real}\n", sp.Symbol("T", real=True)),
        ("parameters: {T: 1/4}\n", sp.Rational(1, 4)),
        ("parameters: {h: 2}\n", sp.Symbol("T", positive=True)),
    ],
)
def test_what_a_file_says_of_the_name_wins(said, period):
    text = said + PLANT.replace("[0, 1]", "[0, h]")
    assert read(text).system.sample_time == period


def test_a_constant_is_no_name():
    assert read(PLANT.replace("sample_time: T", "sample_time: pi")).system.sample_time == sp.pi


@pytest.mark.parametrize("period", ["0", "-1", "k", "T*", "[1]"])
def test_a_period_that_cannot_be_is_a_fault_at_its_place(period):
    with pytest.raises(InputError) as caught:
        read(PLANT.replace("sample_time: T", f"sample_time: {period}"))
    assert caught.value.diagnostics[0].line == 1


def test_the_period_goes_on_to_the_parts_about_a_discrete_result():
    text = (
        "system: {transfer_function: 1/(z - 1), time: discrete, sample_time: T}\nfind:\n  a: realization\n"
        "  b: {task: stability, system: {from: a}}\n"
    )
    system = read(text).parts[1].system
    assert (system.discrete, system.sample_time) == (True, sp.Symbol("T", positive=True))
