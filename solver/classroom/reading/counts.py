"""Whole numbers in words: two, rank 2, full rank, 2 roots in the right half plane, none."""

from __future__ import annotations

import re

_ENGLISH = ("zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")
_GERMAN = ("keine", "eins", "zwei", "drei", "vier", "fünf", "sechs", "sieben", "acht", "neun", "zehn")
NUMBERS = {word: i for words in (_ENGLISH, _GERMAN) for i, word in enumerate(words)} | {"eine": 1, "null": 0}
_NONE = {"none", "no", "keine", "kein", "keinen"}
_FULL = {"full", "maximal", "voll", "voller", "vollen"}
_NOUNS = {"rank", "rang", "root", "roots", "pole", "poles", "eigenvalue", "eigenvalues", "nullstelle", "nullstellen",
          "eigenwert", "eigenwerte", "step", "steps", "schritt", "schritte", "schritten", "sample", "samples", "type",
          "period", "periods", "sampling", "abtastperioden",
          "typ", "takt", "takte", "takten", "abtastschritt", "abtastschritte", "abtastschritten", "integrator",
          "integrators", "umläufe", "integratoren", "encirclement", "encirclements", "umrundung",
          "umrundungen", "umschlingung", "umschlingungen", "system"}  # fmt: skip
_FILLING = {"a", "system", "there", "is", "are", "it", "has", "the", "lie", "lies", "es", "gibt", "ist", "hat", "der",
            "liegt", "liegen", "=", "after", "nach"}  # fmt: skip
