"""The usual mistakes of decoupling, and what a wrong gain leaves coupled."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt, Slip
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.tasks import mistakes
from solver.tasks.multivariable.decoupling_steps import Channels, channels_of
from solver.tasks.representation.plants import matrices_of
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

    from solver.derivation import Task

NOT_INVERTED = Slip(
    "not_inverted", "$B^{*}$ is not inverted; $F = (B^{*})^{-1}$ and $K = (B^{*})^{-1}[c_i\\alpha_i(A)]$"
)
POWER = Slip("power", "the rows are $c_iA^{r_i - 1}$, one power of $A$ too low; they must be $c_iA^{r_i}$")
ONE_LESS = Slip("one_less", "each is the power of $A$ in $c_iA^{r_i - 1}B$; the relative degree is one more")
ONE_MORE = Slip("one_more", "each is one too large: $c_iA^{r_i - 1}B$ is the first that is not zero")
SIGN_OF_POLES = Slip("sign_of_poles", "the polynomials have the roots $-p_i$ in place of $p_i$")
WITHOUT_POLES = Slip(
    "without_poles", "it leaves all poles at the origin; the polynomials of the channels are forgotten"
)

POINTS = (1, 2, 3)


def rows_of(own: Channels) -> ImmutableMatrix:
    """The rows c α(A)."""
    return exact.decoupling_law(own.found, own.polynomials or ()).rows


def register(task: Task[Any, Any]) -> None:
    """Declare the mistakes of the task."""
    task.mistake(mistakes.GAIN_ADDED, "K")(mistakes.negative)
    task.mistake(NOT_INVERTED, "K", "F")(_not_inverted)
    task.mistake(POWER, "K")(_power_too_low)
    task.mistake(ONE_LESS, "relative_degrees")(lambda wrong: [[r - 1 for r in wrong.ours]])
    task.mistake(ONE_MORE, "relative_degrees")(lambda wrong: [[r + 1 for r in wrong.ours]])
    task.mistaken_question(mistakes.EXCHANGED)(mistakes.inputs_for_outputs)
    task.mistaken_question(SIGN_OF_POLES)(_poles_negated)
    task.mistaken_question(WITHOUT_POLES)(_without_poles)


def _not_inverted(wrong: Attempt[Any, Any]) -> Iterable[Any]:
    """B* for F, and B* times the rows for K."""
    own = channels_of(wrong.given.system, wrong.given.options.poles)
    if own.polynomials is not None:
        E = own.found.matrix
        yield E if wrong.name == "F" else sp.ImmutableMatrix(E * rows_of(own))


def _power_too_low(wrong: Attempt[Any, Any]) -> Iterable[Any]:
    """B*⁻¹ times the rows with c A^{r−1} for c Aʳ, the other terms as they are or one power lower too."""
    own = channels_of(wrong.given.system, wrong.given.options.poles)
    if own.polynomials is None or 0 in own.found.degrees:
        return
    lower = sp.Matrix.vstack(*(sp.Matrix(channel.rows[-2] - channel.rows[-1]) for channel in own.found.channels))
    F = exact.inverse(own.found.matrix)
    yield sp.ImmutableMatrix(F * (rows_of(own) + lower))


def _poles_negated(system: Any, options: Any) -> Any:
    poles = options.poles
    if not poles:
        return None
    by_channel = isinstance(poles[0], tuple | list)
    turned = tuple(tuple(-p for p in each) for each in poles) if by_channel else tuple(-p for p in poles)
    return system, replace(options, poles=turned)


def _without_poles(system: Any, options: Any) -> Any:
    return (system, replace(options, poles=None)) if options.poles else None


def coupling_left(wrong: Attempt[Any, Any]) -> Reason | None:
    """Return an entry beside the diagonal of G with this gain and F = B*⁻¹ that is not zero; None with parameters."""
    plant, K = wrong.given.system, wrong.value
    A, B, C, D = matrices_of(plant)
    own = channels_of(plant, wrong.given.options.poles)
    if own.polynomials is None or K.shape != (B.cols, A.rows) or any(M.free_symbols for M in (A, B, C, D, K)):
        return None
    F = exact.inverse(own.found.matrix)
    for point in POINTS:
        pencil = sp.Matrix(point * sp.eye(A.rows) - A + B * K)
        if pencil.det() == 0:
            continue
        G = (C - D * K) * pencil.LUsolve(sp.Matrix(B * F)) + D * F
        for i, j in ((i, j) for i in range(G.rows) for j in range(G.cols) if i != j):
            if abs(complex(G[i, j])) > numeric.TOLERANCE:
                x = sp.Symbol("z" if plant.discrete else "s")
                values = {"i": i + 1, "j": j + 1, "x": x, "point": sp.Integer(point), "value": sp.N(G[i, j], 4)}
                return Reason("decoupling/still_coupled", values)
    return None
