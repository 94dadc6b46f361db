"""What a YAML parser's complaint means to the author of a problem file."""

from __future__ import annotations

import re

import yaml

from solver.problem.source import Diagnostic, Source

INDENTATION = "check the indentation, and whether a quote, a bracket or a comma is missing above"

# a piece of the parser's message (libyaml's or PyYAML's wording): what is wrong, what to do
HINTS: tuple[tuple[str, str, str], ...] = (
    (
        "mapping values are not allowed",
        "a ':' is not expected here",
        "put a text that contains ': ' in quotes; check the indentation",
    ),
    (
        "unknown escape",
        "unknown escape in a text in double quotes",
        "a backslash is an escape there: use single quotes, or a block text after '|'",
    ),
    ("',' or ']'", "a ',' or the closing ']' is missing", ""),
    ("',' or '}'", "a ',' or the closing '}' is missing", ""),
    (
        "could not find expected ':'",
        "a key without its ':'",
        "write 'key: value', with a space after the ':'",
    ),
    ("expected node content", "a value is missing here", ""),
    ("expected the node content", "a value is missing here", ""),
    ("expected alphabetic or numeric", "a name is missing", "put a text that starts with '*' or '&' in quotes"),
    ("expected key", "this line does not fit what stands above it", INDENTATION),
    ("<block end>", "this line does not fit what stands above it", INDENTATION),
    ("'-' indicator", "this line does not fit what stands above it", INDENTATION),
    ("sequence entries", "a list cannot start here", "start it on a line of its own, or write [a, b]"),
    ("document start", "this does not fit what stands above it", INDENTATION),
    ("comment or line break", "nothing may follow '|' or '>' on its line", "start the text on the next line"),
    ("chomping", "nothing may follow '|' or '>' on its line", "start the text on the next line"),
    ("document indicator", "a text in quotes is not closed before this line", ""),
)


def explain(error: yaml.YAMLError, source: Source) -> Diagnostic:
    """Return the parser's complaint in plain words, at its place."""
    place = _place(error, "problem_mark") or _place(error, "context_mark")
    if place is None:
        return Diagnostic("this is not readable as YAML")
    problem, context = str(getattr(error, "problem", None) or ""), str(getattr(error, "context", None) or "")
    line, column = place
    before = source.line(line)[: column - 1].strip()
    if not any(each.strip() for each in (source.line(line)[column - 1 :], *source.lines[line:])):
        return _unclosed(problem, context, _place(error, "context_mark") or place)
    if "cannot start any token" in problem:
        start = source.line(line)[column - 1]
        return Diagnostic(f"a value cannot start with '{start}'", line, column, note="put the text in quotes")
    for piece, message, note in HINTS:
        if piece in problem:
            if "escape" in problem and before.endswith("\\"):
                column -= 1  # PyYAML points after the backslash, libyaml at it
            if note == INDENTATION and before:
                return Diagnostic("this is not expected here", line, column, note="the value before it has ended")
            return Diagnostic(message, line, column, note=_glued(source, line) or note)
    return Diagnostic(f"this is not readable as YAML: {problem}", line, column)


def _place(error: yaml.YAMLError, which: str) -> tuple[int, int] | None:
    mark = getattr(error, which, None)
    return None if mark is None else (mark.line + 1, mark.column + 1)


def _glued(source: Source, line: int) -> str:
    """Return a hint if the line before is `key:value`, which YAML takes for a text."""
    key = re.match(r"\s*(\w+):[^\s:]", source.line(line - 1))
    return f"line {line - 1}: a space is missing after '{key[1]}:'" if key else ""


def _unclosed(problem: str, context: str, opened: tuple[int, int]) -> Diagnostic:
    """Something is open at the end of the file: point to where it was opened."""
    closing = next((f"'{bracket}'" for bracket in "]}" if bracket in problem), "quote" if "quoted" in context else "")
    message = f"the closing {closing} is missing" if closing else "the file ends before this is complete"
    return Diagnostic(message, *opened)
