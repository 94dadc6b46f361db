"""A key is compact: each equation stands in it once, and as many on a line as fit.

An equation of a step that an answer has stands there; one that leads to the value of an answer takes its place.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator
from dataclasses import replace
from itertools import groupby

from solver.document.model import Work, WorkAnswer, WorkStep
from solver.formula import latex, read
from solver.formula.nodes import Row, Table
from solver.formula.width import LINE, width
from solver.render.displays import READABLE, display
from solver.render.side_by_side import equations_in, is_broken, side_by_side, sides_of

_DISPLAY = re.compile(r"\$\$\n(.+)\n\$\$", re.DOTALL)

NARROW = 0.7 * LINE
"""Room on a line for answers, beside which their meanings may stand."""

CHAIN = 3
"""Sides of an equation that leads to a value."""

MOST_LINES = 4
"""Lines of an equation that is told beside others."""

SHORT_ITEM = 120
"""Characters of an item of a list that stands in a line with the others."""

_BRACES = re.compile(r"([_^])\{(\w)\}")


def compact(part: Work) -> Work:
    """Return a part of a key with its equations side by side, each once."""
    leading = [each for step in part.steps for each in _equations_of(step) if len(sides_of(each)) >= CHAIN]
    answers: dict[int, WorkAnswer] = {}
    told: set[str] = set()
    for answer in part.found:
        answers[id(answer)], equations = _answer(answer, leading, told)
        told |= equations
    steps = tuple(step for each in part.steps if (step := _step(each, told)).markdown or step.figures)
    return replace(
        part,
        steps=steps,
        answers=tuple(answers.get(id(each), each) for each in part.answers),
        equations=tuple(answers.get(id(each), each) for each in part.equations),
    )


def _answer(answer: WorkAnswer, leading: Iterable[Row], told: Collection[str]) -> tuple[WorkAnswer, set[str]]:
    """Return an answer without equations told above, each with what leads to it, and the equations that it tells."""
    head, all_of_it = equations_in(read(answer.shown))
    news = [each for each in all_of_it if _look(each) not in told]
    if len(all_of_it) == 1 or not news or any(map(is_broken, news)):
        return answer, set(map(_look, all_of_it))
    found = [next((chain for chain in leading if _leads_to(chain, each)), each) for each in news]
    (shown,) = side_by_side(head, found, NARROW)
    return replace(answer, derived=latex(shown)), set(map(_look, [*news, *found]))


def _leads_to(chain: Row, equation: Row) -> bool:
    first, *_, last = map(_look, sides_of(chain))
    return [first, last] == [*map(_look, sides_of(equation))]


def _look(equation: Row) -> str:
    """Return what an equation looks like: an index of one sign is the same with braces and without."""
    return _BRACES.sub(r"\1\2", latex(equation))


def _equations_of(step: WorkStep) -> Iterator[Row]:
    for block in step.markdown.split("\n\n"):
        if found := _DISPLAY.fullmatch(block):
            yield from equations_in(read(found[1]))[1]


def _step(step: WorkStep, told: Collection[str]) -> WorkStep:
    """Return a step without equations that the answers tell, the others side by side; a lead-in to none goes, too."""
    blocks: list[str] = []
    for displayed, group in groupby(step.markdown.split("\n\n"), lambda block: bool(_DISPLAY.fullmatch(block))):
        if not displayed:
            blocks += group
            continue
        formulas = [read(block.removeprefix("$$\n").removesuffix("\n$$")) for block in group]
        equations = [each for formula in formulas for each in _all_in(formula) if _look(each) not in told]
        equations = [*filter(_is_readable, equations)]
        short = [each for each in equations if _lines_of(each) <= MOST_LINES] or equations
        blocks += [display(latex(each)).strip() for each in side_by_side(Row(), short)]
        if not equations and blocks and blocks[-1].endswith(":"):
            blocks.pop()
    return replace(step, markdown="\n\n".join(_in_lines(blocks)))


def _lines_of(equation: Row) -> int:
    return sum(len(each.rows) for each in equation.items if isinstance(each, Table) and each.environment == "aligned")


def _is_readable(equation: Row) -> bool:
    """Whether an equation is none that has to be made tiny, which nobody compares with a student's."""
    return width(equation) <= READABLE * LINE


def _in_lines(blocks: Iterable[str]) -> Iterator[str]:
    """Yield blocks of text, short items of a list in one line."""
    for listed, group in groupby(blocks, lambda block: block.startswith("- ") and "\n" not in block):
        items = list(group)
        if listed and max(map(len, items)) <= SHORT_ITEM:
            between = " " if all(item.endswith(".") for item in items) else "; "
            yield between.join(item.removeprefix("- ").rstrip(";,") for item in items)
        else:
            yield from items


def _all_in(formula: Row) -> tuple[Row, ...]:
    """Return the equations of a display; one that a word begins is told whole."""
    head, equations = equations_in(formula)
    return (formula,) if head.items else equations
