"""A small catalogue of its own, so that these tests hold whatever tasks the program has."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import make_dataclass
from typing import Any

import pytest

from solver.derivation import AnswerName, Task, option
from solver.options.channel import Channel
from solver.options.choice import Choice
from solver.options.expression import Expression
from solver.options.expression_list import ExpressionList
from solver.options.flag import Flag
from solver.options.integer import Integer
from solver.options.matrix import MatrixOf
from solver.options.names import Names
from solver.options.number import Number
from solver.options.poles import Poles
from solver.options.transfer_function import TransferFunctionOption
from solver.problem.model import Problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks.plant_options import PlantOptions


def _nothing(given):
    yield from ()


def _option(name, kind, doc, **facts):
    return name, Any, option(kind, doc, **facts)


def _task(name, needs, options=(), answers=("answer",), methods=()):
    task = Task(
        name,
        title=name.replace("_", " ").capitalize(),
        doc=f"What {name} asks.",
        needs=needs,
        options=make_dataclass("Declared", options, bases=(PlantOptions,), frozen=True, kw_only=True),
        answers=[AnswerName(each, "", "an answer") if isinstance(each, str) else each for each in answers],
    )
    for method, time in methods or ((name, "both"),):
        task.method(method, time=time)(_nothing)
    return task


@pytest.fixture(scope="session")
def catalogue() -> Mapping[str, Task]:
    tasks = [
        _task("stability", ("A",)),
        _task("controllability", ("A", "B"), [_option("horizon", Number(), "horizon", methods=("gramian",))], (),
              (("rank", "both"), ("pbh", "both"), ("gramian", "continuous"))),
        _task("transition", ("A",), [
            _option("terms", Integer(1, 12), "number of terms", default=3, methods=("series",)),
            _option("convention", Choice(("right", "left")), "convention", methods=("modal",)),
        ], ("Phi", AnswerName("Phi_truncated", "", "truncated", ("series",))),
              (("laplace", "continuous"), ("z_transform", "discrete"), ("series", "continuous"), ("modal", "both"))),
        _task("placement", ("A", "B"), [_option("poles", Poles(), "poles of the closed loop", required=True)],
              ("K", "closed_loop_A", "polynomial"), (("ackermann", "both"), ("bass_gura", "both"))),
        _task("realization", ("transfer_function",)),
        _task("subspaces", ("matrix",), [_option("matrix", MatrixOf(), "another matrix")]),
        _task("desired", (), [_option("overshoot", Number(percent=True), "overshoot")], ("poles",)),
        _task("options", ("A",), [
            _option("count", Integer(1, 12), "a number"),
            _option("band", Choice(("2%", "5%")), "a band"),
            _option("dual", Flag(), "a flag"),
            _option("ratio", Number(percent=True), "a ratio"),
            _option("plain", Number(), "a number"),
            _option("shape", Expression(("t", "k")), "a function"),
            _option("input", ExpressionList(("t", "k")), "functions"),
            _option("poles", Poles(), "poles"),
            _option("Q", MatrixOf("n", "n"), "a weight"),
            _option("R", MatrixOf("m", "m"), "a weight"),
            _option("L", MatrixOf("n", "p", flat="column"), "a gain"),
            _option("output", Channel("output"), "an output"),
            _option("state", Channel("state"), "a state"),
            _option("parameters", Names(), "names"),
            _option("target", TransferFunctionOption(), "a transfer function"),
            _option("defaulted", MatrixOf(1, 2), "a row", default=[1, "3/4"]),
            _option("observer_gain", MatrixOf("n", "p", flat="column"), "a gain", answer="L"),
        ]),
    ]  # fmt: skip
    found = {task.name: task for task in tasks}
    found["placement"].refusal(_one_pole_a_state)
    return found


def _one_pole_a_state(system, options):
    if options.poles is not None and len(options.poles) != system.order:
        yield "poles", f"there are {len(options.poles)} poles for {system.order} states"


@pytest.fixture(scope="session")
def read(catalogue) -> Callable[[str], Problem]:
    """Read a problem file given as text."""
    return lambda text: read_problem(Source("file.yaml", text), catalogue)


@pytest.fixture(scope="session")
def complaints(read) -> Callable[[str], list[str]]:
    """Return what is wrong with a text, one "line:column message" a line, with "(length)" where it is not 1."""

    def complain(text: str) -> list[str]:
        with pytest.raises(InputError) as caught:
            read(text)
        return [
            f"{each.line}:{each.column}-{each.column + each.length} {each.message}" for each in caught.value.diagnostics
        ]

    return complain


@pytest.fixture(scope="session")
def part(read):
    """Read one part asked of a system given in flow style; return the part."""

    def of(part: str, system: str = "A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0]"):
        return read(f"system: {{{system}}}\nfind:\n  a: {part}\n").parts[0]

    return of
