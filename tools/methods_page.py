"""The page of the orders of steps, docs/methods.md, with the titles that the wording gives them."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import cache
from itertools import groupby

from tools.methods import NOTHING, ROOT, Either, Named, Node, Repeated, Route, Then, methods

WORDING = ROOT / "templates" / "wording"
HEAD = """\
# Methods

Made by `make tables` from the derivations and the titles of their steps: the order of the steps of each method, lemmas
included. `→` is followed by, `[ ]` stands in some cases only, `( | )` is one of several, `*` is repeated.
"""


def page() -> str:
    """Return the page."""
    lines = [HEAD]
    for task, routes in groupby(methods(), key=lambda route: route.task):
        lines += [f"## `{task}`\n", "| method | steps |", "|---|---|", *map(_row, routes), ""]
    return "\n".join(lines).rstrip() + "\n"


def _row(route: Route) -> str:
    name = f"`{route.method}`" if route.method != route.task else ""
    return f"| {name} | {_written(_factored(route.order)).replace('|', '&#124;')} |"


def _written(node: Node, *, inner: bool = False) -> str:
    if isinstance(node, Named):
        return title_of(node)
    if isinstance(node, Repeated):
        text = _written(node.part, inner=True)
        return f"{text}*" if text.startswith(("(", "[")) else f"({text})*"
    if isinstance(node, Then):
        text = " → ".join(dict.fromkeys(_written(part, inner=True) for part in node.parts))
        return f"({text})" if inner and len(node.parts) > 1 else text
    ways = [way for way in node.ways if way != NOTHING]
    text = " | ".join(dict.fromkeys(_written(way) for way in ways))
    if NOTHING in node.ways:
        return f"[{text}]"
    return f"({text})" if len(ways) > 1 else text


def _factored(node: Node) -> Node:
    """Write once what all ways begin or end with."""
    if isinstance(node, Repeated):
        return Repeated(_factored(node.part))
    if isinstance(node, Then):
        return Then(tuple(map(_factored, node.parts)))
    if not isinstance(node, Either):
        return node
    ways = [way.parts if isinstance(way, Then) else (way,) for way in map(_factored, node.ways)]
    first = _shared(ways)
    ways = [way[first:] for way in ways]
    last = _shared([way[::-1] for way in ways])
    begin = node_parts(node)[:first]
    end = ways[0][len(ways[0]) - last :]
    middle = dict.fromkeys(Then(way[: len(way) - last]) for way in ways)
    return Then((*map(_factored, begin), Either(tuple(middle)), *end)) if first or last else Either(tuple(middle))


def node_parts(node: Either) -> tuple[Node, ...]:
    """Return the parts of the first of some ways."""
    way = node.ways[0]
    return way.parts if isinstance(way, Then) else (way,)


def _shared(ways: Sequence[tuple[Node, ...]]) -> int:
    """How many parts all ways begin with alike."""
    count = 0
    for parts in zip(*ways, strict=False):
        if any(part != parts[0] for part in parts):
            break
        count += 1
    return count


def title_of(step: Named) -> str:
    """Return the title of a step; what depends on the case is shortened."""
    text = _titles(step.wording).get(step.kind) or step.kind.replace("_", " ")
    return " ".join(_spoken(text).split()) or step.kind.replace("_", " ")


@cache
def _titles(wording: str) -> dict[str, str]:
    """Return the titles of a file by the names of its macros."""
    path = WORDING / f"{wording}.md.jinja"
    if not path.exists():
        path = path.parent / f"{path.parent.name}.md.jinja"
    return dict(_macros(path.read_text(encoding="utf-8"))) if path.exists() else {}


def _macros(text: str) -> Iterator[tuple[str, str]]:
    for name, body in re.findall(r"{% macro (\w+)\(.*?%}(.*?){%-? endmacro", text, re.DOTALL):
        title = re.search(r"^### (.*)$", body, re.MULTILINE)
        if title:
            yield name, title[1]


def _spoken(title: str) -> str:
    """Return a title without the language of templates: every way it may read, and dots for values."""
    block = re.compile(r"{%-? if [^%]*-?%}((?:(?!{%-? (?:if|endif)).)*){%-? endif -?%}")
    while (found := block.search(title)) is not None:
        ways = [way.strip() for way in re.split(r"{%-? (?:elif|else)[^%]*%}", found[1])]
        title = title.replace(found[0], " / ".join(filter(None, ways)) if len(ways) > 1 else "", 1)
    title = re.sub(r"{%.*?%}", "", title)
    return re.sub(r"{{(.*?)}}", _value, title)


def _value(match: re.Match[str]) -> str:
    said = re.sub(r'"[^"]*" in|== "[^"]*"|\["[^"]*"\]', "", match[1])
    words = [word for word in re.findall(r'"([^"]*)"', said) if word.strip()]
    return " / ".join(words) if " if " in match[1] and len(words) > 1 else "" if " if " in match[1] else "…"
