"""Feedforward that holds the output at a constant reference: x_d = F r, u_d = N r, u = −K x + K_o r."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.arithmetic.inverses import inverted as inverted_by_cofactors
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
    Step,
    Task,
    Unsolved,
    control_law,
    option,
)
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import design as judges
from solver.options.matrix import MatrixOf
from solver.stated.algebra import difference, product, total
from solver.stated.matrices import inverse, rank
from solver.tasks import consequences, meanings
from solver.tasks.design.loop_figures import block_diagram
from solver.tasks.design.mapped_poles import with_mapping_mistakes
from solver.tasks.design.placement import place
from solver.tasks.design.pole_options import PoleOptions, asked_poles, numeric_poles, pole_faults, variable
from solver.tasks.design.set_point import (
    after_a_step,
    determinant_of_rest,
    feedthrough,
    least_solution,
    rest_by_elimination,
)
from solver.tasks.freedom import gain_is_free, more_inputs_than_outputs, reference_gain_is_free
from solver.words import Phrase, Reason

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

    from solver.tasks.needed import WithBoth


@dataclass(frozen=True, kw_only=True)
class ReferenceTrackingOptions(PoleOptions):
    """The poles, and what is known of the gain."""

    gain: ImmutableMatrix | None = option(
        MatrixOf("m", "n", flat="row"), "the feedback K of u = −K x + K_o r", answer="K"
    )


reference_tracking: Task[WithBoth, ReferenceTrackingOptions] = Task(
    "reference_tracking",
    title="Tracking of a constant reference",
    doc="The steady state x_d = F r, u_d = N r in which the output is r, and K_o = N + K F of u = −K x + K_o r.",
    needs=("A", "B", "C"),
    options=ReferenceTrackingOptions,
    answers=[
        AnswerName("F", "F", "the desired state for the reference, $x_{d} = Fr$", free=more_inputs_than_outputs),
        AnswerName("N", "N", "the desired input for the reference, $u_{d} = Nr$", free=more_inputs_than_outputs),
        AnswerName(
            "K_o",
            "K_o",
            "the gain of the reference",
            free=reference_gain_is_free,
            principal=True,
            earned=("input", "solution", "state", "closed_loop"),
        ),
        AnswerName("K", r"\sym{K}", "the gain of the feedback", (), True, free=gain_is_free),
    ],
    example={"poles": '["-3 ± 2j"]'},
)
reference_tracking.together(control_law(("-K", "x"), ("K_o", "r")))


@reference_tracking.refusal
def a_gain_or_poles(system: Any, options: ReferenceTrackingOptions) -> Iterable[Refusal]:
    """Either the gain is given, or poles for it."""
    if not options.has("gain"):
        yield from pole_faults(system, options)
    elif options.poles:
        yield "poles", Reason("placement/gain_and_poles")


@reference_tracking.method(source="Lecture note, sections 3.2 and 5.4")
def by_the_steady_state(given: Given[WithBoth, ReferenceTrackingOptions]) -> Derivation[Answers]:
    """In the steady state A F + B N = 0 and C F + D N = I; u = u_d − K (x − x_d) gives K_o = N + K F."""
    plant, discrete = given.system, given.system.discrete
    A, B, C, D = plant.A, plant.B, plant.C, feedthrough(plant)
    yield from block_diagram(
        "state_feedback_reference", r"State feedback with a reference, $u = -\sym{K} x + K_o r$", discrete=discrete
    )
    F, N = yield from steady_state_of(A, B, C, D, discrete=discrete)
    K, placed = given.options.gain, given.options.gain is None
    if K is None:
        poles = yield from asked_poles(given)
        method = "coefficient_matching" if B.cols == 1 and A.rows <= 3 else "ackermann"
        found = yield from place(A, B, poles, method, x=variable(plant))
        K = found.K
    K_o = yield from _feedforward(given, K, F, N)
    answers = Answers(F=F, N=N, K_o=K_o)
    if placed:
        answers["K"] = K
    return answers


def steady_state_of(
    A: ImmutableMatrix, B: ImmutableMatrix, C: ImmutableMatrix, D: ImmutableMatrix, *, discrete: bool
) -> Derivation[tuple[ImmutableMatrix, ImmutableMatrix]]:
    """Solve the equations of the steady state for F and N; raises Unsolved where they have no solution for every r."""
    n, m, p = A.rows, B.cols, C.rows
    M = exact.equations_of_rest(A, B, C, D, discrete=discrete)
    order = exact.rank(M)
    claims = {"rank": Claim(rank(M), sp.Integer(order), "rank of the matrix of the steady state")}
    more, lines = determinant_of_rest(M, exact.determinant(M)) if M.is_square else ({}, ())
    shape = {"inputs": m, "outputs": p, "states": n}
    yield Step("steady_state", claims=claims | more, M=M, discrete=discrete, order=order, steps=lines, **shape)
    if order < n + p:
        raise Unsolved("tracking/no_steady_state", m=m, p=p, discrete=discrete)
    steady = exact.set_point(A, B, C, D, discrete=discrete)
    if not steady.unique:
        solution = least_solution(steady)
    elif not exact.is_singular(exact.at_rest(A, discrete=discrete)):
        yield from _through_the_inverse(A, B, C, D, steady, discrete=discrete)
        return steady.F, steady.N
    else:
        solution = product(inverse(M), steady.right)
    yield Step(
        "solution",
        claims={"solution": Claim(solution, steady.stacked, "solution of the equations of the steady state")},
        F=steady.F,
        N=steady.N,
        unique=steady.unique,
        discrete=discrete,
        steps=rest_by_elimination(steady) if steady.unique else (),
    )
    return steady.F, steady.N


def _through_the_inverse(
    A: ImmutableMatrix,
    B: ImmutableMatrix,
    C: ImmutableMatrix,
    D: ImmutableMatrix,
    steady: exact.SetPoint,
    *,
    discrete: bool,
) -> Derivation[None]:
    """F = −A⁻¹ B N and N = (D − C A⁻¹ B)⁻¹, for a nonsingular A (discrete: A − I)."""
    A0 = exact.at_rest(A, discrete=discrete)
    inverted = exact.inverse(A0)
    dc = exact.added(D, -C * inverted * B)
    through = exact.added(inverted * B)
    lines = inverted_by_cofactors("(A - I)" if discrete else "A", A0, inverted)
    lines += multiplied(inverted, B, through) + multiplied(exact.added(-C), through, exact.added(-C * through))
    terms = [product(-1, C, inverse(A0), B)] if D.is_zero_matrix else [D, product(-1, C, inverse(A0), B)]
    yield Step(
        "input",
        claims={
            "inverse": Claim(inverse(A0), inverted, "inverse"),
            "dc": Claim(total(*terms), dc, "steady-state gain of the plant"),
            "N": Claim(inverse(dc), steady.N, "$N$"),
        },
        discrete=discrete,
        direct=not D.is_zero_matrix,
        scalar=dc.shape == (1, 1),
        steps=lines,
    )
    yield Step("state", claims={"F": Claim(product(-1, inverted, B, steady.N), steady.F, "$F$")}, discrete=discrete)


def _feedforward(
    given: Given[WithBoth, ReferenceTrackingOptions], K: ImmutableMatrix, F: ImmutableMatrix, N: ImmutableMatrix
) -> Derivation[ImmutableMatrix]:
    """K_o = N + K F, and the steady-state gain of the closed loop, which is the identity."""
    plant = given.system
    K_o: ImmutableMatrix = exact.added(N, K * F)
    claims = {"K_o": Claim(total(N, product(K, F)), K_o, "$K_o = N + K F$")}
    yield Step("feedforward", claims=claims, K=K, steps=multiplied(K, F, exact.added(K * F)))
    A, B, C, D = plant.A, plant.B, plant.C, feedthrough(plant)
    loop = exact.added(A, -B * K)
    rest = exact.at_rest(loop, discrete=plant.discrete)
    if exact.is_singular(rest):
        raise Unsolved("tracking/does_not_settle")
    seen = exact.added(C, -D * K)
    terms = [product(-1, seen, inverse(rest), B, K_o)]
    terms = terms if D.is_zero_matrix else [*terms, product(D, K_o)]
    identity = sp.ImmutableMatrix(sp.eye(C.rows))
    yield Step(
        "check",
        claims={"gain": Claim(total(*terms), identity, "steady-state gain from the reference to the output")},
        loop=loop,
        discrete=plant.discrete,
        direct=not D.is_zero_matrix,
        figures=after_a_step(plant, K, K_o),
    )
    return K_o


@reference_tracking.verification("F", "N", "K_o", "K")
def holds_the_output_at_the_reference(
    given: Given[WithBoth, ReferenceTrackingOptions], answers: Answers
) -> Iterable[Check]:
    """A F + B N = 0 and C F + D N = I; where one of the two is missing, some other completes it (numpy)."""
    plant = given.system
    A, B, C, D = plant.A, plant.B, plant.C, feedthrough(plant)
    rest = difference(A, sp.ImmutableMatrix(sp.eye(A.rows))) if plant.discrete else A
    F, N, K = answers.get("F"), answers.get("N"), answers.get("K", given.options.gain)
    matrices = (A, B, C, D)
    if F is not None and N is not None:
        zero, identity = sp.ImmutableMatrix(sp.zeros(A.rows, C.rows)), sp.ImmutableMatrix(sp.eye(C.rows))
        at_rest, held = total(product(rest, F), product(B, N)), total(product(C, F), product(D, N))
        yield numeric.check_claim(Claim(at_rest, zero), "the desired state is at rest: $A F + B N = 0$")
        yield numeric.check_claim(Claim(held, identity), "the output is the reference: $C F + D N = I$")
    for name in ("F", "N"):
        if name in answers:
            known = {name: answers[name]}
            yield numeric.check_residual(
                Phrase("${name}$ belongs to a steady state with $y = r$", name=name),
                "numpy.linalg.lstsq",
                lambda known=known: judges.steady_residual(matrices, known, discrete=plant.discrete),  # type: ignore[misc]
                answer=name,
            )
    if "K" in answers:
        yield numeric.check_residual(
            r"$\det(xI - A + BK) = \prod_i (x - p_i)$ at random $x$",
            "numpy.linalg.det",
            lambda: judges.placed_residual(A, B, answers["K"], numeric_poles(given)),
            answer="K",
        )
    if "K_o" in answers:
        yield numeric.check_residual(
            "$K_o = N + K F$ for a steady state with $y = r$",
            "numpy.linalg.lstsq",
            lambda: judges.feedforward_residual(
                matrices, answers["K_o"], K, numeric_poles(given) if K is None else (), discrete=plant.discrete
            ),
            answer="K_o",
        )


reference_tracking.consequence("F", of=("N",))(consequences.state_of_rest)
reference_tracking.consequence("K_o", of=("F", "N"))(consequences.reference_gain)
reference_tracking.consequence("K_o", of=("F", "N", "K"))(consequences.reference_gain)


with_mapping_mistakes(reference_tracking)


@reference_tracking.meaning("K")
def poles_of_the_gain(wrong: Attempt[WithBoth, ReferenceTrackingOptions]) -> Reason | None:
    """The poles that the gain gives."""
    plant = wrong.given.system
    return meanings.poles_given(plant.A - plant.B * wrong.value, numeric_poles(wrong.given))
