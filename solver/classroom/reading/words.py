"""Verdicts in words: yes and no, and words of which an answer has a list, read however they are written."""

from __future__ import annotations

import re
from collections.abc import Sequence

from solver.classroom.reading.terms import (
    ABBREVIATIONS,
    ADJECTIVES,
    IGNORED,
    NEGATIONS,
    NOUNS,
    PARTS,
    PHRASES,
    SYNONYMS,
)

YES = {"t", "\\checkmark", "yes", "true", "always", "y", "ja", "oui", "wahr", "correct", "holds", "✓"}
NO = {"f", "no", "false", "never", "n", "nein", "non", "falsch", "not", "✗"}
ALL = ("reals", "all", "any", "every", "always", "all reals")
NONE = ("none", "never", "no", "[]", "empty", "trivial", "only the zero vector", "the zero vector", "zero vector",
        "nullvektor", "the trivial space", "trivial space", "keine", "empty set", "the empty set",
        "leere menge", "∅", "no feedthrough", "no direct feedthrough", "kein durchgriff",
        "no segments", "no segments on the real axis", "aucun", "aucune")  # fmt: skip
_REASONED = re.compile(r"\w+\s*(?:[,;:.!(–—]|-(?!\w))")
_DEFECTIVE = re.compile(r"(.*diag.+?)\s*[,;(]\s*(?:(?:not|nicht) )?(?:defective|defekt)\s*\)?\s*\.?", re.IGNORECASE)
_REASON = re.compile(r"\s*[,;:(–—]|\s+(?:since|because|as|although|though|despite|da|weil|denn|obwohl|trotz)\s")
_HENCE = re.compile(
    r"(.+?)(?:\s*[,;.:]|\s)\s*(?:so|hence|therefore|thus|also|daher|folglich|⇒|⟹|→|[=-]>)\s*(?:it is |is )?(.+)"
)
_SUBJECT = re.compile(
    r"^\s*(?:(?:the|das|die|der)\s+)?(?:(?:pair|system|plant|matrix|paar|strecke)\s+)?(?:\(\s*[AC]\s*,\s*[ABC]\s*\)|A)?\s*(?:\bis\b|\bist\b)?\s+(?=\S)"
    r"|^\s*\(\s*[AC]\s*,\s*[ABC]\s*\)\s*(?:is|ist)?\s*",
    re.IGNORECASE,
)
"""What has the property: the pair (A, B) is."""
_SINCE = re.compile(r"\s*(?:[Aa]s|[Ss]ince|[Bb]ecause|[Dd]a|[Ww]eil)\b(.+?)\b(?:the|das|der) \w+ (?:is|ist) (.+)")
_WHOLLY = {
    "vollst",
    "completely",
    "fully",
    "state",
    "vollständig",
    "is",
    "ist",
    "it",
    "es",
    "system",
    "the",
    "das",
    "matrix",
    "closed",
    "loop",
    "der",
    "geschlossene",
    "kreis",
    "regelkreis",
}
_DENIED = {"no", "not", "nicht", "kein", "keine", "but", "aber"}
_YES = re.compile(r"^\s*(?:yes|ja)\s*[,:;–—-]\s*(?:it is |the system is |es ist )?(?=\w)", re.IGNORECASE)
_BESIDE = re.compile(r"(?<=\w)\s*[✓✔!]+\s*$|\s*\(?\b(?:over|über)\s+(?:ℂ|C|the complex numbers)\)?\s*\.?$")
_CRITERION = re.compile(r"\s*(?:det|rank|rang)\b[^,;]*[=<≠][^,;]*[,;]\s*(\S.*)$", re.IGNORECASE | re.DOTALL)
"""det = 0, not controllable: what is concluded stands behind."""
_ANSWERS = {"yes", "no", "ja", "nein", "true", "false", "wahr", "falsch", "oui", "non"}
_FINITE = {"finite", "endlichen", "such", "transmission", "invariant"}

