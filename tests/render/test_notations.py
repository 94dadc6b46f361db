"""The symbols of a page are those of one notation: in texts, formulas, answers, labels and figures."""

import re

import pytest

from solver.notation import spelled
from solver.resources import root
from solver.symbols import COURSE, NOTATIONS
from solver.tasks import catalogue
from tests.helpers.solved import EXAMPLES, by_problem, document_of_problem

OURS = re.compile(r"K_\{?f|L_\{?c(?![a-z])|\\mathcal\{C\}_\{?o|\\mathcal\{O\}_\{?v")
"""Symbols that only the course has."""


def told(path):
    document = document_of_problem(path)
    return document, document.told(notation="ogata")


def captions(document):
    figures = [figure for part in document.parts for step in part.steps for figure in step.figures]
    return [figure.caption for figure in figures] + [
        label for figure in figures for label in getattr(figure, "labels", {}).values()
    ]


@pytest.mark.parametrize(**by_problem(EXAMPLES, EXAMPLES[::6], of=2))
def test_an_example_is_told_in_either_notation_and_claims_the_same(path):
    course, ogata = told(path)
    assert OURS.search("\n".join([ogata.markdown(), *captions(ogata)])) is None
    for ours, theirs in zip(course.parts, ogata.parts, strict=True):
        assert (ours.status, ours.fault) == (theirs.status, theirs.fault)
        assert [(each.name, each.tex, each.value) for each in ours.answers] == [
            (each.name, each.tex, each.value) for each in theirs.answers
        ]
        assert [(each.oracle, each.residual, each.status) for each in ours.checks] == [
            (each.oracle, each.residual, each.status) for each in theirs.checks
        ]
        for answer, other in zip(ours.answers, theirs.answers, strict=True):
            declared = catalogue()[ours.task].answers[answer.name].symbol
            assert answer.symbol == spelled(declared, COURSE)
            if "\\sym{" in declared:
                assert other.symbol == spelled(declared, "ogata")


def test_the_damping_ratio_is_zeta_wherever_it_stands():
    course, ogata = told(root("problems") / "examples" / "desired-poles.yaml")
    assert "\\xi" in course.markdown()
    assert "\\xi" not in ogata.markdown()
    assert "\\zeta" in ogata.markdown()


def test_templates_and_tasks_name_symbols_of_the_notation_and_do_not_spell_them():
    tasks = root("templates").parent / "solver" / "tasks"
    files = [*(root("templates") / "wording").rglob("*.md.jinja"), *tasks.rglob("*.py")]
    assert len(files) > 100
    assert not [path.name for path in files if OURS.search(path.read_text(encoding="utf-8"))]


def test_a_symbol_is_spelled_with_room_for_what_follows():
    assert {frozenset(table) for table in NOTATIONS.values()} == {frozenset(NOTATIONS[COURSE])}
    assert spelled(r"A - B\sym{K}", "ogata") == "A - BK"
    assert spelled(r"2\sym{damping_ratio}s", "ogata") == r"2\zeta s"
    assert spelled(r"2\sym{damping_ratio}\omega_n", COURSE) == r"2\xi\omega_n"
