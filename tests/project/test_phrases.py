"""What a reader is told is words with values, not a text put together: another language words it by its pattern."""

import ast
import re

import pytest

from solver.resources import root

SOLVER = root("templates").parent / "solver"
ROOMS = ("classroom", "conversions", "displayed", "document", "limits", "numeric", "postconditions", "tasks")
NOT_TOLD = (
    "declarations.py",
    "tasks/__init__.py",
    "changed.py",
    "limits/codec.py",
)
READING = "classroom/reading/"
"""What these files say, and this folder, is read by who writes a task, or is wrong with a file, and stays English."""

MARKUP = re.compile(r"<[^<>]*>(.*</\w+>)?")

INSIDE = {"ValueError", "TypeError", "LookupError", "AttributeError", "Unreadable"}
"""Errors that no reader of a page sees."""

VALUES = re.compile(r"\0 (node|star|degenerate node|focus)")
"""Values of answers that are put together of two words: they are compared, and read in answer files, as they are."""

FORMULA = re.compile(r"\$[^$]*\$")


def told(text):
    """Whether a text, values as \0, holds words outside of its formulas."""
    bare = FORMULA.sub(" ", text)
    silent = VALUES.fullmatch(text) or MARKUP.fullmatch(text)
    return bool(re.search(r"[^\W\d_]{2,}", bare) and re.search(r"\s", bare) and not silent)


def texts_put_together(tree):
    """Yield the line and the source of every text in words that is put together of pieces."""
    inside = {
        id(node)
        for error in ast.walk(tree)
        if isinstance(error, ast.Raise)
        and isinstance(error.exc, ast.Call)
        and getattr(error.exc.func, "id", "") in INSIDE
        for node in ast.walk(error)
    }
    for node in ast.walk(tree):
        if id(node) not in inside and any(map(told, pieces_of(node))):
            yield node.lineno, ast.unparse(node)


def pieces_of(node):
    """Return the fixed texts of an f-string, of a sum, or of what is joined, formatted or replaced."""
    if isinstance(node, ast.JoinedStr):
        return ["".join(each.value if isinstance(each, ast.Constant) else "\0" for each in node.values)]
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Mod):
        return texts(node.left) + texts(node.right)
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr in {"join", "format"}:
        return texts(node.func.value)
    return []


def texts(node):
    """Return the texts that a piece may be."""
    if isinstance(node, ast.IfExp):
        return texts(node.body) + texts(node.orelse)
    return [node.value] if isinstance(node, ast.Constant) and isinstance(node.value, str) else []


@pytest.mark.parametrize("room", ROOMS)
def test_no_text_that_is_told_is_put_together(room):
    found = [
        f"{path.relative_to(SOLVER)}:{line}: {text}"
        for path in sorted((SOLVER / room).rglob("*.py"))
        if not path.as_posix().endswith(NOT_TOLD) and READING not in path.as_posix()
        for line, text in texts_put_together(ast.parse(path.read_text(encoding="utf-8")))
    ]
    assert found == [], "write Phrase(pattern, **values), or a reason"


@pytest.mark.parametrize(
    "source",
    [
        'f"solution {number}"',
        'Check.that("the condition holds" + (f" ({fault})" if fault else ""), "none", True)',
        '" and ".join(names)',
        '"row {} is zero".format(i)',
        '"%s is zero" % name',
        'Claim(a, b, f"$A$ is {n}×{n}")',
        'raise NotEvaluable(f"no value for {name}")',
    ],
)
def test_texts_put_together_are_found(source):
    assert list(texts_put_together(ast.parse(source)))


@pytest.mark.parametrize(
    "source", ['f"row{i}"', 'f"$A^{{{i}}}$"', 'Phrase("row {i}", i=i)', 'raise ValueError(f"no {x}")']
)
def test_names_formulas_and_phrases_are_none(source):
    assert not list(texts_put_together(ast.parse(source)))
