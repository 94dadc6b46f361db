r"""Questions of Moodle with gaps in their text: how gaps are written, what they weigh, and shares that Moodle knows.

A gap is `{2:NUMERICAL:=4:0.01~%50%-4:0.01#hint}`. Moodle turns the entities in it into signs once, when it reads it,
and shows that as HTML. So HTML stands in a gap with its entities escaped once more, and the signs that end one are
entities of it.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from decimal import Decimal
from fractions import Fraction
from html import escape
from math import gcd, lcm

from solver.papers.export.content import line_of, with_tex
from solver.papers.export.decimals import written
from solver.papers.export.quiz import Choice, Field, Number

SHARES = ("100", "90", "83.33333", "80", "75", "70", "66.66667", "60", "50", "40", "33.33333", "30", "25", "20",
          "16.66667", "14.28571", "12.5", "11.11111", "10", "5", "0")  # fmt: skip
"""Percentages that Moodle's importer takes; it refuses or rounds any other."""

CLOSE = Fraction(1, 10**5)
"""By so much a share may lie below one of the list, as 1/3 does below 33.33333 %."""

_ENDS = re.compile(r"[{}~]|(?<!&)#|\\\Z")
"""Signs that end a gap or an answer, a hash that begins an entity apart; a backslash before an end would hide it."""

_SHARE = re.compile(r"\A[=%]")
"""What an answer begins with that has a share."""

_BEGINS = re.compile(r"\{(?=\d*:|#\d+\})")
"""The brace of a gap, and that of what Moodle writes in its place."""


def share_of(share: Fraction) -> str:
    """Return the largest percentage of Moodle's list that is not more."""
    return next(each for each in SHARES if Fraction(each) / 100 <= share + CLOSE)


def without_gaps(html: str) -> str:
    """Return HTML in which no brace begins a gap."""
    return _BEGINS.sub("&#123;", html)


def gap(field: Field, weight: int) -> str:
    """Return the gap of a field."""
    match field:
        case Number():
            answers = [f"={_value(field.value, field.tolerance)}"]
            answers += [
                f"%{share_of(wrong.share)}%{_value(wrong.value, wrong.tolerance)}#{_inside(hint(wrong.hint))}"
                for wrong in field.wrong
            ]
            return f"{{{weight}:NUMERICAL:{'~'.join(answers)}}}"
        case Choice():
            words = [("=" if i == field.right else "") + _word(word) for i, word in enumerate(field.words)]
            return f"{{{weight}:MULTICHOICE:{'~'.join(words)}}}"


def _value(value: Decimal, tolerance: Decimal) -> str:
    return f"{written(value)}:{written(tolerance)}"


def hint(markdown: str) -> str:
    """Return a hint as HTML."""
    return with_tex(lambda math: line_of(markdown, math))


def _inside(html: str) -> str:
    """Return HTML as it stands in a gap."""
    return _ENDS.sub(_entity, html).replace("&", "&amp;")


def _word(word: str) -> str:
    """Return a plain word as an answer without a share; behind an answer a hash that is none has a backslash."""
    return _inside(_SHARE.sub(_entity, escape(word, quote=False))).replace("#", r"\#")


def _entity(sign: re.Match[str]) -> str:
    return f"&#{ord(sign[0])};"


def weights_of(fields: Sequence[Field], marks: Fraction) -> list[int]:
    """Return whole weights in the ratio of the marks, which add up to `marks` where whole ones can."""
    if not any(field.marks for field in fields):
        return [1] * len(fields)
    common = lcm(*(field.marks.denominator for field in fields))
    whole = [int(field.marks * common) for field in fields]
    least = [each // gcd(*whole) for each in whole]
    factor = marks / sum(least)
    return [each * factor.numerator for each in least] if factor.denominator == 1 else least
