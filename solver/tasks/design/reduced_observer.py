"""Observer of reduced order: estimates only what is not measured."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

from solver.derivation import (
    AnswerEquations,
    AnswerName,
    Answers,
    Attempt,
    Claim,
    Derivation,
    Equation,
    Given,
    Refusal,
    Step,
    Task,
    Unsolved,
    option,
)
from solver.lazy import exact, systems
from solver.lazy import sympy as sp
from solver.options.names import Names
from solver.options.poles import Poles
from solver.stated.algebra import product, total
from solver.stated.matrices import partitioned
from solver.tasks import meanings
from solver.tasks.design import reduced_observer_checks as checks
from solver.tasks.design import reduced_observer_formulas as formulas
from solver.tasks.design.mapped_poles import (
    SampledPoles,
    asked_faults,
    listed,
    numeric_poles_in_z,
    poles_in_z,
    with_mapping_mistakes,
)
from solver.tasks.design.plants import measuring
from solver.tasks.design.reduced_order import (
    error_equation_of,
    estimate_of,
    measurement_fault,
    observer_matrices_of,
    partition_of,
    pole_faults,
    reduced_gain_of,
)
from solver.tasks.freedom import measured_by_combinations, reduced_gain_is_free
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import System
    from solver.tasks.needed import WithInput


@dataclass(frozen=True, kw_only=True)
class ReducedObserverOptions(SampledPoles):
    """Where the estimation error has its poles, and what is measured."""

    poles: tuple[Expr, ...] | None = option(Poles(), "the n − p eigenvalues of J (or those of the observable part)")
    measured: tuple[str, ...] | None = option(Names(), "the measured states (names or numbers), where C does not say")


OBSERVER = AnswerEquations(
    "the observer",
    (
        Equation(r"\omega", (("J", r"\omega"), ("N", "y"), ("M", "u")), motion=True),
        Equation(r"\hat{\eta}_{2}", (("", r"\omega"), ("L", "y"))),
    ),
    ("J", "N", "M"),
)

reduced_observer: Task[WithInput, ReducedObserverOptions] = Task(
    "reduced_observer",
    title="Observer of reduced order",
    doc="ω' = Jω + Ny + Mu estimates the n − p unmeasured states, η̂₂ = ω + Ly, with errors of the given eigenvalues.",
    needs=("A", "B"),
    options=ReducedObserverOptions,
    answers=[
        AnswerName(
            "L",
            r"\sym{L}",
            r"the gain of the observer, $\hat{\eta}_{2} = \omega + \sym{L}y$",
            free=reduced_gain_is_free,
            principal=True,
            earned=("desired", "unknown", "compare", "choice"),
        ),
        AnswerName(
            "J", "J", r"the matrix of the error, $A_{22} - \sym{L}A_{12}$", free=reduced_gain_is_free, principal=True
        ),
        AnswerName(
            "N",
            "N",
            r"the gain from $y$, $A_{21} - \sym{L}A_{11} + J\sym{L}$",
            free=reduced_gain_is_free,
            principal=True,
        ),
        AnswerName("M", "M", r"the gain from $u$, $B_{2} - \sym{L}B_{1}$", free=reduced_gain_is_free, principal=True),
        AnswerName(
            "T",
            "T",
            r"the transformation $x = T\eta$: what is measured first, then the other states in their order",
            free=measured_by_combinations,
        ),
        AnswerName("A11", "A_{11}", r"how $\eta_{1}$ acts on itself", free=measured_by_combinations, told=("blocks",)),
        AnswerName(
            "A12", "A_{12}", r"how $\eta_{2}$ acts on $\eta_{1}$", free=measured_by_combinations, told=("blocks",)
        ),
        AnswerName(
            "A21", "A_{21}", r"how $\eta_{1}$ acts on $\eta_{2}$", free=measured_by_combinations, told=("blocks",)
        ),
        AnswerName("A22", "A_{22}", r"how $\eta_{2}$ acts on itself", free=measured_by_combinations, told=("blocks",)),
        AnswerName("B1", "B_1", r"how $u$ acts on $\eta_{1}$", free=measured_by_combinations, told=("blocks",)),
        AnswerName("B2", "B_2", r"how $u$ acts on $\eta_{2}$", free=measured_by_combinations, told=("blocks",)),
        AnswerName(
            "A_combined",
            r"A_{\text{combined}}",
            r"the matrix of plant and observer together, in $(x, \omega)$",
            free=reduced_gain_is_free,
        ),
        AnswerName(
            "B_combined",
            r"B_{\text{combined}}",
            r"the input matrix of plant and observer together, in $(x, \omega)$",
            free=reduced_gain_is_free,
        ),
    ],
    example={"C": "[1, 0]", "poles": "[-6]"},
)
reduced_observer.together(OBSERVER)


@reduced_observer.refusal
def what_the_file_shows(system: System, options: ReducedObserverOptions) -> Iterator[Refusal]:
    """Nothing measured, or all, or one quantity twice; another number of poles than of unmeasured states."""
    if not isinstance(system, systems.StateSpace):
        return
    measured = options.measured
    try:
        plant = measuring(system, measured)
    except Unsolved as fault:
        yield "measured", fault.reason
        return
    wrong = measurement_fault(plant)
    if wrong is not None:
        yield "measured" if measured else "", wrong
        return
    unmapped = [*asked_faults(system, options)]
    yield from unmapped
    name, poles = listed(options)
    if not unmapped and poles is not None:
        yield from pole_faults(plant, poles, name)


@reduced_observer.method(source="Lecture note, section 4.2")
def by_partition(given: Given[WithInput, ReducedObserverOptions]) -> Derivation[Answers]:
    """Split off what is measured; A22 − L A12 gets the poles; J, N, M follow from the error equation."""
    plant = measuring(given.system, given.options.measured)
    poles = yield from poles_in_z(given)
    faults = [measurement_fault(plant), *(fault for _, fault in pole_faults(plant, poles))]
    for fault in filter(None, faults):
        raise Unsolved("engine/refused", fault=fault)
    parts = yield from partition_of(plant)
    yield from error_equation_of(discrete=plant.discrete)
    design = yield from reduced_gain_of(parts, poles, discrete=plant.discrete)
    J, N, M = yield from observer_matrices_of(parts, design.L, plant, chosen=design.chosen)
    n, q, C = plant.n, J.rows, plant.C
    yield from estimate_of(parts, design, J, plant)
    NC = exact.multiply(N, C)
    A_combined = sp.ImmutableMatrix(sp.Matrix([[plant.A, sp.zeros(n, q)], [NC, J]]))
    forward = M if plant.plain else sp.ImmutableMatrix(M + exact.multiply(N, plant.D))
    B_combined = sp.ImmutableMatrix(sp.Matrix.vstack(plant.B, forward))
    claims = {"NC": Claim(product(N, C), NC, "$N C$")}
    if not plant.plain:
        claims["through"] = Claim(total(M, product(N, plant.D)), forward, "$M + N D$")
    yield Step(
        "combined",
        claims=claims,
        A=partitioned(A_combined, (n,), (n,)),
        B=partitioned(B_combined, (n,), ()),
        names=[*map(sp.Symbol, plant.state_names), *sp.symbols(f"omega1:{q + 1}")],
        discrete=plant.discrete,
        plain=plant.plain,
    )
    return Answers(L=design.L, J=J, N=N, M=M, T=parts.T, **parts.blocks, A_combined=A_combined, B_combined=B_combined)


reduced_observer.verification("T")(checks.puts_the_measured_first)
reduced_observer.verification(*checks.BLOCKS, "L", "J", "N", "M", "A_combined", "B_combined")(
    checks.estimates_what_is_not_measured
)


reduced_observer.consequence("L", of=("A12", "A22"), symbolic=False)(formulas.gain_for_the_pair)
reduced_observer.consequence("J", of=("L", "A12", "A22"))(formulas.error_matrix)
reduced_observer.consequence("N", of=("L", "J", "A11", "A21"))(formulas.gain_of_the_output)
reduced_observer.consequence("M", of=("L", "N", "B1", "B2"))(formulas.gain_of_the_input)
reduced_observer.consequence("A_combined", of=("J", "N"))(formulas.combined_matrix)
reduced_observer.consequence("B_combined", of=("M", "N"))(formulas.combined_input)
for each in checks.BLOCKS:
    reduced_observer.consequence(each, of=("T",))(partial(formulas.block, each))


with_mapping_mistakes(reduced_observer)


@reduced_observer.meaning("L", "J")
def poles_of_the_error(wrong: Attempt[WithInput, ReducedObserverOptions]) -> Reason | None:
    """The poles of the error; those of a gain where the coordinates are those of the plant."""
    if wrong.name == "J":
        return meanings.poles_given(wrong.value, numeric_poles_in_z(wrong.given))
    if measured_by_combinations(wrong.given):
        return None
    A22, A12 = wrong.answers["A22"], wrong.answers["A12"]
    return meanings.poles_given(A22 - wrong.value * A12, numeric_poles_in_z(wrong.given))
