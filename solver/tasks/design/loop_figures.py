"""Figures of closed loops: the block diagram, and what the loop does by itself."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.derivation.figures import Curve, Diagram, Plot
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import exponential, power, product

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

    from solver.systems import StateSpace

LARGEST = 6
"""Closed loops of higher order are not drawn."""


@lemma("loop_figures")
def block_diagram(name: str, caption: str, **labels: str) -> Derivation[None]:
    """One of the block diagrams of the course, with what is written into its blocks."""
    yield Step("scheme", unclaimed="a drawing", figures=(Diagram(caption, name, labels),), detail="full", name=name)


@lemma("loop_figures")
def zero_input_response(loop: ImmutableMatrix, plant: StateSpace) -> Derivation[None]:
    """The response of x' = loop · x from the initial state (ones where none is given); nothing where it isn't exact."""
    n, discrete = loop.rows, plant.discrete
    if loop.free_symbols or n > LARGEST or loop.has(sp.Float, sp.log, sp.NumberSymbol):
        return
    x0 = plant.x0 if plant.x0 is not None and plant.x0.rows == n else sp.ImmutableMatrix(sp.ones(n, 1))
    time = sp.Symbol("k" if discrete else "t")
    try:
        Phi = exact.power(loop, time).matrix if discrete else exact.exponential(loop, time).matrix
    except exact.NotExact:
        return
    x = sp.ImmutableMatrix(Phi * x0)
    stated = power(loop, time) if discrete else exponential(loop * time)
    yield Step(
        "response",
        claims={"x": Claim(product(stated, x0), x, "response of the closed loop to its initial state")},
        detail="full",
        figures=(_plot(x, time, _horizon(loop, discrete=discrete), discrete=discrete),),
        x0=x0,
        discrete=discrete,
        given=plant.x0 is not None,
    )


def _plot(x: ImmutableMatrix, time: Any, stop: Expr, *, discrete: bool) -> Plot:
    style = "samples" if discrete else "line"
    labels = [f"x_{{{i + 1}}}" for i in range(x.rows)]
    curves = tuple(Curve(x[i, 0], label, style=style) for i, label in enumerate(labels))
    letter = "k" if discrete else "t"
    return Plot("Closed loop from its initial state, without input", letter, "x", time, sp.Integer(0), stop, curves)


def _horizon(loop: ImmutableMatrix, *, discrete: bool) -> Expr:
    """Five time constants of the slowest mode; for a loop that does not settle, three of its fastest growth."""
    values = [complex(sp.N(root.value)) for root in exact.spectrum(loop).roots]
    if discrete:
        return sp.Integer(20)
    rates = [abs(value.real) for value in values if abs(value.real) > 1e-9]
    settles = all(value.real < 0 for value in values)
    stop = (5 / min(rates) if settles else 2 / max(rates)) if rates else 10.0
    return sp.Rational(max(1, round(stop * 10)), 10)
