"""The drawing of a program: its elements with what a person writes beside them."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from solver.derivation.patch_figures import PatchDiagram, PatchElement
from solver.lazy import sympy as sp
from solver.words import formula

if TYPE_CHECKING:
    from sympy import Expr

    from solver.patches import Element, Program

MOST = 16
"""A program of more amplifiers is not drawn."""
LONGEST = 60
"""A source with a longer formula (as LaTeX) is drawn under its name."""
EXACT, DIGITS = 4, 4
"""Decimals of numbers that are written as they are, and digits of all others."""
LARGE = 10**4
"""A multiple of larger whole numbers is written as a decimal."""
DOTTED = re.compile(r"\\(d+ot)\{(\w+)(_\{\w+\})\}")
VOLT = r"\,\mathrm{V}"


def drawn(caption: str, program: Program, outputs: Mapping[str, Expr] | None = None) -> tuple[PatchDiagram, ...]:
    """Return the drawing; nothing where it would be illegible.

    `outputs` are the voltages of amplifiers, by id, in variables; those that are read out need none, nor inverted ones.
    """
    if len(program.of_kind("summer", "integrator", "inverter")) > MOST:
        return ()
    numbers = {each.id: i for i, each in enumerate(program.elements)}
    named = voltages(program, outputs or {})
    return (
        PatchDiagram(
            caption,
            tuple(
                PatchElement(
                    each.kind,
                    formula(sp.Symbol(each.id)),
                    tuple((numbers[fed], decimal(gain)) for fed, gain in each.inputs),
                    _written(each),
                    _voltage(named[each.id]) if each.id in named else "",
                )
                for each in program.elements
            ),
        ),
    )


def voltages(program: Program, outputs: Mapping[str, Expr]) -> dict[str, Expr]:
    """Return what the volts of elements are in variables: what is said, what is read out, and these inverted."""
    found = dict(outputs)
    for name, (element, factor) in program.readout.items():
        found[element] = sp.Symbol(name) / factor
    for each in program.of_kind("inverter"):
        if each.id not in found and each.inputs[0][0] in found:
            found[each.id] = -found[each.inputs[0][0]]
    return found


def _written(element: Element) -> str:
    """What stands beside a symbol: volts of a source and of a start, a setting."""
    if element.kind == "source":
        if element.value.free_symbols:
            text = formula(element.value)
            return text if len(text) <= LONGEST else formula(sp.Symbol(element.id))
        return ("+" if element.value > 0 else "") + decimal(element.value) + VOLT
    if element.kind == "pot":
        return decimal(element.setting)
    return decimal(element.initial) + VOLT if element.kind == "integrator" and element.initial != 0 else ""


def _voltage(volts: Expr) -> str:
    r"""Return a multiple of a variable in a line: -x/5, 2x/3, 0.4472\dot{x}; other sums as they are."""
    factor, variable = volts.as_coeff_Mul()
    if variable.is_Symbol and isinstance(factor, sp.Rational):
        size = "" if abs(factor.p) == 1 else str(abs(factor.p))
        under = "" if factor.q == 1 else f"/{factor.q}"
        if max(abs(factor.p), factor.q) < LARGE:
            return f"{'-' if factor < 0 else ''}{size}{_named(variable)}{under}"
    number, rest = volts.as_independent(*volts.free_symbols, as_Add=False)
    if rest.is_Symbol:
        return decimal(number) + _named(rest)
    return formula(volts)


def decimal(value: Any) -> str:
    """Return a number as a person writes it beside a symbol: 10, 0.35, 12.345; others in four digits: 0.3333, 28.76."""
    if isinstance(value, sp.Rational) and (10**EXACT * value).q == 1:
        shown = f"{float(value):.{EXACT}f}".rstrip("0").rstrip(".")
        return shown if value.q > 1 else str(value.p)
    digits, times, power = str(sp.latex(sp.N(value, DIGITS))).partition(" ")
    return "".join((digits.rstrip("0").rstrip(".") if "." in digits else digits, times, power))


def _named(symbol: Expr) -> str:
    r"""A variable, its index beside the dots: \dot{x}_{1}."""
    return DOTTED.sub(r"\\\1{\2}\3", formula(symbol))
