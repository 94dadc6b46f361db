"""Answer files that are no YAML because of what a value begins or ends with: {{5, 1}, {1, 1}}/4, |K - 3| < 3, %e^-t."""

from __future__ import annotations

import re

import yaml

from solver.problem.source import Source
from solver.problem.yaml_tree import MAX_BYTES, Loader

_VALUE = re.compile(r"(\s*[\w'\"]+:[ \t]+)(\S.*?)([ \t]*(?:[ \t]#.*)?)")
_OPENS = ("[", "{", "(")


def quoted(source: Source) -> Source | None:
    """Return the file with each value of one line that is no YAML by itself in quotes; None where there is none."""
    if len(source.text) > MAX_BYTES:
        return None
    lines = source.text.split("\n")
    mended = [_line(line) for line in lines]
    return Source(source.name, "\n".join(mended)) if mended != lines else None


def _line(line: str) -> str:
    found = _VALUE.fullmatch(line.rstrip("\r"))
    if found is None or _stands(found[2]) or _goes_on(found[2]):
        return line
    text = found[2].replace("'", "''")
    return f"{found[1]}'{text}'{found[3]}"


def _stands(value: str) -> bool:
    """Whether a value is YAML by itself."""
    try:
        return bool(list(yaml.parse(f"x: {value}", Loader=Loader)))
    except yaml.YAMLError:
        return False


def _goes_on(value: str) -> bool:
    """Whether a value may end on a later line."""
    unclosed = value.startswith(_OPENS) and sum(value.count(a) - value.count(b) for a, b in ("[]", "{}", "()")) > 0
    return unclosed or (value[0] in "'\"" and value.count(value[0]) % 2 == 1)
