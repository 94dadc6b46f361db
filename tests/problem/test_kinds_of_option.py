"""The kinds of option, each by itself: its words, its example, its schema, and whether an earlier part may give it."""

import jsonschema
import pytest

from solver.options.channel import Channel
from solver.options.choice import Choice
from solver.options.expression import Expression
from solver.options.expression_list import ExpressionList
from solver.options.flag import Flag
from solver.options.integer import Integer
from solver.options.loop_element import LoopElement
from solver.options.matrix import MatrixOf
from solver.options.names import Names
from solver.options.number import Number
from solver.options.poles import Poles
from solver.options.transfer_function import TransferFunctionOption
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue


@pytest.mark.parametrize(
    ("kind", "example"),
    [
        (MatrixOf(2, 2), "[[1, 0], [0, 1]]"),
        (MatrixOf(1, 3), "[[1, 0, 0]]"),
        (MatrixOf("n", "m"), "[[1], [0]]"),
        (MatrixOf("p", "n"), "[[1, 0]]"),
        (MatrixOf(), "[[1, 0], [0, 1]]"),
        (Integer(3), "3"),
        (Integer(maximum=4), "1"),
        (Number(percent=True), "14%"),
        (Number(), "1/2"),
        (Expression(("t", "k")), "exp(-t)"),
        (Expression(), "1"),
        (ExpressionList(("k",)), "exp(-k)"),
        (LoopElement(switched=True), "unity"),
        (LoopElement(), "2"),
        (Choice(("2%", "5%")), "2%"),
        (Flag(), "true"),
        (Channel("input"), "1"),
    ],
)
def test_examples_suit_a_plant_of_two_states_one_input_and_one_output(kind, example):
    assert kind.example == example


@pytest.mark.parametrize(
    ("kind", "fitting", "others"),
    [
        (Integer(2, 4), [2, 4], [1, 5, 2.5, "2"]),
        (Integer(minimum=2), [2, 99], [1]),
        (Integer(maximum=4), [-7, 4], [5]),
        (Choice(("2%", "2")), ["2%", "2", 2], ["3%", 3]),
        (Flag(), [True, False], ["true", 1]),
        (Channel("output"), [1, "y"], [0, [1]]),
        (Number(), [0.5, "a/2"], [[1]]),
        (LoopElement(), ["2/s", 2, [["1/s"]]], [[1]]),
    ],
)
def test_the_schema_of_a_kind_admits_what_is_read_and_nothing_else(kind, fitting, others):
    validator = jsonschema.Draft202012Validator(kind.schema)
    assert [value for value in [*fitting, *others] if validator.is_valid(value)] == fitting


def test_values_are_taken_from_earlier_parts_and_words_are_not():
    values = (Number(), Expression(), ExpressionList(), LoopElement(), MatrixOf(), Poles(), TransferFunctionOption())
    assert all(kind.referable for kind in values)
    assert not any(kind.referable for kind in (Flag(), Choice(("a",)), Integer(), Channel("input"), Names()))


def test_how_many_outputs_an_earlier_part_gives_is_not_known_yet():
    text = (
        "system: {transfer_function: 1/(s + 1)}\nfind:\n  a: realization\n"
        "  b: {task: transfer_function, system: {from: a}, output: 3}\n"
    )
    assert read_problem(Source("p.yaml", text), catalogue()).parts[1].options["output"] == 2
    with pytest.raises(InputError, match="output: there is no such output"):
        read_problem(Source("p.yaml", text.replace("3", "0")), catalogue())


def loop(given):
    text = f"system: {{transfer_function: 1/(s + 1)}}\nfind: {{a: {{task: transfer_function, {given}}}}}\n"
    return read_problem(Source("p.yaml", text), catalogue()).parts[0].options


def test_the_words_for_a_path_are_those_of_the_feedback_alone():
    assert loop("controller: 2, feedback: none")["feedback"] is None
    assert loop("feedback: unity")["feedback"] == 1
    with pytest.raises(InputError, match="'none' cannot stand for the controller"):  # nor is it a parameter's name
        loop("controller: none, feedback: unity")
    with pytest.raises(InputError, match="feedback must be a list of rows"):
        loop("feedback: [1, 2]")
