"""What students write, right (+) and wrong (-), by the problem; its truth was found by hand.

A file of `students` has problems: "=== name", the problem (or "FILE" and its path), "---", then each answer with what
was typed for it; answers that belong together stand with "&", their values with "&&". A value on several lines has ⏎
between them, "fold " before it where no | stands above them; ⇥ is a tab.
"""

import re
from pathlib import Path

import pytest
import yaml

from tests.helpers.marked import marked
from tests.helpers.shares import turn

FILES = sorted(Path(__file__).parent.glob("students/*.txt"))
BLOCKS = [
    block.split("\n", 1) for path in FILES for block in re.split(r"^=== *", path.read_text("utf-8"), flags=re.M)[1:]
]
ALWAYS = ("angles", "motion")
"""Small problems that are always marked."""


def in_yaml(typed):
    """A value as it stands in an answer file: as it is typed, in quotes where YAML would refuse it."""
    typed = typed.replace("⇥", "\t")
    if "⏎" in typed:
        sign = "" if typed.startswith("fold ") else "|"
        return sign + "".join(f"\n      {line}" for line in typed.removeprefix("fold ").split("⏎"))
    try:
        if typed.startswith(("raw ", "[", "{")) and yaml.safe_load(f"a: {typed.removeprefix('raw ')}"):
            return typed.removeprefix("raw ")
    except yaml.YAMLError:
        pass
    return "'" + typed.replace("'", "''") + "'"


def rows(text):
    """Part, names, whether it is right, and what was typed."""
    place = ""
    for line in text.splitlines():
        if not line.startswith(" "):
            place = line.strip()
        elif line.strip():
            part, names = place.split(".", 1)
            yield part, names.split("&"), line.strip()[0] == "+", line.strip()[2:].split(" && ")


def mismarked(block):
    """Rows that are wrong and marked correct, or right and not marked correct."""
    problem, answers = block.split("\n---\n")
    if problem.startswith("FILE "):
        problem = Path(problem[5:].strip()).read_text("utf-8")
    for part, names, right, values in rows(answers):
        lines = "".join(f"    {name}: {in_yaml(value)}\n" for name, value in zip(names, values, strict=True))
        found = marked(problem, f"answers:\n  {part}:\n{lines}")[part].answers
        if all(str(found[name].verdict) == "correct" for name in names) is not right:
            yield part, names, values, right


def test_both_kinds_are_there():
    signs = [right for _, block in BLOCKS for *_, right, _ in rows(block.split("\n---\n")[1])]
    assert len(signs) > 1000
    assert 0.2 < signs.count(False) / len(signs) < 0.5


@pytest.mark.parametrize(
    "block", [pytest.param(block, id=name, marks=() if name in ALWAYS else turn(name, 16)) for name, block in BLOCKS]
)
def test_nothing_wrong_is_correct_and_what_is_right_is(block):
    assert not list(mismarked(block))