_NONE_SINCE = re.compile(
    r"((?:there (?:is|are) )?(?:none|no(?: \w+){1,3}|keine))\s*"
    r"(?:[,;:]\s*(?=[A-Za-z]{2})|\(|[–—]|\s-\s|\s(?=since|because|as|da|weil))(.+?)\)?\s*\.?",
    re.IGNORECASE,
)
"""None, and why."""
_NONE_ON = re.compile(
    r"(?:there (?:is|are) )?(?:none|keine)\s+(?:on the (?:real|imaginary|jω|jw)[- ]?axis"
    r"|auf der (?:reellen|imaginären) achse|(?:for|für)\s+(?:ω|w|omega|K)\s*>\s*0)\s*\.?",
    re.IGNORECASE,
)
"""None where they might be."""
_NEVER = re.compile(
    r"^\s*(?:(?:never|nie)\s+(?=\w)|((?:not|nicht)\b[^,;]*?)\s+(?:for|für) (?:all|any|every|alle|jedes)(?: values? of)?"
    r" [^\W\d]\w*\s*\.?$)",
    re.IGNORECASE,
)
"""Never controllable, not controllable for any a. What is so for all a is no plain yes: there may be exceptions."""
_CONTRACTED = re.compile(r"(?<=[a-z])(?:'s(?=\s)|n't\b)")
_PREMISE = re.compile(
    r"\s*(?=[^:,;]*[<>=≤≥≠])(?:(?<![^\W\d_])[^\W\d_]{1,2}(?![^\W\d_])|zeta|omega|lambda|sqrt|[\W\d_])+?\s*[:,;]\s*(?=[^\W\d])"
)
"""ζ < 1: what is concluded from a relation."""
_IMAGINARY = ("imaginary", "jω", "jw", "imaginäre")
_REAL = ("real", "reelle")
_CROSSES_NOT = re.compile(
    r"(?:(?:it|the (?:root )?locus|the curve|the plot|root locus|sie|es|die (?:wurzelortskurve|ortskurve))\s+)?"
    r"(?:(?:never|does not|doesn't|doesn’t) (?:cross|meet|intersect|reach)(?:es)? the (\w+)[- ]?axis"
    r"|(?:schneidet|kreuzt|erreicht) die (\w+)[- ]?achse (?:nie|nicht|niemals))\s*\.?",
    re.IGNORECASE,
)
_MISSING = re.compile(
    r"\s*(?:(?:it )?does(?: not|n't|n’t) exist|there is none|existiert nicht|gibt es nicht|n/a|nan|[-–—]"
    r"|(?:the )?(?:phase )?(?:never|does(?: not|n't|n’t)) (?:reach|cross)(?:es)? [-−]180\s?°?"
    r"|(?:die )?phase (?:erreicht|schneidet) [-−]180\s?° (?:nie|nicht))\s*\.?",
    re.IGNORECASE,
)
_SPACE = re.compile(r"(?:ℝ|\\mathbb\{?\s*R\s*\}?|R)\s*\^\s*\{?([1-9])\}?")
_MIXED = re.compile(r"([+-]?)\s*(\d{1,9})\s+(\d{1,9}/\d{1,9})")


def truth(text: str, name: str = "") -> bool | None:
    """Return what a text says of whether something has a property, yes or "not controllable"; None if nothing."""
    text = _CONTRACTED.sub(lambda found: " not" if "n" in found[0] else " is", text.replace("’", "'"))
    text = _NEVER.sub(lambda found: found[1] or "not ", text)
    text = _BESIDE.sub("", _SUBJECT.sub("", " ".join(text.split()), count=1).replace("isable", "izable"))
    said = [word for word in _words(text) if word not in _WHOLLY]
    words = " ".join(said)
    if words in YES | NO or (said and _REASONED.match(text.strip()) and said[0] in YES | NO):
        yes = said[0] in YES
        denied = truth(" ".join(said[1:]), name) is (not yes)  # "yes, it is unobservable" says both
        return None if denied else yes
    own = name.replace("_", " ").lower()
    if own == "diagonalizable" and words.endswith(("defective", "defekt")):
        denied = bool({"not", "nicht"} & set(said[-2:]))
        claimed = truth(found[1], name) if (found := _DEFECTIVE.fullmatch(text)) else denied
        return denied if claimed is denied else None
    adjectives = (own, *ADJECTIVES.get(own, ())) if own else ()
    if words in adjectives:
        return True
    if any(words == f"{negation}{each}" for each in adjectives for negation in NEGATIONS):
        return False
    if (found := _HENCE.match(text)) and own and truth(found[1], name) is None:
        return truth(found[2], name)
    return _with_reason(text, name, {"but", "aber", *adjectives}) if own else None