_OUT_OF = re.compile(
    r"\s*(?:rank|rang)?\s*=?\s*(\d{1,3})\s*(?:<|≠|!=|(?:out )?of|von)\s*(\d{1,3})(?:\s*=\s*n)?\s*$", re.IGNORECASE
)
"""Less than the full number: 2 < 3, rank 2 of 3."""
_HENCE = re.compile(r"\s*(\w+ .+?)\s*[,;]\s*(?:so|hence|thus|also|daher)\s+(\w+)\s*$")
_NOT_FULL = re.compile(
    r"\s*(?:rank|rang)?\s*=?\s*(\d{1,3})\s*[,(]\s*"
    r"(?:(?:so |also )?(?:is )?(?:not|nicht|no|kein)\s+(?:full|voller|maximal)(?: rank| rang)?|rank[- ]deficient)"
    r"\s*\)?\s*\.?",
    re.IGNORECASE,
)
"""Less than the full number, in words."""
_SIGNED = re.compile(r"\s*(?:N\s*=\s*)?[-−](\d+\b.*)")
_IN_BRACKETS = re.compile(r"\s*(?:\w\s*=\s*)?([-+−]?\w+)\s*[,(]\s*([^()]*)\)?\s*")
_EQUALLY = re.compile(r"\s*(\d{1,3})\s*=\s*n\s*$")
_TIMES = {"once": "one", "twice": "two", "einmal": "eins", "zweimal": "zwei"}
_TURNS = re.compile(
    r"\s*(\d+(?=\s*[x×])|\w+)\s*(?:times?|x|×|mal|encirclements?|turns?|umläufe?|umrundung(?:en)?)?[\s,(]+"
    r"(?:in (?:the )?)?"
    r"(?:(c(?:ounter)?[- ]?c(?:lock)?[- ]?w(?:ise)?|counter[- ]?clockwise|anti[- ]?clockwise|gegen den uhrzeigersinn)"
    r"|c(?:lock)?[- ]?w(?:ise)?|im uhrzeigersinn|mit dem uhrzeigersinn)"
    r"(?: direction| sense| encirclements?)?(?: (?:of|around|about|um) (?:the point )?[-−]1)?\s*\)?\s*\.?",
    re.IGNORECASE,
)
"""Turns, which count clockwise."""
_REPEATED = re.compile(
    r"\s*(?:(?:type|typ|rank|rang)[\s-]+)?(\w+)\s*\(\s*(\w+)\s+([^():]+)(?::[^()]*)?\)\s*\.?", re.IGNORECASE
)
_ALL_STABLE = re.compile(
    r"\s*(none|no roots?|0|zero|keine|null)\s*[,;(–—]\s*(?:so |hence |i\.e\. |it is |the system is |all |alle )*"
    r"(?:are |sind |ist )?(?:asymptotically |asymptotisch )?(?:stable|stabil|in the left half[- ]plane|links)"
    r"\s*\)?\s*\.?",
    re.IGNORECASE,
)
"""No root to the right, and what follows from it."""
_ABOUT_MINUS_ONE = re.compile(
    r"\s+(?:of|around|about|um)\s+(?:the point\s+|den punkt\s+)?\(?[-−]1(?:\s*[+,|]\s*j?0)?\)?\s*\.?$", re.IGNORECASE
)
_NOT_ENCIRCLED = re.compile(
    r"\s*(?:(?:the point |der punkt )?[-−]1\s+(?:is|wird)\s+)?"
    r"(?:not encircled|nicht (?:umschlungen|umrundet|umlaufen))\s*\.?",
    re.IGNORECASE,
)
_SINCE = re.compile(
    r"^\s*([\w−-]+)\s*(?:,\s*(?:since|because|as|da|weil|denn)\s.+|\(\s*(?:since|because|as|crosses|da|weil)\b[^()]*\))\s*$",
    re.IGNORECASE,
)
_TYPE = re.compile(
    r"\s*(?:(?:system\s+)?(?:type|typ)[\s-]*)?(I{1,3}|\d(?=[\s-]))(?:[\s-]*(?:type|typ|system))*\s*", re.IGNORECASE
)
_TYPE_BEHIND = re.compile(r"[^\W\d][^\d()]*[\s(](?:type|typ)[\s-]*(I{1,3}|\d)\s*\)?\s*\.?", re.IGNORECASE)
_INTEGRATORS = re.compile(r"\s*(single|one|double|two|triple|three)[ -]integrators?(?: system)?\s*\.?", re.IGNORECASE)
_MANY = {"single": "1", "one": "1", "double": "2", "two": "2", "triple": "3", "three": "3"}
_ROMAN = {"I": "1", "II": "2", "III": "3"}
"""Type II, of a loop with two integrators."""
_PLACES = {
    "right_half_plane_roots": re.compile(
        r"(?:in |on )?(?:open |offenen )?(?:right half ?plane|rhp|rechten halbebene)|rechts"
        r"|unstable|instabile|with positive real parts?|mit positivem realteil"
        r"|(?:sign changes?|changes? of sign|vorzeichenwechsel)(?: in (?:the )?first column)?"
    ),
    "system_type": re.compile(r"(?:at |in )(?:the )?(?:origin|s = 0|z = 1|ursprung)|im ursprung|bei s = 0"),
    **dict.fromkeys(
        ("open_loop_unstable_poles", "closed_loop_unstable_poles"),
        re.compile(
            r"(?:in |on )?(?:open |offenen )?(?:right half ?plane|rhp|rechten halbebene)|rechts|unstable|instabile"
        ),
    ),
    "unstable_poles": re.compile(
        r"(?:outside|außerhalb)(?: of)?(?: des)? (?:unit circle|einheitskreises)|unstable|instabile"
    ),
    "imaginary_axis_roots": re.compile(r"(?:on |auf )(?:imaginary axis|imaginären achse)"),
}


def said(text: str, name: str, most: int | None, *, things: bool) -> str | None:
    """Return what is said of a whole number: by `counted` where an answer counts `things`, else by `whole_number`."""
    return counted(text, name, most) if things else whole_number(text, name)


def whole_number(text: str, name: str) -> str:
    """Return a whole number that is said in words, "two" or "determinant zero", in digits; any other text as it is.

    `name` is that of the answer, "" of any; what names something else, rank 1, says no number of it.
    """
    words = _said(text)
    own = name.lower().split("_") if name else _NOUNS
    bare = [word for word in words if word not in own]
    named = len(words) > 1  # "none" alone may be no number at all
    found = _number(bare[0]) if len(bare) == 1 and (named or bare[0] not in _NONE) else None
    return text if found is None else str(found)


def _count(text: str) -> str:
    """A number of things in digits: two, rank 1, 2 roots; any other text as it is."""
    bare = [word for word in _said(text) if word not in _NOUNS]
    found = _number(bare[0]) if len(bare) == 1 else None
    return text if found is None else str(found)


