"""Decoupling by state feedback: u = −K x + F v, so that each input v acts on an output of its own alone."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import (
    AnswerName,
    Answers,
    Attempt,
    Check,
    Claim,
    Derivation,
    Given,
    Refusal,
    Task,
    control_law,
    option,
)
from solver.lazy import numeric, systems
from solver.lazy import sympy as sp
from solver.numeric.judges import multivariable as judges
from solver.numeric.judges import structure
from solver.options.channel_poles import ChannelPoles
from solver.stated.algebra import difference, product, total
from solver.stated.matrices import determinant, inverse
from solver.tasks.multivariable import decoupling_mistakes as mistakes
from solver.tasks.multivariable.decoupling_steps import (
    channels_of,
    closed_loop_of,
    hidden_motion_of,
    interaction_of,
    law_of,
    polynomials_of,
)
from solver.tasks.plant_options import PlantOptions
from solver.tasks.representation.plants import matrices_of, variable_of
from solver.tasks.structure.pair_checks import condition_checks
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr

    from solver.stated import Stated
    from solver.tasks.needed import WithBoth


@dataclass(frozen=True, kw_only=True)
class DecouplingOptions(PlantOptions):
    """Where the decoupled channels have their poles."""

    poles: tuple[Any, ...] | None = option(
        ChannelPoles(), "poles of the decoupled channels, as many each as its relative degree (all at the origin)"
    )


def gain_is_free(given: Given[WithBoth, DecouplingOptions]) -> bool:
    """What no input moves may be fed back or not."""
    A, B = given.system.A, given.system.B
    return bool(numeric.rank(structure.krylov_matrix(A, B)) < A.rows)


decoupling: Task[WithBoth, DecouplingOptions] = Task(
    "decoupling",
    title="Decoupling by state feedback",
    doc="The law u = −K x + F v under which each new input acts on one output alone, where there is one.",
    needs=("A", "B", "C"),
    options=DecouplingOptions,
    answers=[
        AnswerName(
            "feasible",
            r"\text{feasible}",
            "whether static state feedback decouples the plant",
            principal=True,
            earned=("matrix", "infeasible"),
        ),
        AnswerName(
            "relative_degrees",
            "r_i",
            r"the relative degrees: which derivative of each output an input acts on first ($\infty$: on none)",
            ordered=True, numbered=True,
            principal=True,
            earned=("differentiated",),
        ),
        AnswerName("K", r"\sym{K}", "the gain of the feedback", optional=True, free=gain_is_free, principal=True,
                   earned=("rows", "law", "decay")),
        AnswerName("F", "F", "the gain of the new inputs, $(B^{*})^{-1}$", optional=True, principal=True),
        AnswerName("G", "G", "the diagonal transfer matrix from $v$ to $y$", optional=True),
        AnswerName(
            "exceptions",
            r"\text{exceptions}",
            "for which parameters a relative degree is another, or $B^{*}$ has no inverse",
            optional=True,
        ),
    ],
    example={
        "A": "[[0, 1], [0, -1]]",
        "B": "[[1, 0], [0, 1]]",
        "C": "[[1, 0], [0, 1]]",
        "poles": "[[-1], [-2]]",
    },
)  # fmt: skip
decoupling.together(control_law(("-K", "x"), ("F", "v")))


@decoupling.refusal
def as_many_inputs_as_outputs(system: Any, options: DecouplingOptions) -> Iterable[Refusal]:
    """One input for each output; for each channel as many poles as its relative degree, closed under conjugation."""
    p, m = system.size("p"), system.size("m")
    if p is not None and m is not None and p != m:
        yield "", Reason("decoupling/not_square", {"p": p, "m": m})
    elif isinstance(system, systems.StateSpace) and system.C is not None and system.B is not None and options.poles:
        fault = channels_of(system, options.poles).fault
        if fault is not None:
            yield "poles", fault


@decoupling.method(source="Falb and Wolovich, IEEE Trans. Automatic Control 12 (1967)")
def by_differentiating_the_outputs(given: Given[WithBoth, DecouplingOptions]) -> Derivation[Answers]:
    """Differentiate each output until an input acts on it; these inputs can be chosen at will if B* has an inverse."""
    plant, x = given.system, variable_of(given.system)
    found, exceptions = yield from interaction_of(plant)
    degrees = [sp.oo if r is None else sp.Integer(r) for r in found.degrees]
    answers = Answers(feasible=bool(found.determinant != 0), relative_degrees=degrees)
    if exceptions is not None:
        answers["exceptions"] = exceptions
    if not answers["feasible"]:
        return answers
    polynomials = yield from polynomials_of(plant, found, given.options.poles, x)
    law = yield from law_of(plant, found, polynomials, x)
    loop, G = yield from closed_loop_of(plant, law, polynomials, x)
    yield from hidden_motion_of(plant, found, loop, polynomials, x)
    answers.update(K=law.K, F=law.F, G=G[0, 0] if G.shape == (1, 1) else G)
    return answers


@decoupling.verification("feasible", "relative_degrees")
def outputs_that_inputs_act_on(given: Given[WithBoth, DecouplingOptions], answers: Answers) -> Iterable[Check]:
    """The products c Aᵏ B and their ranks at random values of the parameters."""
    found = judges.acting_inputs(*matrices_of(given.system))
    if "relative_degrees" in answers:
        degrees = [sp.oo if r is None else sp.Integer(r) for r in found.degrees]
        holds = list(answers["relative_degrees"]) == degrees
        label = r"$c_i A^{r_i - 1} B$ is the first of its row that is not zero"
        yield Check.that(label, "numpy.linalg.svd", holds, answer="relative_degrees")
    if "feasible" in answers:
        label = r"the inputs that act on the outputs are independent, $\operatorname{rank} B^{*}$"
        holds = bool(answers["feasible"]) == found.decouples
        yield Check.that(label, "numpy.linalg.svd", holds, answer="feasible")


@decoupling.verification("K", "F", "G")
def decouples(given: Given[WithBoth, DecouplingOptions], answers: Answers) -> Iterable[Check]:
    """The closed loop at random s, its poles by determinants, and F by B* F, each for itself and together."""
    plant, x = given.system, variable_of(given.system)
    A, B, C, D = matrices_of(plant)
    found = judges.acting_inputs(A, B, C, D)
    degrees = [r or 0 for r in found.degrees]
    alphas = judges.channel_polynomials(degrees, given.options.poles, x) if found.decouples else None
    if alphas is None:
        label = "the plant can be decoupled, with as many poles as there are in the channels"
        yield Check.that(label, "numpy.linalg.svd", False)
        return
    wanted = sp.ImmutableMatrix(sp.diag(*(1 / alpha for alpha in alphas)))
    gains = [*_gains(alphas, x, discrete=plant.discrete)]
    if "K" in answers:
        yield from _gain_checks((A, B, C, D), answers["K"], found.matrix, alphas, x)
    if "F" in answers:
        yield _one_of([Claim(product(found.matrix, answers["F"]), gain) for gain in gains], "$B^{*}F = I$", "F")
    if "G" in answers:
        G = answers["G"] if isinstance(answers["G"], sp.MatrixBase) else sp.ImmutableMatrix([[answers["G"]]])
        label = r"$G$ is diagonal, with $1/\alpha_i$ in channel $i$"
        yield _one_of([Claim(product(wanted, gain), G) for gain in gains], label, "G")
    if "K" in answers and "F" in answers and "G" in answers:
        through = _through((A, B, C, D), answers["K"], answers["F"], x)
        yield numeric.check_claim(Claim(through, G), "$K$ and $F$ lead to $G$ at random points")


def _gains(alphas: list[Any], x: Any, *, discrete: bool) -> Iterator[Any]:
    """B* F: the identity, or what makes the steady-state gains one, which is as usual."""
    yield sp.ImmutableMatrix(sp.eye(len(alphas)))
    at_rest = [sp.expand(alpha.subs(x, int(discrete))) for alpha in alphas]
    if all(value != 0 for value in at_rest):
        yield sp.ImmutableMatrix(sp.diag(*at_rest))


def _one_of(claims: list[Claim], label: str, answer: str) -> Check:
    """The check of the first claim that holds, else of the first."""
    checks = [numeric.check_claim(claim, label, answer=answer) for claim in claims]
    return next((each for each in checks if each.status.value == "passed"), checks[0])


def _gain_checks(matrices: tuple[Any, ...], K: Any, E: Any, alphas: list[Expr], x: Any) -> Iterator[Check]:
    """G(s) with F = B*⁻¹, and the poles: those of the channels, and where the system matrix has no inverse."""
    A, B, C, D = matrices
    if K.shape != (B.cols, A.rows):
        yield Check.that("the shape of $K$", "shape", False, answer="K")
        return
    through = _through(matrices, K, inverse(E), x)
    wanted = sp.ImmutableMatrix(sp.diag(*(1 / alpha for alpha in alphas)))
    label = r"$(C - DK)(sI - A + BK)^{-1}BF + DF$ is diagonal, with $1/\alpha_i$ in channel $i$"
    yield numeric.check_claim(Claim(through, wanted), label.replace("s", str(x), 1), answer="K")
    poles = determinant(total(_pencil(A, x), product(B, K)))
    zeros = determinant(judges.system_matrix_of(A, B, C, D, x))
    claim = Claim(product(determinant(E), poles), product(*alphas, zeros))
    yield numeric.check_claim(claim, "the poles are those of the channels and the zeros of the plant", answer="K")


def _pencil(A: Any, x: Any) -> Stated:
    return difference(product(x, sp.ImmutableMatrix(sp.eye(A.rows))), A)


def _through(matrices: tuple[Any, ...], K: Any, F: Any, x: Any) -> Stated:
    """(C − D K)(xI − A + B K)⁻¹ B F + D F as stated."""
    A, B, C, D = matrices
    return total(
        product(difference(C, product(D, K)), inverse(total(_pencil(A, x), product(B, K))), B, F), product(D, F)
    )


@decoupling.verification("exceptions")
def where_it_is_different(given: Given[WithBoth, DecouplingOptions], answers: Answers) -> Iterable[Check]:
    """The rank of B* falls there, or where it has no inverse anyway a row of it vanishes, and nowhere else."""
    found = judges.acting_inputs(*matrices_of(given.system))
    told = found.matrix if found.decouples else found.rows_apart
    yield from condition_checks(told, answers["exceptions"], "exceptions")


@decoupling.consequence("K", of=("F",))
def gain_of_the_inverse(given: Given[WithBoth, DecouplingOptions], found: Mapping[str, Any]) -> Any:
    """F times the rows c α(A)."""
    own = channels_of(given.system, given.options.poles)
    return None if own.polynomials is None else sp.ImmutableMatrix(found["F"] * mistakes.rows_of(own))


mistakes.register(decoupling)


@decoupling.meaning("K")
def still_coupled(wrong: Attempt[WithBoth, DecouplingOptions]) -> Reason | None:
    """An entry beside the diagonal that is not zero with this gain."""
    return mistakes.coupling_left(wrong)
