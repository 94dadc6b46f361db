"""What a page says in place of what stands above, as Markdown: "As in (d), steps 1–4:"; links are those of `link`."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import TYPE_CHECKING

from solver.render.displaying import word_of
from solver.words import Phrase

if TYPE_CHECKING:
    from solver.document.checks import Say
    from solver.document.model import Reference, Work, WorkAnswer, WorkStep

_LINK = re.compile(r"\[([^\]]+)\]\(#[^)]+\)")

Link = Callable[["Reference"], str]
"""Writes a reference in a format, by default as its words."""


def words_of(there: Reference) -> str:
    """Return a reference without a link."""
    return there.place


def linked(there: Reference) -> str:
    """Return a reference with a link, for formats that have targets."""
    return f"[{there.place}](#{there.anchor})"


def unlinked(markdown: str) -> str:
    """Return a text without its links to places of the page, for formats that have no targets."""
    return _LINK.sub(r"\1", markdown)


def referring(step: WorkStep, say: Say, link: Link = words_of) -> str:
    """Return where the steps stand that a step takes the place of; its own text, if it has one, follows."""
    *others, last = map(link, step.refers)
    places = say(Phrase("{places}, and {last}", places="; ".join(others), last=last)) if others else last
    return say(Phrase("As in {places}:" if step.markdown else "As in {places}.", places=places))


def picturing(there: Reference, say: Say, link: Link = words_of) -> str:
    """Return where a figure stands."""
    return say(Phrase("The figure is that of {place}.", place=link(there)))


def agreeing(same: Reference, say: Say, link: Link = words_of) -> str:
    """Return that another method has found the same answers."""
    return say(Phrase("The same as by {method}.", method=link(same)))


def noting(part: Work, say: Say, link: Link = words_of) -> str:
    """Return where the answers stand that were found on the way."""
    places = "; ".join(f"{', '.join(map(_named, answers))} ({link(there)})" for there, answers in part.noted)
    return say(Phrase("Found on the way: {places}.", places=places))


def _named(answer: WorkAnswer) -> str:
    """Return the symbol of an answer, its meaning where it has a word in place of one."""
    return answer.doc if not answer.symbol or word_of(answer.symbol) else f"${answer.symbol}$"
