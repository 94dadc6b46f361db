r"""Functions of time told piece by piece: f for 0 <= t < 1, g for t >= 1; \begin{cases}; Piecewise(…).

They become sums with steps. The pieces must follow one another without a gap, from t = 0 or before on without an end;
whatever else is written so is not read.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from solver.classroom.reading.brackets import enclosed, matching, split

_CALL = re.compile(r"(?:\w+\.)*([Pp]iecewise)\s*[(\[]")
_CASES = re.compile(r"^(.*?)\\begin\{(?:cases|dcases)\}(.*)\\end\{(?:cases|dcases)\}\s*\.?\s*$", re.DOTALL)
_LABEL = re.compile(r"^\s*[A-Za-z]\w*\s*(?:\(t\))?\s*=\s*$|^\s*$")
_FOR = r"(?:for|für|if|falls|when|wenn|while|where|,)\s*:?"
_SEPARATOR = re.compile(r"\s*[;\n]\s*|\s*,\s*(?:and\s+|und\s+)?(?=\S)|\s+(?:and|und)\s+")
_PIECE = re.compile(rf"^(.+?)\s+(?:{_FOR})\s+(.*\bt\b.*|otherwise|sonst|else)$"
    rf"|^(.+?)\s*\(\s*(?:{_FOR})?\s*([^()]*\bt\b[^()]*[<>≤≥][^()]*|[^()]*[<>≤≥][^()]*\bt\b[^()]*)\)$"
    r"|^(.+?)\s*,\s*([^,]*\bt\b[^,]*[<>≤≥][^,]*|[^,]*[<>≤≥][^,]*\bt\b[^,]*)$",
                    re.DOTALL)  # fmt: skip
_REST = re.compile(r"^([^<>≤≥]+?)\s*,?\s+(?:otherwise|sonst|else)\s*\.?$")
_ELSE = re.compile(r"^(?:otherwise|sonst|else)\s*[:,]?\s+([^<>≤≥]+?)\s*\.?$")
_CONDITIONAL = re.compile(r"^(.+)\s+if\s+([^<>≤≥]*[<>≤≥][^<>≤≥]*?)\s+else\s+([^<>≤≥]+)$")
"""f if t < 1 else g, of Python."""
_AFTER_RANGE = re.compile(
    r"\s*\(\s*(?:for |für |if |wenn )?([^()<>≤≥]*[<>≤≥][^()]*?)\s*[,;]\s*"
    r"((?:sonst|otherwise|else)[^()]*|[^(),;]*(?:sonst|otherwise|else))\s*\)\s*$"
)
"""f (t ≥ 0, otherwise 0)."""
_OTHERWISE = {"otherwise", "sonst", "else", "true", "\\text{otherwise}", "\\text{sonst}"}
_RANGE = re.compile(r"^(?:([^<>≤≥t]+?)\s*(?:<=?|≤)\s*)?t\s*(?:(?:<=?|≤)\s*([^<>≤≥t]+))?$")
_FROM = re.compile(r"^t\s*(?:>=?|≥)\s*([^<>≤≥t]+)$|^([^<>≤≥t]+)\s*(?:>=?|≥)\s*t$")
_LATEX = (("\\leq", "<="), ("\\le", "<="), ("\\geq", ">="), ("\\ge", ">="), ("\\lt", "<"), ("\\gt", ">"), ("\\,", " "),
          ("\\quad", " "), ("\\text{for }", ""), ("\\text{if }", ""), ("\\text{für }", ""))  # fmt: skip
MOST_PIECES = 8
MAX_CHARACTERS = 1000
Piece = tuple[str, str, str]
"""A formula, and where it begins and ends; "" where it begins before all or never ends."""


def as_steps(text: str) -> str:
    """Return a piecewise function of t as a sum with steps, "" where a text is none, or has gaps."""
    if len(text) > MAX_CHARACTERS:
        return ""
    label, sign, behind = text.strip().rpartition("= {")
    bare = f"{label}= {behind.rstrip('. ')[:-1]}" if sign and behind.rstrip(". ").endswith("}") else text.strip()
    pairs = _pairs(bare[1:-1] if enclosed(bare, "{}") else bare)
    if len(pairs) == 1 and (only := _bounded(*pairs[0])) and only[1] not in ("", "0", "?") and not only[2]:
        return f"({only[0]})*step(t - ({only[1]}))"  # for t >= 1, and nothing is said of what was before
    if not 1 < len(pairs) <= MOST_PIECES:
        return ""
    pieces = [_bounded(formula, condition) for formula, condition in pairs]
    known = [piece for piece in pieces if piece is not None]
    first = [piece for piece in known if not piece[1] and piece[2]]  # for t < 1, wherever it is told
    known = [*first, *(piece for piece in known if piece not in first)]
    return _sum(known) if len(known) == len(pieces) else ""


def _pairs(text: str) -> list[tuple[str, str]]:
    """The formulas with their conditions."""
    if found := _CASES.match(text):
        if not _LABEL.match(found[1]):
            return []
        lines = [re.split(r"&", line) for line in found[2].split("\\\\") if line.strip()]
        return [(line[0].strip().rstrip(","), line[1].strip()) for line in lines if len(line) == 2] if all(
            len(line) == 2 for line in lines) else []  # fmt: skip
    text = _CONDITIONAL.sub(r"\1 for \2, \3 otherwise", text)
    text = _AFTER_RANGE.sub(r" for \1, \2", text)
    head, _, rest = text.partition("=")
    if rest and _LABEL.match(f"{head}=") and not rest.startswith("=") and head.strip()[-1:] not in "<>":
        text = re.sub(rf"(?<!\w){re.escape(head.strip())}\s*=\s*", "", rest).strip()
    if (call := _CALL.match(text)) and matching(text, call.end() - 1) == len(text) - 1:
        return _of_call(text[call.end() : -1], matlab=call[1] == "piecewise")
    found_pairs = []
    for piece in _pieces(text):
        if (match := _REST.match(piece.strip()) or _ELSE.match(piece.strip())) is not None:
            found_pairs.append((match[1], "otherwise"))
            continue
        match = _PIECE.match(piece.strip())
        if match is None:
            return []
        formula, condition = (next(filter(None, match.groups()[of::2])) for of in (0, 1))
        found_pairs.append((formula.strip().rstrip(","), condition.strip()))
    return found_pairs


def _of_call(text: str, *, matlab: bool) -> list[tuple[str, str]]:
    """The pieces of a call of sympy or Mathematica, (f, t < 1), or of MATLAB: t < 1, f, g."""
    arguments = [each.strip() for each in split(text, ",")]
    if matlab:
        pairs = [(arguments[i + 1], arguments[i]) for i in range(0, len(arguments) - 1, 2)]
        return [*pairs, (arguments[-1], "otherwise")] if len(arguments) % 2 else pairs
    listed = arguments[0][1:-1] if len(arguments) < 3 and enclosed(arguments[0], "{}") else text
    inside = [each.strip() for each in split(listed, ",")]
    pairs_ = [split(each[1:-1], ",") for each in inside if each[:1] in "({["]
    last = [(arguments[1], "otherwise")] if listed != text and len(arguments) == 2 else []
    return [*((each[0], each[1]) for each in pairs_ if len(each) == 2), *last]


def _pieces(text: str) -> list[str]:
    """The pieces of "f for …, g for …": separators after a condition only."""
    found: list[str] = []
    for part in split(text, _SEPARATOR):
        complete = found and _PIECE.match(found[-1].strip()) and re.search(r"[<>≤≥]|otherwise|sonst|else", found[-1])
        if found and not complete:
            found[-1] += f", {part}"
        else:
            found.append(part)
    return found


def _bounded(formula: str, condition: str) -> Piece | None:
    """A formula with its bounds; None where they are not understood."""
    for sign, plain in _LATEX:
        condition = condition.replace(sign, plain)
    condition = re.sub(rf"^\s*(?:{_FOR})\s+", "", condition).strip().rstrip(".")
    if condition.lower() in _OTHERWISE:
        return formula, "?", ""
    if found := _FROM.match(condition):
        return formula, (found[1] or found[2]).strip(), ""
    if (found := _RANGE.match(condition)) and (found[1] or found[2]):
        end = (found[2] or "").strip()
        return formula, (found[1] or "").strip(), "" if end in ("∞", "inf", "oo") else end
    return None


def _sum(pieces: Sequence[Piece]) -> str:
    """The sum of the pieces; "" where they do not follow one another."""
    zero_before = pieces[0][2] in ("0", "0.0") and pieces[0][0].strip() in ("0", "0.0")
    if zero_before:  # 0 for t < 0
        return _sum([(pieces[1][0], "0", pieces[1][2]), *pieces[2:]]) if len(pieces) > 1 else ""
    if len(pieces) == 2 and pieces[0][1:] == ("0", "") and pieces[1][:2] == ("0", "?"):
        return f"({pieces[0][0]})"  # 0 otherwise
    if len(pieces) == 2 and pieces[1][0].strip() in ("0", "0.0") and pieces[1][1] == "?" and not pieces[0][2]:
        return f"({pieces[0][0]})*step(t - ({pieces[0][1]}))"  # for t >= 2, 0 otherwise
    whole, at = "", ""
    for i, (formula, begin, end) in enumerate(pieces):
        begins = begin in (("", "0", "-∞", "-oo", "-inf", "0.0") if i == 0 else (at, "?", ""))
        if not begins or (not end and i + 1 < len(pieces)):
            return ""
        if i == 0:
            whole = f"({formula})"
        else:
            whole += f" + (({formula}) - ({pieces[i - 1][0]}))*step(t - ({at}))"
        at = end
    return whole if not at else ""
