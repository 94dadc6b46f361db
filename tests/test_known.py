"""What a part knows of its symbols, given to what it takes from parts that know less."""

import pytest
import sympy as sp

from solver.conditions import Condition, Parameter
from solver.engine import solve_problem
from solver.known import named_alike, signed, symbols_of
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.systems import StateSpace
from solver.tasks import catalogue

k, positive = sp.Symbol("k", real=True), sp.Symbol("k", positive=True)


def test_symbols_of_the_same_name_are_replaced_and_others_stay():
    other = sp.Symbol("z")
    assert named_alike(k + other, {"k": positive}) == positive + other
    assert named_alike((k, [k, 1]), {"k": positive}) == (positive, [positive, 1])
    assert named_alike(sp.ImmutableMatrix([[k]]), {"k": positive}) == sp.ImmutableMatrix([[positive]])
    assert named_alike("k", {"k": positive}) == "k"
    value = k**2
    assert named_alike(value, {"k": k}) is value


def test_the_symbols_of_a_part_are_those_of_its_system_and_its_options():
    text = "system: {A: [[0, 1], [-2, -m]], B: [0, 1]}\nfind:\n"
    text += "  a: {task: pole_placement, poles: [-1, -2], assume: {q: positive}}\n"
    (part,) = read_problem(Source("p.yaml", text), catalogue()).parts
    found = symbols_of(part)
    assert found["m"] == sp.Symbol("m", real=True)
    assert found["q"].is_positive


def test_an_absolute_value_is_written_without_bars_where_conditions_say_its_sign():
    bare = sp.Symbol("a", real=True)
    a = Parameter("a", (Condition(bare - 1, ">"),), real=True)
    plant = StateSpace(sp.ImmutableMatrix([[sp.Abs(a - 1)]]), B=sp.ImmutableMatrix([[1]]))
    assert sp.ImmutableMatrix([[a - 1]]) == signed(plant).A
    assert signed(plant).B == plant.B
    unknown = StateSpace(sp.ImmutableMatrix([[sp.Abs(bare - 1)]]))
    assert signed(unknown) is unknown


@pytest.mark.parametrize(
    ("conditions", "message"),
    [
        (["a > b", "b > c", "c > a"], "contradicts those before it"),
        (["a^2 < 0"], "never holds"),
        (["a > b", "a^2 + 1 > 0"], "always holds"),
    ],
)
def test_conditions_that_need_algebra_are_told_apart(conditions, message):
    text = f"conditions: {conditions}\nsystem: {{A: [[a, b], [c, 1]]}}\nfind: {{p: characteristic_polynomial}}\n"
    with pytest.raises(InputError, match=message) as caught:
        solve_problem(read_problem(Source("p.yaml", text), catalogue()))
    assert caught.value.diagnostics[0].line == 1
