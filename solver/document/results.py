"""What steps display as their results: the last displays, what they end in, and whether that is an answer."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import dropwhile, takewhile

from solver.document.model import WorkAnswer, WorkStep

LONGEST_RESULT = 240
"""Characters of LaTeX up to which results that stand above are displayed again, to go on with."""

MANY_SIDES = 3
"""Sides of a chain of which those between the first and the last lead to the value."""

_DISPLAY = re.compile(r"\$\$.*?\$\$", re.DOTALL)
RESULT = re.compile(r"^\$\$\n.*?\$\$", re.DOTALL | re.MULTILINE)
_COMPARES = re.compile(r"[<>]|\\(?:le|ge|ne|approx|Rightarrow|to|q?quad)\b")
_ALIGNED = r"\begin{aligned}", r"\end{aligned}"
_LINES = re.compile(r"\\left\[\\begin\{array\}\{[c|]+\}(.*?)\\end\{array\}\\right\]", re.DOTALL)


def results_of(run: Sequence[WorkStep]) -> list[str]:
    """Return the last displays of the last step that has one and of all of its kind, each on lines of its own.

    Where there are none, it is the last of those below. A formula on one line of the text is a law, and no result to
    go on with.
    """
    own = [(step.kind, found) for step in run if (found := at_the_end(step.markdown.split("\n\n")))]
    if own:
        last, _ = own[-1]
        return list(dict.fromkeys(display for kind, found in own if kind == last for display in found))
    below = [found for step in run for each in step.walk() if (found := at_the_end(each.markdown.split("\n\n")))]
    return (below or [[]])[-1]


def only_repeats(step: WorkStep, given: str) -> bool:
    """Whether a step shows what is given, and nothing else; words that lead to it are nothing by themselves."""
    blocks = step.markdown.split("\n\n")
    shown = [block for block in blocks if not block.endswith(":")]
    return not step.steps and bool(shown) and set(shown) <= set(filter(RESULT.fullmatch, given.split("\n\n")))


def at_the_end(blocks: Sequence[str]) -> list[str]:
    """Return the last blocks in a row that are displays; what is said behind them concludes."""
    backwards = dropwhile(lambda block: not RESULT.fullmatch(block), reversed(blocks))
    return list(takewhile(RESULT.fullmatch, backwards))[::-1]


def to_go_on_with(results: Sequence[str]) -> str:
    """Return the results, each without what leads to its value; nothing of many, for one alone would mislead."""
    shown = "\n\n".join(map(_ends_of, results))
    return shown if len(shown) <= LONGEST_RESULT else ""


def _ends_of(display: str) -> str:
    """Return the first and the last side of a chain of equalities on one line; one that compares is told whole."""
    sides = display.strip("$").strip().split(" = ")
    torn = any(each.count("{") != each.count("}") for each in sides)
    if len(sides) < MANY_SIDES or torn or "aligned" in display or _COMPARES.search(display):
        return display
    return f"$$\n{sides[0]} = {sides[-1]}\n$$"


def chains_in(step: WorkStep) -> Iterator[str]:
    """Yield the displays of a step, without the signs around them."""
    for each in step.walk():
        yield from (display.strip("$").strip() for display in _DISPLAY.findall(each.markdown))


def ends_in(chain: str, answer: WorkAnswer) -> bool:
    """Whether a display is the equation of an answer, or one from its symbol, of any variable, to its value."""
    chain = _LINES.sub(_without_lines, chain)
    lines = chain.removeprefix(_ALIGNED[0]).removesuffix(_ALIGNED[1]).strip()
    begins = re.match(re.escape(answer.symbol) + r"(\([a-z]\))? &?=", lines)
    one = all(line.startswith("&") for line in lines.split("\\\\\n")[1:]) if lines != chain else True
    return chain == answer.equation or (begins is not None and one and lines.endswith(f"= {answer.tex}"))


def _without_lines(found: re.Match[str]) -> str:
    """Return a matrix without the lines between its blocks."""
    return rf"\begin{{bmatrix}}{found[1]}\end{{bmatrix}}".replace(r"\hline ", "")


def value_of(display: str) -> str:
    """Return what a display ends in, behind its last sign of equality."""
    return display.strip("$").rpartition("=")[2].strip()
