r"""Questions of Moodle with gaps in their text: how gaps are written, what they weigh, and shares that Moodle knows.

A gap is `{2:NUMERICAL:=4:0.01~%50%-4:0.01#hint}`. Signs that end one, and braces that would begin one, are written as
entities of HTML, which Moodle turns back into signs when it has read the gap.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from decimal import Decimal
from fractions import Fraction
from math import gcd, lcm

from solver.papers.export.content import line_of, with_tex
from solver.papers.export.decimals import written
from solver.papers.export.quiz import Choice, Field, Number, Spelling

SHARES = ("100", "90", "83.33333", "80", "75", "70", "66.66667", "60", "50", "40", "33.33333", "30", "25", "20",
          "16.66667", "14.28571", "12.5", "11.11111", "10", "5", "0")  # fmt: skip
"""Percentages that Moodle's importer takes; it refuses or rounds any other."""

CLOSE = Fraction(1, 10**5)
"""By so much a share may lie below one of the list, as 1/3 does below 33.33333 %."""

_ENDS = re.compile(r"[{}~#]")
_BEGINS = re.compile(r"\{(?=\d*:)")
_SAFE_HASH = re.compile(r"&#(?=\d+;|x)")


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
                f"%{share_of(wrong.share)}%{_value(wrong.value, wrong.tolerance)}#{hint(wrong.hint)}"
                for wrong in field.wrong
            ]
            return f"{{{weight}:NUMERICAL:{'~'.join(answers)}}}"
        case Choice():
            words = [("=" if i == field.right else "") + _text(word) for i, word in enumerate(field.words)]
            return f"{{{weight}:MULTICHOICE:{'~'.join(words)}}}"
        case Spelling():
            return f"{{{weight}:SHORTANSWER:{'~'.join(f'={_text(word)}' for word in field.right)}}}"


def _value(value: Decimal, tolerance: Decimal) -> str:
    return f"{written(value)}:{written(tolerance)}"


def hint(markdown: str) -> str:
    """Return a hint as HTML that ends no gap."""
    return _entities(with_tex(lambda math: line_of(markdown, math)))


def _text(word: str) -> str:
    """Return a plain text that ends no answer and has no share; its entities are signs when it is shown."""
    text = _entities(word.replace("&", "&amp;").replace("<", "&lt;"))
    return f"&#{ord(text[0])};{text[1:]}" if text[:1] in {"=", "%"} else text


def _entities(html: str) -> str:
    parts = _SAFE_HASH.split(html)
    return "&#".join(_ENDS.sub(lambda found: f"&#{ord(found[0])};", part) for part in parts)


def weights_of(fields: Sequence[Field], marks: Fraction) -> list[int]:
    """Return whole weights in the ratio of the marks, which add up to `marks` where whole ones can."""
    if not any(field.marks for field in fields):
        return [1] * len(fields)
    common = lcm(*(field.marks.denominator for field in fields))
    whole = [int(field.marks * common) for field in fields]
    least = [each // gcd(*whole) for each in whole]
    factor = marks / sum(least)
    return [each * factor.numerator for each in least] if factor.denominator == 1 else least
