"""Content as HTML, for any system that shows some: formulas drawn and images addressed as that one wants them."""

from __future__ import annotations

import re
from collections.abc import Callable
from html import escape

from solver.papers.export.quiz import Content, Heading, Picture, Text
from solver.problem.images import Image
from solver.render.prose import Address, Math, inline_html, to_html

TOP = 3
"""The level in HTML of the highest heading: what is above belongs to the system."""

_DELIMITER = re.compile(r"\\(?=[()\[\]])|\$(?=\$)")
_KEPT = re.compile("\ue000(\\d+)\ue001")


def html_of(content: Content, math: Math, address: Address) -> str:
    """Return well-formed HTML (and XHTML) without script, style and anything from outside.

    `math(latex, displayed)` draws a formula, escaped; `address(image)` says where an image is found. All else is
    escaped here.
    """
    return "\n".join(_block(block, content, math, address) for block in content.blocks)


def line_of(markdown: str, math: Math) -> str:
    """Return one line of Markdown as HTML without a paragraph around it."""
    return inline_html(markdown, math)


def images_of(content: Content) -> list[Image]:
    """Return the images in the order in which they are shown, each once."""
    found: dict[Image, None] = {}

    def noted(image: Image) -> str:
        found[image] = None
        return ""

    html_of(content, lambda _latex, _displayed: "", noted)
    return list(found)


def with_tex(write: Callable[[Math], str], display: tuple[str, str] = (r"\[", r"\]")) -> str:
    r"""Return the HTML that `write` makes, its formulas between `\( \)`, or `display`, for systems that draw TeX.

    Such signs in a text that is no formula are kept from beginning one.
    """
    formulas: list[str] = []

    def kept(latex: str, displayed: bool) -> str:
        text = escape(latex.strip(), quote=False)
        formulas.append(text.join(display) if displayed else rf"\({text}\)")
        return f"\ue000{len(formulas) - 1}\ue001"

    html = _DELIMITER.sub(lambda found: f"{found[0]}\u2060", write(kept))
    return _KEPT.sub(lambda found: "".join(formulas[int(found[1]) :][:1]), html)


def _block(block: Text | Heading | Picture, content: Content, math: Math, address: Address) -> str:
    match block:
        case Text(markdown):
            return to_html(markdown, math, content.images, address).strip()
        case Heading(markdown, level):
            tag = f"h{min(6, TOP - 1 + level)}"
            return f"<{tag}>{inline_html(markdown, math)}</{tag}>"
        case Picture(image, alt, caption):
            shown = f'<img alt="{escape(alt)}" src="{escape(address(image))}" />'
            return f"<p>{shown}</p>" + (f"\n<p>{inline_html(caption, math)}</p>" if caption else "")
