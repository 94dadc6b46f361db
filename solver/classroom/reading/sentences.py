"""Values within sentences: "The eigenvalues are 1 and 3.", "K = [k1 k2] = [18 6]", "about 1.2", "-3 (stable)".

Only words of a closed list are left out, so that nothing that denies or limits a value is: of "at most 2" and "not 3"
nothing is read. What is left is read like any other text.
"""

from __future__ import annotations

import re

from solver.classroom.reading.brackets import split
from solver.classroom.reading.counts import NUMBERS

MOST_SIDES = 6
_SIDES = re.compile(r"\s*(?:≈|≅|:=|(?<![<>=!:≤≥])==?(?![=>]))\s*")
_SPACES = re.compile(r"[^\S\n]+|\n\s*\n")
"""Runs of spaces, which patterns would go through again and again."""
_SO = re.compile(
    r"\s*[,;.]?\s*(?:⇒|⟹|→|=>|->|\\Rightarrow|\\implies"
    r"|\b(?:hence|therefore|thus|so|daher|folglich)\b)\s*"
)
_WORD = re.compile(r"\s*([^\W\d_][^\W\d_]+)(?![\w(^])[,:]?\s*(?=\S)")
_ABOUT = re.compile(
    r"\s*(?:~|∼|≈|≅|\\approx|\\sim|(?:(?:a )?factor(?: of)?|faktor|exactly|genau"
    r"|approx(?:imately)?|about|circa|ca|roughly|rund|etwa|ungefähr)\b\.?)\s*",
    re.IGNORECASE,
)
_UNIT = re.compile(r"(?<=[\w).])\s*\[\s*(rad/s|1/s|s)\s*\]\s*$")
_POSITIVE = re.compile(r"\s*(?:\(\s*)?(?:>|≻|\\succ)\s*0\s*\)?\s*$")
_REMARKS = (
    "breakaway break-away break-in entry exit point points different verschieden asymptotically asymptotisch"
    " stable unstable stabil instabil controller observer regler beobachter plant strecke repeated real reell row"
    " zeile column spalte nonzero non-zero complex conjugate conjugates conjugated pair konjugiert komplex"
    " konjugierte komplexe positive positives negative negatives root solution lösung wurzel"
    " pole poles pol mode eigenvalue eigenwert"
    " constant konstant konstante underdamped overdamped undamped critically damped damping nonminimum non-minimum"
    " minimum phase first second third fourth state slow fast dominant oscillating oscillation oscillatory"
    " decaying distinct simple stabilizing stabilising stabilisierend stabilisierende integrator marginal exact"
    " critical vertical upper lower horizontal lag lead zero zeros asymptote asymptotes one two three corner"
    " golden ratio vector left right half plane halfplane half-plane lhp rhp open linke rechte halbebene"
    " purely imaginary rein imaginär imaginäre"
)
"""Words of which remarks in brackets are made that deny nothing."""
_WORDS = "|".join(sorted(_REMARKS.split(), key=len, reverse=True))
_REMARK = re.compile(
    rf"\s*\(\s*(?:(?:(?:(?:{_WORDS}|all|both|beide|and|und|the|of|in)[\s,]+){{0,6}}(?:{_WORDS}))|type? \d"
    r"|[25] ?%(?:[ -](?:band|criterion|kriterium))?|not zero"
    r"|only at infinity)\s*\)",
    re.IGNORECASE,
)
_SINCE = re.compile(
    r"\s*\(\s*(?:since|because|as|from|by|weil|da|denn|aus|wegen)\s+[^()]*(?:\([^()]*\)[^()]*)*\)\s*\.?$", re.IGNORECASE
)
_INFINITE = re.compile(r"^([^()]*(?:∞|\binf|\binfinity|\binfinite|\boo|unendlich))\s*\([^()]*\)\s*\.?$")
_REFUSED = re.compile(
    r"\s*[,;(]\s*(?:the other(?: one)?[^()]*?|die andere[^()]*?|[-−+\d./√ ]+)\s*(?:(?:is|lies|does|ist|liegt)\s+)?"
    r"(?:not (?:lie )?on the (?:root )?locus|rejected|discarded|no breakaway point"
    r"|nicht auf der (?:wok|wurzelortskurve))"
    r"\s*\)?\s*\.?$",
    re.IGNORECASE,
)
"""What was found too, and is none."""
_LOST = re.compile(
    r"\s*\(\s*(?:uncontrollable|unobservable|hidden|not (?:controllable|observable)"
    r"|nicht (?:steuerbar|beobachtbar))\s*\)"
)
_MANY = re.compile(
    r"^(.*?)\b(?:double|doppelter|doppelte|zweifacher)\s+(?:eigenvalue|pole|root|eigenwert|pol)\s+(?:at |bei )?(.*)$",
    re.IGNORECASE,
)
_DOUBLE = re.compile(r"\s*,\s*(double|doppelt|twice|triple|dreifach)\s*(?:eigenvalue|root|pole)?\s*$", re.IGNORECASE)
_PAIR = re.compile(
    r"(?<=[\s,])(?:the\s+|das\s+)?(?:complex\s+|konjugierte\s+|komplexe\s+)?(?:pair|paar)\s+", re.IGNORECASE
)
_OF = re.compile(r"\s*(?:of|von)\s+(?:the\s+)?(?:[A-Z]|\([A-Z],\s*[A-Z]\))\s+(?=\S)")
_IS = re.compile(r"(?<=[\w})])\s+(?:is|ist|equals)\s+(?=[-+−\d.√(])")

