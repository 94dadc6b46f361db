"""Write what the tasks declare into the documentation: the list in docs/user-guide.md, docs/tasks.md, docs/methods.md.

python -m tools.tables            write them
python -m tools.tables --check    only say whether they are up to date (exit code 1 if not)
"""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator
from itertools import groupby
from pathlib import Path
from typing import Any

from solver.derivation import AnswerName, Option, Task
from solver.notation import spelled
from solver.symbols import COURSE
from solver.tasks import Catalogue, Declaration, catalogue
from tools import methods_page

ROOT = Path(__file__).parents[1]
GUIDE = ROOT / "docs" / "user-guide.md"
PAGE = ROOT / "docs" / "tasks.md"
METHODS = ROOT / "docs" / "methods.md"
BEGIN, END = "<!-- tasks: made by `make tables` -->\n", "<!-- end of tasks -->\n"

HEAD = """\
# Tasks

Made by `make tables` from the declarations of the tasks: what each asks, its methods, options and answers. The first
method is the default. Answers in **bold** are what the question is after; one in *italics* is given where it makes
sense.
"""


def guide(text: str, known: Catalogue) -> str:
    """Return the user guide with its list of tasks made anew."""
    before, _, rest = text.partition(BEGIN)
    _, _, after = rest.partition(END)
    return f"{before}{BEGIN}{_list(known)}{END}{after}"


def page(known: Catalogue) -> str:
    """Return the page with all about every task."""
    lines = [HEAD]
    for (group, title), members in groupby(known.declarations(), key=_topic):
        lines.append(f"## {group}: {title}\n")
        for each in members:
            lines += _about(known[each.name])
    return "\n".join(lines).rstrip() + "\n"


def _topic(declared: Declaration) -> tuple[str, str]:
    return declared.topic.group, declared.topic.title


def _list(known: Catalogue) -> str:
    lines = []
    for (_, title), members in groupby(known.declarations(), key=_topic):
        rows = [(f"`{each.name}`", known[each.name].doc, _names(_methods(known[each.name]))) for each in members]
        lines += ["", *_table((title, "asks", "methods"), rows)]
    return "\n".join([*lines[1:], ""])


def _methods(task: Task[Any, Any]) -> list[str]:
    return [] if list(task.methods) == [task.name] else list(task.methods)


def _names(names: Iterable[str]) -> str:
    return ", ".join(f"`{name}`" for name in names)


def _about(task: Task[Any, Any]) -> Iterator[str]:
    """Yield the lines about one task."""
    yield f"### `{task.name}`\n"
    yield f"{task.title}. {task.doc}\n"
    if _methods(task):
        rows = [(f"`{each.name}`", each.title, _time(each.time), each.source) for each in task.methods.values()]
        yield from [*_table(("method", "", "time", "source"), rows), ""]
    yield from [*_table(("option", "is", "means"), map(_option, task.options.values())), ""]
    yield from [*_table(("answer", "is"), (_answer(task, each) for each in task.answers.values())), ""]


def _time(time: str) -> str:
    return "any" if time == "both" else time


def _option(option: Option) -> tuple[str, str, str]:
    facts = [option.kind.words, *(["required"] if option.required else [])]
    if option.default is not None:
        default = str(option.default)
        facts.append(f"default {default.lower() if isinstance(option.default, bool) else default}")
    return f"`{option.name}`", "; ".join(facts), option.doc + _only(option.methods)


def _answer(task: Task[Any, Any], answer: AnswerName) -> tuple[str, str]:
    name = f"`{answer.name}`"
    name = f"**{name}**" if answer.name in task.principal else f"*{name}*" if answer.optional else name
    return name, spelled(answer.doc, COURSE) + _only(answer.methods)


def _only(methods: tuple[str, ...]) -> str:
    return f" (only {_names(methods)})" if methods else ""


def _table(head: tuple[str, ...], rows: Iterable[tuple[str, ...]]) -> Iterator[str]:
    yield f"| {' | '.join(head)} |"
    yield f"|{'---|' * len(head)}"
    yield from (f"| {' | '.join(cell.replace('|', '&#124;') for cell in row)} |" for row in rows)


def main(arguments: list[str]) -> int:
    """Write all; with --check say whether that would change them."""
    known = catalogue()
    made = {GUIDE: guide(GUIDE.read_text(encoding="utf-8"), known), PAGE: page(known), METHODS: methods_page.page()}
    old = {path: path.read_text(encoding="utf-8") if path.exists() else "" for path in made}
    stale = [path for path, text in made.items() if text != old[path]]
    if "--check" in arguments:
        print("\n".join(f"{path.relative_to(ROOT)} is out of date: make tables" for path in stale))
        return int(bool(stale))
    for path in stale:
        path.write_text(made[path], encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
