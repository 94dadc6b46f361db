"""Whole numbers in words: two, rank 2, full rank, 2 roots in the right half plane, none."""

from __future__ import annotations

import re

_ENGLISH = ("zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")
_GERMAN = ("keine", "eins", "zwei", "drei", "vier", "fünf", "sechs", "sieben", "acht", "neun", "zehn")
_NUMBERS = {**{word: i for i, word in enumerate(_ENGLISH)}, **{word: i for i, word in enumerate(_GERMAN)}, "eine": 1}
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
_EQUALLY = re.compile(r"\s*(\d{1,3})\s*=\s*n\s*$")
_TIMES = {"once": "one", "twice": "two", "einmal": "eins", "zweimal": "zwei"}
_TURNS = re.compile(
    r"\s*(\w+)\s*(?:times?|mal|encirclements?|turns?|umläufe?|umrundung(?:en)?)?[\s,(]+(?:in (?:the )?)?"
    r"(?:(c(?:ounter)?[- ]?c(?:lock)?[- ]?w(?:ise)?|counter[- ]?clockwise|anti[- ]?clockwise|gegen den uhrzeigersinn)"
    r"|c(?:lock)?[- ]?w(?:ise)?|im uhrzeigersinn|mit dem uhrzeigersinn)"
    r"(?: direction| sense| encirclements?)?(?: (?:of|around|about|um) (?:the point )?[-−]1)?\s*\)?\s*\.?",
    re.IGNORECASE,
)
"""Turns, which count clockwise."""
_REPEATED = re.compile(
    r"\s*(?:(?:type|typ|rank|rang)[\s-]+)?(\w+)\s*\(\s*(\w+)\s+([^():]+)(?::[^()]*)?\)\s*\.?", re.IGNORECASE
)
_ABOUT_MINUS_ONE = re.compile(
    r"\s+(?:of|around|about|um)\s+(?:the point\s+|den punkt\s+)?[-−]1(?:\s*[+,|]\s*j?0)?\s*\.?$", re.IGNORECASE
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
    "imaginary_axis_roots": re.compile(r"(?:on |auf )(?:imaginary axis|imaginären achse)"),
}


def count(text: str) -> str:
    """Return a whole number that is said in words, two, rank 1 or 2 roots, in digits; any other text as it is."""
    said = _said(text)
    bare = [word for word in said if word not in _NOUNS]
    named = len(said) > 1  # "none" alone may be no number at all
    number = _number(bare[0]) if len(bare) == 1 and (named or bare[0] not in _NONE) else None
    return text if number is None else str(number)


def counted(text: str, name: str, most: int | None) -> str | None:
    """Return the number of an answer that counts: as in `count`, where `full` is `most`, and none is 0.

    None where that is not clear: what is full is not known, or is another number; or what is counted lies elsewhere.
    """
    text = _bare(text, name)
    if name == "encirclements" and (found := _TURNS.fullmatch(text)):
        number = _number(_TIMES.get(found[1].lower(), found[1].lower()))
        return None if number is None else str(-number if found[2] else number)
    if (found := _REPEATED.fullmatch(text)) and _number(found[1].lower()) == _number(found[2].lower()) is not None:
        text = f"{found[2]} {found[3]}"  # 2 (two sign changes)
    if (found := _OUT_OF.match(text)) and most is not None and int(found[1]) < int(found[2]) == most:
        return found[1]
    if (found := _HENCE.match(text)) and count(found[1].split(maxsplit=1)[0]) == count(found[2]):
        text = found[1]  # two sign changes, so 2
    if (found := _EQUALLY.match(text)) and most == int(found[1]):
        return found[1]
    said = _said(text)
    bare = [word for word in said if word not in _NOUNS | _FULL]
    full = any(word in _FULL for word in said)
    if full and not bare:
        return None if most is None else str(most)
    number = _number(bare[0]) if bare and said != ["no"] else None
    place, places = " ".join(bare[1:]), _PLACES.get(name)
    place = "" if set(bare[1:]) <= set(name.split("_")) else place
    if number is None or (place and places is None):
        return None if full else text
    elsewhere = place and places is not None and not places.fullmatch(place)
    return None if elsewhere or (full and most not in (None, number)) else str(number)


def _bare(text: str, name: str) -> str:
    """A type in digits, encirclements without the point that they go round."""
    if name == "system_type" and (found := _TYPE.fullmatch(text)):
        return _ROMAN.get(found[1].upper(), found[1])
    if name == "system_type" and (found := _INTEGRATORS.fullmatch(text)):
        return _MANY[found[1].lower()]
    if name == "encirclements":
        text = "0" if _NOT_ENCIRCLED.fullmatch(text) else _ABOUT_MINUS_ONE.sub("", text)
    return _SINCE.sub(r"\1", text)


def _number(word: str) -> int | None:
    if word.isdecimal():
        return int(word)
    return 0 if word in _NONE else _NUMBERS.get(word)


def _said(text: str) -> list[str]:
    """The words of a text without those that say nothing."""
    bare = re.sub(r"[(),:;]|(?<=half)-(?=plane)|\.\s*$", " ", text.lower().replace("=", " = "))
    return [word for word in bare.split() if word not in _FILLING]
