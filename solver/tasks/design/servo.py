"""Integral action: the error of each output is integrated and fed back, so that y = r in the steady state."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
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
    Step,
    Task,
    Unsolved,
    control_law,
    lemma,
)
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import design as judges
from solver.stated.algebra import difference, product
from solver.stated.matrices import inverse, rank
from solver.tasks import meanings
from solver.tasks.design.gain_checks import Asked, judge_gain
from solver.tasks.design.loop_figures import block_diagram
from solver.tasks.design.mapped_poles import with_mapping_mistakes
from solver.tasks.design.placement import place
from solver.tasks.design.pole_options import PLACING, PoleOptions, asked_poles, numeric_poles, pole_faults, variable
from solver.tasks.design.set_point import determinant_of_rest, feedthrough
from solver.tasks.figures import step_of_the_reference
from solver.tasks.freedom import several_inputs
from solver.words import Phrase, Reason

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

    from solver.tasks.needed import WithBoth


servo: Task[WithBoth, PoleOptions] = Task(
    "servo",
    title="Servo with integral action",
    doc="K and k_I of u = −K x + k_I ξ, ξ' = r − y (discrete: ξ(k+1) = ξ(k) + r − y), for the poles asked for.",
    needs=("A", "B", "C"),
    options=PoleOptions,
    answers=[
        AnswerName(
            "K",
            r"\sym{K}",
            "the gain of the states",
            free=several_inputs,
            principal=True,
            earned=("augmented", *PLACING),
        ),
        AnswerName(
            "k_I", "k_I", "the gain of the integrated error", free=several_inputs, principal=True, earned=("parts",)
        ),
        AnswerName(
            "closed_loop_A",
            r"\bar{A} - \bar{B}\bar{K}",
            r"the matrix of the closed loop in $(x, \sym{integrator})$",
            free=several_inputs,
        ),
    ],
    example={"poles": '["-3 ± 2j", -4]'},
)
servo.together(control_law(("-K", "x"), ("k_I", r"\sym{integrator}")))


def augmented(plant: Any) -> tuple[ImmutableMatrix, ImmutableMatrix]:
    """Return Ā and B̄ of (x, ξ)."""
    A, B = exact.with_integrators(plant.A, plant.B, plant.C, feedthrough(plant), discrete=plant.discrete)
    return A, B


@servo.refusal
def a_pole_for_each_state_and_integrator(system: Any, options: PoleOptions) -> Iterable[Refusal]:
    """There are n + p poles."""
    outputs = getattr(system, "C", None)
    if outputs is not None:
        yield from pole_faults(system, options, extra=outputs.rows)


@lemma("integrators")
def _designed(given: Given[WithBoth, PoleOptions], method: str) -> Derivation[Answers]:
    """Augment the plant by integrators, look whether the inputs move them, and place all poles."""
    plant, x = given.system, variable(given.system)
    n, p, D = plant.order, plant.C.rows, feedthrough(plant)
    yield from block_diagram(
        "servo", r"Servo with integral action, $u = -\sym{K} x + k_I \sym{integrator}$", discrete=plant.discrete
    )
    A, B = augmented(plant)
    yield Step(
        "augmented",
        unclaimed="a definition: the state equations of the plant and of the integrators in one",
        A=A,
        B=B,
        direct=not D.is_zero_matrix,
        discrete=plant.discrete,
        outputs=p,
    )
    yield from _integrators_reached(plant, D)
    poles = yield from asked_poles(given)
    found = yield from place(A, B, poles, method, x=x, named="augmented")
    K, k_I = sp.ImmutableMatrix(found.K[:, :n]), sp.ImmutableMatrix(-found.K[:, n:])
    yield Step(
        "parts",
        claims={"whole": Claim(found.K, sp.ImmutableMatrix(sp.Matrix.hstack(K, -k_I)), "$[K, -k_I]$")},
        K=K,
        k_I=k_I,
    )
    yield from _steady_state(plant, found.loop, K, k_I)
    return Answers(K=K, k_I=k_I, closed_loop_A=found.loop)


def _integrators_reached(plant: Any, D: ImmutableMatrix) -> Derivation[None]:
    """The integrators can be moved unless the plant has a zero at the origin (z = 1): full rank of [[A, B], [C, D]]."""
    m, p, n = plant.B.cols, plant.C.rows, plant.order
    M = exact.equations_of_rest(plant.A, plant.B, plant.C, D, discrete=plant.discrete)
    order = exact.rank(M)
    claims = {"rank": Claim(rank(M), sp.Integer(order), "rank of the matrix of the steady state")}
    if m == p:
        more, lines = determinant_of_rest(M, exact.determinant(M))
        claims |= more
    values = {"order": order, "needed": n + p, "discrete": plant.discrete, "square": m == p}
    yield Step("condition", claims=claims, M=M, steps=lines if m == p else (), **values)
    if order == n + p:
        return
    if m < p:
        raise Unsolved("tracking/fewer_inputs", m=m, p=p)
    raise Unsolved("tracking/zero_at_rest", discrete=plant.discrete)


def _steady_state(plant: Any, loop: ImmutableMatrix, K: ImmutableMatrix, k_I: ImmutableMatrix) -> Derivation[None]:
    """The closed loop's gain from r to y in the steady state is the identity: C̄ (−Ā_cl)⁻¹ [0; I] = I."""
    D, n, p = feedthrough(plant), plant.order, k_I.cols
    rest = exact.at_rest(loop, discrete=plant.discrete)
    reference = sp.ImmutableMatrix(sp.Matrix.vstack(sp.zeros(n, p), sp.eye(p)))
    if exact.is_singular(rest):
        raise Unsolved("tracking/pole_at_rest")
    seen = sp.ImmutableMatrix(sp.Matrix.hstack(sp.Matrix(exact.added(plant.C, -D * K)), sp.Matrix(D * k_I)))
    gain = product(-1, seen, inverse(rest), reference)
    yield Step(
        "no_error",
        claims={
            "gain": Claim(gain, sp.ImmutableMatrix(sp.eye(p)), "steady-state gain from the reference to the output")
        },
        discrete=plant.discrete,
        seen=seen,
        outputs=p,
        figures=step_of_the_reference(
            loop,
            reference,
            (seen, sp.ImmutableMatrix(sp.zeros(p, p))),
            (sp.ImmutableMatrix(sp.Matrix.hstack(-K, k_I)), sp.ImmutableMatrix(sp.zeros(k_I.rows, p))),
            discrete=plant.discrete,
        ),
    )


