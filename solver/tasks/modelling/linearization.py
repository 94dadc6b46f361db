"""The linear model of a system about a point of equilibrium, by the Jacobians of f and h."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from solver.derivation import (
    AnswerName,
    Answers,
    Check,
    Claim,
    Derivation,
    Given,
    Options,
    Step,
    Task,
    Unsolved,
    option,
)
from solver.derivation.answer_equations import AnswerEquations, Equation
from solver.derivation.figures import Motion, Signals
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import modelling as judges
from solver.options.point import PointOf
from solver.stated.algebra import quotient as over
from solver.stated.calculus import partial_derivative, value_at
from solver.tasks.figures import motion
from solver.tasks.modelling import linearization_mistakes
from solver.tasks.modelling.first_order import FirstOrder, first_order_of, functions_of
from solver.tasks.modelling.operating_point import OperatingPoint, operating_point_of, point_of
from solver.tasks.modelling.questions import is_driven, question_of
from solver.words import Phrase, formula

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

    from solver.systems import Equations


@dataclass(frozen=True, kw_only=True)
class LinearizationOptions(Options):
    """The point."""

    at: Mapping[Symbol, Any] | None = option(
        PointOf(),
        "the point: values of states and inputs; a name not given stands for its own value there",
        answer="points",
    )


NEWTON = "Newton's method and differences"
linearization: Task[Equations, LinearizationOptions] = Task(
    "linearization",
    title="Linearization",
    doc="The linear model for small deviations from an equilibrium.",
    needs=("equations",),
    options=LinearizationOptions,
    example={"equations": "[\"x'' = sin(x) + u\"]", "at": "{x: 0}"},
    answers=[
        AnswerName("A", "A", r"$\partial f/\partial x$ at the point, n×n",
                   principal=True, earned=("entries", "matrices")),
        AnswerName("B", "B", r"$\partial f/\partial u$ at the point, n×m", optional=True, principal=is_driven),
        AnswerName("C", "C", r"$\partial h/\partial x$ at the point, p×n", principal=True),
        AnswerName("D", "D", r"$\partial h/\partial u$ at the point, p×m", optional=True, principal=is_driven),
        AnswerName("conditions", r"\text{conditions}", "what must hold for the point to be an equilibrium",
                   optional=True),
    ],
)  # fmt: skip
linearization.together(
    AnswerEquations(
        "the linear model",
        (
            Equation(r"\Delta x", (("A", r"\Delta x"), ("B", r"\Delta u")), motion=True),
            Equation(r"\Delta y", (("C", r"\Delta x"), ("D", r"\Delta u"))),
        ),
        ("A", "B", "C", "D"),
    )
)

linearization_mistakes.register(linearization)


@linearization.method(source="Ogata, Modern Control Engineering, §2–7")
def by_jacobians(given: Given[Equations, LinearizationOptions]) -> Derivation[Answers]:
    """Δx' = A Δx + B Δu with the partial derivatives of f and h, each taken and then evaluated at the point."""
    found = yield from first_order_of(given.system)
    yield from functions_of(found)
    point = yield from operating_point_of(found, given.options.at or {})
    variables, values = [*found.X, *found.U], point.values
    try:
        quotients, rows = exact.partials_at([*found.f, *found.h], variables, values)
    except exact.NotDifferentiable:
        raise Unsolved("linearization/undefined", values=list(values.items())) from None
    yield _entries(quotients, rows, variables, values, len(found.f))
    n, m = len(found.X), len(found.U)
    J = sp.ImmutableMatrix(len(rows), n + m, [each.value for row in rows for each in row])
    A, B, C, D = (J[:n, :n], J[:n, n:] if m else None, J[n:, :n], J[n:, n:] if m else None)
    yield Step("matrices", unclaimed="the entries found above", A=A, B=B, C=C, D=D, discrete=found.model.discrete,
               figures=_responses(found, values, A))  # fmt: skip
    named = {"A": A, "B": B, "C": C, "D": D}
    answers = Answers(**{name: M for name, M in named.items() if M is not None})
    if point.conditions:
        answers["conditions"] = list(point.conditions)
    return answers