def counted(text: str, name: str, most: int | None) -> str | None:
    """Return the number of an answer that counts: as in `whole_number`, where `full` is `most`, and none is 0.

    None where that is not clear: what is full is not known, or is another number; or what is counted lies elsewhere.
    """
    text = _bare(text, name)
    if name == "encirclements" and (turns := _turned(text)) != text:
        return turns
    if (less := _less_than_full(text, most)) != text:
        return less
    if (found := _REPEATED.fullmatch(text)) and _number(found[1].lower()) == _number(found[2].lower()) is not None:
        text = f"{found[2]} {found[3]}"  # 2 (two sign changes)
    if (found := _HENCE.match(text)) and _count(found[1].split(maxsplit=1)[0]) == _count(found[2]):
        text = found[1]  # two sign changes, so 2
    words = _said(text)
    bare = [word for word in words if word not in _NOUNS | _FULL]
    full = any(word in _FULL for word in words)
    if full and not bare:
        return None if most is None else str(most)
    number = _number(bare[0]) if bare and words != ["no"] else None
    own, places = name.split("_"), _PLACES.get(name)
    found_at = [" ".join(bare[1:]), " ".join(word for word in bare[1:] if word not in own)]
    if number is None or (all(found_at) and places is None):
        return None if full else text
    elsewhere = all(found_at) and places is not None and not any(map(places.fullmatch, found_at))
    return None if elsewhere or (full and most not in (None, number)) else str(number)


def _less_than_full(text: str, most: int | None) -> str | None:
    """The number of 2 < 3, 1 (not full rank) or 2 = n, None where that is not true; any other text as it is."""
    if most is None:
        return text
    if found := _NOT_FULL.fullmatch(text):
        return found[1] if int(found[1]) < most else None
    if (found := _OUT_OF.match(text)) and int(found[1]) < int(found[2]) == most:
        return found[1]
    if (found := _EQUALLY.match(text)) and most == int(found[1]):
        return found[1]
    return text


def _turned(text: str) -> str | None:
    """Turns in digits, None where a remark beside them says another number; any other text as it is."""
    if (turns := _turns(text)) is not None:
        return turns
    if (signed := _SIGNED.fullmatch(text)) and (turns := _turns(signed[1])) is not None:
        return turns if turns.startswith("-") else None  # -1 (ccw)
    found = _IN_BRACKETS.fullmatch(text)
    turns = _turns(found[2]) if found else None
    if found is None or turns is None:
        return text
    return turns if turns == found[1].replace("−", "-") else None


def _turns(text: str) -> str | None:
    """Turns that are said with their sense; None of any other text."""
    found = _TURNS.fullmatch(text)
    turns = _number(_TIMES.get(found[1].lower(), found[1].lower())) if found else None
    return None if found is None or turns is None else str(-turns if found[2] else turns)


def _bare(text: str, name: str) -> str:
    """A type in digits, encirclements without the point they go round, no root to the right without what follows."""
    if name == "right_half_plane_roots" and _ALL_STABLE.fullmatch(text):
        return "0"
    if name == "system_type" and (found := _TYPE.fullmatch(text)):
        return _ROMAN.get(found[1].upper(), found[1])
    if name == "system_type" and (found := _TYPE_BEHIND.fullmatch(text)):
        return _ROMAN.get(found[1].upper(), found[1])
    if name == "system_type" and (found := _INTEGRATORS.fullmatch(text)):
        return _MANY[found[1].lower()]
    if name == "encirclements":
        text = "0" if _NOT_ENCIRCLED.fullmatch(text) else _ABOUT_MINUS_ONE.sub("", text)
    return _SINCE.sub(r"\1", text)


def _number(word: str) -> int | None:
    if word.isdecimal():
        return int(word)
    return 0 if word in _NONE else NUMBERS.get(word)


def _said(text: str) -> list[str]:
    """The words of a text without those that say nothing."""
    bare = re.sub(r"[(),:;]|(?<=half)-(?=plane)|-(?=loop\b)|\.\s*$", " ", text.lower().replace("=", " = "))
    return [word for word in bare.split() if word not in _FILLING]
