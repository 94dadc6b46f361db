"""`solve tasks`, `solve new`, `solve schema`: what can be asked."""

import json
from dataclasses import dataclass
from importlib import import_module
from pkgutil import iter_modules
from typing import Any

import pytest
from jsonschema import Draft202012Validator

import solver.options
from solver.cli.catalogue_text import one
from solver.derivation import AnswerName, OptionKind, Options, Slip, Task, option
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
from solver.problem.source import Source
from solver.tasks import catalogue

TASKS = sorted(catalogue())


def test_every_task_is_listed_under_its_group(solve):
    out = solve("tasks").out
    group = ""
    found = {}
    for line in out.splitlines():
        if line and not line.startswith((" ", "`")):
            group = line
        elif line:
            found[line.split()[0]] = group
    assert {each.name: each.topic.group for each in catalogue().declarations()}.items() <= found.items()


@pytest.mark.parametrize("name", TASKS)
def test_all_about_a_task_is_told(solve, name):
    task = catalogue()[name]
    done = solve("tasks", name)
    assert done.code == 0
    words = done.out.split()
    assert {*task.options, *task.answers} <= set(words)
    assert set(task.methods) - {name} <= set(words)
    assert max(map(len, done.out.splitlines())) <= 100


@dataclass(frozen=True)
class Declared(Options):
    """What a task might take."""

    steps: int = option(Integer(1, 9), "the number of steps", required=True, methods=("slow",))
    dual: bool = option(Flag(), "whether it is turned round")
    gain: Any = option(Number(), "a gain")


def test_a_task_is_described_by_its_needs_methods_options_and_answers():
    answers = [AnswerName("rank", "r", r"the rank of $\sym{K}$", ("slow",)), AnswerName("P", "P", "P", optional=True)]
    task = Task("turn", title="Turning", doc="It turns.", needs=("A", "B"), options=Declared, answers=answers)
    task.method("slow", title="Slowly", source="A book", time="discrete")(lambda given: given)
    task.method("quick", title="Quickly")(lambda given: given)
    task.mistake(Slip("sign", r"it is $-\sym{K}$"), "rank")(lambda wrong: [])
    assert one(task).split("\n") == [
        "turn",
        "  Turning.",
        "  It turns.",
        "  Needs A, B of the system.",
        "",
        "Methods",
        "  slow   Slowly; discrete time; A book",
        "  quick  Quickly",
        "",
        "Options",
        "  steps  the number of steps [a whole number from 1 to 9; required] (only slow)",
        "  dual   whether it is turned round [true or false; default false]",
        "  gain   a gain [a number]",
        "",
        "Answers",
        "  rank  the rank of K_f (only slow)",
        "  P     P (where it makes sense)",
        "",
        "Mistakes, beside those of any task",
        "  sign  it is −K_f",
    ]


def test_of_a_task_that_has_one_method_and_no_mistakes_these_are_not_listed():
    task = Task(
        "turn", title="Turning", doc="It turns.", needs=(), options=Options, answers=[AnswerName("P", "P", "P")]
    )
    task.method(title="Slowly")(lambda given: given)
    headings = [line for line in one(task).split("\n") if line and not line.startswith(" ")]
    assert headings == ["turn", "Options", "Answers"]


KINDS = {
    Integer(): "a whole number",
    Integer(1, 12): "a whole number from 1 to 12",
    Integer(1): "a whole number from 1",
    Integer(None, 3): "a whole number up to 3",
    Choice(("left", "right")): "one of left, right",
    Flag(): "true or false",
    Number(): "a number",
    Number(percent=True): 'a number, or a percentage such as "14%"',
    Expression(("t",)): "an expression in t",
    ExpressionList(("t", "k")): "an expression or a list of them, in t, k",
    Poles(): 'a list of poles, "-3 ± 2j" for a pair',
    MatrixOf("m", "n"): "a matrix m×n; a flat list is a row",
    MatrixOf(flat="column"): "a matrix; a flat list is a column",
    Channel("input"): "an input by number from 1 or by name",
    Channel("state"): "a state by number from 1 or by name",
    Names(): "a list of names",
    LoopElement(): "an expression in s (discrete: z) or a matrix of them",
    LoopElement(switched=True): "unity, none, an expression in s (discrete: z) or a matrix of them",
    TransferFunctionOption(): "a transfer function",
}


@pytest.mark.parametrize("kind", KINDS, ids=str)
def test_each_kind_of_option_is_described(kind):
    assert kind.words == KINDS[kind]


@pytest.mark.parametrize("name", [info.name for info in iter_modules(solver.options.__path__)])
def test_a_file_of_an_option_holds_one_kind(name):
    module = import_module(f"solver.options.{name}")
    kinds = [each for each in vars(module).values() if isinstance(each, type) and each.__module__ == module.__name__]
    (kind,) = [each for each in kinds if issubclass(each, OptionKind)]
    assert not kind.__abstractmethods__
    assert kind.__doc__


@pytest.mark.parametrize("name", TASKS)
def test_a_new_problem_can_be_read_and_agrees_with_the_schema(solve, tmp_path, name):
    assert solve("new", name, "-o", "mine.yaml").out == "wrote mine.yaml; solve it with: solve mine.yaml\n"
    text = (tmp_path / "mine.yaml").read_text(encoding="utf-8")
    assert text == solve("new", name).out
    assert read_problem(Source("mine.yaml", text), catalogue()).parts[0].task == name


def test_the_schema_is_a_schema(solve):
    schema = json.loads(solve("schema").out)
    Draft202012Validator.check_schema(schema)
    assert set(TASKS) <= set(schema["$defs"]["Part"]["properties"]["task"]["enum"])
