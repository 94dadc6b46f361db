"""The control of least energy between two states: it minimizes c ∫ uᵀRu dt for x' = A x + B u, x(0) and x(T) given."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Check, Claim, Derivation, Given, Refusal, Task
from solver.lazy import numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import variations as judges
from solver.stated.algebra import product
from solver.stated.calculus import derivative, value_at
from solver.stated.matrices import transpose
from solver.tasks.variations import energy_mistakes
from solver.tasks.variations.energy_by_gramian import control_by_gramian, gramian_of
from solver.tasks.variations.energy_by_variations import conditions_of, constants_of, optimum_of
from solver.tasks.variations.energy_question import EnergyOptions, Transfer, faulty_transfer

if TYPE_CHECKING:
    from solver.systems import System
    from solver.tasks.needed import WithInput

FLOATS = 1e-8
"""Tolerance of comparisons with what is simulated in floats."""


def _open_costates(given: Given[WithInput, EnergyOptions]) -> bool:
    """Whether several costates give the control: what the input does not reach may be added."""
    return not judges.reaches_everything(given.system.A, given.system.B)


minimum_energy_control: Task[WithInput, EnergyOptions] = Task(
    "minimum_energy_control",
    title="Control of least energy",
    doc="The input that takes x(0) to x(T) with the least ∫ uᵀRu dt.",
    needs=("A", "B"),
    options=EnergyOptions,
    answers=[
        AnswerName(
            "u",
            "u",
            "the control, in t",
            principal=True,
            earned=("stationary", "ends", "gramian", "gap", "weights"),
        ),
        AnswerName("x", "x", "the states, in t"),
        AnswerName("cost", r"J^{*}", "the least cost"),
        AnswerName(
            "costates",
            r"\lambda",
            r"the costates $\lambda_1, \ldots, \lambda_n$, in $t$",
            methods=("variations",),
            ordered=True,
            free=_open_costates,
        ),
        AnswerName(
            "equations",
            r"\text{equations}",
            "the necessary conditions, each of which is zero (in `lambda1_dot`, `lambda1`, `u`, `x1_dot`, `x1`)",
            methods=("variations",),
            zero=True,
            told=("costate_equations", "stationary"),
        ),
        AnswerName("gramian", "W", r"$\int_0^T e^{At} B R^{-1} B^{T} e^{A^{T} t}\,dt$", methods=("gramian",)),
    ],
    example={"final_time": "1", "initial_state": "[1, 0]"},
)


@minimum_energy_control.refusal
def wrong_question(system: System, options: EnergyOptions) -> Iterable[Refusal]:
    """A weight or a time that is not positive, no ends."""
    yield from faulty_transfer(system, options)


@minimum_energy_control.method(
    "variations", title="Lagrange multipliers", source="Lecture note, section 5.1", time="continuous"
)
def by_variations(given: Given[WithInput, EnergyOptions]) -> Derivation[Answers]:
    """λ' = −∂H/∂x, ∂H/∂u = 0 and x' = A x + B u, with the constants from x(0) and x(T)."""
    transfer = Transfer.of(given)
    equations = yield from conditions_of(transfer)
    best = transfer.solved()
    constants = yield from constants_of(transfer, best)
    answers = yield from optimum_of(transfer, best, constants)
    return Answers(**answers, equations=equations)


@minimum_energy_control.method(
    "gramian",
    title="Controllability Gramian",
    source="Brockett, Finite Dimensional Linear Systems, section 22",
    time="continuous",
)
def by_the_gramian(given: Given[WithInput, EnergyOptions]) -> Derivation[Answers]:
    """u = R⁻¹ Bᵀ e^{Aᵀ(T−t)} η with W η = x(T) − e^{AT} x(0)."""
    transfer = Transfer.of(given)
    best = transfer.solved()
    yield from gramian_of(transfer, best)
    return (yield from control_by_gramian(transfer, best))


@minimum_energy_control.verification("u")
def arrives_at_the_least_cost(given: Given[WithInput, EnergyOptions], answers: Answers) -> Iterable[Check]:
    """u leads to x(T), and is orthogonal to all that leads from rest to rest."""
    transfer, u = Transfer.of(given).judged, answers["u"]
    yield numeric.check_residual(
        "simulated with $u$, the state ends at $x(T)$",
        "scipy.linalg.expm and quadrature",
        lambda: judges.arrival_residual(transfer, u),
        FLOATS,
    )
    yield numeric.check_residual(
        r"$\int u^{T}R\,v\,dt = 0$ for other controls $u + v$ that arrive: each of them costs more",
        "Gauss–Legendre quadrature",
        lambda: judges.orthogonality_residual(transfer, u),
        FLOATS,
    )


@minimum_energy_control.verification("x")
def is_the_optimal_motion(given: Given[WithInput, EnergyOptions], answers: Answers) -> Iterable[Check]:
    """Its ends are those asked for, and on the way it is the simulated one."""
    transfer, x, t = Transfer.of(given), answers["x"], sp.Symbol("t")
    if getattr(x, "shape", None) == transfer.x0.shape:
        yield numeric.check_claim(Claim(value_at(x, t, sp.S.Zero), transfer.x0), "$x(0)$")
        yield numeric.check_claim(Claim(value_at(x, t, transfer.T), transfer.xf), "$x(T)$")
    yield numeric.check_residual(
        "the optimal motion at several times",
        "scipy.linalg.expm and quadrature",
        lambda: judges.motion_residual(transfer.judged, x),
        FLOATS,
    )


@minimum_energy_control.verification("cost")
def is_the_least_cost(given: Given[WithInput, EnergyOptions], answers: Answers) -> Iterable[Check]:
    """The cost of the control that the Gramian gives, in floats."""
    transfer = Transfer.of(given).judged
    yield numeric.check_residual(
        "the cost of the optimal control",
        "scipy.linalg.expm and quadrature",
        lambda: judges.energy_residual(transfer, answers["cost"]),
        FLOATS,
    )


@minimum_energy_control.verification("costates")
def solve_the_costate_equations(given: Given[WithInput, EnergyOptions], answers: Answers) -> Iterable[Check]:
    """λ' = −Aᵀλ, and the control that they give is the optimal one."""
    transfer, t = Transfer.of(given), sp.Symbol("t")
    costates = sp.ImmutableMatrix(list(answers["costates"]))
    if costates.shape == transfer.x0.shape:
        claim = Claim(derivative(costates, t), product(-1, transpose(transfer.A), costates))
        yield numeric.check_claim(claim, r"$\dot{\lambda} = -A^{T}\lambda$")
    yield numeric.check_residual(
        r"the control $-\frac{1}{2c}R^{-1}B^{T}\lambda$ is the optimal one",
        "scipy.linalg.expm and quadrature",
        lambda: judges.costate_residual(transfer.judged, costates),
        FLOATS,
    )


