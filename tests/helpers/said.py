"""What a worked page says in words: each phrase stands on the pages of the cases it is about, and on no other."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import pytest

from solver.derivation import Step
from solver.render.wording import Wording
from tests.helpers.asking import ask


@dataclass(frozen=True)
class Family:
    """Questions that go through the branches of a method, and for each phrase the names of those that must say it."""

    task: str
    method: str
    cases: Mapping[str, Any]
    """Systems by name; a pair is a system and the options."""
    said: Mapping[str, str]
    """The names, or "all but" those that must not."""


def page_of(task: str, method: str, plant: Any, **options: Any) -> str:
    """All steps in words with all detail, on one line."""
    wording = Wording(detail="tutor")

    def texts(step: Step) -> list[str]:
        worded = wording.word(step)
        return [text for part in (worded, *worded.steps) for text in (part.title, part.markdown)]

    written = " ".join(text for step in ask(task, plant, method, **options).steps for text in texts(step))
    return " ".join(written.split())


def cases_of(families: Mapping[str, Family]) -> dict[str, Any]:
    """Arguments for parametrize: the family and the name of the case."""
    rows = [pytest.param(family, name, id=f"{key}-{name}") for key, family in families.items() for name in family.cases]
    return {"argnames": ("family", "name"), "argvalues": rows}


def wrongly_said(family: Family, name: str) -> dict[str, str]:
    """The phrases that stand on the page of a case and must not, or must and do not."""
    each = family.cases[name]
    plant, options = each if isinstance(each, tuple) else (each, {})
    page = page_of(family.task, family.method, plant, **options)
    return {
        phrase: "said" if phrase in page else "not said"
        for phrase, names in family.said.items()
        if (phrase in page) is not _must_say(family, name, names)
    }


def _must_say(family: Family, name: str, names: str) -> bool:
    listed = names.removeprefix("all but").split()
    assert set(listed) <= family.cases.keys(), f"there is a name without a case: {names}"
    return (name in listed) is not names.startswith("all but")
