"""Every problem as a bank: none fails, and what Moodle marks agrees with what goes out."""

from pathlib import Path

import pytest

from solver.document.model import Presentation
from solver.papers.exam.telling import Asked
from solver.papers.export.items import items_made
from solver.papers.export.moodle import moodle_xml
from solver.papers.export.quiz import Number
from tests.helpers.shares import turn
from tests.papers.banks.making import items_by_part, quiz_with
from tests.papers.banks.moodle_reader import read_moodle

PROBLEMS = Path(__file__).parents[3] / "problems"
FILES = sorted(path for folder in ("examples", "course") for path in (PROBLEMS / folder).rglob("*.yaml")
               if "find:" in path.read_text(encoding="utf-8") and "printed" not in path.parts)  # fmt: skip


@pytest.mark.parametrize("file", [pytest.param(path, id=path.stem, marks=turn(path.stem, 64)) for path in FILES])
def test_a_problem_becomes_questions(file):
    made = items_made(file.read_text(encoding="utf-8"), str(file), Asked((), Presentation("full")))
    assert not made.fault
    items = items_by_part(made)
    if not items:  # some problems of the course show what has no solution
        assert made.left_out
        return
    for item, read in zip(items.values(), read_moodle(moodle_xml(quiz_with(items))), strict=True):
        assert not item.fields or not item.essay
        for field, gap in zip(item.fields, read.gaps, strict=True):
            if isinstance(field, Number):
                assert gap.marked(field.typed)[0] == 100
                assert all(gap.marked(str(wrong.value))[1] for wrong in field.wrong)
                assert all(gap.marked(str(wrong.value))[0] <= float(wrong.share) * 100 + 1e-3 for wrong in field.wrong)