@minimum_energy_control.verification("equations")
def are_the_necessary_conditions(given: Given[WithInput, EnergyOptions], answers: Answers) -> Iterable[Check]:
    """They say the same as λ' = −Aᵀλ, 2cRu + Bᵀλ = 0 and x' = Ax + Bu together."""
    transfer = Transfer.of(given)
    columns = (transfer.rates[0], transfer.costates, transfer.u, transfer.rates[1], transfer.x)
    names: list[Any] = [name for column in columns for name in column.flat()]
    yield numeric.check_residual(
        "the equations together, in any order, scale and combination",
        "numpy.linalg.lstsq",
        lambda: judges.necessary_conditions_residual(transfer.judged, list(answers["equations"]), names),
    )


@minimum_energy_control.verification("gramian")
def is_the_weighted_gramian(given: Given[WithInput, EnergyOptions], answers: Answers) -> Iterable[Check]:
    """The integral by quadrature."""
    transfer = Transfer.of(given).judged
    yield numeric.check_residual(
        r"$\int_{0}^{T} e^{At}BR^{-1}B^{T}e^{A^{T}t}\,dt$",
        "scipy.linalg.expm and quadrature",
        lambda: judges.weighted_gramian_residual(transfer, answers["gramian"]),
        FLOATS,
    )


energy_mistakes.register(minimum_energy_control)