@servo.method("coefficient_matching", title="Comparison of coefficients", source="Lecture note, section 3.3")
def by_coefficient_matching(given: Given[WithBoth, PoleOptions]) -> Derivation[Answers]:
    """det(sI − Ā + B̄K̄) with unknown entries of K̄ = [K, −k_I] is compared with the desired polynomial."""
    return (yield from _designed(given, "coefficient_matching"))


@servo.method("bass_gura", title="Formula of Bass and Gura", source="Lecture note, sections 3.1 and 3.3")
def by_bass_gura(given: Given[WithBoth, PoleOptions]) -> Derivation[Answers]:
    """K̄ = (â − a)ᵀ (𝒞 W)⁻¹ for the augmented plant."""
    return (yield from _designed(given, "bass_gura"))


@servo.method("canonical_form", title="Canonical form", source="Lecture note, sections 3.1 and 3.3")
def by_canonical_form(given: Given[WithBoth, PoleOptions]) -> Derivation[Answers]:
    """The augmented plant in canonical form, where the gain is â − a."""
    return (yield from _designed(given, "canonical_form"))


@servo.method("ackermann", title="Ackermann's formula", source="Lecture note, sections 3.1 and 3.3")
def by_ackermann(given: Given[WithBoth, PoleOptions]) -> Derivation[Answers]:
    """K̄ = (0, …, 0, 1) 𝒞⁻¹ p̂(Ā)."""
    return (yield from _designed(given, "ackermann"))


@servo.method("unity_rank", title="Gain of unity rank", source="Kailath, Linear Systems, section 7.1")
def by_unity_rank(given: Given[WithBoth, PoleOptions]) -> Derivation[Answers]:
    """K̄ = g k: the inputs of the augmented plant act together as one."""
    return (yield from _designed(given, "unity_rank"))


