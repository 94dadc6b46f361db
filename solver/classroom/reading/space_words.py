"""Spaces told in words: all multiples of (1, 2), the whole plane R^2, only the zero vector."""

from __future__ import annotations

import re

from solver.classroom.reading.words import NONE

_LEAD = re.compile(
    r"^\s*(?:(?:the|die|der|das|all|alle|every|any|whole|ganze[rs]?|ganz|entire|of|von|line|gerade|plane|ebene|multiples?"
    r"|vielfachen?|vectors?|vektor(?:en)?|rows?|columns?|zeilen?|spalten?|through|durch|origin|ursprung|spanned by"
    r"|aufgespannt (?:von|durch)|form|basis|linear combinations?|linearkombination(?:en)?|space|raum)\b[\s:,]*)+"
    r"(?=.*[\d({\[Rℝ=])",
    re.IGNORECASE,
)
_LABEL = re.compile(
    r"^\s*(?:[LNUVSK]|ker\w*\s*\(?\s*A?\s*\)?|null\(A\)|bild\s*\(?A?\)?|im\w*\s*\(?A?\)?)\s*=\s*(?=[{<⟨]|span|lin)"
    r"|^\s*[xyvwz]\s*=\s*(?=[a-zα-ω]_?\d?\s*[*·]?\s*[(\[])",
    re.IGNORECASE,
)
_ZERO_VECTOR = r"(?:zero vector|null-?vektor|zero|null|0\s*\u20d7|\\vec\s*\{?\s*0\s*\}?|\\mathbf\s*\{\s*0\s*\}|0)"
_ONLY_ZERO = re.compile(
    rf"\s*(?:x\s*=\s*)?(?:(?:only|nur|just)\s+(?:x\s*=\s*)?(?:the\s+|der\s+|den\s+|aus\s+|dem\s+)*{_ZERO_VECTOR}"
    rf"|\{{?\s*(?:[(\[]\s*0(?:\s*[,;|\s]\s*0)+\s*[)\]]|0\s*\u20d7|\\vec\s*\{{?\s*0\s*\}}?|\\mathbf\s*\{{\s*0\s*\}})"
    r"(?:\^T|'|ᵀ)?\s*\}?)\s*\.?",
    re.IGNORECASE,
)
_REASON = re.compile(
    r"\s*[,;(]\s*(?:since|because|as|da|weil|denn|A\s+(?:is|ist)|det|rank|rang|full|voller)\b.*$",
    re.IGNORECASE | re.DOTALL,
)
_RAISED = re.compile(r"(?<=[Rℝ])([²³⁴])")
_DIGITS = str.maketrans("²³⁴", "234")


def is_zero_space(text: str) -> bool:
    """Whether a text says that there is nothing but the zero vector: only 0, {(0, 0)}, nur der Nullvektor."""
    bare = _REASON.sub("", text)
    return _ONLY_ZERO.fullmatch(bare) is not None or (bare != text and bare.strip().lower() in (*NONE, "{0}"))


def without_space_words(text: str) -> str:
    """Return a space without the words and the letter that introduce it, R² as R^2."""
    bare = _RAISED.sub(lambda found: f"^{found[1].translate(_DIGITS)}", text)
    return _LEAD.sub("", _LABEL.sub("", bare, count=1), count=1)
