"""Linear difference equations with constant coefficients, by the z-transform or sample by sample."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Check, Claim, Derivation, Given, Step, Task, Unsolved
from solver.derivation.registry import Refusal
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import transforms as judges
from solver.tasks.transforms.difference_question import DifferenceOptions, Question
from solver.tasks.transforms.recursion import by_recursion, run_of
from solver.tasks.transforms.sequence_back import first_terms
from solver.tasks.transforms.sequence_mistakes import name_mistakes_of_differences
from solver.tasks.transforms.transformed_samples import by_z_transform
from solver.words import Phrase, Reason, formula

if TYPE_CHECKING:
    from solver.systems import Equations

difference_equation: Task[Equations, DifferenceOptions] = Task(
    "difference_equation",
    title="Difference equation",
    doc="The solution of linear difference equations with constant coefficients for k ≥ 0, and its first values.",
    needs=("equations",),
    options=DifferenceOptions,
    example={"time": "discrete", "equations": '["y(k+2) - 3y(k+1) + 2y(k) = u(k)"]', "inputs": "[u]",
             "input": "{u: 1}", "initial": '{"y(0)": 0, "y(1)": 1}'},
    answers=[
        AnswerName("solution", r"\text{solution}", "the unknowns as functions of $k \\ge 0$", principal=True,
                   optional=True, earned=("equations", "solved", "partial_fractions", "times_z")),
        AnswerName("values", r"\text{values}", "the first values of the first unknown, from $k = 0$ on",
                   ordered=True, numbered=True, principal=True, earned=("latest", "table", "first_terms")),
    ],
)  # fmt: skip


@difference_equation.refusal
def incomplete_question(system: Any, options: DifferenceOptions) -> Iterable[Refusal]:
    """An input that is not given, or of another kind; values that start no recursion; equations that are not linear."""
    if not hasattr(system, "sides") or not system.discrete:
        return
    missing = [name for name in system.inputs if name not in (options.input or {})]
    if missing:
        yield "input", Reason("difference_equation/no_input", {"names": [sp.Symbol(name) for name in missing]})
        return
    asked = Question(system, options.input or {}, system.initial if options.initial is None else options.initial)
    try:
        written = asked.written
        _ = asked.pieces
        exact.latest_samples(written)
    except exact.NotExact as failure:
        fault = failure.reason
        yield "input" if fault.kind.startswith("signals/") else "", fault
        return
    if asked.moved is None:
        needed = [sp.Symbol(f"{x}({m})") for x, (low, high) in written.spans.items() for m in range(low, high)]
        yield "initial", Reason("difference_equation/other_values", {"needed": needed})


@difference_equation.method(
    "z_transform", title="z-transform", source="Ogata, Discrete-Time Control Systems, §2–6", time="discrete"
)
def with_the_z_transform(given: Given[Equations, DifferenceOptions]) -> Derivation[Answers]:
    """Each equation transformed with the values at the start, solved for the transforms, and back."""
    asked = Question.of(given)
    _refuse_ahead(asked)
    found = yield from by_z_transform(asked)
    name = asked.model.unknowns[0]
    run = run_of(asked, asked.terms)
    values = [run.values.get((name, k), sp.S.Zero) for k in range(asked.terms)]
    yield from first_terms(found[name], values, asked.names(name), recursion=True)
    if len(found) > 1:
        rows = [(sp.Symbol(x), f) for x, f in found.items()]
        yield Step("solution", unclaimed="what was found", rows=rows, k=asked.k)
    return Answers(solution={sp.Symbol(x, real=True): f for x, f in found.items()}, values=values)


def _refuse_ahead(asked: Question) -> None:
    """Raise Unsolved where from rest an unknown would begin before its input."""
    for name, image in asked.images.items() if asked.at_rest else ():
        if image != 0 and exact.sequence_image(sp.together(image), asked.z).advanced:
            raise Unsolved("difference_equation/ahead", name=sp.Symbol(name))


@difference_equation.method(
    "recursion", title="Recursion", source="Ogata, Discrete-Time Control Systems, §2–6", time="discrete"
)
def sample_by_sample(given: Given[Equations, DifferenceOptions]) -> Derivation[Answers]:
    """The equations solved for their latest samples, and each value from the ones before."""
    asked = Question.of(given)
    _refuse_ahead(asked)
    values = yield from by_recursion(asked)
    return Answers(values=list(values))


def _problem(asked: Question) -> judges.Recursion:
    return judges.Recursion(
        asked.equations, asked.model.jets, asked.inputs, asked.start, asked.moved or 0, asked.at_rest
    )


@difference_equation.verification("solution")
def goes_through_the_recursion(given: Given[Equations, DifferenceOptions], answers: Answers) -> Iterable[Check]:
    """The equations run through numerically give the values of the solution."""
    asked = Question.of(given)
    functions = {str(name): f for name, f in answers["solution"].items()}
    missing = [name for name in asked.model.unknowns if name not in functions]
    yield Check.that("a sequence for each unknown", "counted", not missing)
    if missing:
        return
    count = 8 + 2 * asked.written.order + max(asked.terms_by_delay)
    try:
        wanted = judges.values_of_recursion(_problem(asked), asked.k, count)
    except numeric.NotEvaluable as refusal:
        yield Check.skipped("the first values", "recursion", refusal.reason)
        return
    for name in asked.model.unknowns:
        claim = Claim(judges.first_values(functions[name], asked.k, count), sp.ImmutableMatrix(wanted[name]))
        yield numeric.check_claim(
            claim, Phrase("${name}(0), {name}(1), \\ldots$ by the recursion", name=formula(sp.Symbol(name)))
        )


@difference_equation.verification("values")
def are_those_of_the_recursion(given: Given[Equations, DifferenceOptions], answers: Answers) -> Iterable[Check]:
    """The equations run through numerically give them."""
    asked, values = Question.of(given), list(answers["values"])
    yield Check.that("as many values as asked for", "counted", len(values) >= asked.terms)
    try:
        wanted = judges.values_of_recursion(_problem(asked), asked.k, len(values))[asked.model.unknowns[0]]
    except numeric.NotEvaluable as refusal:
        yield Check.skipped("the first values", "recursion", refusal.reason)
        return
    for step, (value, right) in enumerate(zip(values, wanted, strict=True)):
        yield numeric.check_claim(Claim(value, right), Phrase("the value at $k = {k}$ by the recursion", k=step))


name_mistakes_of_differences(difference_equation)
