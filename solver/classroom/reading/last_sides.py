"""What stands behind the last sign of equality of a chain, where no side is another value: K = R⁻¹BᵀP = [3 √6]."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any
from unicodedata import normalize

import sympy as sp

from solver.classroom.reading import polynomials
from solver.classroom.reading.expected import Expected
from solver.classroom.reading.general_forms import is_general
from solver.classroom.reading.labels import ForeignLabelError, Labels, changes, of_another_argument
from solver.classroom.reading.likeness import SIGNALS
from solver.classroom.reading.names import symbols_of
from solver.classroom.reading.said_twice import same, says_how
from solver.classroom.reading.sentences import sides_of
from solver.classroom.submitted import Submitted
from solver.problem.nodes import Node, ScalarNode
from solver.symbols import CONTINUOUS

_VALUE_AT = re.compile(r"[A-Z]\w?\s*\(\s*[\d.j∞]+\s*\)")
"""G(0), which is the value of a function and no product."""
_WORDS = re.compile(r"[^\W\d]\w*")
_DOT = re.compile(r"_d*dot$")
VARIABLES = CONTINUOUS | {"k"}
"""Letters of functions: what is labelled with another argument is another function."""


def last_side(
    node: ScalarNode, ours: Any, expected: Expected, like: Callable[[Node], list[Submitted]]
) -> list[Submitted]:
    """What stands behind the last sign of equality, where no other side is another value. Raises Fault."""
    if isinstance(ours, Mapping) or expected.zero:
        return []
    sides = sides_of(node.text)
    of_a_variable = isinstance(ours, sp.Expr) and bool({x.name for x in symbols_of(ours)} & VARIABLES)
    end = expected.name in ("y_final", "y_peak")
    other = bool(sides) and of_another_argument(f"{sides[0]} = 0", of_a_variable=of_a_variable, at_its_end=end)
    if other or (of_a_variable and any(_is_of_own(side, expected.labels) for side in sides[:-1])):
        return []
    if polynomials.variable_of(ours) is not None and sides and sides[-1] == "0":
        sides = sides[:-1]
    if not sides:
        return []
    if any(map(expected.labels.is_own, sides[1:-1])):  # K = G(0) = 2
        sides = sides[[expected.labels.is_own(side) for side in sides].index(True) :]
    try:
        expected.labels.without(f"{sides[0]} = 0")
    except ForeignLabelError:
        if not (changes(sides[0]) and _is_formula(sides[0], ours, expected.labels)):
            return []
    written = [ScalarNode(node.place, side, "quoted") for side in sides]
    found = [[] if _VALUE_AT.fullmatch(side.text) else like(side) for side in written]
    *before, last = found
    if not last:
        return []
    known = symbols_of(last[0].value)
    how = [_says_how(side, expected) for side in sides]
    values = [
        [] if formula else [each for each in one if symbols_of(each.value) <= known]
        for formula, one in zip(how, before, strict=False)
    ]
    for side, known_values in zip(sides, values, strict=False):
        if known_values and not any(same(each, one) for each in known_values for one in last):
            raise node.fault(f"{side} and {sides[-1]} are not equal")
    named = values[0] or expected.labels.may_define(sides[0]) or _is_formula(sides[0], ours, expected.labels) or how[0]
    named = named or (bool(symbols_of(ours)) and is_general(sides[0], expected.labels))
    return last if named or polynomials.compares(ours, found[0], known) else []


def _is_of_own(side: str, labels: Labels) -> bool:
    """Whether a side is another quantity that is made of the one asked for: t f(t), dy/dt, 2 y; no loop of G."""
    if not labels.before(f"{side} = 0")[0] or is_general(side, labels):
        return False
    words = [_DOT.sub("", word) for word in _WORDS.findall(normalize("NFD", side))]
    words += [word[1:] for word in words if word[0] == "d" and len(word) > 1]
    return any(not word[-1].isdigit() and not labels.before(f"{word} = 0")[0] for word in words)


def _says_how(text: str, expected: Expected) -> bool:
    """Whether a text says how a value is found from values of functions, or from components beside signals."""
    signals = expected.signals.names if expected.signals else ()
    return says_how(text, signals, of_functions=expected.name in ("error", *SIGNALS, "y_steady_state"))


def _is_formula(text: str, ours: Any, labels: Labels) -> bool:
    """Whether a text says how a number is found from other quantities: exp(-πζ/√(1-ζ²)), 1/K_v."""
    kind = sp.Expr | list if "±" in text else sp.Expr
    number = isinstance(ours, kind) and getattr(ours, "shape", (1, 1)) == (1, 1) and not symbols_of(ours)
    return number and labels.is_of_others(text)
