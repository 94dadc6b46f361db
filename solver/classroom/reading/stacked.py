"""Matrices that programs put together of lists: np.vstack(([1, 2], [3, 4])), cbind(c(1, 2), c(3, 4)), reshape(…).

MATLAB, Julia and R fill a matrix column by column, numpy and a matrix of R with byrow=TRUE row by row.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from solver.classroom.reading.brackets import matching, split
from solver.classroom.reading.grids import transposed
from solver.problem.nodes import Node, SequenceNode

_CALL = re.compile(
    r"((?:[A-Za-z_]\w*\.)*)(vstack|row_stack|vertcat|rbind|hstack|horzcat|column_stack|cbind|reshape|matrix|mat|c|vec)\s*\("
)
_INDEXED = re.compile(r"(?:np|numpy)\.([rc])_\s*\[")
_METHOD = re.compile(r"(.*[\])])\s*\.reshape\s*\((.*)\)", re.DOTALL)
_KEYWORD = re.compile(r"\s*(nrow|ncol|byrow)\s*=\s*(\w+)\s*")
_SIZE = re.compile(r"-?\d{1,2}")
_BELOW = ("vstack", "row_stack", "vertcat", "rbind")
_AS_COLUMNS = ("column_stack", "cbind")
_AS_LISTED = ("c", "vec", "mat")

Read = Callable[[str], Node]
"""Reads a piece of the text."""


def stacked(text: str, read: Read) -> Node | None:
    """Return the matrix that a call puts together of lists; None of any other text."""
    if found := _METHOD.fullmatch(text):
        return _reshaped(read(found[1]), split(found[2].strip("()"), ","), by_row=True)
    if (found := _INDEXED.match(text)) and matching(text, found.end() - 1) == len(text) - 1:
        lists = [read(each) for each in split(text[found.end() : -1], ",")]
        return _beside(lists) if found[1] == "c" else _in_a_row(lists)
    found = _CALL.match(text)
    if found is None or matching(text, found.end() - 1) != len(text) - 1:
        return None
    return _called(found[1], found[2], text[found.end() : -1].strip(), read)


def _called(library: str, name: str, inside: str, read: Read) -> Node | None:
    arguments = split(inside, ",")
    if name in _AS_LISTED:
        return read(f"[{inside}]") if len(arguments) > 1 and not library else None
    if name == "matrix":
        return _matrix_of_r(arguments, read)
    if name == "reshape":
        return _reshaped_by_call(library, arguments, read)
    if len(arguments) == 1:  # of numpy, whose lists stand in a tuple or a list
        arguments = split(inside[1:-1], ",")
    lists = [read(each.strip()) for each in arguments if each.strip()]
    if name in _BELOW:
        return _below(lists)
    columns = name in _AS_COLUMNS or library.endswith("Matrix.") or all(_is_matrix(each) for each in lists)
    return _beside(lists) if columns else _in_a_row(lists)


def _matrix_of_r(arguments: Sequence[str], read: Read) -> Node | None:
    """matrix(c(1, 2, 3, 4), nrow=2, byrow=TRUE), matrix(c(1, 2, 3, 4), 2, 2)."""
    first, *rest = arguments or [""]
    if not first.strip().startswith("c("):
        return None
    named = {found[1]: found[2] for each in rest if (found := _KEYWORD.fullmatch(each))}
    sizes = [each.strip() for each in rest if _SIZE.fullmatch(each.strip())]
    height = named.get("nrow", sizes[0] if sizes else "-1")
    width = named.get("ncol", sizes[1] if len(sizes) > 1 else "-1")
    return _reshaped(read(first), [height, width], by_row=named.get("byrow", "F").startswith("T"))


def _reshaped_by_call(library: str, arguments: Sequence[str], read: Read) -> Node | None:
    """reshape(a, 2, 2) and reshape(a, [2 2]) of MATLAB, np.reshape(a, (2, 2)); a tuple without np. may be of Julia."""
    if len(arguments) < 2:
        return None
    of_numpy = library in ("np.", "numpy.")
    size = ",".join(arguments[1:]).strip()
    if size.startswith("(") and not of_numpy:
        return None
    sizes = re.split(r"[\s,]+", size.strip("[]() "))
    return _reshaped(read(arguments[0].strip()), sizes, by_row=of_numpy)


def _reshaped(node: Node, sizes: Sequence[str], *, by_row: bool) -> Node | None:
    """The entries of a list in rows or columns of a size, of which one may be -1."""
    if not isinstance(node, SequenceNode) or _is_matrix(node):
        return None
    found = [int(each) for each in map(str.strip, sizes) if _SIZE.fullmatch(each)]
    if len(found) != 2 or len(sizes) != 2 or 0 in found:
        return None
    count = len(node.items)
    height, width = (own if own > 0 else count // abs(other) for own, other in (found, found[::-1]))
    if height * width != count or not count:
        return None
    step = width if by_row else height
    lines = [SequenceNode(node.place, node.items[at : at + step]) for at in range(0, count, step)]
    whole = SequenceNode(node.place, tuple(lines))
    return whole if by_row else transposed(whole)


def _is_matrix(node: Node) -> bool:
    """Whether a list has rows."""
    return isinstance(node, SequenceNode) and bool(node.items) and all(isinstance(i, SequenceNode) for i in node.items)


def _below(lists: Sequence[Node]) -> SequenceNode | None:
    """Matrices or rows below each other."""
    lines: list[Node] = []
    for each in lists:
        if not isinstance(each, SequenceNode):
            return None
        lines += each.items if _is_matrix(each) else [each]
    return SequenceNode(lists[0].place, tuple(lines)) if lines else None


def _beside(lists: Sequence[Node]) -> SequenceNode | None:
    """Matrices or columns beside each other."""
    turned = [transposed(each) if _is_matrix(each) else each for each in lists if isinstance(each, SequenceNode)]
    below = _below(turned) if turned and len(turned) == len(lists) else None
    return transposed(below) if below else None


def _in_a_row(lists: Sequence[Node]) -> SequenceNode | None:
    """Lists and numbers one behind the other."""
    items: list[Node] = []
    for each in lists:
        items += each.items if isinstance(each, SequenceNode) else [each]
    return SequenceNode(lists[0].place, tuple(items)) if items else None
