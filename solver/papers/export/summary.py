"""What is said of a bank: how many questions it has, and which of them a person must mark."""

from __future__ import annotations

from collections.abc import Iterator

from solver.papers.export.quiz import Item, Quiz


def counted(quiz: Quiz) -> str:
    """Return how many questions there are, and how many of them have fields."""
    items = list(quiz.items)
    essays = sum(item.essay is not None for item in items)
    asked = f"{len(items)} question{'s' * (len(items) != 1)}"
    return f"{asked}, {len(items) - essays} with fields, {essays} essay{'s' * (essays != 1)}"


def told(quiz: Quiz) -> Iterator[str]:
    """Yield which parts became essays, and why: once for all variants of a part."""
    for group in quiz.groups:
        named: dict[str, dict[str, None]] = {}
        for item in group.items:
            for name, why in _reasons(item):
                named.setdefault(why, {})[name] = None
        if named:
            reasons = (f"{', '.join(names)}: {why}" for why, names in named.items())
            yield f"essay: {', '.join(group.path[1:])}: {'; '.join(reasons)}"


def _reasons(item: Item) -> Iterator[tuple[str, str]]:
    if item.essay is not None:
        yield from item.essay.reasons.items()
