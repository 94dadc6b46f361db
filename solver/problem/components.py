"""A resistor or a capacitor as a file gives it: by its name, R1, or by its value, {R: 5000}."""

from __future__ import annotations

import re
from collections.abc import Mapping

import sympy as sp

from solver.problem.lexicon import Lexicon
from solver.problem.nodes import MappingNode, Node, ScalarNode, scalar

LETTERS = {"R": "a resistance", "C": "a capacitance"}
OTHERS = "an element is a resistor or a capacitor: a name that begins with R or C, as R1, or its value, as {R: 5000}"
MULTIPLES = {"M": 6, "k": 3, "m": -3, "u": -6, "μ": -6, "µ": -6, "n": -9, "p": -12}
"""What stands before ohms and farads, which would be names here."""
MULTIPLE = rf"([0-9.]+(?:[eE][+-]?[0-9]+)?)\s*({'|'.join(MULTIPLES)})?\s*(ohm|Ohm|Ω|Ω|F)?"


def read_component(node: Node, lexicon: Lexicon, barred: Mapping[str, str]) -> tuple[str, str, sp.Expr]:
    """Return the letter of a component, its name ("" without one) and its value, which is not zero; raises Fault."""
    if not isinstance(node, MappingNode):
        return _named(scalar(node), lexicon, barred)
    if len(node.entries) != 1:
        raise node.fault("one value is expected here, {R: ..} or {C: ..}")
    (letter,) = node.entries
    value = node[letter]
    _check_multiple(scalar(value), "")
    return letter, "", _checked(letter, lexicon.expression(value, barred=barred), value)


def _named(node: ScalarNode, lexicon: Lexicon, barred: Mapping[str, str]) -> tuple[str, str, sp.Expr]:
    text = node.text.strip()
    letter = text[:1]
    if re.fullmatch(MULTIPLE, text):
        _check_multiple(node, "R")
        raise node.fault("a number does not say what it is", note=f"write {{R: {text}}} or {{C: {text}}}")
    if letter not in LETTERS or not re.fullmatch(r"\w+", text):
        upper = letter.upper() + text[1:]
        like = upper if letter.upper() in LETTERS and re.fullmatch(r"\w+", text) else ""
        raise node.fault(OTHERS, suggestion=like)
    return letter, text, _checked(letter, lexicon.expression(node, barred=barred), node)


def _check_multiple(node: ScalarNode, letter: str) -> None:
    """Refuse 5k, which would be the product 5·k, and units."""
    found = re.fullmatch(MULTIPLE, node.text.strip())
    if found is None or not (found[2] or found[3]):
        return
    power = f"{found[1]}e{MULTIPLES[found[2]]}" if found[2] else found[1]
    letter = "C" if found[3] == "F" else letter
    note = f"write {{{letter}: {power}}}" if letter else f"write {power}"
    raise node.fault("values are numbers in ohms and farads, without a unit", note=note)


def _checked(letter: str, value: sp.Expr, node: Node) -> sp.Expr:
    if value.is_positive is False:
        raise node.fault(f"{LETTERS[letter]} is positive")
    return value