def _with_reason(text: str, name: str, against: set[str]) -> bool | None:
    """What a text says before its reason, where that denies nothing; words `against` it spoil what is denied."""
    if (found := _CRITERION.match(text)) is not None:
        return truth(found[1], name)
    claim, *reason = _REASON.split(text, maxsplit=1)
    if not reason or not claim.strip():
        return None
    why, said = _words(reason[0].replace("?", " ")), truth(claim, name)
    spoils = against if said is False else _DENIED
    answers = _ANSWERS - {"no"} if said is False and len(why) > 2 else _ANSWERS
    return None if set(why) & (spoils | answers) else said


def is_concluded(text: str) -> bool:
    """Whether a word stands behind a relation that it is concluded from, ζ = 1.25 > 1, overdamped."""
    return _PREMISE.match(text) is not None


def is_name(label: str, name: str) -> bool:
    """Whether what stands before a colon or a sign = may name a yes or no, and says nothing of it: no "No: …"."""
    said = set(_words(label))
    reasons = _REASON.search(label) is not None  # "controllable since rank = n" names nothing
    return not reasons and not said & (YES | NO | _DENIED) and truth(label, name) is not False


def fitting(text: str, known: Sequence[str]) -> list[str]:
    """Return the words of a list that a text may mean: the one that it is, else those that say all that it says."""
    for pattern, words in ABBREVIATIONS:
        text = pattern.sub(words, text)
    text = _YES.sub("", text)
    own = {word for each in known for word in each.split()}
    spoken = " ".join(word if word in own else SYNONYMS.get(word, word) for word in _words(text) if word not in IGNORED)
    spoken = PHRASES.get(spoken, spoken)
    if spoken == "stable" and "asymptotically stable" in known:
        return ["asymptotically stable"]
    for words, part in PARTS.items():
        spoken = spoken if words in known else spoken.replace(words, part)
    parts = set(spoken.split())
    same = [each for each in known if parts == set(each.split())]
    if not same and (found := _HENCE.fullmatch(text)) and not _DENIED & set(_words(found[1])):
        return [] if fitting(found[1], known) else fitting(found[2], known)
    if not same and (found := _PREMISE.match(text)):
        return fitting(text[found.end() :], known)
    if not same and (found := _SINCE.fullmatch(text)) and not _DENIED & set(_words(found[1])):
        return fitting(found[2], known)
    claim, *reason = _REASON.split(text, maxsplit=1)
    if not same and reason and claim.strip() and not _DENIED & set(_words(reason[0])):
        return fitting(claim, known)
    return same or [each for each in known if parts and parts <= set(each.split())]


def is_none(text: str, name: str = "") -> bool:
    """Whether a text says that there is nothing: none, no zeros, keine Nullstellen, none (stable for all K > 0)."""
    if found := _NONE_SINCE.fullmatch(text):
        text = found[1] if not _DENIED & set(_words(found[2])) - {"no", "not", "nicht"} else text
    if text.strip().lower() in NONE or _NONE_ON.fullmatch(text.strip()):
        return True
    if name.endswith("_crossings") and (found := _CROSSES_NOT.fullmatch(text.strip())):
        return (found[1] or found[2]).lower() in (_IMAGINARY if name.startswith("imaginary") else _REAL)
    said = [word for word in _words(text) if word not in _WHOLLY | {"there", "are", "gibt", "has", "hat"}]
    if not said or said[0] not in ("no", "none", "keine"):
        return False
    own = set(name.split("_"))
    *adjectives, noun = said[1:] or [name]
    return set(adjectives) <= own | _FINITE and bool({NOUNS.get(noun, noun), f"{noun}s"} & (own | {name}))


def is_missing(text: str) -> bool:
    """Whether a text says that there is no such value: does not exist, –, never reaches −180°."""
    return _MISSING.fullmatch(text) is not None


def in_words(text: str) -> str:
    """Return a verdict of which no list is known; case, hyphens, underscores and the full stop do not matter."""
    return " ".join(_words(text))


def _words(text: str) -> list[str]:
    return re.sub(r"[-_.!,;:()\"'`$]|\\text|[{}]", " ", text.lower()).split()


def whole_space(text: str) -> int:
    """Return n where a text is the name of a whole space, R^n; else 0."""
    found = _SPACE.fullmatch(text.strip().strip("$"))
    return int(found[1]) if found else 0


def mixed_number(text: str) -> tuple[str, str] | None:
    """Return what 2 3/5 may be, the sum or the product; None of any other text."""
    found = _MIXED.fullmatch(text.strip())
    if found is None:
        return None
    sign, whole, part = found.groups()
    return f"{sign}({whole} + {part})", f"{sign}({whole})*({part})"
