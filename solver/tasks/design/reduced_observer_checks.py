"""What makes the matrices of an observer of reduced order right: coordinates, poles, an error that nothing drives."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Check, Claim, Given
from solver.lazy import numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import design as judges
from solver.stated import Stated
from solver.stated.algebra import difference, product, total
from solver.stated.matrices import inverse
from solver.tasks.design.mapped_poles import numeric_poles_in_z
from solver.tasks.design.plants import Plant, measuring
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

    from solver.tasks.design.reduced_observer import ReducedObserverOptions
    from solver.tasks.needed import WithInput

BLOCKS = ("A11", "A12", "A21", "A22", "B1", "B2")
BLOCK = r"${letter}_{{{index}}}$ is the block of the plant in $(\eta_1, \eta_2)$"


def puts_the_measured_first(given: Given[WithInput, ReducedObserverOptions], answers: Answers) -> Iterable[Check]:
    """C T = [I, 0] and T invertible; where the outputs are states, the others follow in their order."""
    plant, T = measuring(given.system, given.options.measured), answers["T"]
    p, q = plant.p, plant.n - plant.p
    selected = sp.ImmutableMatrix(sp.Matrix.hstack(sp.eye(p), sp.zeros(p, q)))
    yield numeric.check_claim(Claim(product(plant.C, T), selected), "$C T = [I, 0]$")
    yield Check.that("$T$ is invertible", "numpy.linalg.svd", T.rows == T.cols and numeric.independent(T))
    expected = order_of_states(plant)
    if expected is not None:
        yield numeric.check_claim(Claim(T, expected), "the unmeasured states keep their order")


def order_of_states(plant: Plant) -> ImmutableMatrix | None:
    """T as the convention fixes it where every output is one state; None where outputs are combinations of states."""
    n, rows = plant.n, plant.C.tolist()
    if any(row.count(0) != n - 1 or 1 not in row for row in rows):
        return None
    measured = [row.index(1) for row in rows]
    order = [*measured, *(j for j in range(n) if j not in measured)]
    return sp.ImmutableMatrix(n, n, lambda i, j: int(order[j] == i))


@dataclass(frozen=True)
class _Blocks:
    """What the checks need: the blocks in the coordinates of T, recomputed by sympy's own inverse, and the gain."""

    plant: Plant
    E: ImmutableMatrix
    A: ImmutableMatrix
    B: ImmutableMatrix

    @classmethod
    def of(cls, plant: Plant, answers: Answers) -> _Blocks | None:
        """The blocks in the coordinates that the convention or the answer T fixes; None where neither does."""
        T = order_of_states(plant)
        if T is None:
            T = answers.get("T")
        if T is None or T.shape != plant.A.shape or not numeric.independent(T):
            return None
        Q = sp.Matrix(T).inv()
        return cls(
            plant,
            sp.ImmutableMatrix(Q[plant.p :, :]),
            sp.ImmutableMatrix(Q * plant.A * T),
            sp.ImmutableMatrix(Q * plant.B),
        )

    def __getattr__(self, name: str) -> Any:
        """A11, A12, A21, A22, B1, B2."""
        p = self.plant.p
        if name not in BLOCKS:
            raise AttributeError(name)
        rows = slice(None, p) if name[1] == "1" else slice(p, None)
        if name[0] == "B":
            return self.B[rows, :]
        return self.A[rows, slice(None, p) if name[2] == "1" else slice(p, None)]

    def only_gain(self, poles: Sequence[Expr]) -> Stated | None:
        """The gain by Ackermann's formula where it is the only one: one output, and all of the pair observable."""
        A22, A12, q = self.A22, self.A12, self.A22.rows
        if A12.rows > 1 or len(poles) < q:
            return None
        O = sp.ImmutableMatrix(sp.Matrix.vstack(*(A12 * A22**k for k in range(q))))
        if numeric.rank(O) < q:
            return None
        factors = [sp.ImmutableMatrix(A22 - pole * sp.eye(q)) for pole in poles]
        last = sp.ImmutableMatrix(q, 1, lambda i, _j: int(i == q - 1))
        return product(*factors, inverse(O), last)