_ASYMPTOTE = re.compile(r"^\s*(?:(?:one|two|three|four|\d) )?asymptotes? (?:at|with angles?(?: of)?) ", re.IGNORECASE)
_ONE = re.compile(
    r"^\s*(?:(?:one|a|single|eine?) (?:(?:finite|real|stable) )?(?:(zero|pole|point|nullstelle|pol) )?"
    r"|(?:the )?break-?(?:away|in)(?: point)? )(?:at|bei) ",
    re.IGNORECASE,
)
"""One zero at -2: of several the number says how often."""
_COMPARED = re.compile(
    r"(?<![\w.)])([-+−]?\s*\d{1,9}(?:\.\d{1,9})?)\s*\(?\s*([<>])\s*(\d{1,3}(?:\.\d{1,3})?)(?![.\d])\s*\)?"
)
_TWO = re.compile(r"±|\+/-|\+-|\\pm")
_NUMBERS = re.compile(r"[-+−]?[\d.]+\s*(?:[,;]|\band\b|\bund\b)\s*[-+−]?[\d.]+")
_BRACKETS = re.compile(r"\([^()]*\)|\[[^\[\]]*\]|\{[^{}]*\}")
_DENIED = re.compile(
    r"\b(?:not|no|nicht|kein\w*|never|neither|nor|and|or|und|oder|but|aber|if|unless|without|wrong|false)\b|[≠;,\n]",
    re.IGNORECASE,
)

_LAST_WORDS = re.compile(
    r"\s*[^\W\d_]{2,}(?:[ ,-]{1,3}[^\W\d_]{2,})*(?:(?<=rank) \d|(?<=rang) \d)?\s*[.!]?\s*", re.IGNORECASE
)
_NUMBERED = frozenset({"infinity", "infinite", "unendlich", "inf", "zero", "null", *NUMBERS})
_THAT_IS = re.compile(r"\s*[,;]?\s*(?:\bi\.\s?e\.|\bd\.\s?h\.|\bthat is|\bdas heißt)[,:]?\s*")

FILLING = frozenset(
    "the of is are at be lie lies equals equal to we get obtain have has result answer value values it"
    " tends goes decays approaches settles geht gegen strebt converges only der die das des ist sind lautet lauten bei"
    " liegt liegen beträgt ergibt sich zu mit with and und system matrix plant origin there result results final"
    " solution ergebnis endergebnis antwort lösung somit damit folgt".split()
)  # fmt: skip
NOUNS = {
    "eigenvalues": "eigenvalue eigenvalues eigenwert eigenwerte pair poles",
    "poles": "pole poles polstellen eigenvalues pair",
    "zeros": "zero zeros nullstelle nullstellen transmission",
    "modes": "mode modes eigenvalue eigenvalues eigenwert eigenwerte moden modus hidden",
    "polynomial": "characteristic polynomial charakteristische charakteristisches polynom closed-loop",
    "G": "transfer function übertragungsfunktion",
    "K": "gain feedback controller rückführung regler verstärkung state",
    "L": "observer gain beobachter beobachterverstärkung",
    "rank": "rank rang",
    "determinant": "determinant determinante",
    "points": "two three four five equilibria equilibrium point points ruhelagen ruhelage gleichgewichte",
    "solutions": "solution solutions lösung lösungen",
    "closed_loop_A": "companion closed-loop",
    "cancelled": "pole poles zero zeros factor mode modes hidden cancelled pol nullstelle",
    "gain_crossover": "frequency durchtrittsfrequenz durchtrittskreisfrequenz schnittfrequenz",
    "phase_crossover": "frequency nyquist phasenschnittfrequenz phasendurchtrittsfrequenz",
    "gain_margin": "amplitudenreserve amplitudenrand verstärkungsreserve",
    "gain_margin_db": "amplitudenreserve amplitudenrand verstärkungsreserve",
    "phase_margin": "phasenreserve phasenrand",
    "overshoot": "maximum percent überschwingen überschwingweite",
    "rise_time": "anstiegszeit anregelzeit",
    "settling_time": "ausregelzeit einschwingzeit",
    "natural_frequency": "undamped eigenfrequenz kennkreisfrequenz",
    "damping_ratio": "damping dämpfung dämpfungsgrad dämpfungsmaß",
    "error": "steady state bleibende regelabweichung regelfehler",
    "bandwidth": "frequency bandbreite",
    "magnitude": "amplitude betrag",
    "phase": "angle shift phasenverschiebung phasenwinkel",
    "dc_gain": "static statische verstärkung",
    "centroid": "schwerpunkt wurzelschwerpunkt asymptotes",
    "null_space": "all multiples vielfache von spanned by span",
}
"""What an answer is called in a sentence, by its name, or the last word of its name."""


