"""Lemma: Nyquist's criterion for a loop with parameters: the turns case by case, by where the crossings lie."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice, product
from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.numeric.judges import stability as regions
from solver.tasks.frequency.figures import nyquist_figures
from solver.tasks.frequency.parametric_crossovers import loop_factors, real_axis_with_letters

if TYPE_CHECKING:
    from solver.systems import OpenLoop

SIMPLE = (1, 2, 3, 5, 10, -1, -2, -3)
MOST_TRIED = 64


def turns_with_letters(loop: OpenLoop) -> Derivation[Answers]:
    """The crossings of the real axis with parameters; where each lies left of −1 tells turns and poles."""
    found = exact.parametric_turns(loop.numerator, loop.denominator, loop.variable)
    yield from _poles(loop, found)
    yield from real_axis_with_letters(exact.parametric_axis(loop_factors(loop)), found.crossings)
    yield from _count(found)
    yield from _picture(loop)
    answers = Answers(open_loop_unstable_poles=sp.Integer(found.open_loop))
    for name, of in (("encirclements", "clockwise"), ("closed_loop_unstable_poles", "closed_loop")):
        values = {getattr(case, of) for case in found.cases}
        if len(values) == 1:
            answers[name] = sp.Integer(values.pop())
    stable = {case.closed_loop == 0 and not found.on_axis for case in found.cases}
    if len(stable) == 1:
        answers["stable"] = stable.pop()
    answers["condition"] = found.condition
    answers["real_axis_crossings"] = [each.value for each in found.crossings if not each.start]
    return answers


@lemma("parametric_crossovers")
def _poles(loop: OpenLoop, found: exact.ParametricTurns) -> Derivation[None]:
    """The path, and the poles of L inside it."""
    yield Step("poles", unclaimed="counted by the signs of Routh arrays; the answer has a check of its own",
               s=loop.variable, P=found.open_loop, arcs=list(found.arcs))  # fmt: skip


@lemma("parametric_crossovers")
def _count(found: exact.ParametricTurns) -> Derivation[None]:
    """What each crossing adds where it lies left of −1, and Z = N + P in each case."""
    rows = [(each, 1 if each.start else 2) for each in found.crossings if exact.decided_sign(each.value) < 0]
    yield Step("turns", unclaimed="counted; the answers have checks of their own", rows=rows, arcs=list(found.arcs),
               closing=found.closing)  # fmt: skip
    truth: Any = {sp.true: "always", sp.false: "never"}.get(found.condition, "")
    yield Step("count", unclaimed="counted; the answers have checks of their own", cases=list(found.cases),
               P=found.open_loop, on_axis=found.on_axis, truth=truth,
               condition=found.condition)  # fmt: skip


@lemma("parametric_crossovers")
def _picture(loop: OpenLoop) -> Derivation[None]:
    """The curve at simple values of the parameters; nothing where none are found that may be drawn."""
    at = next(_simple_values(loop), None)
    if at is None:
        return
    N, D = (each.xreplace(at) for each in (loop.numerator, loop.denominator))
    L = exact.on_axis(N, D, loop.variable)
    crossings = [value for _, value in exact.phase_crossovers(L).real_axis]
    found = exact.encirclements(N, D, loop.variable)
    yield Step("picture", unclaimed="drawn from numbers", at=list(at.items()), count=found.closed_loop,
               figures=nyquist_figures("Nyquist diagram of $L$", "The same near $-1$", L, crossings))  # fmt: skip


def _simple_values(loop: OpenLoop) -> Iterator[dict[Any, Any]]:
    """Small whole numbers that the parameters may have, for which the curve does not pass through −1."""
    letters = sorted(set(loop.parameters) - {loop.variable}, key=str)
    for values in islice(product(SIMPLE, repeat=len(letters)), MOST_TRIED):
        at = dict(zip(letters, map(sp.Integer, values), strict=True))
        if regions.is_admissible(at) and not exact.encirclements(
            loop.numerator.xreplace(at), loop.denominator.xreplace(at), loop.variable).through:  # fmt: skip
            yield at


__all__ = ["turns_with_letters"]
