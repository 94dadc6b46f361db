"""A plant behind a controller, the loop closed or not, is a transfer function: C G/(1 + C G H), or C G."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from solver.conversions.forward_path import by_powers, forward_path_of, polynomials_of
from solver.conversions.matrix_feedback import transfer_matrix_of_loop, transfer_system
from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.derivation.conversion import composition, conversion, converted_to
from solver.lazy import sympy as sp
from solver.stated.algebra import product, quotient, total
from solver.systems import (
    DeadTime,
    LateLoop,
    LatePath,
    MatrixFeedback,
    OutputFeedback,
    System,
    TransferFunction,
)


@composition("controller", "feedback", order=2)
def closed(system: System, options: Mapping[str, Any]) -> OutputFeedback:
    """With the options `controller` and `feedback` the question is about what is made of the plant."""
    controller, H = options["controller"], options["feedback"]
    C = sp.Integer(1) if controller is None else controller
    several = {system.size("p") or 1, system.size("m") or 1} != {1} or hasattr(C, "shape") or hasattr(H, "shape")
    if several:
        return MatrixFeedback(system, C, H)
    if not isinstance(system, DeadTime):
        return OutputFeedback(system, C, H)
    return LatePath(system, C, H) if H is None else LateLoop(system, C, H)


@conversion(OutputFeedback, TransferFunction, gives=lambda _: ("transfer_function", "motion", "path"))
@lemma("loop")
def transfer_function_of_loop(loop: OutputFeedback) -> Derivation[TransferFunction]:
    """L = C G (1 + C G H)⁻¹ on polynomials, nothing cancelled between C, G and H: what is hidden stays a root.

    Raises Unsolved where 1 + C G H vanishes, and where the result is improper.
    """
    G: TransferFunction = yield from converted_to(loop.plant, TransferFunction)
    if G.matrix.shape != (1, 1):
        return (yield from transfer_matrix_of_loop(MatrixFeedback(G, loop.controller, loop.feedback)))
    x, C, H = G.variable, loop.controller, loop.feedback
    (p, q), (c, d) = (G.numerators[0][0], G.denominators[0][0]), polynomials_of(C)
    top, bottom = by_powers(c * p, x), by_powers(d * q, x)
    above, below = G.written if G.written is not None and C == 1 else (top, bottom)
    path = quotient(above, below)
    yield from forward_path_of(C, quotient(p, q), path, x, open_loop=H is None, several=False)
    if H is not None:
        h, k = polynomials_of(H)
        N, D = by_powers(top * k, x), by_powers(bottom * k + top * h, x)
        if D == 0:
            raise Unsolved("conversions/ill_posed_loop")
        claims = {
            "substituted": Claim(quotient(path, total(1, product(path, H))), quotient(N, D), "closed loop $T$"),
            "denominator": Claim(total(product(below, k), product(above, h)), D, "denominator of the closed loop"),
        }
        yield Step("closed", claims=claims, x=x, H=H, unity=H == 1, alone=C == 1)
        top, bottom = N, D
    if sp.degree(top, x) > sp.degree(bottom, x):
        raise Unsolved("conversions/improper_loop")
    return transfer_system(G, sp.ImmutableMatrix([[sp.cancel(top / bottom)]]), ((top,),), ((bottom,),))


@conversion(LatePath, DeadTime, gives=lambda _: ("dead_time", "motion", "path"))
@lemma("loop")
def late_path_of(path: LatePath) -> Derivation[DeadTime]:
    """C G₀ with the dead time of G; raises Unsolved where it is improper."""
    plant = path.plant
    G, C, x = plant.rational, path.controller, plant.variable
    (p, q), (c, d) = (G.numerators[0][0], G.denominators[0][0]), polynomials_of(C)
    top, bottom = by_powers(c * p, x), by_powers(d * q, x)
    whole = quotient(top, bottom)
    late = product(whole, plant.factor)
    yield from forward_path_of(C, product(quotient(p, q), plant.factor), late, x, open_loop=True, several=False)
    if sp.degree(top, x) > sp.degree(bottom, x):
        raise Unsolved("conversions/improper_loop")
    rational = transfer_system(G, sp.ImmutableMatrix([[sp.cancel(top / bottom)]]), ((top,),), ((bottom,),))
    return DeadTime(rational, plant.delay)


@conversion(LateLoop, TransferFunction, gives=lambda _: ("transfer_function", "motion"))
def of_late_loop(loop: LateLoop) -> Derivation[TransferFunction]:
    """There is none: raises Unsolved."""
    yield from ()
    raise Unsolved("conversions/dead_time_in_a_loop", closed=loop.feedback is not None)
