"""The drawing of a program: its elements with what a person writes beside them."""

from __future__ import annotations

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
PLACES = 4
"""Decimals of a setting or a voltage that is no shorter decimal."""
SMALL = 1e-3
"""What is smaller is written with a power of ten."""
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
        if max(abs(factor.p), factor.q) < 10**PLACES:
            return f"{'-' if factor < 0 else ''}{size}{formula(variable)}{under}"
    numbers = volts.as_independent(*volts.free_symbols, as_Add=False)
    if numbers[1].is_Symbol:
        return decimal(numbers[0]) + formula(numbers[1])
    return formula(volts)


def decimal(value: Any) -> str:
    """Return a number as a dial shows it: 10, 0.35, 0.3333."""
    exact = sp.Rational(value) if value.is_Rational else None
    if exact is not None and exact.q == 1:
        return str(exact.p)
    shown = float(value)
    if 0 < abs(shown) < SMALL:
        digits, power = f"{shown:.3e}".split("e")
        return rf"{digits.rstrip('0').rstrip('.')} \cdot 10^{{{int(power)}}}"
    return f"{shown:.{PLACES}f}".rstrip("0").rstrip(".")
