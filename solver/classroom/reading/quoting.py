r"""Answer files that are no YAML because of a few values or lines, as YAML, so that nothing else is lost.

A value that is none by itself stands in quotes: {{5, 1}, {1, 1}}/4, [10, 4 without its bracket, *K, "\frac{1}{2}" in
double quotes. Tabs and other invisible characters become spaces, `K:[10 4]` gets its space, a key beside the others its
column. Lines keep their numbers.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import accumulate

import yaml

from solver.classroom.reading.brackets import enclosed, split
from solver.problem.source import Source
from solver.problem.yaml_tree import FORBIDDEN, MAX_BYTES, MAX_DEPTH, MAX_TEXT, Loader

_KEY = re.compile(r"( *)([\w'\"]+) *:(?: +(\S.*?))? *$", re.DOTALL)
_SPACELESS = re.compile(r"( *[^\W\d]\w*):(?=[^\s:=/])")
_STATED = re.compile(r"( +[A-Za-z]\w*) *= *(?=[^\s=])")
_END = re.compile(r"\r\n?|\n")
_FENCE = re.compile(r"\s*(?:```|~~~)\s*\w*\s*")
_BLOCK = re.compile(r"[|>][+-]?\d?[+-]?\s*(?:#.*)?")
_REMARK = re.compile(r"(.*?)( +#.*)?", re.DOTALL)
_PROSE = re.compile(r"(?=.*[^\W\d_]{3,}\s+[^\W\d_]{2,})[^\d=:\[\](){}]*")
_LEFT = re.compile(r"(?<=\s)(?=\S)|^(?=\S)")
_TOLD = re.compile(r"(?<= )([^\W\d_]{2,}(?: [^\W\d_]{2,}){1,5}) *: +(?=\S)")
"""What a remark is called by: "my remark: …"."""
_WIDE = re.compile("[：，] ?")
"""The colon and the comma of Chinese keyboards."""
_QUOTES = "'\""
_PLACES = ("answers", "problem", "exam")
"""Keys of a file that are read as they are: what all answers hang on is not guessed."""
PART = 3
"""Columns of keys that are open where the answers of a part stand: of `answers`, of the part, of the answer."""
TWICE = "_given_twice"
"""Stands behind a key that is there already."""
UNREADABLE = "… "
"""What no reader of values knows stands before those that are none."""


def quoted(source: Source) -> Source | None:
    """Return the file with what is no YAML mended; None where there is nothing to mend."""
    if len(source.text) > MAX_BYTES:
        return None
    lines = [
        _seen(line) for line in source.text.removeprefix("\ufeff").replace("\r\n", "\n").replace("\r", "\n").split("\n")
    ]
    entries = _once(list(_entries(list(_in_columns(lines)))))
    mended = "\n".join(line for entry in entries for line in _entry(entry))
    return Source(source.name, mended) if mended != source.text else None


def _seen(line: str) -> str:
    """A line without invisible characters, wide signs and what marks a block of code."""
    if _FENCE.fullmatch(line):
        return ""
    inside = line.lstrip("\t \u00a0")
    before = line[: len(line) - len(inside)].replace("\t", "  ").replace("\u00a0", " ")
    inside = _WIDE.sub(lambda found: ": " if found[0][0] == "：" else ", ", inside)
    return before + FORBIDDEN.sub(lambda found: " " if found[0] == "\t" else "", inside)


def _in_columns(lines: Sequence[str]) -> Iterator[str]:
    """Lines whose keys have their space, and stand in the column of the keys before them."""
    columns: list[int] = []
    opens = True
    for each in lines:
        line = _SPACELESS.sub(r"\1: ", each, count=1)
        if len(columns) >= PART and _indentation(line) == columns[-1]:
            line = _STATED.sub(r"\1: ", line, count=1)
        if found := _KEY.fullmatch(line):
            value = found[3] or ""
            column = _fitting(len(found[1]), columns, opens=opens, holds=not value or value.startswith("{"))
            line = " " * column + line.lstrip(" ")
            columns = [*(before for before in columns if before < column), column]
            opens = not value or value.startswith("#") or _BLOCK.fullmatch(value) is not None
        elif not opens and len(columns) >= PART and _indentation(line) == columns[-1]:
            line = _TOLD.sub(lambda found: found[1].replace(" ", "_") + ": ", line, count=1)
        yield line


def _fitting(column: int, columns: Sequence[int], *, opens: bool, holds: bool) -> int:
    """The column where a key belongs that stands in one, below keys in others, the last of which may open a new one.

    Between two columns it belongs to the first where it `holds` others, else to the second.
    """
    if not columns or column in columns or (opens and column > columns[-1]):
        return column
    before = [each for each in columns if each < column]
    behind = [each for each in columns if each > column]
    if not before or not behind:
        return (before or behind)[-1 if before else 0]
    return before[-1] if holds else behind[0]


def _indentation(line: str) -> int:
    return len(line) - len(line.lstrip(" "))


def _entries(lines: Sequence[str]) -> Iterator[list[str]]:
    """The lines of each key: its own, and those below it that begin no other key."""
    entry: list[str] = []
    for line in lines:
        if _KEY.fullmatch(line) and entry:
            yield entry
            entry = []
        entry.append(line)
    if entry:
        yield entry


def _once(entries: list[list[str]]) -> list[list[str]]:
    """Entries of which no two have one key in one place: of two values neither counts, a mapping gets another key."""
    path: list[tuple[int, str]] = []
    known: dict[tuple[str, ...], int] = {}
    again: Counter[tuple[str, ...]] = Counter()
    for i, (first, *rest) in enumerate(entries):
        found = _KEY.fullmatch(first)
        if found is None:
            continue
        path = [*(each for each in path if each[0] < len(found[1])), (len(found[1]), found[2])]
        place = tuple(key for _, key in path)
        earlier = known.setdefault(place, i)
        if earlier == i:
            continue
        before, value = _value(entries[earlier]), _value(entries[i])
        if before and value and not all(enclosed(each, "{}") and ":" in each for each in (before, value)):
            entries[i] = [""] * (1 + len(rest))
            if before != value:
                told = f"{UNREADABLE}given twice: {before}; {value}"
                entries[earlier] = [f"{found[1]}{found[2]}: {_in_quotes(told)}", *[""] * (len(entries[earlier]) - 1)]
        else:
            again[place] += 1
            entries[i] = [f"{found[1]}{found[2]}{TWICE * again[place]}: {value}", *rest]
    return entries


def _value(lines: Sequence[str]) -> str:
    """What stands behind a key."""
    found = _KEY.fullmatch(lines[0])
    below = [line.strip() for line in lines[1:] if line.strip() and not line.lstrip().startswith("#")]
    return "\n".join(each for each in ((found[3] or "") if found else "", *below) if each)


def _entry(lines: Sequence[str]) -> list[str]:
    """The lines of a key with its value in quotes where that is no YAML by itself."""
    found = _KEY.fullmatch(lines[0])
    if found is None:
        return list(lines)
    first, *rest = _without_prose(lines)
    before, head = len(found[1]), f"{found[1]}{found[2]}:"
    value, remark = _remarked(found[3] or "")
    if _BLOCK.fullmatch(value):
        return _block(head, before, rest)
    if value.endswith(("},", "],")):
        first = f"{head} {value[:-1]}{remark}"
    below = [" " * max(0, before + 1 - _indentation(line)) + line if line.strip() else line for line in rest]
    if _stands("\n".join([first, *below])):
        return [first, *below]
    unclear = value.startswith("{") and value.count("{") > max(1, value.count("}"))  # which part the rest belongs to
    if unclear or (found[2] in _PLACES and not before):
        return list(lines)
    if not any(map(str.strip, rest)) and (mapped := _mapping(value)):
        return [f"{head} {mapped}{remark}", *rest]
    return [f"{head} {_in_quotes(_value([first, *rest]).removesuffix(remark))}{remark}", *[""] * len(rest)]


def _without_prose(lines: Sequence[str]) -> list[str]:
    """Lines with those below a whole value as remarks that only say something."""
    first, *rest = lines
    if not _remarked(_value([first]))[0] or not _stands(first):
        return [first, *rest]
    return [
        first,
        *(f"{' ' * _indentation(line)}# {line.strip()}" if _PROSE.fullmatch(line) else line for line in rest),
    ]


def _remarked(value: str) -> tuple[str, str]:
    """A value and the remark behind it, which a # in quotes does not begin."""
    found = _REMARK.fullmatch(value)
    if found is None or value[:1] in _QUOTES:
        return value, ""
    return found[1], found[2] or ""


