"""The state in which a system was, from the output, the input and their derivatives (samples) at one instant."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.arithmetic.exactness import where_exact
from solver.arithmetic.inverses import inverted
from solver.arithmetic.products import multiplied
from solver.derivation import (
    AnswerName,
    Answers,
    Attempt,
    Check,
    Claim,
    Derivation,
    Given,
    Refusal,
    Slip,
    Step,
    Task,
    Unsolved,
    option,
)
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import modelling as judges
from solver.options.expression_list import ExpressionList
from solver.stated.algebra import difference, power, product
from solver.stated.matrices import inverse
from solver.tasks.plant_options import PlantOptions
from solver.tasks.representation.plants import matrices_of
from solver.words import Phrase, Reason

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

    from solver.systems import System
    from solver.tasks.needed import WithOutput


@dataclass(frozen=True, kw_only=True)
class InitialStateOptions(PlantOptions):
    """What is known at the instant."""

    y: tuple[Expr, ...] = option(
        ExpressionList(),
        "y(0), y'(0), … (discrete: y(0), y(1), …); of several outputs one after another",
        required=True,
    )
    u: tuple[Expr, ...] | None = option(
        ExpressionList(), "u(0), u'(0), … (discrete: u(0), u(1), …), zero where not given", needs=("B",)
    )


initial_state: Task[WithOutput, InitialStateOptions] = Task(
    "initial_state",
    title="Initial state",
    doc="The state that an output and its derivatives (discrete: samples) begin in.",
    needs=("A", "C"),
    options=InitialStateOptions,
    example={"y": "[1, 0]"},
    answers=[AnswerName("x0", "x(0)", "the initial state, n×1", earned=("rows", "stacked"))],
)


@dataclass(frozen=True)
class Known:
    """Outputs and inputs by order: `y[k]` and `u[k]` are columns; those of u that are not given are zero."""

    y: list[ImmutableMatrix]
    u: list[ImmutableMatrix]


def _known(plant: Any, options: InitialStateOptions) -> Known:
    p, m = plant.C.rows, plant.B.cols if plant.B is not None else 0
    count = -(-len(options.y) // p)
    u = [*(options.u or ()), *[sp.S.Zero] * (m * count)]
    columns = [sp.ImmutableMatrix(options.y[p * k : p * k + p]) for k in range(count)]
    inputs = [sp.ImmutableMatrix(m, 1, list(u[m * k : m * k + m])) for k in range(count)] if m else []
    return Known(columns, inputs)


@initial_state.refusal
def as_many_values_as_fit(system: System, options: InitialStateOptions) -> Iterable[Refusal]:
    """The values of y are those of all outputs, up to one order; those of u likewise."""
    for name, of in (("y", "p"), ("u", "m")):
        values, size = getattr(options, name), system.size(of)
        if values is not None and size and len(values) % size:
            yield name, Reason("initial_state/not_whole", {"name": name, "size": size, "given": len(values)})


@initial_state.method(source="Lecture note, section 2.2")
def by_observability_matrix(given: Given[WithOutput, InitialStateOptions]) -> Derivation[Answers]:
    """y, y', … are O x(0) and what the input adds; solved for x(0) where O has full rank."""
    plant, known = given.system, _known(given.system, given.options)
    rows, markov = _rows(plant, len(known.y))
    yield _derivatives(plant, rows, markov, known)
    O = sp.ImmutableMatrix.vstack(*rows)
    if exact.rank(O) < plant.order:
        whole = exact.rank(sp.ImmutableMatrix.vstack(*_rows(plant, plant.order)[0]))
        if whole < plant.order:
            raise Unsolved("initial_state/unobservable", rank=whole, n=plant.order)
        raise Unsolved("initial_state/too_few", n=plant.order, discrete=plant.discrete)
    Y, forced = sp.ImmutableMatrix.vstack(*known.y), _forced(markov, known)
    free = _tidy(Y - forced)
    yield Step("stacked", claims={"free": Claim(difference(Y, forced), free, "what the state alone gives")}, O=O, Y=Y,
               forced=forced, free=free, moved=any(forced.flat()))  # fmt: skip
    chosen, x0 = _solution(O, free)
    if any(_tidy(O * x0 - free).flat()):
        raise Unsolved("initial_state/contradiction", discrete=plant.discrete)
    used, right = O.extract(chosen, list(range(O.cols))), free.extract(chosen, [0])
    claims = {
        "equation": Claim(product(O, x0), free, "the initial state put in"),
        "solution": Claim(product(inverse(used), right), x0, "the inverse"),
    }
    whole_rows = len(chosen) == O.rows
    yield Step("solution", claims=claims, steps=_by_the_inverse(used, right, x0) if whole_rows else (), O=used,
               right=right, x0=x0, chosen=[i + 1 for i in chosen], all_rows=whole_rows)  # fmt: skip
    return Answers(x0=x0)


@where_exact
def _by_the_inverse(O: ImmutableMatrix, right: ImmutableMatrix, x0: ImmutableMatrix) -> tuple[Step, ...]:
    """The inverse of the observability matrix, and its product with what the state alone gives."""
    back = exact.inverse(O)
    return inverted(r"\mathcal{O}", O, back) + multiplied(back, right, x0)