def _responses(found: FirstOrder, values: Mapping[Symbol, Expr], A: ImmutableMatrix) -> tuple[Motion, ...]:
    """Both motions from a small deviation of one state, where all is numbers; the inputs as at the point."""
    X = found.X
    shifted = {x: values[x] + x for x in X} | {u: values[u] for u in found.U}
    f = [row.xreplace(shifted) - (values[x] if found.model.discrete else 0) for x, row in zip(X, found.f, strict=True)]
    if any(row.free_symbols - set(X) for row in f):
        return ()
    seen = [i for i, (_, k) in enumerate(found.states) if k == 0]
    first = next((i for i in seen if any(A.col(i))), seen[0])
    start = sp.ImmutableMatrix([sp.Rational(int(i == first), 10) for i in range(len(X))])
    rows = sp.ImmutableMatrix([[int(i == j) for j in range(len(X))] for i in seen])
    names = tuple(rf"\Delta{{{formula(X[i])}}}" for i in seen)
    shown = Signals(r"\Delta x", names, rows)
    caption = "The linear model and, dashed, the equations themselves, from a deviation of 0.1"
    drawn = motion(caption, A, start, shown, discrete=found.model.discrete)
    return tuple(replace(each, beside=(tuple(X), tuple(f))) for each in drawn)


@dataclass(frozen=True, slots=True)
class Entry:
    """A partial derivative as it is shown: of the function `name` (f or h with its row), at a place of a matrix."""

    name: str
    variable: Symbol
    place: str
    partial: exact.Partial
    function: Expr
    at: Any = ""
    """Numerator over denominator at the point, where the value is a fraction that has to be worked out."""


def _entries(
    quotients: Sequence[exact.Quotient],
    rows: Sequence[Sequence[exact.Partial]],
    variables: Sequence[Symbol],
    values: Mapping[Symbol, Expr],
    n: int,
) -> Step:
    """The partial derivatives that are not seen at once, with their values at the point."""
    shown, claims, split = [], {}, []
    for i, (quotient, row) in enumerate(zip(quotients, rows, strict=True)):
        name, number, letters = ("f", i + 1, "ab") if i < n else ("h", i - n + 1, "cd")
        if quotient.function in variables:
            continue
        taken = list(_of_row(quotient, row, variables, (name, number, letters, n), values))
        if any(each.partial.of_numerator for each in taken):
            split.append((f"{name}_{{{number}}}", number))
        shown += taken
        for each in taken:
            part, x = each.partial, each.variable
            says = Phrase("the partial derivative of row {i}", i=number)
            claims[f"partial_{each.place}"] = Claim(partial_derivative(each.function, x), part.formula, says)
            at = partial_derivative(quotient.function, x)
            claims[f"value_{each.place}"] = Claim(_at(at, quotient.function, values), part.value, says)
    return Step("entries", claims=claims, unclaimed="" if claims else "every entry is seen at once", shown=shown,
                split=split, values=list(values.items()))  # fmt: skip


def _of_row(
    quotient: exact.Quotient,
    row: Sequence[exact.Partial],
    variables: Sequence[Symbol],
    named: tuple[str, int, str, int],
    values: Mapping[Symbol, Expr],
) -> Iterator[Entry]:
    name, number, letters, n = named
    for j, (x, partial) in enumerate(zip(variables, row, strict=True)):
        if partial.formula != 0:
            letter, column = (letters[0], j + 1) if j < n else (letters[1], j - n + 1)
            function = quotient.numerator if partial.of_numerator else quotient.function
            place = f"{letter}_{{{number}{column}}}"
            yield Entry(f"{name}_{{{number}}}", x, place, partial, function, _fraction(partial, values))


