"""Model matching: a state feedback that gives the plant the transfer function of a model."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import (
    AnswerName,
    Answers,
    Check,
    Claim,
    Derivation,
    Given,
    Refusal,
    Step,
    Task,
    Unsolved,
    option,
)
from solver.lazy import exact, numeric, systems
from solver.lazy import sympy as sp
from solver.numeric.judges import design as judges
from solver.options.transfer_function import TransferFunctionOption
from solver.stated.algebra import difference, product, quotient, total
from solver.stated.matrices import inverse
from solver.tasks.design.frames import Wanted
from solver.tasks.design.loop_figures import block_diagram
from solver.tasks.design.placement import place
from solver.tasks.design.pole_options import variable
from solver.tasks.plant_options import PlantOptions
from solver.tasks.representation.completing import register
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

    from solver.tasks.needed import InputOutput

    Matrices = tuple[ImmutableMatrix, ImmutableMatrix, ImmutableMatrix, ImmutableMatrix]


@dataclass(frozen=True, kw_only=True)
class ModelMatchingOptions(PlantOptions):
    """What the plant is to become."""

    target: Expr = option(TransferFunctionOption(), "the transfer function wanted, proper", required=True)


model_matching: Task[InputOutput, ModelMatchingOptions] = Task(
    "model_matching",
    title="Model matching by state feedback",
    doc="Whether state feedback (and a gain of the reference) can turn the plant's transfer function into a target.",
    needs=("transfer_function",),
    options=ModelMatchingOptions,
    answers=[
        AnswerName("feasible", r"\text{feasible}", "whether state feedback alone turns the plant into the target"),
        AnswerName("compensator", "G/H", "the series compensator that would do the same: target over plant"),
        AnswerName("A", "A", "system matrix of the realization used", (), True, free=True),
        AnswerName("B", "B", "input matrix of the realization", (), True, free=True),
        AnswerName("C", "C", "output matrix of the realization", (), True, free=True),
        AnswerName(
            "K",
            r"\sym{K}",
            "the gain for this realization",
            (),
            True,
            free=True,
            principal=True,
            earned=("compensator", "conditions", "gain_polynomial", "equations"),
        ),
    ],
)


@model_matching.refusal
def one_input_and_output(system: Any, options: ModelMatchingOptions) -> Iterable[Refusal]:
    """The plant has one input and one output, the target the plant's variable."""
    target, other = options.target, sp.Symbol("s" if system.discrete else "z")
    if target is not None and target.has(other):
        names = {"variable": str(variable(system)), "other": str(other)}
        yield "target", Reason("model_matching/other_variable", names)
    if isinstance(system, systems.TransferFunction):
        single = system.matrix.shape == (1, 1)
    else:
        single = system.B is None or system.C is None or (system.B.cols, system.C.rows) == (1, 1)
    if not single:
        yield "", Reason("model_matching/several_channels")


def _fraction(system: Any, x: Symbol) -> tuple[Expr, Expr]:
    """Return numerator and denominator of the plant, not cancelled."""
    G = system
    if isinstance(system, systems.StateSpace):
        D = system.D if system.D is not None else sp.ImmutableMatrix([[0]])
        G = exact.transfer_matrix(system.A, system.B, system.C, D, x)
    return G.numerators[0][0], G.denominators[0][0]


def transfer_of(matrices: Matrices, x: Symbol) -> Any:
    """C (xI − A)⁻¹ B + D as stated."""
    A, B, C, D = matrices
    resolvent = inverse(difference(product(x, sp.ImmutableMatrix(sp.eye(A.rows))), A))
    through = product(C, resolvent, B)
    return through if D.is_zero_matrix else total(through, D)


@model_matching.method(source="Lecture note, section 3.5")
def by_moving_the_poles(given: Given[InputOutput, ModelMatchingOptions]) -> Derivation[Answers]:
    """State feedback keeps the zeros of the plant and moves its poles; so the target's zeros must be among them."""
    x, G = variable(given.system), given.options.target
    top, bottom = _fraction(given.system, x)
    yield _plant_shown(given.system, top, bottom, x)
    if not top.free_symbols and top == 0:
        raise Unsolved("model_matching/zero_plant")
    found = exact.matching(top, bottom, G, x)
    if found.order == 0:
        raise Unsolved("model_matching/constant_plant")
    yield from block_diagram("model_matching", "State feedback that turns $H$ into $G$")
    H = quotient(found.numerator, found.denominator)
    yield Step(
        "compensator",
        claims={"series": Claim(product(H, found.compensator), G, "plant times compensator")},
        G=quotient(found.target_numerator, found.target_denominator),
        compensator=found.compensator,
        x=x,
        proper=found.relative_degrees[1] >= found.relative_degrees[0],
    )
    stable = _all_stable(found.hidden_zeros, discrete=given.system.discrete)
    yield Step(
        "conditions",
        unclaimed="" if found.possible else "a comparison of zeros and degrees",
        claims={
            "polynomial": Claim(
                product(found.target_denominator, found.hidden),
                exact.polynomial_in(x, found.desired),
                "desired closed-loop polynomial",
            )
        }
        if found.desired
        else {},
        found=found,
        stable=stable,
        x=x,
        discrete=given.system.discrete,
    )
    answers = Answers(feasible=found.possible and stable, compensator=found.compensator)
    if answers["feasible"]:
        yield from _designed(given, found, answers, x)
    return answers


