"""The eigenvectors asked for: what is wrong with them as the file shows it, and whether a gain gives them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Check, Claim, Refusal
from solver.lazy import exact, numeric, systems
from solver.lazy import sympy as sp
from solver.numeric.judges import design as judges
from solver.stated.algebra import product
from solver.tasks.design.desired_poles import specified
from solver.tasks.design.frames import same_number
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

    from solver.tasks.design.gain_checks import Asked
    from solver.tasks.design.pole_options import PoleOptions

WHERE = "eigenvectors"


def eigenvector_faults(system: Any, options: PoleOptions, wanted: ImmutableMatrix | None) -> Iterable[Refusal]:
    """Return what is wrong with the wanted eigenvectors (n×n, a column for each pole; None: not asked for)."""
    if (
        wanted is None
        or not isinstance(system, systems.StateSpace)
        or system.B is None
        or options.later & {"poles", "s_poles"}
    ):
        return
    poles, n = options.poles or options.s_poles or (), system.order
    if system.B.cols == 1:
        yield WHERE, Reason("placement/eigenvectors_of_one_input")
    elif specified(options):
        yield WHERE, Reason("placement/eigenvectors_without_poles")
    elif len(poles) < n:
        yield "poles", Reason("placement/all_poles_with_eigenvectors", {"n": n, "count": len(poles)})
    elif wanted.rows != n:
        yield WHERE, Reason("placement/length_of_eigenvectors", {"n": n, "given": wanted.rows})
    elif wanted.cols != n:
        yield WHERE, Reason("placement/number_of_eigenvectors", {"n": n, "given": wanted.cols})
    else:
        yield from _faults_of_columns(poles, [sp.ImmutableMatrix(wanted[:, i]) for i in range(n)])


def _faults_of_columns(poles: Sequence[Expr], columns: Sequence[ImmutableMatrix]) -> Iterable[Refusal]:
    """Columns that are zero, not real for a real pole, or not conjugate for conjugate poles."""
    left = list(range(len(poles)))
    for i, pole in enumerate(poles):
        if columns[i].is_zero_matrix:
            yield WHERE, Reason("placement/zero_eigenvector", {"i": i + 1})
        elif i in left:
            left.remove(i)
            mirror = exact.conjugated(pole)
            if mirror == pole:
                if columns[i].has(sp.I):
                    yield WHERE, Reason("placement/eigenvector_not_real", {"i": i + 1, "pole": pole})
                continue
            j = next((j for j in left if same_number(poles[j], mirror)), None)
            if j is not None:
                left.remove(j)
                if not _parallel(exact.conjugated(columns[i]), columns[j]):
                    values = {"i": i + 1, "j": j + 1, "wanted": exact.conjugated(columns[i]).flat()}
                    yield WHERE, Reason("placement/eigenvectors_not_conjugate", values)


def _parallel(u: ImmutableMatrix, v: ImmutableMatrix) -> bool:
    """Whether one column is a multiple of the other."""
    n = u.rows
    return all(sp.expand(u[i] * v[j] - u[j] * v[i]) == 0 for i in range(n) for j in range(i))


def judge_eigenvectors(asked: Asked, wanted: ImmutableMatrix, answers: Answers) -> Iterable[Check]:
    """The closed loop has the attainable eigenvectors nearest to the wanted ones, which lstsq finds by itself."""
    question = asked.A, asked.B, asked.poles, wanted
    K, loop = answers.get("K"), answers.get("closed_loop_A")
    says = r"$(A - B\sym{K})\,\nu_i = \lambda_i \nu_i$ for the nearest attainable $\nu_i$"
    if K is not None and K.shape == (asked.B.cols, asked.A.rows):
        of_K = sp.ImmutableMatrix(asked.A - asked.B * K)
        yield numeric.check_residual(
            says, "numpy.linalg.lstsq", lambda: judges.assigned_residual(*question, of_K), answer="K"
        )
    if loop is not None:
        yield numeric.check_residual(
            says, "numpy.linalg.lstsq", lambda: judges.assigned_residual(*question, loop), answer="closed_loop_A"
        )
    if "eigenvectors" in answers:
        yield numeric.check_residual(
            "each eigenvector is a multiple of the attainable one nearest to the one asked for",
            "numpy.linalg.lstsq",
            lambda: judges.nearest_residual(*question, answers["eigenvectors"]),
            answer="eigenvectors",
        )
    if "eigenvectors" in answers and loop is not None and loop.shape == answers["eigenvectors"].shape:
        V, poles = answers["eigenvectors"], sp.ImmutableMatrix(sp.diag(*asked.poles))
        says = r"$(A - B\sym{K}) V = V \operatorname{diag}(\lambda_{1}, \ldots, \lambda_{n})$"
        yield numeric.check_claim(Claim(product(loop, V), product(V, poles)), says, answer="eigenvectors")
