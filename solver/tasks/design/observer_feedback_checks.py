"""What makes the answers about feedback of an estimate right: both spectra, the separation, the loop closed."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Check, Claim, Given
from solver.lazy import numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import design as judges
from solver.stated.algebra import product
from solver.tasks.design.mapped_poles import numeric_poles_in_z
from solver.tasks.design.plants import Plant, measuring
from solver.tasks.design.reduced_observer_checks import order_of_states
from solver.tasks.sample_times import sample_time_of

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

    from solver.tasks.design.observer_feedback import ObserverFeedbackOptions
    from solver.tasks.needed import WithBoth


def observer_poles(given: Given[WithBoth, ObserverFeedbackOptions]) -> list[Any]:
    """The poles of the observer without the exact kernels, e^{sT} as it stands."""
    in_s = given.options.observer_s_poles
    if in_s is None:
        return list(given.options.observer_poles or ())
    return judges.sampled_poles(in_s, sample_time_of(given))


def _coordinates(given: Given[WithBoth, ObserverFeedbackOptions], answers: Answers, plant: Plant) -> Any:
    """T of x = T η: the identity for an observer of full order; None where neither convention nor answers tell."""
    if not given.options.reduced:
        return sp.ImmutableMatrix(sp.eye(plant.n))
    T = order_of_states(plant)
    if T is None and "S1" in answers and "S2" in answers:
        T = sp.ImmutableMatrix(sp.Matrix.hstack(answers["S1"], answers["S2"]))
    fits = T is not None and T.shape == plant.A.shape and numeric.independent(T)
    return T if fits else None


def _observed(
    given: Given[WithBoth, ObserverFeedbackOptions], plant: Plant, T: ImmutableMatrix
) -> tuple[ImmutableMatrix, ImmutableMatrix]:
    """The pair of the error equation: (A, C), or (A22, A12) in the coordinates T."""
    if not given.options.reduced:
        return plant.A, plant.C
    A = sp.Matrix(T).inv() * plant.A * T
    return sp.ImmutableMatrix(A[plant.p :, plant.p :]), sp.ImmutableMatrix(A[: plant.p, plant.p :])


def has_both_spectra(given: Given[WithBoth, ObserverFeedbackOptions], answers: Answers) -> Iterable[Check]:
    """[[A − BK, BK S₂], [0, A − LC]] for some gains, with the poles asked for (or for the gains given)."""
    plant, whole = measuring(given.system), answers["closed_loop_A"]
    T = _coordinates(given, answers, plant)
    if T is None:
        yield Check.skipped("closed loop", "none", "the coordinates are free here: it is judged together with S1, S2")
        return
    n, (A22, A12) = plant.n, _observed(given, plant, T)
    size = n + A22.rows
    yield Check.that("its size", "inspection", whole.shape == (size, size))
    if whole.shape != (size, size):
        return
    inverse = sp.Matrix(T).inv()
    A, B = sp.ImmutableMatrix(inverse * plant.A * T), sp.ImmutableMatrix(inverse * plant.B)
    loop, coupling = sp.ImmutableMatrix(whole[:n, :n]), sp.ImmutableMatrix(whole[:n, n:])
    lower, error = sp.ImmutableMatrix(whole[n:, :n]), sp.ImmutableMatrix(whole[n:, n:])
    zero = sp.ImmutableMatrix(sp.zeros(*lower.shape))
    yield numeric.check_claim(Claim(lower, zero), "nothing drives the error")
    first = plant.p if given.options.reduced else 0
    feedback = sp.ImmutableMatrix((A - loop)[:, first:])
    yield numeric.check_claim(Claim(coupling, feedback), "the error enters as the state does")
    yield from _is_feedback(given, sp.ImmutableMatrix(A.T), sp.ImmutableMatrix(B.T), loop, T)
    yield from _is_observer(given, A22, A12, error)


def _is_feedback(
    given: Given[WithBoth, ObserverFeedbackOptions], At: Any, Bt: Any, loop: Any, T: Any
) -> Iterator[Check]:
    A, B = sp.ImmutableMatrix(At.T), sp.ImmutableMatrix(Bt.T)
    if given.options.gain is not None:
        claim = Claim(loop, sp.ImmutableMatrix(A - B * given.options.gain * T))
        yield numeric.check_claim(claim, "$A - B K$ with the gain given")
        return
    yield numeric.check_residual(
        "the state feedback has the poles asked for",
        "characteristic polynomial",
        lambda: judges.placed_matrix_residual(A, B, loop, numeric_poles_in_z(given)),
    )
    yield numeric.check_residual(
        "it is $A - B K$ for some $K$",
        "numpy.linalg.pinv",
        lambda: judges.row_space_residual(sp.ImmutableMatrix(At - loop.T), Bt),
    )


def _is_observer(given: Given[WithBoth, ObserverFeedbackOptions], A22: Any, A12: Any, error: Any) -> Iterator[Check]:
    if given.options.observer_gain is not None:
        claim = Claim(error, sp.ImmutableMatrix(A22 - given.options.observer_gain * A12))
        yield numeric.check_claim(claim, "the error with the gain given")
        return
    At, Ct = sp.ImmutableMatrix(A22.T), sp.ImmutableMatrix(A12.T)
    yield numeric.check_residual(
        "the error has the poles asked for",
        "characteristic polynomial",
        lambda: judges.placed_matrix_residual(At, Ct, sp.ImmutableMatrix(error.T), observer_poles(given)),
    )
    yield numeric.check_residual(
        "it is $A - L C$ for some $L$",
        "numpy.linalg.pinv",
        lambda: judges.row_space_residual(sp.ImmutableMatrix(A22 - error), A12),
    )


def _groups(given: Given[WithBoth, ObserverFeedbackOptions], answers: Answers) -> list[Any] | None:
    """For the feedback and for the observer: (A, B, poles) or, of a gain that is given, the closed matrix."""
    plant = measuring(given.system)
    T = _coordinates(given, answers, plant)
    if T is None:
        T = _some_coordinates(plant)
    A22, A12 = _observed(given, plant, T)
    K, L = given.options.gain, given.options.observer_gain
    control = (plant.A, plant.B, numeric_poles_in_z(given)) if K is None else sp.ImmutableMatrix(plant.A - plant.B * K)
    if L is None:
        error: Any = (sp.ImmutableMatrix(A22.T), sp.ImmutableMatrix(A12.T), observer_poles(given))
    elif given.options.reduced and order_of_states(plant) is None and "S2" not in answers:
        return None  # what a gain does depends on the coordinates
    else:
        error = sp.ImmutableMatrix(A22 - L * A12)
    return [control, error]


def _some_coordinates(plant: Plant) -> ImmutableMatrix:
    """Any T with C T = [I, 0]: the poles of the error do not depend on it."""
    C = sp.Matrix(plant.C)
    right = C.T * (C * C.T).inv()
    return sp.ImmutableMatrix(sp.Matrix.hstack(right, *C.nullspace()))


def are_those_of_both(given: Given[WithBoth, ObserverFeedbackOptions], answers: Answers) -> Iterable[Check]:
    """The eigenvalues of the feedback and those of the observer, each as often as it occurs."""
    groups = _groups(given, answers)
    if groups is None:
        reason = "the coordinates are free here: they are judged together with S1, S2"
        yield Check.skipped("eigenvalues", "none", reason)
        return
    yield numeric.check_residual(
        "the eigenvalues are those of the feedback and of the observer",
        "characteristic polynomial",
        lambda: judges.joined_spectrum_residual(answers["eigenvalues"], groups),
    )


def closes_the_loop(given: Given[WithBoth, ObserverFeedbackOptions], answers: Answers) -> Iterable[Check]:
    """The plant with u = G y in its loop has the characteristic polynomial that was designed."""
    plant, G, groups = measuring(given.system), answers["compensator"], _groups(given, answers)
    if groups is None:
        reason = "the coordinates are free here: it is judged together with S1, S2"
        yield Check.skipped("compensator", "none", reason)
        return
    matrix = G if isinstance(G, sp.MatrixBase) else sp.ImmutableMatrix([[G]])
    order = plant.n - plant.p if given.options.reduced else plant.n
    yield numeric.check_residual(
        "with it the loop has the poles of feedback and observer",
        "return difference at random points",
        lambda: judges.closing_residual((plant.A, plant.B, plant.C, plant.D), matrix, plant.variable, groups, order),
        1e-6,
    )


def split_the_state(given: Given[WithBoth, ObserverFeedbackOptions], answers: Answers) -> Iterable[Check]:
    """C S₁ = I and C S₂ = 0 with independent columns; where the outputs are states, the others keep their order."""
    plant = measuring(given.system)
    p, q = plant.p, plant.n - plant.p
    expected = order_of_states(plant)
    for name, right, columns in (
        ("S1", sp.eye(p), slice(None, p)),
        ("S2", sp.zeros(p, q), slice(p, None)),
    ):
        if name in answers:
            S = answers[name]
            claim = Claim(product(plant.C, S), sp.ImmutableMatrix(right))
            yield numeric.check_claim(claim, f"$C {name[0]}_{name[1]} = {'I' if name == 'S1' else 0}$", answer=name)
            yield Check.that("its columns are independent", "numpy.linalg.svd", numeric.independent(S), answer=name)
            if expected is not None:
                yield numeric.check_claim(
                    Claim(S, sp.ImmutableMatrix(expected[:, columns])), "the states keep their order", answer=name
                )
    if expected is None and "S1" in answers and "S2" in answers:
        T = sp.ImmutableMatrix(sp.Matrix.hstack(answers["S1"], answers["S2"]))
        yield Check.that("$T$ is invertible", "numpy.linalg.svd", numeric.independent(T))
