"""Names of functions of time in options: of states, inputs and their derivatives."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

from solver.jets import Jet, jet_symbol
from solver.problem.source import did_you_mean

if TYPE_CHECKING:
    from sympy import Symbol

    from solver.problem.context import Context
    from solver.problem.nodes import Node, ScalarNode

DERIVATIVE = re.compile(r"_(?:d{1,3}ot|d[0-9]+)$")


def sample(text: str) -> Jet | None:
    """Return the function and the sample of a value y(0), y(-1); None where the text is none."""
    found = re.fullmatch(r"\s*(\w+)\s*\(\s*([+-]?)\s*([0-9]+)\s*\)\s*", text)
    return (found[1], int(found[2] + found[3])) if found else None


def known_jet(node: ScalarNode, context: Context, *, samples: bool = False) -> Jet:
    """Return the function that is named, x' or x_dot, and the order of its derivative.

    Where there may be `samples`, y(0) and y(-1) are read as such in discrete time.

    Raises Fault where the system is known and has no such function.
    """
    at = sample(node.text) if samples and context.discrete else None
    function, order = at or context.jet(node)
    known = getattr(context.system, "functions", None)
    plain = DERIVATIVE.sub("", function)
    if known is not None and function not in known and plain not in known:
        meant = did_you_mean(plain, known)
        suggestion = meant + function[len(plain) :] if meant else ""
        note = f"there are {', '.join(known)}" if len(known) > 1 else f"there is {known[0]}"
        raise node.fault(f"'{function[:40]}' is neither an unknown nor an input of the system",
                         suggestion=suggestion, note=note)  # fmt: skip
    return function, order


def symbol_of(jet: Jet, context: Context) -> Symbol:
    """Return the symbol of a function or a derivative, with what is assumed of it."""
    return jet_symbol(jet, discrete=context.discrete, assumed=context.lexicon.symbols)


def check_assumed(symbol: Symbol, value: Any, node: Node) -> None:
    """Raise Fault where a value contradicts what is assumed of what it is for."""
    words = (("positive", symbol.is_positive and value.is_nonpositive),
             ("negative", symbol.is_negative and value.is_nonnegative),
             ("nonzero", symbol.is_nonzero and value.is_zero))  # fmt: skip
    for word, wrong in words:
        if wrong:
            raise node.fault(f"this contradicts what is assumed of {symbol}: it is {word}")
