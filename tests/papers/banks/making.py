"""Banks made of problems in this process, without drawing and without a command."""

from __future__ import annotations

from dataclasses import replace

from solver.document.model import Presentation
from solver.engine import solve_problem
from solver.papers.exam.telling import Asked as Wanted
from solver.papers.export.bench import Bench
from solver.papers.export.items import items_made
from solver.papers.export.quiz import Group, Quiz
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue


def items_of(text, detail="full", **presentation):
    """Return the items of a problem by part and kind: {"a": item} with fields, {"a rest": item} with an essay."""
    made = items_made(text, "problem.yaml", Wanted((), Presentation(detail, **presentation)))
    assert not made.fault
    return items_by_part(made)


def items_by_part(made):
    """Return the items that were made, by part and kind."""
    return {
        f"{letter} rest" if item.essay else letter: replace(item, identifier=f"q-{letter}-{place}", name=f"({letter})")
        for letter, _, items in made.parts
        for place, item in enumerate(items)
    }


def quiz_with(items, title="An exam"):
    """Return a bank of items."""
    return Quiz(title, "", "en", tuple(Group((title, each.name), (each,)) for each in items.values()))


def bench_of(text):
    """Return our own marking of a problem, and its parts by name."""
    problem = read_problem(Source("problem.yaml", text), catalogue())
    return Bench(solve_problem(problem)), {part.id: part for part in problem.parts}
