"""A gain told as the law of feedback, u = -[18 6] x or u = -18 x1 - 6 x2, and a law told with the gain's row."""

from __future__ import annotations

import re

from solver.classroom.reading.brackets import by_spaces, enclosed, matching, split
from solver.classroom.reading.linear_sums import coefficients, terms

_LAW = re.compile(r"^\s*u(?:_?1)?(?:\^\*|\*)?(?:\s*\([tk]\)|\[k\])?\s*=\s*(.+)$", re.DOTALL)
_STATE = r"x(?:\([tk]\)|\[k\]|_k)?"
_REFERENCE = re.compile(r"\s*\+\s*(?:(?:[A-Z]_?\w?|[\d./]+)\s*[*·]?\s*)?[rvw](?:\([tk]\)|\[k\])?\s*$")
_BEFORE = re.compile(r"^\s*(?:(?:[A-Z]_?\w?|[\d./]+)\s*[*·]?\s*)?[rvw](?:\([tk]\)|\[k\])?\s*(?=[-−])")
_ROW = re.compile(r"^([-−]?)\s*(?=[\[(])")
_EACH = re.compile(r"\s*u_?([1-9])(?:\([tk]\)|\[k\])?\s*=\s*(.+)", re.DOTALL)
_BETWEEN = re.compile(r"\s*[,;\n]\s*(?:and\s+|und\s+)?|\s+(?:and|und)\s+")
_FACTOR = re.compile(r"^([\d./]+)\s*[*·]?\s*[(\[]")
_PARAMETER = re.compile(r"([KT])_?\{?([pPidIDnNvV])\}?\s*=\s*(?:([\d./√]+)\s*(?:s|sec)?|([^=]+))")
_ERROR = r"e(?:\([tτ]\)|\(\\?tau\))?"
_LAW_OF_ERROR = re.compile(
    rf"\s*([-+]?)\s*(.*?)\s*[*·]?\s*(?:(?P<sum>(?:∫|\\int|integral|int)\s*(?:_\{{?0\}}?\s*\^\{{?t\}}?\s*|\(?(?=\s*e))\s*{_ERROR}\)?"
    rf"(?:\s*\\?,?\s*d\s*\\?(?:t|τ|tau))?)|(?P<rate>(?:d\s?{_ERROR}\s*/\s*d\s?t|d\s*/\s*d\s?t\s+{_ERROR}|ė|e'|\\dot\{{?\s?e\}}?"
    rf"|e_dot)(?:\(t\))?)|{_ERROR})\s*"
)
_CORRECTED = re.compile(r"(K|T|α|alpha|a|\\alpha)\s*=\s*(?:([\d./√]+)\s*(?:s|sec)?|([^=]+))")
_ACTIONS = {"KI": "{}/s", "KD": "{}*s", "TI": "1/({}*s)", "TN": "1/({}*s)", "TD": "{}*s", "TV": "{}*s"}
_BELOW = str.maketrans("₁₂₃₄₅₆₇₈₉−", "123456789-")
_AT = r"(?:\(\s*{0}\s*\)|\[\s*{0}\s*\]|_\{{\s*{0}\s*\}}|_{0})"
_DIFFERENCES = re.compile(rf"^\s*(Δ|∆|\\?Delta\s*)?u{_AT.format('[kn]')}\s*=\s*(.+)$", re.DOTALL)
_SAMPLE = re.compile(rf"^\s*([-+]?)\s*(.*?)\s*[*·]?\s*([ue]){_AT.format('[kn](?:-([1-9]))?')}\s*$", re.DOTALL)
MOST_STATES = 9


def gain_of(text: str) -> str:
    """Return the row K of u = -K x, as its entries in brackets; "" of any other text."""
    found = _LAW.match(text.translate(_BELOW))
    if found is None:
        return ""
    law = _BEFORE.sub("", _REFERENCE.sub("", found[1].strip().rstrip(".")))
    if (row := _row_beside(law, _STATE)) is not None:
        sign, entries = row
        return entries if sign else f"-{entries}"
    if (alone := coefficients(law, "x") or {}).keys() == {("x", "")}:  # u = -tanh(1 - t) x
        return f"[-({alone['x', '']})]"
    listed = _coefficients(law)
    return f"[{', '.join(f'-({each})' for each in listed)}]" if listed else ""


def gains_of(text: str) -> str:
    """Return the matrix K of u1 = -2 x1, u2 = -x1 - 3 x2, a law for each input; "" of any other text."""
    found = [_EACH.fullmatch(piece) for piece in split(text.translate(_BELOW), _BETWEEN)]
    numbers = [int(each[1]) for each in found if each]
    rows = [coefficients(each[2].rstrip("."), "x") for each in found if each]
    if len(numbers) < max(2, len(found)) or sorted(numbers) != list(range(1, len(found) + 1)):
        return ""
    named = [{int(index): value for (_, index), value in row.items() if index} for row in rows if row is not None]
    if len(named) < len(rows) or any(len(each) < len(row or {}) for each, row in zip(named, rows, strict=True)):
        return ""
    width = max((max(each, default=0) for each in named), default=0)
    lines = {
        number: ", ".join(f"-({each[i]})" if i in each else "0" for i in range(1, width + 1))
        for number, each in zip(numbers, named, strict=True)
    }
    return f"[{'; '.join(lines[number] for number in sorted(lines))}]" if width else ""


