"""A task whose methods misbehave in every way that the limits must contain; registered by the tests that need it."""

import faulthandler
import os
import signal

from solver.derivation import AnswerName, Answers, Check, Step, Task, Unsolved
from solver.tasks.plant_options import PlantOptions
from solver.words import Reason

difficult = Task(
    "difficult",
    title="A difficult question",
    doc="Never asked by a user.",
    needs=("A",),
    options=PlantOptions,
    answers=[AnswerName("F", "F", "the matrix itself")],
)


def method(name):
    """Register a method that has no steps: a function of what is given, to its answers."""

    def register(function):
        def derive(given):
            yield from ()
            return function(given)

        return difficult.method(name, title=name)(derive)

    return register


@method("easy")
def easy(given):
    return Answers(F=given.system.A)


@method("endless")
def endless(given):
    if path := os.environ.get("DIFFICULT_PID_FILE"):
        with open(path, "w", encoding="ascii") as file:  # noqa: PTH123 - so that it is written at once
            file.write(str(os.getpid()))
    while True:
        pass


@method("greedy")
def greedy(given):
    hoard = []
    while True:
        hoard.append(bytearray(8 * 2**20))


@method("bottomless")
def bottomless(given):
    return bottomless_sum(given.system.A)


def bottomless_sum(x):
    return x + bottomless_sum(x)


@method("deadly")
def deadly(given):
    faulthandler.disable()  # this death is expected
    os.kill(os.getpid(), signal.SIGSEGV)


@method("quitting")
def quitting(given):
    os._exit(0)


@method("buggy")
def buggy(given):
    raise KeyError("a bug")


@method("unsolvable")
def unsolvable(given):
    raise Unsolved("model_matching/constant_plant")


@difficult.method("speechless", title="speechless")
def speechless(given):
    yield Step("without_a_macro", unclaimed="nothing is said")
    return Answers(F=given.system.A)


@method("unpicklable")
def unpicklable(given):
    return Answers(F=lambda: None)


@method("wrong")
def wrong(given):
    return Answers(F=2 * given.system.A)


@difficult.verification("F")
def is_the_matrix(given, answers):
    yield Check.that("$F = A$", "comparison", answers["F"] == given.system.A or given.method == "unpicklable")


@difficult.refusal
def of_some_matrices(system, options):
    """Refuse a question about −1; that about −2 is never judged."""
    while system.A[0, 0] == -2:
        pass
    if system.A[0, 0] == -1:
        yield "", Reason("limits/ended", {"words": "it begins with -1"})


def problem_text(*methods, matrix="[[1, 2], [3, 4]]"):
    """Return a problem that asks for each method in a part of its own."""
    parts = [f"  {chr(97 + i)}: {{task: difficult, method: {name}, prompt: Do it.}}" for i, name in enumerate(methods)]
    return "\n".join(["title: Difficult", f"system: {{A: {matrix}}}", "find:", *parts, ""])
