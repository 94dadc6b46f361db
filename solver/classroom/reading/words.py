"""Verdicts in words: yes and no, and words of which an answer has a list, read however they are written."""

from __future__ import annotations

import re
from collections.abc import Sequence

YES = {"yes", "true", "always", "y", "ja", "wahr", "correct", "holds", "✓"}
NO = {"no", "false", "never", "n", "nein", "falsch", "not", "✗"}
_NUMBERS = ("zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")
_COUNT = re.compile(r"(?:rank|rang)\s*[=:]?\s*(\d+)|(\d+)\s+(?:roots?|poles?|eigenvalues?|nullstellen)")
ALL = ("reals", "all", "any", "every", "always", "all reals")
NONE = ("none", "never", "no", "[]", "empty", "trivial", "only the zero vector", "the zero vector", "zero vector",
        "nullvektor", "the trivial space", "trivial space")  # fmt: skip
_REASONED = re.compile(r"\w+\s*[,;:.(–-]")
_WHOLLY = {"completely", "fully", "vollständig", "is", "it", "system", "the", "matrix"}
_IGNORED = {"a", "an", "the", "is", "it", "system", "equilibrium", "point", "matrix", "this", "plant", "ein", "eine",
            "das", "der", "die", "ist", "origin", "loop", "closed"}  # fmt: skip
_SYNONYMS = {"spiral": "focus", "spirale": "focus", "strudel": "focus", "centre": "center", "vortex": "center",
             "wirbel": "center", "zentrum": "center", "asymptotic": "asymptotically", "asymptotisch": "asymptotically",
             "asymp": "asymptotically", "stabil": "stable", "stabiler": "stable", "instabil": "unstable",
             "instabiler": "unstable", "instable": "unstable", "marginal": "marginally", "critically": "marginally",
             "grenzstabil": "marginally stable", "sattel": "saddle", "sattelpunkt": "saddle", "knoten": "node",
             "improper": "degenerate", "posdef": "positive definite", "attractive": "stable",
             "positiv": "positive", "negativ": "negative", "definit": "definite", "semidefinit": "semidefinite",
             "indefinit": "indefinite", "semi": "semi"}  # fmt: skip


def truth(text: str, name: str = "") -> bool | None:
    """Return what a text says of whether something has a property, yes or "not controllable"; None if nothing."""
    said = [word for word in _words(text.replace("isable", "izable")) if word not in _WHOLLY]
    words = " ".join(said)
    if words in YES | NO or (said and _REASONED.match(text.strip()) and said[0] in YES | NO):
        return said[0] in YES
    own = name.replace("_", " ").lower()
    if own == "diagonalizable" and words.endswith("defective"):
        return "not" in said
    if own and words == own:
        return True
    negated = {f"not {own}", f"un{own}", f"non {own}", f"nicht {own}"}
    return False if own and words in negated else None


def fitting(text: str, known: Sequence[str]) -> list[str]:
    """Return the words of a list that a text may mean: the one that it is, else those that say all that it says."""
    said = [word for word in _words(text) if word not in _IGNORED]
    spoken = " ".join(_SYNONYMS.get(word, word) for word in said)
    for negated in ("not asymptotically stable", "not stable"):
        if spoken == negated and negated not in known and "unstable" in known and negated == "not stable":
            return ["unstable"]
    if spoken in known:
        return [spoken]
    parts = set(spoken.split())
    return [each for each in known if parts and parts <= set(each.split())]


def count(text: str) -> str:
    """Return a whole number that is said in words, two, rank 1 or 2 roots, in digits; any other text as it is."""
    bare = text.strip().rstrip(".").lower()
    if found := _COUNT.fullmatch(bare):
        return found[1] or found[2]
    return str(_NUMBERS.index(bare)) if bare in _NUMBERS else text


def in_words(text: str) -> str:
    """Return a verdict of which no list is known; case, hyphens, underscores and the full stop do not matter."""
    return " ".join(_words(text))


def _words(text: str) -> list[str]:
    return re.sub(r"[-_.!,;:\"'`$]|\\text|[{}]", " ", text.lower()).split()