def _block(head: str, before: int, lines: Sequence[str]) -> list[str]:
    """A text after | whose first line may stand further in than others."""
    filled = [line for line in lines if line.strip()]
    most = min(map(_indentation, filled), default=0)
    return [f"{head} |1", *(" " * (before + 1) + line[most:] if line.strip() else "" for line in lines)]


def _mapping(value: str) -> str:
    """{K: !x, P: 3} with each value in quotes that is none by itself; "" where it is no mapping."""
    value = value if enclosed(value, "{}") else f"{value}}}"  # its bracket is missing
    if not enclosed(value, "{}"):
        return ""
    pieces = [piece.partition(":") for piece in split(value[1:-1], ",")]
    if not all(sign and key.strip().isidentifier() for key, sign, _ in pieces):
        return ""
    return f"{{{', '.join(f'{key.strip()}: {_whole(each.strip())}' for key, _, each in pieces)}}}"


def _whole(value: str) -> str:
    """A value within braces, in quotes where it is none by itself."""
    return value if _stands(f"x: {{y: {value}}}") else _in_quotes(value)


def _in_quotes(text: str) -> str:
    """A text in quotes; of one in quotes already, what stands between them as it was typed."""
    if text[:1] in _QUOTES:
        text = text.removeprefix(text[0]).removesuffix(text[0])
    if len(text) > MAX_TEXT or sum(map(text.count, "[{(")) > MAX_DEPTH:
        text = f"{UNREADABLE}longer or deeper than can be read: {text[:40].strip('[{(')}"
    if "\n" not in text:
        return "'" + text.replace("'", "''") + "'"
    escaped = text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n")
    return f'"{escaped}"'


def _stands(text: str) -> bool:
    """Whether a text is YAML, without anchors and the like, and within the bounds of texts and depth."""
    try:
        events = list(yaml.parse(text, Loader=Loader))
    except yaml.YAMLError:
        return False
    depths = accumulate(map(_deeper, events))
    return max(depths, default=0) < MAX_DEPTH - PART and not any(map(_is_refused, events))


def _deeper(event: yaml.Event) -> int:
    return isinstance(event, yaml.CollectionStartEvent) - isinstance(event, yaml.CollectionEndEvent)


def _is_refused(event: yaml.Event) -> bool:
    if isinstance(event, yaml.AliasEvent) or getattr(event, "anchor", None) or getattr(event, "tag", None):
        return True
    return isinstance(event, yaml.ScalarEvent) and bool(len(event.value) > MAX_TEXT or FORBIDDEN.search(event.value))
