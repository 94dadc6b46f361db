"""Signals that are differentiated or integrated, as students write it: dv/dt, v', ∫ v dt, int(v, t, 0, t).

Each such operation is taken out of a text, and a name stands in its place; what it acts on is read as any other text.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef

from solver.classroom.reading.brackets import matching, split
from solver.classroom.reading.latex import is_latex

BEFORE, AFTER = r"(?<![A-Za-z0-9_])", r"(?![A-Za-z0-9_])"
"""A name begins and ends here."""
NAME = "Q_9{}"
"""What stands in the place of an operation: nothing a person calls something."""
INTEGRAL = re.compile(r"\b(?:Integral|integral|integrate|int|Int)\s*\(")
LIMITS = re.compile(
    r"\s*(?:_\s*(?:\{([^{}]*)\}|\(([^()]*)\)|(\w+))\s*)?(?:\^\s*(?:\{([^{}]*)\}|\(([^()]*)\)|(\w+)))?"
    r"|\s*[\[(]\s*(\S+?)\s*(?:\.\.+|,|…|to|bis)\s*(\w+)\s*[\])]"
)
VARIABLE = re.compile(r"(?<![A-Za-z0-9_])d\s?(tau|sigma|lambda|lamda|xi|eta|t|x|s|u|r|q|T)(?:_?\d)?(?![A-Za-z0-9_])")
TIME = sp.Symbol("t")
TAU = sp.Symbol("tau")
_DOT = re.compile(r"([^\W\d_])\u0307(_?[\d₀-₉]?)")
"""v̇1 with a dot of its own above the letter."""
_GREEK = {"τ": "tau", "σ": "sigma", "λ": "lamda", "ξ": "xi", "η": "eta", "′": "'", "’": "'", "″": "''"}
_SMALL = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")


@dataclass(frozen=True)
class Operation:
    """A derivative of that order (positive), or so many integrals (negative), of what a text says in some variable."""

    text: str
    order: int
    variable: str = "t"


@dataclass
class Operators:
    """Takes the operations out of texts; `held` is what the output is before t = 0, said as v_o(0)."""

    names: Sequence[str]
    of_time: bool = True
    output: str = ""
    held: Any = None
    found: dict[str, Operation] = field(default_factory=dict)
    latex: bool = False

    def without(self, text: str) -> str:
        """Return a text with a name for each operation, and signals without their argument."""
        self.latex = is_latex(text)
        text = self._plain(text)
        if self.of_time:
            text = self._integrals(self._calls(self._derivatives(text)))
        letter = "t" if self.of_time else "s"
        text = re.sub(rf"({self._signal})\s*\(\s*{letter}\s*\)", r"\1", text)
        for place in [*self.names, *self.found]:
            text = re.sub(rf"(?<=[\w)\]}}])\s+(?={_spelled(place)}(?![\w(]))", " * ", text)
        return text

    @property
    def _signal(self) -> str:
        longest_first = sorted(self.names, key=len, reverse=True)
        return rf"{BEFORE}(?:{'|'.join(map(_spelled, longest_first))}){AFTER}"

    def _named(self, operation: Operation) -> str:
        number = len(self.found) + 1
        self.found[NAME.format(number)] = operation
        return f" Q_{{9{number}}} " if self.latex else f" {NAME.format(number)} "

    def _plain(self, text: str) -> str:
        for sign, plain in _GREEK.items():
            text = text.replace(sign, plain)
        text = re.sub(r"[₀₁₂₃₄₅₆₇₈₉]+", lambda found: found[0].translate(_SMALL), text.replace("₀ᵗ", "_0^t "))
        text = re.sub(r"\\(?:[,;:! ]|quad|limits|displaystyle|left|right)", " ", text)
        text = re.sub(r"\\mathrm\s*\{\s*d\s*\}", "d", text)
        text = re.sub(r"\\(tau|sigma|xi|eta)(?![a-z])", r"\1", text).replace(r"\int", " ∫ ")
        text = _DOT.sub(r"\1\2'", text)
        for mark, primes in ((r"\\dot", "'"), (r"\\ddot", "''")):
            dotted = rf"{mark}\s*(?:\{{\s*)?([A-Za-z]\w*?)\s*(?:\}}\s*)?(_\w+|_\{{\w+\}}|)(?![\w{{])\s*\}}?"
            text = re.sub(dotted, rf"\1\2{primes}", text)
        slash = r"\\[dt]?frac\s*\{\s*(d(?:\s*\^\s*\{?\d\}?)?[^{}]*)\}\s*\{\s*(d\s*t(?:\s*\^\s*\{?\d\}?)?)\s*\}"
        text = re.sub(slash, lambda found: f" {found[1].strip()}/{found[2]} ", text)
        if self.output and self.held is not None:
            start = rf"(?<![A-Za-z0-9_]){_spelled(self.output)}\s*\(\s*0\s*(?:\^?\{{?\s*[-+−]\}}?)?\s*\)"
            text = re.sub(start, lambda _: self._held(), text)
        return text

    def _held(self) -> str:
        return self._named(Operation("", 0))

    def _derivatives(self, text: str) -> str:
        """dv/dt, d/dt v, d/dt(v), diff(v, t), Derivative(v(t), (t, 2)), v', v'(t), v_dot."""
        v, d = self._signal, r"(?<![A-Za-z0-9_])d"
        bare, argument = v.removesuffix(AFTER), r"(?:\s*\(\s*t\s*\))?"
        square = r"\s*(?:\^\s*\{?\s*\d\s*\}?|²|³)?"
        power = r"\s*(?:\^\s*\{?\s*(?P<power>\d)\s*\}?|(?P<small>²|³))?"
        below = rf"\s*/\s*(?:\(\s*d\s*t{square}\s*\)|d\s*t{square}{AFTER})"
        inside = v.removeprefix(BEFORE)
        above = rf"\s*(?:\(\s*(?P<first>{inside}){argument}\s*\)|(?P<second>{inside}){argument})"
        behind = rf"\s*(?:\(\s*(?P<first>{v}){argument}\s*\)|(?P<second>{v}){argument}(?=\s*(?:[-+*)]|$)))"
        order = r"(?:,\s*\(?\s*t\s*(?:,\s*(?P<power>\d)\s*)?\)?)?"
        for pattern in (
            rf"{d}{power}{above}{below}",
            rf"{d}{power}{below}{behind}",
            rf"\b(?:diff|[Dd]erivative|D)\s*\(\s*(?P<first>{v}){argument}\s*{order}\s*\)",
            rf"(?P<first>{bare})_(?P<dots>d{{1,3}})ot{AFTER}",
            rf"(?P<first>{bare})\s?(?P<dots>'{{1,3}}){argument}",
        ):
            text = re.sub(pattern, self._derived, text)
        return text

    def _derived(self, found: re.Match[str]) -> str:
        groups = found.groupdict()
        name = groups.get("first") or groups.get("second") or ""
        small = {"²": 2, "³": 3}.get(groups.get("small") or "", 1)
        order = len(groups.get("dots") or "") or int(groups.get("power") or small)
        return self._named(Operation(name, order))

    def _calls(self, text: str) -> str:
        """int(v, t, 0, t), Integral(v(tau), (tau, 0, t)); the innermost ones first."""
        while found := [*INTEGRAL.finditer(text)]:
            start, opening = found[-1].start(), found[-1].end() - 1
            end = matching(text, opening)
            body, *limits = [each.strip() for each in split(text[opening + 1 : end], ",")] or [""]
            tuples = [each for each in limits if each.startswith("(")]
            flat = ",".join(each.strip("() ") for each in (tuples[:1] or limits))
            variable, *ends = [each.strip() for each in flat.split(",")] if flat else ["t"]
            if variable in ("0", "0-"):
                variable, ends = "t", [variable, *ends]
            if ends and (ends[0].strip() not in ("0", "0-") or len(ends) != 2):
                break
            text = text[:start] + self._named(Operation(body, -max(1, len(tuples)), variable)) + text[end + 1 :]
        return text

    def _integrals(self, text: str) -> str:
        """∫_0^t … dτ; the innermost, which is the last, first."""
        while (at := text.rfind("∫")) >= 0:
            limits = LIMITS.match(text, at + 1)
            low, high = _ends(limits)
            body_at = limits.end() if limits else at + 1
            end = _end_of_integrand(text, body_at)
            if end is None or low not in ("", "0", "0-") or (high not in ("", "t") and not VARIABLE.match(f"d{high}")):
                break
            variable = VARIABLE.match(text, end)
            assert variable is not None  # noqa: S101 - that is where the integrand ends
            named = self._named(Operation(text[body_at:end], -1, variable[1]))
            text = text[:at] + named + text[variable.end() :]
        return text

    def put_in(self, value: Any, read: Callable[[str], Any]) -> Any:
        """Return a value with the operations in the place of their names; `read` reads what they act on."""
        if not isinstance(value, sp.Basic):
            return value
        known = {name.replace("_", ""): operation for name, operation in self.found.items()}
        inside = [(x, known[str(x).replace("_", "")]) for x in value.free_symbols if str(x).replace("_", "") in known]
        return value.xreplace({x: self._operated(operation, read) for x, operation in inside})

    def _operated(self, operation: Operation, read: Callable[[str], Any]) -> Any:
        if operation.order == 0:
            return self.held
        variable = sp.Symbol(operation.variable)
        bare = re.sub(rf"({self._signal})\s*\(\s*{re.escape(operation.variable)}\s*\)", r"\1", operation.text)
        outside = sp.Dummy("t") if operation.variable != "t" else TIME
        moving = self._moving(self.put_in(read(bare).xreplace({TIME: outside}), read))
        if operation.order > 0:
            return sp.diff(moving, (TIME, operation.order))
        own = {x for x in moving.free_symbols if str(x) == operation.variable}
        for _ in range(-operation.order):
            moving = sp.Add(*(_integrated(term, {*own, variable}) for term in sp.Add.make_args(sp.expand(moving))))
        return moving.xreplace({outside: TIME})

    def _moving(self, value: Any) -> Any:
        """A value with its signals as functions of t."""
        plain = {
            x: sp.Function(name)(TIME)
            for x in value.free_symbols
            for name in self.names
            if str(x).replace("_", "") == name.replace("_", "")
        }
        return value.xreplace(plain)


def _integrated(term: Any, variables: set[Any]) -> Any:
    """∫ of a term from 0 to t; an integral of an integral is one with two limits. `variables` stand for t in it."""
    factors = sp.Mul.make_args(term)
    inner = next((each for each in factors if isinstance(each, sp.Integral)), None)
    constants = [each for each in factors if each is not inner and not each.has(TIME, *variables, AppliedUndef)]
    rest = sp.Mul(*(each for each in factors if each is not inner and each not in constants))
    if inner is not None and rest == 1:
        limits = inner.limits
        over = sp.Symbol(f"tau_{len(limits)}")
        joined = [*limits[:-1], (limits[-1][0], 0, over)]
        return sp.Mul(*constants) * sp.Integral(inner.function, *joined, (over, 0, TIME))
    whole = rest if inner is None else rest * inner
    moved = whole.xreplace({**dict.fromkeys(variables, TAU), TIME: TAU})
    return sp.Mul(*constants) * sp.Integral(moved, (TAU, 0, TIME))


def _spelled(name: str) -> str:
    """A pattern for a name: v1 may be written v_1."""
    found = re.fullmatch(r"([A-Za-z]+)_?(\w+)", name)
    return rf"{found[1]}(?:_?{found[2]}|_\{{{found[2]}\}})" if found else re.escape(name)


def _ends(limits: re.Match[str] | None) -> tuple[str, str]:
    """The ends of an integral, "" where they are not said."""
    if limits is None:
        return "", ""
    groups = [each.strip() if each else "" for each in limits.groups()]
    return "".join([*groups[:3], groups[6]]), "".join([*groups[3:6], groups[7]])


def _end_of_integrand(text: str, at: int) -> int | None:
    """Where dτ stands behind an integrand, outside of its brackets."""
    depth = 0
    for i in range(at, len(text)):
        depth += (text[i] in "([{") - (text[i] in ")]}")
        if depth < 0:
            return None
        if depth == 0 and VARIABLE.match(text, i):
            return i
    return None
