"""Texts of lists put otherwise: a conjugate for both of a pair, what is said of all items, multiplicities, sets."""

from __future__ import annotations

import re

from solver.classroom.reading.brackets import split

_COLUMN = re.compile(r"\s*[\[(]([^\[\]();,]+(?:;[^\[\]();,]+)+)[\])]\s*")
_NAMED = re.compile(r"\s*([^\W\d]\w*)\s*[:=]\s*([^:=]*\S)\s*")
_CALL = re.compile(
    r"^\s*(?:\w+\.)*(?:roots|eig\w*|Eigenvalues|poles?|zeros?|tzero|spec|solve|Solve)\s*"
    r"(?:\([^()]*\)|\[[^\[\]]*\])\s*=\s*(?=[-+−±\d\[{(])"
)
_CONJUGATE = re.compile(
    r"\s*(?:,|\+|\band\b|\bund\b|\bplus\b)\s*(?:its |the |das |ihre?\w* |\()?\s*"
    r"(?:(?:complex |komplex )?conj(?:ugates?|\.)?"
    r"|(?:komplex )?konjugierte?s?|c\.\s?c\.|cc|k\.\s?k\.)\)?\s*\.?\s*$",
    re.IGNORECASE,
)
_IMAGINARY = re.compile(r"^(.*?)([-+−])(\s*(?:[ij][^-+−,;]*|[^-+−,;]*[ij]))$")
_CONJUGATE_OF = re.compile(
    r"(?:conj|conjugate|konj)\s*\(\s*(\w+)\s*\)|([^\W\d]\w*)\s*\^?\s*\{?\*\}?|\\?(?:bar|overline)\s*[{(]\s*(\w+)\s*[)}]"
)
_INDEXED = re.compile(
    r"\s*([^=<>;]+?)\s*[,;(]?\s*(?:\b(?:for|für|with|mit)\b)?\s*\b([knlmq])\s*=\s*([-−]?\d(?:\s*,\s*[-−]?\d)+)\s*\)?\s*\.?"
)
_ITEMS = re.compile(r"\s*[,;]\s*(?:and\s+|und\s+)?|\s+(?:and|und)\s+")
_MULTIPLICITY = re.compile(
    r",\s*((?:alg\w*\.?\s*)?(?:mult\w*\.?|vielfachheit|vfh\.?)\s*(?:=|of)?\s*\d)(?=\s*(?:[,;.]|$))", re.IGNORECASE
)
_GEOMETRIC = re.compile(
    r",\s*(?:geom\w*\.?\s*(?:mult\w*\.?|vielfachheit|vfh\.?)|g\.?\s?[mv]\.?)\s*(?:=|of)?\s*\d(?=\s*\))", re.IGNORECASE
)
_EACH = re.compile(
    r"^([^:=]*?)[,:]?\s+\(?(?:each|both|jeweils|beide)\s+(?:(?:with|of|mit)\s+)?(?:(?:algebraic\s+)?(?:multiplicity|mult\.|"
    r"vielfachheit)\s*(\d)|double|twice|doppelt)\)?\s*\.?$",
    re.IGNORECASE,
)
_OF_ALL = re.compile(
    r"\s*[,;(]\s*(?:both|beide|all|alle)\s+(?:simple|einfach|distinct|verschieden|real|reell)\s*\)?\s*\.?$",
    re.IGNORECASE,
)
_ANGLES_OF_ALL = re.compile(r"^[^,;]*\(\s*(?:2\s*[kqnlm]|[kqnlm]\s*·?\s*360)[^,;=:]*[=:]\s*(?=[^=]*$)")
_THEN = re.compile(r"\s*(?:→|->|,?\s+(?:then|dann|danach)\b)\s*")
_FIRST = re.compile(r"^\s*(?:first|initially|zuerst|zunächst|anfangs)\s+(?=[-+−]?\d)", re.IGNORECASE)
_BETWEEN_BARS = re.compile(r"\s*[^|(]+(?:\s\|\s[^|(]+)+")
_BOTH_SIGNS = re.compile(r"\s*\+\s*([^-+−/,;=]+?)\s*/\s*[-−]\s*([^-+−/,;=]+?)\s*")
_OR = re.compile(r"\s+(?:or|oder)\s+")
_OPERAND = r"\s*([-+−±\d./√() ]*[ij]?[\d./√() ]*?)\s*"
_TIMES = re.compile(rf"{_OPERAND}[x×]{_OPERAND}")
_TIMES_IN_BRACKETS = re.compile(r"\(\s*([x×]\s*\d+|\d+\s*[x×])\s*\)")
_COUNTS = tuple(map(str, range(1, 10)))
MOST_SIGNS = 60
_SETS = re.compile(r"\}\s*(?:∪|\bund\b|\band\b|,)\s*\{")


def with_conjugates(text: str) -> str:
    """Return -1 ± 2j for -1 + 2j and its conjugate; "" of any other text."""
    found = _CONJUGATE.search(text)
    parts = _IMAGINARY.match(text[: found.start()].strip()) if found else None
    return f"{parts[1]}±{parts[3]}" if parts else ""


