"""The list of all tasks as plain text. Reads their declarations; imports none, and no algebra."""

from __future__ import annotations

from itertools import groupby

from solver.tasks import Declaration, catalogue


def overview() -> str:
    """Return all tasks by group and topic: name, title, methods."""
    known = catalogue().declarations()
    width = max((len(each.name) for each in known), default=0)
    lines: list[str] = []
    for group, in_group in groupby(known, key=lambda each: each.topic.group):
        lines.append(group)
        for title, members in groupby(in_group, key=lambda each: each.topic.title):
            lines += [f"  {title}", *(f"    {each.name:{width}}  {_summary(each)}" for each in members), ""]
    return "\n".join(
        [*lines, "`solve tasks NAME` tells more of one; `solve new NAME` writes a problem file that asks it."]
    )


def _summary(declared: Declaration) -> str:
    methods = [name for name in declared.methods if name != declared.name]
    return f"{declared.title} ({', '.join(methods)})" if methods else declared.title


__all__ = ["overview"]