def _plant_shown(system: Any, top: Expr, bottom: Expr, x: Symbol) -> Step:
    """H as numerator over denominator, from the matrices where these are given."""
    H = quotient(sp.factor(top), sp.factor(bottom))
    if not isinstance(system, systems.StateSpace):
        return Step("plant", unclaimed="as given", H=H, x=x)
    plant: Any = system
    D = plant.D if plant.D is not None else sp.ImmutableMatrix([[0]])
    stated = transfer_of((plant.A, plant.B, plant.C, D), x)
    found = sp.ImmutableMatrix([[top / bottom]])
    return Step("plant", claims={"H": Claim(stated, found, "transfer function of the plant")}, H=H, x=x)


def _all_stable(zeros: Iterable[Expr], *, discrete: bool) -> bool:
    """Whether the zeros that become hidden poles decay; raises Unsolved where parameters leave it open."""
    for zero in zeros:
        real, imaginary = exact.complex_parts(zero)
        sign = exact.sign_of(sp.expand(real**2 + imaginary**2 - 1) if discrete else real)
        if sign is None:
            raise Unsolved("model_matching/hidden_pole", zero=zero)
        if sign >= 0:
            return False
    return True


def _designed(
    given: Given[InputOutput, ModelMatchingOptions], found: exact.Matching, answers: Answers, x: Symbol
) -> Derivation[None]:
    """Realize the plant, place the poles, and compare the closed loop with the target."""
    matrices = yield from _realized(given, found, x)
    A, B, C, D = matrices
    if exact.reachable_order(A, B) < A.rows:
        raise Unsolved("model_matching/not_controllable")
    placed = yield from place(A, B, (), "coefficient_matching", x=x, wanted=Wanted(coefficients=found.desired or ()))
    seen = exact.added(C, -D * placed.K)
    loop = transfer_of((placed.loop, B, seen, D), x)
    yield Step(
        "matched",
        claims={
            "transfer": Claim(product(found.gain, loop), sp.ImmutableMatrix([[given.options.target]]), "closed loop")
        },
        loop=placed.loop,
        B=B,
        C=seen,
        gain=found.gain,
        target=quotient(found.target_numerator, found.target_denominator),
        hidden=found.hidden,
        x=x,
    )
    answers.update(A=A, B=B, C=C, K=placed.K)


def _realized(
    given: Given[InputOutput, ModelMatchingOptions], found: exact.Matching, x: Symbol
) -> Derivation[Matrices]:
    """The plant in state space: as given, or in controllable canonical form with the states in descending order."""
    plant = given.system
    if isinstance(plant, systems.StateSpace):
        D = plant.D if plant.D is not None else sp.ImmutableMatrix([[0]])
        matrices = (plant.A, plant.B, plant.C, D)
    else:
        matrices = exact.descending_form(*_fraction(given.system, x), x)
    H = sp.ImmutableMatrix([[found.numerator / found.denominator]])
    A, B, C, D = matrices
    yield Step(
        "realization",
        claims={"transfer": Claim(transfer_of(matrices, x), H, "the realization has the transfer function")},
        own=isinstance(plant, systems.StateSpace),
        A=A,
        B=B,
        C=C,
        D=D,
        x=x,
    )
    return A, B, C, D


@model_matching.verification("feasible", "compensator", "A", "B", "C", "K")
def turns_the_plant_into_the_target(
    given: Given[InputOutput, ModelMatchingOptions], answers: Answers
) -> Iterable[Check]:
    """Zeros and degrees compared in numbers; compensator, realization and closed loop at random points."""
    x, G = variable(given.system), given.options.target
    system = given.system
    if isinstance(system, systems.StateSpace):
        D = system.D if system.D is not None else sp.ImmutableMatrix([[0]])
        own = (system.A, system.B, system.C, D)
        plant = judges.fraction_of(own, x)
    else:
        own, plant = None, (system.numerators[0][0], system.denominators[0][0])
    if "feasible" in answers:
        holds = judges.matching_possible(plant, G, x, discrete=system.discrete)
        yield Check.that(
            "the target's zeros are zeros of the plant, relative degrees agree, hidden poles are stable",
            "numpy.roots",
            bool(answers["feasible"]) == holds,
            answer="feasible",
        )
    if "compensator" in answers:
        series = product(quotient(*plant), answers["compensator"])
        yield numeric.check_claim(Claim(series, G), "plant times compensator is the target", answer="compensator")
    given_realization = all(name in answers for name in "ABC")
    for name in "ABC":
        if name in answers and not given_realization:
            yield Check.skipped("realization", "random points", "it is judged with A, B and C together", answer=name)
    matrices = own or judges.first_row_form(plant, x)
    if given_realization:
        matrices = (answers["A"], answers["B"], answers["C"], judges.direct_term(plant, x))
        yield numeric.check_residual(
            r"$C(xI - A)^{-1}B + D$ is the plant at random points",
            "numpy.linalg.solve",
            lambda: judges.realization_residual(matrices, plant, x),
        )
    if "K" in answers:
        yield numeric.check_residual(
            "the closed loop is the target up to a constant gain",
            "numpy.linalg.solve",
            lambda: judges.matched_residual(matrices, answers["K"], G, x),
            answer="K",
        )


register(model_matching)
