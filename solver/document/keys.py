"""What a key tells of a part: the answers that earn the marks, each as formula = numbers = value, and what earns them.

A step earns the marks of an answer where it finds its value, or is of a kind that the task's `AnswerName` says.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp

from solver.derivation import AnswerName
from solver.derivation.displayed import Displayed, Written
from solver.matrices import entry_alone
from solver.render.displays import display
from solver.render.wording import WordedStep, Wording
from solver.stated import Stated

DISPLAY = re.compile(r"\$\$\n.+?\n\$\$", re.DOTALL)

_ENTRY = re.compile(r"\$\$\n[a-z]_\{\d+(?:,\s*\d+)?\} = ([^\n]+)\n\$\$")
"""An entry of a matrix as a line of its own."""


@dataclass(frozen=True, slots=True)
class Key:
    """The steps that earn marks, and the LaTeX of `symbol = formula = value` of the answers that a step finds so."""

    steps: tuple[WordedStep, ...]
    derived: Mapping[str, str]


def key_of(
    worded: Sequence[WordedStep], answers: Mapping[str, Any], declared: Mapping[str, AnswerName], wording: Wording
) -> Key:
    """Return the key of a part that was worded; where no step earns anything, it is the last that is told."""
    kinds = {kind for name in answers for kind in declared[name].earned}
    values = [_Value(each, wording) for each in answers.values()]
    earning = [step for step in worded if step.step.kind in kinds or _finds(step, values)]
    entries = {
        wording.tex(entry) for value in answers.values() if isinstance(value, sp.MatrixBase) for entry in value.flat()
    }
    steps = [_without_entries(replace(step, steps=(), figures=()), entries) for step in earning or worded[-1:]]
    derived: dict[str, str] = {}
    for name, value in zip(answers, values, strict=True):
        for i, step in reversed(list(enumerate(steps))):
            line = next((each for each in step.displayed if _ends_in(each, value)), None)
            if line is not None:
                steps[i], formula = _without(step, line, wording)
                derived |= {name: formula} if formula.count("=") > 1 else {}
                break
    return Key(tuple(_news(step for step in steps if _tells(step, values))), derived)


def _news(steps: Iterable[WordedStep]) -> Iterator[WordedStep]:
    """Yield the steps but those whose lines have all been told: partial fractions of what is a single one."""
    told: set[str] = set()
    for step in steps:
        lines = set(DISPLAY.findall(step.markdown))
        if not lines or not lines <= told:
            yield step
        told |= lines


class _Value:
    """The value of an answer; a formula that is printed alike is the same to a reader."""

    def __init__(self, value: Any, wording: Wording) -> None:
        self.value = entry_alone(value)
        self.wording = wording
        self.tex = "" if isinstance(value, str | bool | sp.logic.boolalg.BooleanAtom) else wording.tex(self.value)

    def is_in(self, found: Any) -> bool:
        """Whether this is what was found; verdicts and words are not found by equalities."""
        if not self.tex or isinstance(found, Written | bool):
            return False
        parted = isinstance(found, Stated) and found.operation == "partitioned"
        alone = entry_alone(found.operands[0] if parted else found)
        return bool(alone == self.value) or (isinstance(found, Stated) and self.wording.tex(alone) == self.tex)


def _finds(step: WordedStep, values: Iterable[_Value]) -> bool:
    """Whether a step shows one of the values as something that was found."""
    return any(value.is_in(claim.right) for claim in step.step.claims.values() for value in values)


def _ends_in(line: Displayed, value: _Value) -> bool:
    return line.relation == "=" and len(line.sides) > 1 and value.is_in(line.sides[-1])


def _without(step: WordedStep, line: Displayed, wording: Wording) -> tuple[WordedStep, str]:
    """Return the step without a line that becomes the answer's, and its LaTeX; as it is where it has no such block."""
    formula = wording.chain(line)
    block = display(formula).strip()
    if step.markdown.count(block) != 1:
        return step, ""
    text = step.markdown.replace(block, "").strip()
    return replace(step, markdown=text), formula


def _without_entries(step: WordedStep, entries: Collection[str]) -> WordedStep:
    """Return a step without the lines that tell one entry of a matrix, which the answer has in its place."""
    blocks = step.markdown.split("\n\n")
    told = (_ENTRY.fullmatch(block) for block in blocks)
    kept = [block for block, entry in zip(blocks, told, strict=True) if entry is None or entry[1] not in entries]
    return replace(step, markdown="\n\n".join(kept)) if kept else step


def _tells(step: WordedStep, values: Sequence[_Value]) -> bool:
    """Whether a step has more to tell than the answers, which follow."""
    stated = [each for each in step.displayed if not isinstance(each.sides[-1], Written)]
    only = all(len(each.sides) == 2 and any(value.is_in(each.sides[-1]) for value in values) for each in stated)
    listed = any(block.startswith("- ") for block in step.markdown.split("\n\n"))
    return bool(step.markdown) and not step.markdown.endswith(":") and (listed or not (stated and only))
