"""Linear differential equations with constant coefficients, by the Laplace transform or the characteristic equation."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Check, Claim, Derivation, Given, Task
from solver.derivation.registry import Refusal
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import transforms as judges
from solver.tasks.transforms.characteristic import by_characteristic
from solver.tasks.transforms.equation_question import DifferentialOptions, Question
from solver.tasks.transforms.transform_mistakes import name_mistakes_of_equations
from solver.tasks.transforms.transformed_equations import by_laplace, told
from solver.words import Phrase, Reason, formula

if TYPE_CHECKING:
    from solver.systems import Equations

differential_equation: Task[Equations, DifferentialOptions] = Task(
    "differential_equation",
    title="Differential equation",
    doc="The solution of linear differential equations with constant coefficients for t ≥ 0, from values at 0−.",
    needs=("equations",),
    options=DifferentialOptions,
    example={"equations": "[\"x'' + 3x' + 2x = u\"]", "inputs": "[u]", "input": '{u: "exp(-3t)"}', "initial": "{x: 1}"},
    answers=[
        AnswerName("solution", r"\text{solution}", "the unknowns as functions of $t \\ge 0$", principal=True,
                   earned=("equations", "solved", "partial_fractions", "homogeneous", "general", "constants")),
    ],
)  # fmt: skip


@differential_equation.refusal
def incomplete_question(system: Any, options: DifferentialOptions) -> Iterable[Refusal]:
    """An input that is not given, or of another kind; values that are not asked for; equations that are not linear."""
    if not hasattr(system, "sides"):
        return
    missing = [name for name in system.inputs if name not in (options.input or {})]
    if missing:
        yield "input", Reason("differential_equation/no_input", {"names": [system.symbol((n, 0)) for n in missing]})
        return
    asked = Question(system, options.input or {}, options.initial or system.initial)
    try:
        orders = asked.operators.orders
        _ = asked.pieces
    except exact.NotExact as failure:
        fault = failure.reason
        yield "input" if fault.kind.startswith("signals/") else "", fault
        return
    for (name, k), _value in asked.initial.items():
        if name in system.inputs or k >= max(orders.get(name, 0), 1):
            values = {"jet": system.symbol((name, k)), "input": name in system.inputs, "order": orders.get(name, 0)}
            yield "initial", Reason("differential_equation/no_initial_value", values)


@differential_equation.method(
    "laplace", title="Laplace transform", source="Ogata, Modern Control Engineering, §2–6", time="continuous"
)
def with_the_laplace_transform(given: Given[Equations, DifferentialOptions]) -> Derivation[Answers]:
    """Each equation transformed with the values at 0−, solved for the transforms, and back."""
    asked = Question.of(given)
    found = yield from by_laplace(asked)
    return (yield from told(asked, found))


@differential_equation.method(
    "characteristic_equation",
    title="Characteristic equation",
    source="W. Walter, Ordinary Differential Equations, §20",
    time="continuous",
)
def with_the_characteristic_equation(given: Given[Equations, DifferentialOptions]) -> Derivation[Answers]:
    """The homogeneous solution, a particular one by undetermined coefficients, the constants from the values at 0+."""
    asked = Question.of(given)
    found = yield from by_characteristic(asked)
    return (yield from told(asked, found))


@differential_equation.verification("solution")
def satisfies_the_equations(given: Given[Equations, DifferentialOptions], answers: Answers) -> Iterable[Check]:
    """Both sides transformed by quadrature, with the values at 0−; the equations themselves at random times."""
    asked, s, t = Question.of(given), sp.Symbol("s"), sp.Symbol("t")
    model = given.system
    problem = judges.Problem(asked.equations, model.jets, asked.inputs, asked.initial)
    functions = {str(name): f for name, f in answers["solution"].items()}
    missing = [name for name in model.unknowns if name not in functions]
    yield Check.that("a function for each unknown", "counted", not missing)
    if missing:
        return
    try:
        for number, (left, right) in enumerate(judges.transformed_sides(problem, functions, t, s), 1):
            label = Phrase("equation {i} transformed, with the values at $0^-$", i=number)
            yield numeric.check_claim(Claim(left, right), label)
        for left, right, start in judges.sides_in_time(problem, functions, t):
            label = Phrase("the equation after $t = {at}$", at=formula(start))
            yield numeric.check_claim(Claim(left, right), label)
    except numeric.NotEvaluable as refusal:
        yield Check.skipped("the equations", "Gauss–Legendre quadrature", refusal.reason)


name_mistakes_of_equations(differential_equation)
