"""The texts of a problem, Markdown with `$math$`: formulas and images must be such that every format can show them."""

from __future__ import annotations

from collections.abc import Iterator
from urllib.parse import quote

from solver.markup import images_in, math_problems
from solver.problem.images import Image, NoImage, load_image
from solver.problem.nodes import MappingNode, Node, ScalarNode
from solver.problem.source import Diagnostic, Fault, Report, Source

ADVICE = "formulas stand between dollar signs; a dollar sign itself is written \\$"


def check_texts(root: MappingNode, source: Source, report: Report) -> dict[str, Image]:
    """Return the images of the statement and the prompts; report what is wrong with them and with formulas."""
    images: dict[str, Image] = {}
    for node in _texts(root):
        check_formulas(node, source, report)
        for address in images_in(node.text):
            with report:
                images[address] = _image(address, node, source)
    return images


def check_formulas(node: ScalarNode, source: Source, report: Report) -> None:
    """Report what is wrong with the formulas of a text."""
    for offset, message in math_problems(node.text):
        with report:
            raise _fault(node, offset, f"in a formula: {message}", source, ADVICE)


def _image(address: str, node: ScalarNode, source: Source) -> Image:
    """Return an image of a text; raises Fault at its place."""
    try:
        return load_image(address, source)
    except NoImage as reason:
        offset = max(node.text.find(quote(address)), node.text.find(address), 0)
        raise _fault(node, offset, f"the image '{address[:60]}' cannot be shown: {reason}", source, "") from None


def _texts(root: MappingNode) -> Iterator[ScalarNode]:
    """The nodes of all texts."""
    find = root.get("find")
    parts = [entry.value for entry in find] if isinstance(find, MappingNode) else []
    holders: list[tuple[Node | None, str]] = [(root, "statement"), *((part, "prompt") for part in parts)]
    for holder, key in holders:
        node = holder.get(key) if isinstance(holder, MappingNode) else None
        if isinstance(node, ScalarNode):
            yield node


def _fault(node: ScalarNode, offset: int, message: str, source: Source, note: str) -> Fault:
    """Return the fault at a place in a text: in a block (statement: |) by the line it stands on."""
    before, _, _ = node.text[:offset].rpartition("\n")
    number = node.text[:offset].count("\n")
    words = node.text.split("\n")[number]
    column = source.line(node.place.line + 1 + number).find(words) if node.style == "block" and words else -1
    if column < 0:
        return node.fault_inside(message, offset, 1, note=note)
    inside = offset - len(before) - bool(number)
    return Fault(Diagnostic(message, node.place.line + 1 + number, column + inside + 1, 1, note=note))
