"""Programs of machine equations: what each amplifier computes, the fewest amplifiers; when a variable overloads."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import product as every
from typing import Any

import sympy as sp

from solver.derivation import Check, Claim
from solver.patches import faults_of

TIME = sp.Symbol("t")
ALL_TRIED = 9
"""Up to so many amplifiers a program is said to be the best of all choices of signs."""
TRIED_OUT = 6
"""Up to so many amplifiers all signs are tried out."""
SAMPLES = 12
SEEN = 1e-9


def of_synthesized(
    found: Any, equations: Any, readout: Mapping[str, Any], gains: Sequence[Any], reference: Any
) -> Iterator[Claim | Check]:
    """Patched together, the elements give the equations with the signs that are told; it can be patched."""
    program, signs = found.program, found.signs.of
    known = {name: signs[x] * x for x, name in found.amplifiers.items()}
    volts = {each.id: known.get(each.id, each.value) for each in program.elements}

    def given(name: str) -> Any:
        if volts[name] is None:
            element = program[name]
            fed = sp.Add(*(gain * given(other) for other, gain in element.inputs))
            volts[name] = element.setting * fed if element.kind == "pot" else -fed
        return volts[name]

    for each in (*equations.integrated, *equations.summed):
        element, sign = program[found.amplifiers[each.variable]], signs[each.variable]
        fed = sp.Add(*(gain * given(other) for other, gain in element.inputs))
        yield Claim(sp.expand(-fed), sp.Add(*(sign * c * term for term, c in each.terms.items())))
        if element.kind == "integrator":
            yield Claim(element.initial, sign * each.initial)
    for wire in found.wires:
        yield Claim(given(wire.origin), wire.sign * wire.volts * wire.term)
    yield from _as_told(found, equations)
    for name, (x, factor) in readout.items():
        of, by = program.readout[name]
        yield Check.that("what is read out", "compared", of == found.amplifiers[x] and by == signs[x] * factor)
    yield Check.that("it can be patched", "compared", not list(faults_of(program, gains)))
    yield Check.that("the reference", "compared", program.reference == reference)
    amplifiers = len(found.amplifiers)
    tried = not found.signs.exhaustive or found.signs.tried == 2**amplifiers
    yield Check.that("all choices of signs", "counted", tried and found.signs.exhaustive == (amplifiers <= ALL_TRIED))
    yield from _fewest(found, equations)


def _as_told(found: Any, equations: Any) -> Iterator[Check]:
    """The rows are the equations, and each wire is one of the program."""
    rows = [(each.variable, dict(each.terms)) for each in (*equations.integrated, *equations.summed)]
    same = [(row.variable, dict(row.terms)) for row in found.rows] == rows
    same = same and [row.initial for row in found.rows] == [
        *(each.initial for each in equations.integrated), *(None for _ in equations.summed)
    ]  # fmt: skip
    yield Check.that("the equations of the amplifiers", "compared", same)
    settings = found.program.potentiometers
    for wire in found.wires:
        fed = (wire.pot or wire.origin, wire.gain) in found.program[wire.into].inputs
        own = settings[wire.pot] == wire.setting if wire.pot else wire.setting == 1
        rows_of = dict(rows)[wire.variable]
        yield Check.that("a wire", "compared", fed and own and rows_of[wire.term] == wire.coefficient)


def _fewest(found: Any, equations: Any) -> Iterator[Check]:
    """No choice of signs needs fewer inverters; counted by trying all of them."""
    rows = [(each.variable, each.terms) for each in (*equations.integrated, *equations.summed)]
    if len(rows) > TRIED_OUT:
        return
    own = {x for x, _ in rows}
    fixed = set(equations.inputs)
    least = []
    for signs in every((1, -1), repeat=len(rows)):
        carried = dict(zip((x for x, _ in rows), signs, strict=True))
        turned = {
            term
            for x, terms in rows
            for term, c in terms.items()
            if term in own | fixed and carried[x] * carried.get(term, 1) * (1 if sp.N(c) > 0 else -1) > 0
        }
        least.append(len(turned))
    added = len(found.inverters) + len(found.collectors)
    yield Check.that("no more amplifiers than inverters would do", "compared", added <= min(least, default=0))


def of_first_overload(found: Any, _equations: Any, maxima: Mapping[Any, Any]) -> Iterator[Claim | Check]:
    """At that time the size is reached; before, at samples, it is not."""
    if found is None:
        return
    x, time, motion = found
    last = float(time)
    sizes = [
        abs(complex(sp.N(motion.xreplace({TIME: sp.Float(last * i / SAMPLES)}), 15)).real) for i in range(SAMPLES + 1)
    ]
    limit = float(maxima[x])
    yield Check.that("the size is reached then", "sympy.N", abs(sizes[-1] - limit) <= SEEN * limit)
    yield Check.that("and not before", "sympy.N", all(each <= limit * (1 + SEEN) for each in sizes[:-1]))


def of_bound(found: Any, function: Any) -> Iterator[Check]:
    """The size at samples is at most the bound."""
    symbols = sorted(function.free_symbols, key=str)
    if len(symbols) == 1:
        values = [
            abs(complex(sp.N(function.xreplace({symbols[0]: sp.Rational(3 * i, 7)}), 15))) for i in range(SAMPLES)
        ]
        yield Check.that("a bound of a function", "sympy.N", max(values) <= float(found) * (1 + SEEN))
