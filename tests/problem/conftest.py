"""A small catalogue of its own, so that these tests hold whatever tasks the program has."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import pytest

from solver.derivation import (
    AnswerName,
    Channel,
    Choice,
    Expression,
    ExpressionList,
    Flag,
    Integer,
    MatrixOf,
    Names,
    Number,
    Option,
    Poles,
    Task,
    TransferFunctionOption,
)
from solver.problem.model import Problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source


def _nothing(given):
    yield from ()


def _task(name, needs, options=(), answers=("answer",), methods=()):
    task = Task(
        name,
        group="Representation and analysis",
        title=name.replace("_", " ").capitalize(),
        doc=f"What {name} asks.",
        needs=needs,
        options=options,
        answers=[AnswerName(each, "", "an answer") if isinstance(each, str) else each for each in answers],
    )
    for method, time in methods or ((name, "both"),):
        task.method(method, time=time)(_nothing)
    return task


@pytest.fixture(scope="session")
def catalogue() -> Mapping[str, Task]:
    tasks = [
        _task("stability", ("A",)),
        _task("controllability", ("A", "B"), [Option("horizon", Number(), "horizon", methods=("gramian",))], (),
              (("rank", "both"), ("pbh", "both"), ("gramian", "continuous"))),
        _task("transition", ("A",), [
            Option("terms", Integer(1, 12), "number of terms", default=3, methods=("series",)),
            Option("convention", Choice(("right", "left")), "convention", methods=("modal",)),
        ], ("Phi", AnswerName("Phi_truncated", "", "truncated", ("series",))),
              (("laplace", "continuous"), ("z_transform", "discrete"), ("series", "continuous"), ("modal", "both"))),
        _task("placement", ("A", "B"), [Option("poles", Poles(), "poles of the closed loop", required=True)],
              ("K", "closed_loop_A", "polynomial"), (("ackermann", "both"), ("bass_gura", "both"))),
        _task("realization", ("transfer_function",)),
        _task("subspaces", ("matrix",), [Option("matrix", MatrixOf(), "another matrix")]),
        _task("desired", (), [Option("overshoot", Number(percent=True), "overshoot")], ("poles",)),
        _task("options", ("A",), [
            Option("count", Integer(1, 12), "a number"),
            Option("band", Choice(("2%", "5%")), "a band"),
            Option("dual", Flag(), "a flag"),
            Option("ratio", Number(percent=True), "a ratio"),
            Option("plain", Number(), "a number"),
            Option("shape", Expression(("t", "k")), "a function"),
            Option("input", ExpressionList(("t", "k")), "functions"),
            Option("poles", Poles(), "poles"),
            Option("Q", MatrixOf("n", "n"), "a weight"),
            Option("R", MatrixOf("m", "m"), "a weight"),
            Option("L", MatrixOf("n", "p", flat="column"), "a gain"),
            Option("output", Channel("output"), "an output"),
            Option("state", Channel("state"), "a state"),
            Option("parameters", Names(), "names"),
            Option("target", TransferFunctionOption(), "a transfer function"),
            Option("defaulted", MatrixOf(1, 2), "a row", default=[1, "3/4"]),
            Option("observer_gain", MatrixOf("n", "p", flat="column"), "a gain"),
        ]),
    ]  # fmt: skip
    found = {task.name: task for task in tasks}
    found["placement"].refusal(_one_pole_a_state)
    return found


def _one_pole_a_state(system, options):
    if options.get("poles") is not None and len(options["poles"]) != system.order:
        yield "poles", f"there are {len(options['poles'])} poles for {system.order} states"


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
