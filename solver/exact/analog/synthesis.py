"""The program of a machine that computes machine equations in volts: amplifiers, inverters, potentiometers, sources.

A coefficient c is the product of a gain of the machine and the setting of a potentiometer, c = gain · setting with
0 < setting ≤ 1; one above the largest gain takes several inputs beside each other.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import sympy as sp

from solver.exact.analog.machine_equations import MachineEquations, Terms
from solver.exact.analog.signs import SignedRow, Signs, carried_signs
from solver.patches import Element, Program

MOST_INPUTS = 3
"""Inputs of the largest gain that one signal may take of an amplifier."""
DIGITS = 30


class TooLarge(ValueError):  # noqa: N818 - a case, no mishap
    """A coefficient is larger than the machine can make it: that of `term` in the equation of `variable`."""

    def __init__(self, variable: sp.Symbol, term: sp.Expr, coefficient: sp.Expr, most: sp.Expr) -> None:
        super().__init__(f"{coefficient} > {most}")
        self.variable, self.term, self.coefficient, self.most = variable, term, coefficient, most
        self.inputs = MOST_INPUTS


class NoBound(ValueError):  # noqa: N818 - a case, no mishap
    """A function of time has no bound that is seen, so that no source can give it within the reference."""

    def __init__(self, function: sp.Expr) -> None:
        super().__init__(str(function))
        self.function = function


@dataclass(frozen=True)
class Row:
    """What one amplifier computes: a variable, or its derivative where it has an `initial` value."""

    variable: sp.Symbol
    terms: Terms
    initial: sp.Expr | None


@dataclass(frozen=True)
class Wire:
    """How a term reaches an amplifier: `sign` · `volts` · term comes from the element `origin`, then `pot` if any.

    `coefficient` is that of the term in the equation of `variable`, `part` what this wire makes of its size: gain times
    setting times `volts`. `into` is the id of the amplifier, `through` that it is a summer before the variable's own,
    whose output goes on with the gain `through`.
    """

    variable: sp.Symbol
    term: sp.Expr
    coefficient: sp.Expr
    part: sp.Expr
    sign: int
    volts: sp.Expr
    origin: str
    pot: str
    setting: sp.Expr
    gain: sp.Expr
    into: str
    through: sp.Expr | None = None


@dataclass(frozen=True)
class Synthesis:
    """A program and its reasons: what each amplifier computes, the signs, the wires in the order of the pots."""

    program: Program
    rows: tuple[Row, ...]
    signs: Signs
    wires: tuple[Wire, ...]
    amplifiers: Mapping[sp.Expr, str]
    inverters: Mapping[sp.Expr, str]
    collectors: Mapping[sp.Symbol, str]


def synthesized(
    equations: MachineEquations,
    readout: Mapping[str, tuple[sp.Symbol, sp.Expr]],
    gains: Sequence[sp.Expr],
    reference: sp.Expr,
) -> Synthesis:
    """Return the program with the fewest amplifiers; `readout` gives variables of the question as factor · variable.

    Raises TooLarge, NoBound.
    """
    rows = [Row(each.variable, each.terms, each.initial) for each in equations.integrated]
    rows += [Row(each.variable, each.terms, None) for each in equations.summed]
    through = {row.variable: _gain_behind(row, gains, equations.inputs) for row in rows}
    own = {each.variable for each in rows} | set(equations.inputs)
    signed = [
        SignedRow(row.variable, {x: _sign(c) for x, c in row.terms.items() if x in own}, bool(through[row.variable]))
        for row in rows
    ]
    bench = _Bench(carried_signs(signed), list(gains), reference, set(equations.inputs))
    bench.name(rows)
    for row in rows:
        bench.patch(row, through[row.variable])
    return bench.synthesis(rows, readout)


def _sign(c: sp.Expr) -> int:
    return 1 if sp.N(c, DIGITS) > 0 else -1


def _at_most(a: sp.Expr, b: sp.Expr) -> bool:
    """Whether a ≤ b, of numbers that may be equal without being written alike."""
    return bool(sp.N(a - b, DIGITS) < sp.Float(10) ** -20)


def _gain_behind(row: Row, gains: Sequence[sp.Expr], inputs: Sequence[sp.Symbol]) -> sp.Expr | None:
    """The gain with which a summer of some terms may go on without leaving the range; None where there is none.

    A summer gives 1/gain of its sum. The range of inputs that are names is not known; their sum goes on with the
    smallest gain.
    """
    ordered = sorted(gains, key=sp.N)
    terms = [x for x in row.terms if getattr(x, "is_Symbol", False)]
    if row.initial is None and all(x in inputs for x in terms):
        return ordered[0]
    total = sp.Add(*(abs(row.terms[x]) for x in terms))
    return next((gain for gain in ordered if _at_most(total, gain)), None)


@dataclass
class _Bench:
    """The elements as they are put on the bench."""

    signs: Signs
    gains: list[sp.Expr]
    reference: sp.Expr
    inputs: set[sp.Symbol]
    sources: dict[sp.Expr, str] = field(default_factory=dict)
    pots: list[Element] = field(default_factory=list)
    amplifiers: dict[sp.Expr, str] = field(default_factory=dict)
    inverters: dict[sp.Expr, str] = field(default_factory=dict)
    collectors: dict[sp.Symbol, str] = field(default_factory=dict)
    patched: list[Element] = field(default_factory=list)
    wires: list[Wire] = field(default_factory=list)

    def name(self, rows: Sequence[Row]) -> None:
        """Number the amplifiers: those of the equations first, then the summers before them and the inverters."""
        named = [row.variable for row in rows]
        self.amplifiers = {x: f"A{i}" for i, x in enumerate(named, 1)}
        self.collectors = {x: f"A{len(named) + i}" for i, x in enumerate(self.signs.collected, 1)}
        first = len(named) + len(self.collectors)
        self.inverters = {x: f"A{first + i}" for i, x in enumerate(self.signs.inverted, 1)}

    def patch(self, row: Row, through: sp.Expr | None) -> None:
        """Put the amplifier of an equation on the bench, and a summer before it where the signs have one."""
        own, sign = self.amplifiers[row.variable], self.signs.of[row.variable]
        collector = self.collectors.get(row.variable)
        inputs: list[tuple[str, sp.Expr]] = []
        collected: list[tuple[str, sp.Expr]] = []
        for term, c in row.terms.items():
            wanted = -sign * _sign(c)
            if collector and self._is_wrong(term, wanted):
                collected += self._wired(row.variable, (term, c), -wanted, collector, through)
            else:
                inputs += self._wired(row.variable, (term, c), wanted, own)
        if collector and through is not None:
            self.patched.append(Element(collector, "summer", tuple(collected)))
            inputs.append((collector, through))
        initial = None if row.initial is None else sign * row.initial
        kind = "summer" if row.initial is None else "integrator"
        self.patched.append(Element(own, kind, tuple(inputs), initial=initial))

    def _is_wrong(self, term: sp.Expr, wanted: int) -> bool:
        """Whether a signal is there with the other sign only; a source may have any sign."""
        return (term in self.amplifiers or term in self.inputs) and self.signs.of.get(term, 1) != wanted

    def _wired(
        self, variable: sp.Symbol, part: tuple[sp.Expr, sp.Expr], sign: int, into: str, through: sp.Expr | None = None
    ) -> list[tuple[str, sp.Expr]]:
        """The inputs that a term takes, through potentiometers where its coefficient is no gain."""
        term, c = part
        origin, volts = self._origin(term, sign)
        size = sp.cancel(abs(c) / volts / (1 if through is None else through))
        inputs = []
        for gain, setting in self._shares(variable, term, size):
            pot = ""
            if setting != 1:
                pot = f"P{len(self.pots) + 1}"
                self.pots.append(Element(pot, "pot", ((origin, sp.S.One),), setting=setting))
            inputs.append((pot or origin, gain))
            made = sp.cancel(gain * setting * volts)
            self.wires.append(Wire(variable, term, c, made, sign, volts, origin, pot, setting, gain, into, through))
        return inputs

    def _shares(self, variable: sp.Symbol, term: sp.Expr, size: sp.Expr) -> list[tuple[sp.Expr, sp.Expr]]:
        """A coefficient as gains with settings: full inputs of the largest gain, and one that makes up the rest."""
        ordered = sorted(self.gains, key=sp.N)
        largest = ordered[-1]
        if not _at_most(size, MOST_INPUTS * largest):
            raise TooLarge(variable, term, size, largest)
        shares = []
        rest = size
        while not _at_most(rest, largest):
            shares.append((largest, sp.S.One))
            rest = sp.cancel(rest - largest)
        gain = next(each for each in ordered if _at_most(rest, each))
        setting = sp.S.One if _at_most(gain, rest) else sp.cancel(rest / gain)
        if not setting.is_Rational:
            setting = sp.N(setting, DIGITS)  # a dial has digits
        return [*shares, (gain, setting)]

    def _origin(self, term: sp.Expr, sign: int) -> tuple[str, sp.Expr]:
        """The element that gives sign · volts · term, and these volts."""
        if term in self.amplifiers or term in self.inputs:
            if self.signs.of.get(term, 1) != sign:
                return self.inverters[term], sp.S.One
            return self.amplifiers[term] if term in self.amplifiers else self._source(term), sp.S.One
        volts = self.reference if term == 1 else sp.cancel(self.reference / bound(term))
        return self._source(sign * volts * term), volts

    def _source(self, value: sp.Expr) -> str:
        return self.sources.setdefault(value, f"U{len(self.sources) + 1}")

    def synthesis(self, rows: Sequence[Row], readout: Mapping[str, tuple[sp.Symbol, sp.Expr]]) -> Synthesis:
        """The program of what stands on the bench."""
        for term, name in self.inverters.items():
            origin = self.amplifiers[term] if term in self.amplifiers else self._source(term)
            self.patched.append(Element(name, "inverter", ((origin, sp.S.One),)))
        order = {f"A{i}": i for i in range(len(self.patched) + 1)}
        elements = [Element(name, "source", value=value) for value, name in self.sources.items()]
        elements += [*self.pots, *sorted(self.patched, key=lambda each: order[each.id])]
        read = {name: (self.amplifiers[x], self.signs.of[x] * factor) for name, (x, factor) in readout.items()}
        program = Program(self.reference, tuple(elements), read)
        named = (self.amplifiers, self.inverters, self.collectors)
        return Synthesis(program, tuple(rows), self.signs, tuple(self.wires), *named)


def bound(function: sp.Expr) -> sp.Expr:
    """Return a bound of |f(t)| for t ≥ 0 that is seen by its factors. Raises NoBound."""
    found: list[sp.Expr] = []
    powers, decay = sp.S.Zero, sp.S.Zero
    for factor in sp.Mul.make_args(function):
        base, exponent = factor.as_base_exp()
        if isinstance(factor, sp.sin | sp.cos | sp.Heaviside) or not factor.free_symbols:
            found.append(sp.S.One if factor.free_symbols else abs(factor))
        elif isinstance(base, sp.sin | sp.cos) and exponent.is_Integer and exponent > 0:
            found.append(sp.S.One)
        elif isinstance(factor, sp.exp) and (rate := _rate(factor.args[0])) is not None and rate[0] < 0:
            decay -= rate[0]
            found.append(sp.exp(rate[1]))
        elif base.is_Symbol and exponent.is_Integer and exponent > 0:
            powers += exponent
        else:
            raise NoBound(function)
    if powers and not decay:
        raise NoBound(function)
    if powers:
        found.append((powers / (decay * sp.E)) ** powers)
    return sp.Mul(*found)


def _rate(exponent: sp.Expr) -> tuple[sp.Expr, sp.Expr] | None:
    """a and b of an exponent a t + b; None of another one."""
    symbols = sorted(exponent.free_symbols, key=str)
    if len(symbols) != 1:
        return None
    slope = sp.diff(exponent, symbols[0])
    return None if slope.free_symbols else (slope, exponent.xreplace({symbols[0]: sp.S.Zero}))
