"""What names mean in an answer."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from solver.problem.expressions import Names
from solver.symbols import MEANINGS, SAMPLES


def names_for(symbols: Mapping[str, sp.Symbol], values: Mapping[str, Any], ours: Any, discrete: bool) -> Names:
    """Return what names mean in an answer: symbols of the problem and of our answers, and the usual variables."""
    usual = (*MEANINGS, *(name for name in SAMPLES if discrete or name not in {*symbols, *values}))
    own = {str(symbol): symbol for symbol in symbols_of(ours)}
    known = {**symbols, **own}
    variables: dict[str, Any] = {name: sp.Symbol(name) for name in usual if name not in own}
    units = {"i": sp.I, "I": sp.I, "E": sp.E}
    variables |= {name: unit for name, unit in units.items() if name not in known and name not in values}
    kept = {name: value for name, value in values.items() if name not in own}
    return Names(known, variables, kept, open=True, impulses=not discrete)


def symbols_of(value: Any) -> set[sp.Symbol]:
    """Return the symbols in a value, in whatever it is made of."""
    if isinstance(value, Mapping):
        return set().union(*(symbols_of(each) for pair in value.items() for each in pair))
    if isinstance(value, list | tuple):
        return set().union(*map(symbols_of, value))
    return set(getattr(value, "free_symbols", ()))


def unknown_of(name: Any, ours: Mapping[Any, Any]) -> Any:
    """Return the unknown y of ours that is called y_k or y_n; any other name as it is."""
    bare = sp.Symbol(str(name).rpartition("_")[0])
    indexed = str(name).endswith(("_k", "_n", "_t"))
    if isinstance(name, sp.Mul) and len(name.args) == 2 and {str(x) for x in name.args} & {"k", "n", "t"}:  # y[n], yk
        return next((each for each in ours if each in name.args), name)
    return next((each for each in ours if str(each) == str(bare)), name) if indexed and name not in ours else name