def _fraction(partial: exact.Partial, values: Mapping[Symbol, Expr]) -> Any:
    """The numbers put into numerator and denominator, where both are needed."""
    above, below = partial.above, partial.below
    if not partial.of_numerator:
        above, below = (exact.put_in(part, values) for part in sp.fraction(partial.formula))
    if below.could_extract_minus_sign():
        above, below = -above, -below
    return "" if below == 1 or above == 0 or above / below == partial.formula else over(above, below)


def _at(stated: Any, function: Expr, values: Mapping[Symbol, Expr]) -> Any:
    for symbol, value in values.items():
        if symbol != value and function.has(symbol):
            stated = value_at(stated, symbol, value)
    return stated


NEAR = 1e-7
"""What differences leave of a derivative."""
QUADRATIC = 0.35
"""An error that shrinks with the square of the deviation is a quarter where that is halved."""


@linearization.verification("A", "B", "C", "D")
def are_differences_of_the_equations(
    given: Given[Equations, LinearizationOptions], answers: Answers
) -> Iterable[Check]:
    """Differences of the equations themselves around the point, and the motions from a small deviation."""
    model, point = given.system, _point(given)
    question, values = question_of(model), point.values
    found = {name: answers[name] for name in "ABCD" if name in answers}
    for name, label, residual in judges.linear_residuals(question, values, found, discrete=model.discrete):
        near = 1e-5 if numeric.holds_decimals([question.equations, found]) else NEAR
        yield Check.within(label, NEWTON, residual, near, answer=name)
    if "A" in found:
        shrunk = judges.shrinking(question, values, found["A"], discrete=model.discrete)
        label = "the error of the linear motion where the deviation is halved"
        if shrunk is not None:
            yield Check.within(label, "scipy.integrate.solve_ivp", shrunk, QUADRATIC, answer="A")


@linearization.verification("conditions")
def hold_at_rest(given: Given[Equations, LinearizationOptions], answers: Answers) -> Iterable[Check]:
    """Where the equations are at rest, the conditions hold."""
    values, conditions = _point(given).values, list(answers["conditions"])
    residual = judges.condition_residual(question_of(given.system), values, conditions, discrete=given.system.discrete)
    yield Check.within("the conditions at points of rest", NEWTON, residual, NEAR)
    yield from _are_enough(given.system, values, conditions)


def _are_enough(model: Equations, values: Mapping[Symbol, Expr], conditions: Sequence[Any]) -> Iterator[Check]:
    """With the conditions put in the equations hold at rest; by numbers where these are not solved for names."""
    solved = {each.lhs: each.rhs for each in conditions if getattr(each.lhs, "is_Symbol", False)}
    if numeric.holds_decimals([*values.values(), *solved.values()]):
        return
    hidden = any(side.has(model.symbol((name, 0))) for pair in model.sides for side in pair for name in model.algebraic)
    if hidden or len(solved) < len(conditions):
        moved = judges.motion_where(question_of(model), values, conditions, discrete=model.discrete)
        yield Check.within("where the conditions hold, nothing moves", NEWTON, moved, NEAR)
        return
    rest = {
        symbol: sp.S.Zero if k and not model.discrete else values.get(model.symbol((name, 0)), symbol)
        for symbol, (name, k) in model.jets.items()
        if name in (*model.unknowns, *model.inputs)
    }
    for left, right in model.sides:
        there = (left - right).xreplace(rest | {x: v for x, v in values.items() if v != x})
        claim = Claim(there.xreplace(solved).xreplace(solved), sp.S.Zero)
        yield numeric.check_claim(claim, "the conditions are enough for a point of rest")


def _point(given: Given[Equations, LinearizationOptions]) -> OperatingPoint:
    """The point as the question gives it."""
    model = given.system
    return point_of(model, judges.states_of(question_of(model)), given.options.at or {})
