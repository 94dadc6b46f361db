"""What runs round a loop: L = C G H of a plant behind a controller, of a transfer function alone L = G."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from solver.conversions.forward_path import by_powers, polynomials_of
from solver.conversions.matrix_feedback import transfer_system
from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.derivation.conversion import conversion, converted_to
from solver.lazy import sympy as sp
from solver.stated.algebra import product, quotient
from solver.systems import DeadTime, LateLoop, LatePath, OpenLoop, OutputFeedback, System, TransferFunction

if TYPE_CHECKING:
    from sympy import Expr


@conversion(OutputFeedback, OpenLoop, gives=lambda _: ("open_loop",))
@lemma("open_loop")
def open_loop_of(loop: OutputFeedback) -> Derivation[OpenLoop]:
    """L = C G H on polynomials, nothing cancelled between its factors; H = 1 where the loop is not closed.

    Raises Unsolved where L is improper, or where there are several inputs or outputs.
    """
    plant, delay = yield from _apart(loop.plant)
    H = sp.Integer(1) if loop.feedback is None else loop.feedback
    x, C, G = plant.variable, loop.controller, plant.uncancelled[0, 0]
    (c, d), (h, k) = polynomials_of(C), polynomials_of(H)
    top = by_powers(c * plant.numerators[0][0] * h, x)
    bottom = by_powers(d * plant.denominators[0][0] * k, x)
    if sp.degree(top, x) > sp.degree(bottom, x):
        raise Unsolved("conversions/improper_loop")
    found = quotient(top, bottom) if top != 0 else sp.S.Zero
    claim = Claim(_of_factors(C, G, H), found, "the open loop $L$")
    factor = sp.exp(-delay * x)
    yield Step("open_loop", claims={"L": claim}, x=x, C=C, G=G, H=H, delay=delay, factor=factor)
    rational = transfer_system(plant, sp.ImmutableMatrix([[sp.cancel(top / bottom)]]), ((top,),), ((bottom,),))
    if plant.written is not None:
        above, below = plant.written
        rational = replace(rational, written=(c * above * h, d * below * k))
    return OpenLoop(loop.plant, rational, delay, C, G, H, closed=loop.feedback is not None)


@conversion(LateLoop, OpenLoop, gives=lambda _: ("open_loop",))
def open_loop_of_late_loop(loop: LateLoop) -> Derivation[OpenLoop]:
    """The same, its dead time kept apart."""
    return (yield from open_loop_of(loop))


@conversion(LatePath, OpenLoop, gives=lambda _: ("open_loop",))
def open_loop_of_late_path(path: LatePath) -> Derivation[OpenLoop]:
    """The same, its dead time kept apart."""
    return (yield from open_loop_of(path))


@conversion(TransferFunction, OpenLoop, gives=lambda has: ("open_loop",) if "transfer_function" in has else ())
def open_loop_alone(G: TransferFunction) -> Derivation[OpenLoop]:
    """Without controller and feedback L is G."""
    return (yield from _alone(G))


@conversion(DeadTime, OpenLoop, gives=lambda _: ("open_loop",))
def open_loop_with_dead_time(G: DeadTime) -> Derivation[OpenLoop]:
    """Without controller and feedback L is G, its dead time kept apart."""
    return (yield from _alone(G))


def _alone(plant: System) -> Derivation[OpenLoop]:
    rational, delay = yield from _apart(plant)
    one = sp.Integer(1)
    return OpenLoop(plant, rational, delay, one, rational.uncancelled[0, 0], one)


def _apart(plant: System) -> Derivation[tuple[TransferFunction, Expr]]:
    """The rational factor of a plant and its dead time; raises Unsolved where there are several channels."""
    delay: Any = plant.delay if isinstance(plant, DeadTime) else sp.Integer(0)
    rational = yield from converted_to(plant.rational if isinstance(plant, DeadTime) else plant, TransferFunction)
    if rational.matrix.shape != (1, 1):
        raise Unsolved("conversions/loop_of_several_channels", p=rational.size("p"), m=rational.size("m"))
    return rational, delay


def _of_factors(C: Expr, G: Expr, H: Expr) -> Any:
    """The product as it is written: without factors that are one."""
    factors = [each for each in (C, G, H) if each != 1]
    return product(*factors) if len(factors) > 1 else factors[0] if factors else sp.Integer(1)