def _solution(O: ImmutableMatrix, right: ImmutableMatrix) -> tuple[list[int], ImmutableMatrix]:
    """The first independent rows of O, and the x with O x = right in these."""
    chosen: list[int] = []
    for i in range(O.rows):
        if len(chosen) < O.cols and exact.rank(O.extract([*chosen, i], list(range(O.cols)))) > len(chosen):
            chosen.append(i)
    square = O.extract(chosen, list(range(O.cols)))
    x0 = exact.multiply(exact.inverse(square), right.extract(chosen, [0]))
    return chosen, sp.ImmutableMatrix(x0)


def _rows(plant: Any, count: int) -> tuple[list[ImmutableMatrix], list[ImmutableMatrix]]:
    """C Aᵏ, and the Markov parameters D, C B, C A B, …, both for k below `count`."""
    rows, markov = [plant.C], [matrices_of(plant)[3]] if plant.B is not None else []
    for _ in range(count - 1):
        if plant.B is not None:
            markov.append(sp.ImmutableMatrix(exact.multiply(rows[-1], plant.B)))
        rows.append(sp.ImmutableMatrix(exact.multiply(rows[-1], plant.A)))
    return rows, markov


def _derivatives(plant: Any, rows: list[ImmutableMatrix], markov: list[ImmutableMatrix], known: Known) -> Step:
    claims = {}
    for k, row in enumerate(rows[1:], 1):
        claims[f"row{k}"] = Claim(product(plant.C, power(plant.A, k)), row, Phrase("$C A^{k}$", k=k))
    for k, M in enumerate(markov[1:], 1):
        stated = product(plant.C, plant.B) if k == 1 else product(plant.C, power(plant.A, k - 1), plant.B)
        claims[f"markov{k}"] = Claim(stated, M, "the Markov parameters")
    driven = any(any(M.flat()) for M in markov) and any(any(u.flat()) for u in known.u)
    return Step("rows", claims=claims, unclaimed="" if claims else "the output equation", rows=rows, markov=markov,
                discrete=plant.discrete, driven=driven, through=any(markov[0].flat()) if markov else False, y=known.y,
                u=known.u)  # fmt: skip


def _forced(markov: list[ImmutableMatrix], known: Known) -> ImmutableMatrix:
    """What the inputs give: in row k the sum of M_{k−i} u_i."""
    size = known.y[0].rows
    parts = []
    for k in range(len(known.y)):
        part = sp.zeros(size, 1)
        for i in range(k + 1) if markov else ():
            part += markov[k - i] * known.u[i]
        parts.append(_tidy(part))
    stacked: ImmutableMatrix = sp.ImmutableMatrix.vstack(*parts)
    return stacked


def _tidy(M: Any) -> ImmutableMatrix:
    return sp.ImmutableMatrix(M.rows, M.cols, [exact.tidy(each) for each in M.flat()])


@initial_state.verification("x0")
def begins_with_these_outputs(given: Given[WithOutput, InitialStateOptions], answers: Answers) -> Iterable[Check]:
    """The motion from x0, as numbers, has the outputs and derivatives (samples) that are given."""
    plant, known = given.system, _known(given.system, given.options)
    residual = judges.beginning_residual(
        (plant.A, plant.B, plant.C, matrices_of(plant)[3] if plant.B is not None else None),
        answers["x0"],
        known.y,
        known.u,
        discrete=plant.discrete,
    )
    near = 1e-6 if numeric.holds_decimals([plant.A, plant.C, answers["x0"]]) else 1e-9
    oracle = "recursion" if plant.discrete else "numpy, Taylor series of the motion"
    yield Check.within("the outputs at the beginning of the motion from $x(0)$", oracle, residual, near)


WITHOUT_INPUT = Slip("without_input", "what the input gives is left out")


@initial_state.mistake(WITHOUT_INPUT, "x0")
def input_left_out(attempt: Attempt[WithOutput, InitialStateOptions]) -> Iterable[Any]:
    """O⁻¹ y, as if the inputs were zero; or only the feedthrough of them."""
    plant, known = attempt.given.system, _known(attempt.given.system, attempt.given.options)
    rows, markov = _rows(plant, len(known.y))
    O, Y = sp.ImmutableMatrix.vstack(*rows), sp.ImmutableMatrix.vstack(*known.y)
    yield _solution(O, Y)[1]
    if markov:
        only = [markov[0], *(0 * M for M in markov[1:])]
        yield _solution(O, sp.ImmutableMatrix(Y - _forced(only, known)))[1]


@initial_state.mistake(Slip("sign_of_input", "what the input gives is added, not subtracted"), "x0")
def input_added(attempt: Attempt[WithOutput, InitialStateOptions]) -> Iterable[Any]:
    """O⁻¹ (y + what the inputs give)."""
    plant, known = attempt.given.system, _known(attempt.given.system, attempt.given.options)
    rows, markov = _rows(plant, len(known.y))
    Y = sp.ImmutableMatrix(sp.ImmutableMatrix.vstack(*known.y) + _forced(markov, known))
    yield _solution(sp.ImmutableMatrix.vstack(*rows), Y)[1]