def without_words(text: str, name: str, *, count: bool = False) -> str:
    """Return a value without the words that introduce it and the remarks behind its items; "" where there are none."""
    called = NOUNS.get(name, NOUNS.get(name.rpartition("_")[2], ""))
    nouns = frozenset([*called.split(), name.lower(), *name.lower().split("_")])
    text = _SPACES.sub(" ", text).strip()
    remarked = text if name.endswith("_modes") else _LOST.sub("", text)
    remarked = _REFUSED.sub("", _INFINITE.sub(r"\1", _SINCE.sub("", remarked)))
    bare = _introduced(_REMARK.sub("", _UNIT.sub(r" \1", remarked)), nouns)
    if (found := _ONE.match(bare)) and {found[1], f"{found[1]}s"} & {None, *nouns}:
        bare = bare[found.end() :]
    bare = _ASYMPTOTE.sub("", _PAIR.sub("", bare))
    if found := _MANY.match(bare):
        bare = _introduced(f"{found[1]}{found[2]} (double)", nouns)
    bare = _DOUBLE.sub(r" (\1)", bare)
    if not count:
        bare = _ABOUT.sub("", bare, count=1) if _ABOUT.match(bare) else bare
        bare = re.sub(r"=\s*(?:~|ca\.?|about|approx\.?)\s*(?=\d)", "= ", bare)
    bare = _IS.sub(" = ", bare)
    return bare if bare != text and bare.strip() else ""


def _introduced(text: str, nouns: frozenset[str]) -> str:
    """A text from its first word on that does not belong to an introduction."""
    at = 0
    while found := _OF.match(text, at) or _WORD.match(text, at):
        if found.re is _WORD and found[1].lower() not in FILLING | nouns:
            break
        at = found.end()
    return text[at:].rstrip().rstrip(".") if at else text


def with_true_signs(text: str) -> str:
    """Return λ₁ = 1 > 0, ζ = 0.6 < 1 without what a plain number is compared with, if that is true; else ""."""
    found = list(_COMPARED.finditer(text))
    pairs = [(float(match[1].replace("−", "-").replace(" ", "")), match[2], float(match[3])) for match in found]
    true = all(one > other if sign == ">" else one < other for one, sign, other in pairs)
    return _COMPARED.sub(r"\1", text) if found and true else ""


def sides_of(text: str) -> list[str]:
    """Return the sides of K = [k1 k2] = [18 6], or of (s+4)(s+5) = s^2 + 9s + 20; none where it is no such chain.

    The last side may be a list, where two values stand before it: -3 ± √3 = -1.27, -4.73.
    """
    pieces = split(_POSITIVE.sub("", text), _SIDES)
    sides = [each.strip() for each in pieces]
    *first, last = sides or [""]
    bare = all(sides) and not any(_DENIED.search(_outside_brackets(each)) for each in first)
    listed = bool(first) and _TWO.search(first[-1]) is not None and _NUMBERS.fullmatch(last) is not None
    bare = bare and (listed or not _DENIED.search(_outside_brackets(last)))
    return sides if bare and 1 < len(sides) <= MOST_SIDES else []


def _outside_brackets(text: str) -> str:
    """What stands in no bracket of a text."""
    while (bare := _BRACKETS.sub("", text)) != text:
        text = bare
    return text


def premise(text: str) -> str:
    """Return what stands before a last "hence" behind which only words follow, 0.33 → unstable; "" of other texts."""
    text = _SPACES.sub(" ", text).strip()
    *before, last = split(text, _SO) or [""]
    said = _LAST_WORDS.fullmatch(last) and not {*last.lower().strip(" .").split()} & _NUMBERED
    ends = [found.start() for found in _SO.finditer(text)]
    return text[: ends[-1]].rstrip() if before and said and ends else ""


def as_equation(text: str) -> str:
    """Return 6 = 15.56 dB of "6, i.e. 15.56 dB"; any other text as it is."""
    return _THAT_IS.sub(" = ", _SPACES.sub(" ", text))


def concluded(text: str) -> str:
    """Return what stands behind the last "hence", =>, "so"; "" where there is nothing of the kind."""
    pieces = split(_SPACES.sub(" ", text), _SO)
    return pieces[-1].strip() if len(pieces) > 1 else ""
