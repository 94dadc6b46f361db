r"""Texts for Canvas: HTML with TeX, which it draws where it finds `\( \)` or `$$ $$`."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Context, Decimal

from solver.papers.export.content import html_of, line_of, with_tex
from solver.papers.export.quiz import Asked, Content, Essay, Field, Fixed, Wrong
from solver.problem.images import Image
from solver.render.prose import Math

IMAGES = "images"
ROOT = "%24IMS-CC-FILEBASE%24"
"""What Canvas puts the address of the files of the package for."""

DISPLAY = "$$", "$$"
LARGEST = 16_000
r"""Signs of the text of a question. Canvas imports no longer one than 16384, and its own marks are added."""

DIGITS = Context(prec=5)
HERE, ELSEWHERE = r"\boxed{?}", r"\square"
"""What is asked for, and what another question asks for."""


def fits(html: str) -> bool:
    """Return whether a text can be that of a question."""
    return len(html) <= LARGEST


def told(content: Content, *more: str) -> str:
    """Return content as HTML, with what comes behind it."""
    html = with_tex(lambda math: html_of(content, math, _address), DISPLAY)
    return "\n".join(filter(None, [html, *more]))


def parts_of(content: Content) -> Iterator[str]:
    """Yield content in pieces that fit, most often one."""
    piece: list[str] = []
    for block in content.blocks:
        html = told(Content((block,), content.images))
        if piece and not fits("\n".join([*piece, html])):
            yield "\n".join(piece)
            piece = []
        piece.append(html)
    if piece:
        yield "\n".join(piece)


def asks(asked: Asked, field: Field) -> str:
    """Return what a field asks for: the answer, what of it is wanted, and how it is typed."""

    def write(math: Math) -> str:
        where, form = placed(asked, field), asked.form
        lines = [_named(asked.symbol, asked.meaning, math), where and math(where, False), form and line_of(form, math)]
        return "\n".join(f"<p>{line}</p>" for line in lines if line)

    return with_tex(write, DISPLAY)


def placed(asked: Asked, field: Field) -> str:
    """Return the LaTeX of an answer with a box where the field is, "" where there is nothing else."""
    if asked.grid:
        rows = [" & ".join(HERE if cell == field else r"\cdot" for cell in line) for line in asked.lines]
        entries = r" \\ ".join(rows)
        return rf"{asked.symbol} = \begin{{bmatrix}} {entries} \end{{bmatrix}}"
    line = [cell for cell in next(line for line in asked.lines if field in line) if cell != Fixed("")]
    if line == [field]:
        return ""
    return " ".join(cell.latex if isinstance(cell, Fixed) else HERE if cell == field else ELSEWHERE for cell in line)


def asks_essay(essay: Essay) -> str:
    """Return the answers that an essay is to give."""

    def write(math: Math) -> str:
        items = [f"<li>{_named(latex, meaning, math)}</li>" for latex, meaning in essay.asked]
        return f"<ul>{''.join(items)}</ul>" if items else ""

    return with_tex(write, DISPLAY)


def _named(symbol: str, meaning: str, math: Math) -> str:
    """Return what an answer is, behind its symbol where it has one."""
    told = line_of(meaning, math)
    return f"{math(symbol, False)}: {told}" if symbol else told


def hints(wrong: tuple[Wrong, ...]) -> str:
    """Return the wrong values of usual mistakes, each with its hint: Canvas cannot tell them apart."""

    def write(math: Math) -> str:
        told = [(math(few(each.value), False), line_of(each.hint, math)) for each in wrong if each.hint]
        lines = [f"<li>{value}: {hint}</li>" for value, hint in told]
        return f"<ul>{''.join(lines)}</ul>" if lines else ""

    return with_tex(write, DISPLAY)


def few(value: Decimal) -> str:
    """Return a value with no more digits than are needed to know it again."""
    return f"{value if value == value.to_integral_value() else DIGITS.create_decimal(value).normalize():f}"


def _address(image: Image) -> str:
    return f"{ROOT}/{IMAGES}/{image.file_name}"