def with_named_conjugates(text: str) -> str:
    """Return λ1 = -1 + 3j, λ2 = -1 - 3j for "λ1 = -1 + 3j, λ2 = conj(λ1)" and for "λ1 = conj(λ2) = -1 + 3j"."""
    known: dict[str, str] = {}
    items: list[str] = []
    found = False
    for item in split(text, _ITEMS):
        name, *values = [each.strip() for each in item.split("=")]
        other = _CONJUGATE_OF.fullmatch(values[0]) if values else None
        if other is None:
            known |= {name: values[-1]} if values else {}
            items.append(item)
            continue
        found = True
        of = next(each for each in other.groups() if each).strip()
        value = known.get(of, "") if len(values) == 1 else values[1]
        if len(values) > 2 or not (turned := _turned(value)):
            return text
        items += [f"{name} = {turned}"] if len(values) == 1 else [f"{name} = {value}", f"{of} = {turned}"]
    return ", ".join(items) if found else text


def with_every_index(text: str) -> str:
    """Return 60°, 180°, 300° as products for "(2k+1)·60°, k = 0, 1, 2"; any other text as it is."""
    found = _INDEXED.fullmatch(text)
    if found is None:
        return text
    formula, index, values = found.groups()
    whole = re.compile(rf"(?<![^\W\d_]){index}(?![\w(])")
    if "," in formula or not whole.search(formula):
        return text
    return ", ".join(whole.sub(f"*({value.strip()})", formula) for value in values.split(","))


def _turned(value: str) -> str:
    """The conjugate of -1 + 3j; "" of what is no such number."""
    found = _IMAGINARY.match(value)
    if found is None:
        return f"-{value}" if re.fullmatch(r"[\d./√()]*[ij][\d./√()]*", value) else ""
    return f"{found[1]}{'-' if found[2] == '+' else '+'}{found[3]}" if "±" not in value else ""


def with_multiplicities(text: str) -> str:
    """Return -1 (mult. 2) for "-1, mult. 2", without what is said of geometric multiplicities."""
    return _GEOMETRIC.sub("", _MULTIPLICITY.sub(r" (\1)", text))


def each_so_often(text: str) -> str:
    """Return -1 (multiplicity 2), -2 (multiplicity 2) for "{-1, -2} each with multiplicity 2"."""

    def spread(found: re.Match[str]) -> str:
        items = re.split(r"\s*(?:[,;]|\band\b|\bund\b)\s*", found[1].strip(" {}[]"))
        return ", ".join(f"{item} (multiplicity {found[2] or 2})" for item in items)

    return _EACH.sub(spread, text)


def without_kind_of_all(text: str) -> str:
    """Return 5, 2 for "5, 2 (both simple)"."""
    return _OF_ALL.sub("", text)


def behind_angles_of_all(text: str) -> str:
    """Return 60°, 180°, 300° for "180°(2k + 1)/3 = 60°, 180°, 300°"."""
    return _ANGLES_OF_ALL.sub("", text)


def one_after_another(text: str) -> str:
    """Return -20, -40 for "-20, then -40" and for "-20 → -40"."""
    return _FIRST.sub("", _THEN.sub(", ", text))


def between_bars(text: str) -> str:
    """Return -20, -40 for "-20 | -40"; "" of any other text."""
    return text.replace("|", ",") if _BETWEEN_BARS.fullmatch(text) else ""


def of_both_signs(text: str) -> str:
    """Return ±2j for "+2j/-2j"; "" of any other text."""
    found = _BOTH_SIGNS.fullmatch(text)
    return f"±{found[1]}" if found and found[1] == found[2] else ""


def joined_alternatives(text: str) -> str:
    """Return {x: 1}, {x: 2} for "{x: 1} or {x: 2}"."""
    return _OR.sub(", ", text)


def joined_sets(text: str) -> str:
    """Return {-1, -2} for {-1} ∪ {-2}."""
    return _SETS.sub(", ", text)


def behind_call(text: str) -> str:
    """Return the values of roots([1 3 2]) = -1, -2, without what finds them."""
    return _CALL.sub("", text)


def as_point(text: str) -> str:
    """Return (1, 2) of the column [1; 2], and x = 1, y = 2 of these lines with colons; "" of any other text."""
    if found := _COLUMN.fullmatch(text):
        return f"({found[1].replace(';', ', ')})"
    lines = [_NAMED.fullmatch(line) for line in text.strip().split("\n")]
    return ", ".join(f"{line[1]} = {line[2]}" for line in lines if line) if len(lines) > 1 and all(lines) else ""


def times_over(item: str) -> tuple[list[str], ...]:
    """Return what 3 x 2 may be in a list: 3 twice, 2 three times, or the product; nothing of any other item."""
    found = _TIMES.fullmatch(_TIMES_IN_BRACKETS.sub(r" \1", item)) if len(item) <= MOST_SIGNS else None
    if found is None or not all(found.groups()):
        return ()
    first, second = (each.strip() for each in found.groups())
    many = [[value] * int(count) for value, count in ((first, second), (second, first)) if count in _COUNTS]
    return (*many, [item]) if many else ()
