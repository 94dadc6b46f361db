"""Conditions in the words and signs of students and of other programs, as relations: K positive and less than 48.

Only text is changed here; nothing is evaluated. What is unclear, as the ends of "between 0 and 48", stays as it is.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from solver.classroom.reading.brackets import enclosed, matching, split

Change = str | Callable[[re.Match[str]], str]

_NUMBER = r"[+-]?(?:\d+(?:\.\d+)?(?:/\d+)?|oo|inf|∞)"
_OPEN = r"\(?\s*(?:exclusive|exclusively|strictly|ends? excluded|open|exklusiv|offen|ausschließlich)\s*\)?"
_CLOSED = r"\(?\s*(?:inclusive|inclusively|ends? included|closed|inklusive|einschließlich)\s*\)?"
_LESS = r"(?:strictly )?(?:less|smaller|lower|below|kleiner|under)(?: than| als)?"
_MORE = r"(?:strictly )?(?:greater|larger|bigger|more|above|größer|grösser|over)(?: than| als)?"

TABLE: tuple[tuple[re.Pattern[str], Change], ...] = tuple(
    (re.compile(pattern, re.IGNORECASE), change)
    for pattern, change in (
        (r"^\s*∀\s*", ""),
        (r"^\s*(?:not possible|impossible|nicht möglich|unmöglich|never(?: stable)?|nie stabil"
         r"|unstable for (?:all|any) \w+)\s*[,;(:–—]\s*(?:since|because|as|da|weil|denn)\b.*$", "never"),
        (r"^\s*(?:always(?: stable)?|immer stabil|stable for all \w+)\s*[,;(:–—]\s*"
         r"(?:since|because|as|da|weil|denn)\b.*$", "always"),
        (r"^\s*(?:for |für )?(?:all |alle )?(?:real |reellen? )?[A-Za-z]\w*\s*(?:∈|\\in\b|\bin\b)\s*"
         r"(?:ℝ|R|reals?|\\mathbb\s*\{?R\}?)\s*$", "always"),
        (r"^\s*(?:none|there is no(?: such)?(?: value of)? [A-Za-z]\w*|not stable for any [A-Za-z]\w*"
         r"|impossible|unmöglich|keine? werte? (?:von|für) [A-Za-z]\w*)\s*$", "never"),
        (r"\s*,?\s*\(?(?:strictly|streng)\)\s*$", ""),
        (r"\s*[,;]\s*(?:and |und )?(?:(?:otherwise|else|sonst) (?:it is )?(?:unstable|instabil)"
         r"|(?:unstable|instabil) (?:otherwise|else|sonst))\s*\.?\s*$", ""),
        (r"\s*,?\s*\(?\b(?:for|für) (?:asymptotic |asymptotische |closed-loop )?(?:stability|stabilität)\)?\s*\.?\s*$",
         ""),
        (r"^\s*(?:for|für) (?:asymptotic |asymptotische |closed-loop )?(?:stability|stabilität)\s*[:,]?\s*(?=\S)", ""),
        (r"\b(?:must|has to|have to|should|muss|soll)\s+(?:be |lie |liegen )?(?=between\b|in\b|zwischen\b)", ""),
        (r"\b(?:muss|soll)\s+(?=(?:zwischen|between)\b)", ""),
        (r"([A-Za-z]\w*)\s*<\s*min\s*[({]([^(){},]+),([^(){},]+)[)}]", r"\1 < \2 and \1 <\3"),
        (r"max\s*[({]([^(){},]+),([^(){},]+)[)}]\s*<\s*([A-Za-z]\w*)", r"\1 < \3 and \2 < \3"),
        (r"(?<=\d)\s*[,;]\s*(?:and |und )?(?:marginally stable|grenzstabil|unstable|instabil)\s+"
         r"(?:for|für|if|at|bei)\s+[^,;]*$", ""),
        (r"\b(?:has|needs|have|ought) to be\b|\bshould be\b", "must be"),
        (r"^[^<>≤≥≠]*?\b[A-Za-z]\w* ?= ?[\d./]+\s*[,;]\s*(?:so|hence|thus|therefore|also|⇒|→|=>)\s+(?=\S)", ""),
        (r"^\s*(?:it is |(?:the |das |der )?(?:(?:closed[ -])?(?:system|loop)|regelkreis) (?:is|ist) |is )?"
         r"(?:asymptotically |asymptotisch )?(?:stable|stabil)\s+"
         r"(?:(?:exactly |precisely |genau )?(?:for|if and only if|if|iff|when|where|as long as|für|wenn|falls)\s+)?"
         r"(?=\S)", ""),
        (r"^\s*(?:for |für )?(?:all|every|any|alle|jedes)\s+positive?[rns]?\s+(?:values? (?:of )?)?([A-Za-z]\w*)\s*$",
         r"\1 > 0"),
        (r"\s*(?:∈|\bin\b|\belem\b)\s*(?:ℝ|R|\(?R)(?:\s*\^?\s*[({]?\s*(?:⁺|\+)\s*[)}]?|_?[({]?\s*>\s*0\s*[)}]?)\s*\)?\s*$",
         " > 0"),
        (r"^\s*(?:for|für)?\s*(?:all|every|any|alle)\s+(?:real\s+|reellen\s+)?(?:values of\s+)?[A-Za-z]\w*\s*$",
         "always"),
        (r"^\s*(?:for |für )?(?:no|kein(?:e[mns]?)?)(?: real| reelles?)?(?: values?| werte?)?(?: of| von)?"
         r" [A-Za-z]\w*\s*$", "never"),
        (r"^\s*(?:always |immer )?(?:unstable|instabil) (?:for|für) (?:all|every|any|alle|jedes)"
         r"(?: real| reellen)?(?: values of)? [A-Za-z]\w*\s*$", "never"),
        (r"^\s*(?:never stable|nie(?:mals)? stabil|always unstable|immer instabil|∅|\{\s*\}|(?:the )?empty set"
         r"|(?:die )?leere menge)\s*$", "never"),
        (r"^[^<>≤≥]*[<>≤≥].*(?:[,;.]\s*(?:so|hence|thus|therefore|also|d\.h\.|i\.e\.)|⇒|→|=>|⟹)\s*"
         r"(?=[^<>≤≥]*[<>≤≥∈])", ""),
        (r"^\s*(?:for|if|iff|when|für|wenn|falls)\s+(?=\S)", ""),
        (r"^\s*(?:all|every|any|alle)\s+(?=[A-Za-z]\w*\s)", ""),
        (r"\s*\((?:asymptotically |asymptotisch )?(?:stable|stabil)\)\s*$", ""),
        (r"\s*\((?:by |from |nach |aus )?(?:the )?(?:routh|hurwitz|routh[-–]hurwitz|jury)(?:['’]s)?"
         r"(?:[ -](?:criterion|array|table|test|kriterium|schema))?\)\s*$", ""),
        (r"\s*[.]\s*$", ""),
        (r"\s+for all\s+(?=[A-Za-z]\w*\s*[<>])", " "),
        (rf"^\s*([A-Za-z])_?\{{?min\}}?\s*=\s*({_NUMBER})\s*(?:,|;|\band\b|\bund\b)\s*\1_?\{{?max\}}?\s*=\s*({_NUMBER})\s*$",
         r"\1 between \2 and \3"),
        (rf"^\s*([A-Za-z])_?\{{?max\}}?\s*=\s*({_NUMBER})\s*(?:,|;|\band\b|\bund\b)\s*\1_?\{{?min\}}?\s*=\s*({_NUMBER})\s*$",
         r"\1 between \3 and \2"),
        (r"^\s*([A-Za-z]\w*)\s*=\s*(?=[(\[\]][^()\[\]]*[,;][^()\[\]]*[)\]\[]\s*$)", r"\1 ∈ "),  # K = (0, 4)
        (r"^([^≤≥=]*?)\s*\(\s*(?:open interval|offenes intervall)\s*\)\s*$", r"\1"),
        (rf"^\s*([A-Za-z])_?\{{?min\}}?\s*=\s*({_NUMBER}\s*[<≤]=?\s*\1\s*[<≤]=?\s*)\1_?\{{?max\}}?\s*=\s*({_NUMBER})\s*$",
         r"\2\3"),
        (r"\bis(?=\s+between\b)|\bist(?=\s+zwischen\b)|\blies(?=\s+between\b)", ""),
        (rf"\bbetween\s+({_NUMBER})\s+and\s+({_NUMBER})\s*,?\s*{_OPEN}", r"∈ (\1, \2)"),
        (rf"\bbetween\s+({_NUMBER})\s+and\s+({_NUMBER})\s*,?\s*{_CLOSED}", r"∈ [\1, \2]"),
        (rf"(?<=\w)\s+(?:from|von)\s+({_NUMBER})\s*(?:to|bis)\s*({_NUMBER})\s*,?\s*{_OPEN}", r" ∈ (\1, \2)"),
        (rf"(?<=\w)\s+(?:from|von)\s+({_NUMBER})\s*(?:to|bis)\s*({_NUMBER})\s*,?\s*{_CLOSED}", r" ∈ [\1, \2]"),
        (rf"(?:\bfrom\s+)?({_NUMBER})\s*(?:to|bis|\.\.|…)\s*({_NUMBER})\s*,?\s*{_OPEN}", r"(\1, \2)"),
        (rf"(?:\bfrom\s+)?({_NUMBER})\s*(?:to|bis|\.\.|…)\s*({_NUMBER})\s*,?\s*{_CLOSED}", r"[\1, \2]"),
        (r"\b(?:is\s+|ist\s+)?(?:non-?\s?negative|nicht ?negativ)\b", ">= 0"),
        (r"\b(?:is\s+|ist\s+)?(?:non-?\s?positive|nicht ?positiv)\b", "<= 0"),
        (r"\b(?:is\s+|ist\s+|must be\s+)?(?:strictly )?positive?\b", "> 0"),
        (r"\b(?:is\s+|ist\s+|must be\s+)?(?:strictly )?negative?\b", "< 0"),
        (rf"\b(?:is\s+|ist\s+|must be\s+)?{_LESS} or equal(?: to)?\b", "<="),
        (rf"\b(?:is\s+|ist\s+|must be\s+)?{_MORE} or equal(?: to)?\b", ">="),
        (r"\b(?:is\s+|ist\s+|must be\s+)?(?:at most|höchstens)\b", "<="),
        (r"\b(?:is\s+|ist\s+|must be\s+)?(?:at least|mindestens)\b", ">="),
        (rf"\b(?:is\s+|ist\s+|must be\s+)?{_LESS}(?=\s)", "<"),
        (rf"\b(?:is\s+|ist\s+|must be\s+)?{_MORE}(?=\s)", ">"),
        (r"\s(?:elem|element of|is an element of|is in|lies in|liegt in|ist in|aus)\s+(?=[\[(\]])", " ∈ "),
        (r"^\s*[A-Za-z]\w*\s*(?:∈|\bin\b)\s*(?:ℝ|R\b|reals?)\s*(?:[,;:]|\band\b|\bund\b)\s*(?=\S)", ""),
        (r"\s*[,;]\s*[A-Za-z]\w*\s*(?:∈|\bin\b)\s*(?:ℝ|R|reals?)\s*$", ""),
        (r"\s*(?:∈|\bin\b)\s*(?:ℝ|\bR\b|reals?)\s*$", ""),
        (r"\s*,?\s*\b[A-Za-z]\w* (?:real|reell)$", ""),
        (r"\s+but\s+|\s+aber\s+", " and "),
        (r"∉\s*\[([^\[\](),;]+)[,;]([^\[\](),;]+)\]", r"∈ (-oo, \1) ∪ (\2, oo)"),
        (r"/\\", " and "),
        (r"\\/", " or "),
    )
)  # fmt: skip
"""What is said in words, and the relation that it is."""
_BETWEEN = re.compile(
    rf"\b(?:between|zwischen)\s+({_NUMBER})\s+(?:and|und)\s+({_NUMBER})|(?:\bfrom|\bvon)\s+({_NUMBER})\s*(?:to|bis)\s*({_NUMBER})"
)

_BARS = re.compile(r"(?<![A-Za-z_)\]|])\s*\|([^|<>=≤≥≠]+)\|(?=\s*(?:[<>=≤≥≠*/+^-]|$))")
_SOLVED = re.compile(r"(?:\w+\.)*(?:solve|reduce|Reduce|Solve)\s*[(\[]")
_SUCH_THAT = re.compile(
    r"^\{\s*([^\W\d]\w*)\s*(?:(?:∈|\bin\b)\s*(?:ℝ|R|reals?)\s*)?(?:\||:|\bsuch that\b|\bmit\b)\s*(.*)\}$", re.DOTALL
)
_INTERVAL = re.compile(r"\bInterval(?:\.(open|Lopen|Ropen))?\s*\(")
_REAL_RANGE = re.compile(r"\bRealRange\s*\(")
_OPEN_END = re.compile(r"\s*Open\s*\((.*)\)\s*", re.DOTALL)
_UNION = re.compile(r"\s*∪\s*|(?<=[)\]\[])\s*(?:U|union|und|or|oder)\s*(?=[(\[\]])", re.IGNORECASE)
_CALLED_UNION = re.compile(r"\bUnion\s*\(")
_MEMBER = re.compile(r"^\s*([^\W\d]\w*)\s*(?:∈|\bin\b)\s*", re.DOTALL)
_SUBJECT = re.compile(r"^\s*([^\W\d]\w*)\s*(?:[<>]=?|[≤≥])")
_JOINED = re.compile(r"(\s+(?:and|und|or|oder|et|ou)\s+)", re.IGNORECASE)


def is_unclear(text: str) -> bool:
    """Whether a text names bounds and does not say whether they belong to what is between."""
    return bool(_BETWEEN.search(in_relations(text)))


def with_ends(text: str, *, closed: bool) -> str:
    """Return K between 0 and 48 as an interval with its ends or without them."""

    def interval(found: re.Match[str]) -> str:
        ends = [each for each in found.groups() if each]
        return f"∈ [{ends[0]}, {ends[1]}]" if closed else f"∈ ({ends[0]}, {ends[1]})"

    found = _BETWEEN.sub(interval, in_relations(text))
    return found.removeprefix("∈").strip()


def in_relations(text: str) -> str:
    """Return a condition with relations and intervals for words, calls and sets."""
    text = text.strip()
    for pattern, change in TABLE:
        text = pattern.sub(change, text)
    text = _BARS.sub(r" abs(\1)", text).strip()
    if found := _SUCH_THAT.match(text):
        text = found[2].strip()
    text = _with_intervals(_solved(text))
    if enclosed(text, "{}") and re.search(r"[<>≤≥]", text):
        text = text[1:-1]
    return _with_subjects(_members(text))


def _solved(text: str) -> str:
    """The relations in solve(…) or Reduce[…, K]."""
    found = _SOLVED.match(text)
    if found is None or matching(text, found.end() - 1) != len(text) - 1:
        return text
    arguments = split(text[found.end() : -1], ",")
    return arguments[0].strip() if arguments else text


def _with_intervals(text: str) -> str:
    """Interval.open(0, 48) of sympy, RealRange(Open(0), 48) of Maple, Union(a, b) as intervals and ∪."""
    while found := _INTERVAL.search(text):
        end = matching(text, found.end() - 1)
        arguments = [each.strip() for each in split(text[found.end() : end], ",")]
        if len(arguments) < 2:
            return text
        ends = [each.lower() == "true" for each in [*arguments[2:4], "", ""][:2]]
        left = found[1] in ("open", "Lopen") or ends[0]
        right = found[1] in ("open", "Ropen") or ends[1]
        text = f"{text[: found.start()]}{_interval(arguments, left, right)}{text[end + 1 :]}"
    while found := _REAL_RANGE.search(text):
        end = matching(text, found.end() - 1)
        sides = [(_OPEN_END.fullmatch(each), each.strip()) for each in split(text[found.end() : end], ",")]
        if len(sides) != 2:
            return text
        (left_open, lower), (right_open, upper) = sides
        bounds = [left_open[1] if left_open else lower, right_open[1] if right_open else upper]
        text = f"{text[: found.start()]}{_interval(bounds, bool(left_open), bool(right_open))}{text[end + 1 :]}"
    if (found := _CALLED_UNION.match(text)) and matching(text, found.end() - 1) == len(text) - 1:
        return " ∪ ".join(split(text[found.end() : -1], ","))
    return text


def _interval(bounds: list[str], left: bool, right: bool) -> str:
    return f"{'(' if left else '['}{bounds[0]}, {bounds[1]}{')' if right else ']'}"


def _members(text: str) -> str:
    """K ∈ (0, 1) ∪ (2, 3) as K ∈ (0, 1) or K ∈ (2, 3); intervals alone are joined alike."""
    found = _MEMBER.match(text)
    pieces = split(text[found.end() :] if found else text, _UNION)
    if len(pieces) < 2:
        return text
    name = f"{found[1]} ∈ " if found else ""
    return " or ".join(f"{name}{piece.strip()}" for piece in pieces)


def _with_subjects(text: str) -> str:
    """K > 0 and < 48 as K > 0 and K < 48."""
    pieces = _JOINED.split(text)
    if len(pieces) < 3 or not (found := _SUBJECT.match(pieces[0])):
        return text
    return "".join(f"{found[1]} {piece}" if piece.lstrip()[:1] in tuple("<>≤≥") else piece for piece in pieces)