def law_of(text: str) -> str:
    """Return -[1 √2] x as -((1)*x1 + (√2)*x2), with the entries of the column behind the row; "" of other texts."""
    found = _LAW.match(text)
    law = found[1].strip() if found else text.strip()
    row = _row_beside(law, rf"(?:{_STATE}|[\[(]\s*x_?1\s*[,;\s]\s*x_?2\s*[\])](?:\^T|')?)")
    if row is None:
        return ""
    sign, entries = row
    inside = entries[1:-1]
    listed = split(inside, ",") if "," in inside else by_spaces(inside)
    terms = [f"({each.strip()})*x{i}" for i, each in enumerate(listed, 1)]
    return f"{sign}({' + '.join(terms)})" if 1 < len(terms) <= MOST_STATES else ""


def coefficients_of(text: str) -> str:
    """Return [q0, q1, q2] of u(k) = u(k-1) + q0 e(k) + q1 e(k-1) + q2 e(k-2), or of what is added; else ""."""
    text = text.translate(_BELOW)
    found = _DIFFERENCES.match(text)
    if found is None and "=" in text:
        return ""
    law = re.sub(r"([kn])\s*-\s*(?=\d)", r"\1-", (found[2] if found else text).strip().rstrip("."))
    named, before = dict[int, str](), found is None or bool(found[1])
    listed_terms = terms(law)
    for term in listed_terms:
        match = _SAMPLE.match(term)
        if match is None:
            return ""
        sign, factor, signal = match[1], match[2].strip(), match[3]
        shift = max(int(each or 0) for each in match.groups()[3:])
        if signal == "u":
            if before or sign == "-" or factor not in ("", "1") or shift != 1:
                return ""
            before = True
        elif shift in named:
            return ""
        else:
            named[shift] = f"{sign.strip('+')}({factor or '1'})"
    listed = [named.get(i, "0") for i in range(max([2, *named]) + 1)]
    return f"[{', '.join(listed)}]" if before and named else ""


def controller_of(text: str) -> str:
    """Return the controller of what a law or parameters say; "" of any other text."""
    return _of_parameters(text) or _of_law(text) or _of_differences(text) or _of_corrections(text)


def _of_law(text: str) -> str:
    """The controller of u = 3 e + 2 ∫ e dt + de/dt."""
    found = _LAW.match(text)
    if found is None:
        return ""
    law, before = found[1].strip().rstrip(".").replace("−", "-"), ""
    if (factor := _FACTOR.match(law)) and matching(law, factor.end() - 1) == len(law) - 1:
        before, law = f"({factor[1]})*", law[factor.end() : -1]
    found_in = [_LAW_OF_ERROR.fullmatch(each) for each in terms(law)]
    known = [(each, "/s" if each["sum"] else "*s" if each["rate"] else "") for each in found_in if each]
    if len(known) < len(found_in) or len({action for _, action in known}) < len(known):
        return ""
    return f"{before}({' + '.join(f'({each[1]}({each[2].strip() or 1}){action})' for each, action in known)})"


def _of_differences(text: str) -> str:
    """The controller of u(k) = u(k-1) + q0 e(k) + q1 e(k-1) + q2 e(k-2), in z."""
    listed = coefficients_of(text) if "=" in text else ""
    terms = [f"({each.strip()})*z^(-{i})" for i, each in enumerate(split(listed[1:-1], ","))] if listed else []
    return f"({' + '.join(terms)})/(1 - z^(-1))" if terms else ""


def _of_corrections(text: str) -> str:
    """The lead or lag K (T s + 1)/(α T s + 1) of K = 10, T = 0.2, α = 0.3."""
    found = [_CORRECTED.fullmatch(each.strip()) for each in split(text, re.compile(r"\s*(?:[,;]|\band\b|\bund\b)\s*"))]
    named = {each[1].strip("\\").replace("alpha", "α").replace("a", "α"): f"({each[2]})" for each in found if each}
    if len(named) < len(found) or named.keys() != {"K", "T", "α"}:
        return ""
    return f"{named['K']}*({named['T']}*s + 1)/({named['α']}*{named['T']}*s + 1)"


def _of_parameters(text: str) -> str:
    """The controller of K_p = 3, T_i = 1, T_d = 0.25, or of K_p, K_i and K_d."""
    pieces = [each.strip() for each in split(text, re.compile(r"\s*(?:[,;]|\band\b|\bund\b)\s*"))]
    found = [_PARAMETER.fullmatch(each) for each in pieces]
    named = {f"{each[1]}{each[2]}".upper(): f"({(each[3] or each[4]).strip()})" for each in found if each}
    if len(named) < len(pieces) or "KP" not in named:
        return ""
    gain = named.pop("KP")
    if not named or not named.keys() <= _ACTIONS.keys() or len({each[0] for each in named}) > 1:
        return ""
    summed = " + ".join(_ACTIONS[name].format(value) for name, value in named.items())
    return f"{gain} + {summed}" if "K" in {each[0] for each in named} else f"{gain}*(1 + {summed})"


def _row_beside(law: str, state: str) -> tuple[str, str] | None:
    """The sign and the row of a product with the state; None of anything else."""
    found = _ROW.match(law)
    if found is None:
        return None
    end = matching(law, found.end())
    row, rest = law[found.end() : end + 1], law[end + 1 :].strip().lstrip("*·").strip()
    if not re.fullmatch(state, rest) or not (enclosed(row) or len(split(row[1:-1], ",")) > 1):
        return None
    return ("-" if found[1] else "", f"[{row[1:-1]}]")


def _coefficients(law: str) -> list[str]:
    """What stands before x1, x2, … in a sum, in their order; nothing where anything else stands there."""
    named = coefficients(law, "x")
    if not named or any(not index for _, index in named):
        return []
    values = {int(index): value for (_, index), value in named.items()}
    return [values.get(i, "0") for i in range(1, max(values) + 1)]