@servo.verification("K", "k_I", "closed_loop_A")
def has_the_poles_and_no_error(given: Given[WithBoth, PoleOptions], answers: Answers) -> Iterable[Check]:
    """The spectrum of the closed loop in (x, ξ); a gain alone is judged by whether another completes it (one input)."""
    plant = given.system
    A, B, C, D, n = plant.A, plant.B, plant.C, feedthrough(plant), plant.order
    below = sp.eye(C.rows) if plant.discrete else sp.zeros(C.rows)
    big = sp.ImmutableMatrix(sp.BlockMatrix([[A, sp.ZeroMatrix(n, C.rows)], [-C, below]]).as_explicit())
    inputs = sp.ImmutableMatrix(sp.Matrix.vstack(sp.Matrix(B), sp.Matrix(-D)))
    poles = numeric_poles(given)
    K, k_I, loop = answers.get("K"), answers.get("k_I"), answers.get("closed_loop_A")
    asked = Asked(big, inputs, poles, variable(plant))
    shapes = {"K": (B.cols, n), "k_I": (B.cols, C.rows)}
    misfits = [name for name, shape in shapes.items() if name in answers and answers[name].shape != shape]
    for name in misfits:
        yield Check.that(
            "the gain has one row an input and one column a state (an output)", "shape", False, answer=name
        )
    if misfits:
        return
    if K is not None and k_I is not None:
        whole = sp.ImmutableMatrix(sp.Matrix.hstack(sp.Matrix(K), -sp.Matrix(k_I)))
        label = r"$\det(xI - \bar{A} + \bar{B}[K, -k_I]) = \prod_i (x - p_i)$ at random $x$"
        yield numeric.check_residual(
            label, "numpy.linalg.det", lambda: judges.placed_residual(big, inputs, whole, poles)
        )
        if loop is not None:
            yield from judge_gain(asked, Answers(closed_loop_A=loop))
            stated = difference(big, product(inputs, whole))
            yield numeric.check_claim(Claim(stated, loop), r"$\bar{A} - \bar{B}[K, -k_I]$", answer="closed_loop_A")
        return
    if loop is not None:
        yield from judge_gain(asked, Answers(closed_loop_A=loop))
    for name, value, start in (("K", K, 0), ("k_I", k_I, n)):
        if value is not None:
            known = {start + j: (value[0, j] if name == "K" else -value[0, j]) for j in range(value.cols)}
            yield numeric.check_residual(
                Phrase("${name}$ is part of a gain that places the poles", name=name),
                "numpy.linalg.lstsq",
                lambda known=known: judges.completed_residual(big, inputs, known, poles),  # type: ignore[misc]
                answer=name,
            )


@servo.consequence("closed_loop_A", of=("K", "k_I"))
def loop_of_the_gains(given: Given[WithBoth, PoleOptions], found: Mapping[str, Any]) -> Any:
    """Ā − B̄ [K, −k_I]."""
    A, B = augmented(given.system)
    whole = sp.Matrix.hstack(sp.Matrix(found["K"]), -sp.Matrix(found["k_I"]))
    return sp.ImmutableMatrix(A - B * whole)


with_mapping_mistakes(servo)


@servo.meaning("K", "k_I", "closed_loop_A")
def poles_of_the_loop(wrong: Attempt[WithBoth, PoleOptions]) -> Reason | None:
    """The poles that the loop has; of K alone their sum, in which k_I is not."""
    asked, own = numeric_poles(wrong.given), wrong.submitted
    if wrong.name == "closed_loop_A":
        return meanings.poles_given(wrong.value, asked)
    if "K" in own and "k_I" not in own:
        return meanings.sum_of_poles(wrong.given.system.A - wrong.given.system.B * own["K"], asked)
    if "K" not in own:
        return None
    other = "k_I" if wrong.name == "K" else r"\sym{K}"
    return meanings.poles_given(loop_of_the_gains(wrong.given, own), asked, beside=other)
