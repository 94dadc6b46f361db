"""Figures of closed loops: the block diagram, and what the loop does by itself."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.derivation.figures import Diagram
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import exponential, power, product
from solver.tasks import figures
from solver.words import Phrase

if TYPE_CHECKING:
    from collections.abc import Iterable

    from sympy import ImmutableMatrix

    from solver.derivation.figures import Figure
    from solver.systems import StateSpace


IN_STEPS = {
    "xdot": "", "integrator": "z^{-1}", "xidot": "r-y", "error_integrator": r"\frac{1}{z-1}", "x": "x(k)",
}  # fmt: skip
"""What is written into a diagram of a discrete loop."""


@lemma("loop_figures")
def block_diagram(name: str, caption: str, *, discrete: bool = False, **labels: str) -> Derivation[None]:
    """One of the block diagrams of the course, with what is written into its blocks; delays where time is discrete."""
    figures_ = (Diagram(caption, name, {**(IN_STEPS if discrete else {}), **labels}),)
    yield Step("scheme", unclaimed="a drawing", figures=figures_, detail="full", name=name, discrete=discrete)


@lemma("loop_figures")
def zero_input_response(loop: ImmutableMatrix, plant: StateSpace, K: ImmutableMatrix) -> Derivation[None]:
    """The response of x' = loop · x from the initial state (ones where none is given); nothing where it isn't exact.

    Nor where nobody could read it: with powers of e in three states its formulas fill pages, and take a minute.
    """
    n, discrete = loop.rows, plant.discrete
    if loop.free_symbols or n > figures.LARGEST or loop.has(sp.Float, sp.log, sp.NumberSymbol):
        return
    if n > 2 and loop.has(sp.exp, sp.cos, sp.sin):
        return
    x0 = figures.start_of(plant.x0, n)
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
        figures=figures.motion(
            "Closed loop from its initial state, without input",
            loop,
            x0,
            figures.states(n),
            figures.inputs(sp.ImmutableMatrix(-K)),
            discrete=discrete,
        ),
        x0=x0,
        discrete=discrete,
        given=plant.x0 is not None,
    )


def optimal_loop(
    A: ImmutableMatrix,
    loop: ImmutableMatrix,
    K: ImmutableMatrix,
    poles: Iterable[Any],
    x0: ImmutableMatrix | None,
    *,
    discrete: bool = False,
) -> tuple[Figure, ...]:
    """The poles before and after, and x and u of the optimal loop; from ones where no numbers are given."""
    start = figures.start_of(None if x0 is None or x0.free_symbols else x0, A.rows)
    moved = figures.plane(
        "Poles of the open loop and of the optimal one",
        figures.eigenvalues_of("open loop", A),
        figures.roots("optimal loop", poles, "square"),
        discrete=discrete,
    )
    caption = Phrase("The optimal loop from $x(0) = {x0}$", x0=figures.column(start))
    panels = (figures.states(A.rows), figures.inputs(sp.ImmutableMatrix(-K)))
    return (*moved, *figures.motion(caption, loop, start, *panels, discrete=discrete))