def estimates_what_is_not_measured(
    given: Given[WithInput, ReducedObserverOptions], answers: Answers
) -> Iterable[Check]:
    """The blocks are those of T⁻¹AT; the error has the poles asked for and is driven by neither plant nor input."""
    plant = measuring(given.system, given.options.measured)
    blocks = _Blocks.of(plant, answers)
    if blocks is None:
        reason = "the coordinates are free here: it is judged together with T"
        yield from (Check.skipped(f"${name}$", "none", reason, answer=name) for name in answers if name != "T")
        return
    for name in BLOCKS:
        if name in answers:
            claim = Claim(answers[name], getattr(blocks, name))
            yield numeric.check_claim(
                claim,
                Phrase(BLOCK, letter=name[0], index=name[1:]),
                answer=name,
            )
    poles = numeric_poles_in_z(given)
    yield from _spectra(blocks, poles, answers)
    gain = blocks.only_gain(poles)
    yield from _drives(blocks, gain if gain is not None else answers.get("L"), answers)
    yield from _combined_states(blocks, answers)


def _spectra(blocks: _Blocks, poles: Sequence[Expr], answers: Answers) -> Iterator[Check]:
    """The matrix of the error, A22 − L A12, has the poles asked for."""
    A22, A12, n = blocks.A22, blocks.A12, blocks.plant.n
    q, At, Ct = A22.rows, sp.ImmutableMatrix(A22.T), sp.ImmutableMatrix(A12.T)
    errors: dict[str, Any] = {}
    if "L" in answers:
        fits = answers["L"].shape == (q, A12.rows)
        errors["L"] = sp.ImmutableMatrix(A22 - answers["L"] * A12) if fits else sp.ImmutableMatrix(0, 0, [])
    if "J" in answers:
        errors["J"] = answers["J"]
    if "A_combined" in answers:
        errors["A_combined"] = sp.ImmutableMatrix(answers["A_combined"][n:, n:])
    for name, error in errors.items():
        yield numeric.check_residual(
            "the error has the poles asked for",
            "characteristic polynomial",
            partial(judges.placed_matrix_residual, At, Ct, sp.ImmutableMatrix(error.T), poles),
            answer=name,
        )
        if name != "L" and error.shape == A22.shape:
            yield numeric.check_residual(
                r"$J = A_{22} - \sym{L} A_{12}$ for some $\sym{L}$",
                "numpy.linalg.pinv",
                partial(judges.row_space_residual, sp.ImmutableMatrix(A22 - error), A12),
                answer=name,
            )


def _drives(blocks: _Blocks, L: Any, answers: Answers) -> Iterator[Check]:
    """With the gain L neither the plant nor the input drives the error."""
    named = [name for name in ("J", "N", "M", "B_combined") if name in answers]
    if L is None:
        reason = "several gains give these poles: it is judged together with L"
        yield from (Check.skipped(f"${name}$", "none", reason, answer=name) for name in named if name != "J")
        return
    plant, n = blocks.plant, blocks.plant.n
    J = difference(blocks.A22, product(L, blocks.A12))
    N = total(difference(blocks.A21, product(L, blocks.A11)), product(J, L))
    forward = difference(blocks.B2, product(L, blocks.B1))
    M = forward if plant.plain else difference(forward, product(N, plant.D))
    for name, wanted in {"J": J, "N": N, "M": M}.items():
        if name in answers:
            label = Phrase("${name}$ leaves the error alone", name=name)
            yield numeric.check_claim(Claim(answers[name], wanted), label, answer=name)
    if "B_combined" in answers:
        lower = sp.ImmutableMatrix(answers["B_combined"][n:, :])
        yield numeric.check_claim(Claim(lower, forward), "the input does not drive the error", answer="B_combined")


def _combined_states(blocks: _Blocks, answers: Answers) -> Iterator[Check]:
    """Plant above, observer below, and Π A = J Π + N C for the error Π x − ω."""
    plant, n, q = blocks.plant, blocks.plant.n, blocks.A22.rows
    if "A_combined" in answers:
        A = answers["A_combined"]
        upper = sp.ImmutableMatrix(sp.Matrix.hstack(plant.A, sp.zeros(n, q)))
        yield numeric.check_claim(
            Claim(sp.ImmutableMatrix(A[:n, :]), upper), "the upper rows are those of the plant", answer="A_combined"
        )
        yield numeric.check_residual(
            "the plant does not drive the error",
            "numpy.linalg.lstsq",
            lambda: judges.driven_error_residual(
                plant.A, plant.C, blocks.E, sp.ImmutableMatrix(A[n:, n:]), sp.ImmutableMatrix(A[n:, :n])
            ),
            answer="A_combined",
        )
    if "B_combined" in answers:
        claim = Claim(sp.ImmutableMatrix(answers["B_combined"][:n, :]), plant.B)
        yield numeric.check_claim(claim, "the upper rows are $B$ of the plant", answer="B_combined")
