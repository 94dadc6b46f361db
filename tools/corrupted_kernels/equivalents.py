"""Changed results that are right nonetheless: another choice where the choice is free; each with its reason."""

from __future__ import annotations

import tomllib
from dataclasses import replace
from fnmatch import fnmatchcase
from functools import cache
from pathlib import Path

from tools.corrupted_kernels.runs import SURVIVED, Outcome

FILE = Path(__file__).with_name("equivalents.toml")
RIGHT = "right nonetheless"


@cache
def equivalents() -> tuple[dict[str, str], ...]:
    """The kernels, the patterns of changes, and the reasons why what a page shows is right."""
    return tuple(tomllib.loads(FILE.read_text(encoding="utf-8"))["equivalent"])


def judged(outcome: Outcome) -> Outcome:
    """The outcome, where it survived perhaps as one that is right nonetheless."""
    if outcome.became != SURVIVED:
        return outcome
    listed = any(
        each["kernel"] == outcome.kernel and fnmatchcase(outcome.change.replace("[", "("), each["change"])
        for each in equivalents()
    )
    return replace(outcome, became=RIGHT) if listed else outcome
