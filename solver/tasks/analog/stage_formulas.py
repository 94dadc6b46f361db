"""The formulas of an inverting stage as a person writes them: currents, the output in time, its transform."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product, quotient, total
from solver.stated.calculus import denoted, derivative

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import OpAmp
    from solver.systems.op_amp import Part, Stage

TIME, S = "t", "s"
UNITS = {"RR": "", "CC": "", "RC": "per_second", "CR": "second"}
"""The unit of Z_f/Z by the letters of the part at the input and of that in the feedback, without its power of s."""


def by_name(part: Part) -> Any:
    """The value of a part, shown by its symbol."""
    return part.value if part.value == part.symbol else denoted(part.symbol, part.value)


def sum_of(terms: list[Any]) -> Any:
    """One term by itself, or a sum."""
    return terms[0] if len(terms) == 1 else total(*terms)


def less(value: Any, moved: Any) -> Any:
    """The difference; v + 2 where −2 is taken away."""
    if moved == 0:
        return value
    return total(value, -moved) if moved.could_extract_minus_sign() else difference(value, moved)


@dataclass(frozen=True)
class StageFormulas:
    """A stage with its number (0: there is one only) and what its inputs are before t = 0."""

    system: OpAmp
    stage: Stage
    number: int
    starts: Mapping[str, Any]

    @property
    def response(self) -> exact.StageResponse:
        """The output by the inputs of the stage."""
        found: exact.StageResponse = exact.stage_response(self.stage, {}, self.starts)
        return found

    @property
    def static(self) -> bool:
        """Whether there are resistors only."""
        return self.stage.feedback.letter == "R" and all(part.letter == "R" for _, part in self.stage.inputs)

    @property
    def numeric(self) -> bool:
        """Whether a part has a value of its own."""
        return any(part.value != part.symbol for part in self.parts)

    @property
    def parts(self) -> list[Part]:
        """The parts at the inputs, then that in the feedback."""
        return [*(part for _, part in self.stage.inputs), self.stage.feedback]

    @property
    def output(self) -> Expr:
        """The output in time."""
        names = dict.fromkeys(name for name, _ in self.stage.inputs)
        return self.response.in_time({name: self.system.symbol(name) for name in names})

    @property
    def transformed(self) -> Expr:
        """Its transform."""
        names = dict.fromkeys(name for name, _ in self.stage.inputs)
        return self.response.transform({name: self.system.transform(name) for name in names})

    def signal(self, name: str) -> Any:
        """A signal, shown by its symbol; where something is differentiated or integrated it is a function of time."""
        symbol = self.system.symbol(name)
        return symbol if self.static else denoted(symbol, exact.of_time(symbol, 0))

    def index(self, j: int) -> str:
        """The index of the current through the part at the input j, 0 for the feedback."""
        own = "f" if j == 0 else str(j) if len(self.stage.inputs) > 1 or self.number else ""
        return f"{own}{self.number}" if j == 0 and self.number else f"{self.number or ''}{own}"

    def currents(self) -> Iterator[tuple[str, Any]]:
        """The index and the law of each current into the minus input, that of the feedback last."""
        t = sp.Symbol(TIME)
        for j, (name, part) in enumerate(self.stage.inputs, 1):
            v = self.signal(name)
            yield self.index(j), quotient(v, by_name(part)) if part.letter == "R" else product(
                by_name(part), derivative(v, t))  # fmt: skip
        part, v = self.stage.feedback, denoted(self.system.symbol(self.stage.output), self.functions())
        yield self.index(0), quotient(v, by_name(part)) if part.letter == "R" else product(
            by_name(part), derivative(v, t))  # fmt: skip

    def functions(self) -> Expr:
        """The output with all signals as functions of time, unless the stage is static."""
        if self.static:
            return self.output
        names = [name for name, _ in self.stage.inputs]
        symbols = map(self.system.symbol, names)
        moved: Expr = self.output.xreplace({symbol: exact.of_time(symbol, 0) for symbol in symbols})
        return moved

    def integrated(self) -> Any:
        """The charges that have flown to the minus input since t = 0, from the output too; their sum is zero."""
        terms = []
        for name, part in self.stage.inputs:
            v = self.system.symbol(name)
            if part.letter == "R":
                terms.append(product(quotient(1, by_name(part)), exact.of_time(v, -1)))
            else:
                moved = self.starts.get(name, 0)
                here = self.signal(name)
                terms.append(product(by_name(part), less(here, moved)))
        v_o = denoted(self.system.symbol(self.stage.output), self.functions())
        since = less(v_o, self.stage.initial)
        return sum_of([*terms, product(by_name(self.stage.feedback), since)])

    def gain(self, part: Part, *, numbers: bool = False) -> Any:
        """Z_f/Z without its power of s: by the symbols, or with the numbers put in."""
        show = (lambda each: each.value) if numbers else by_name
        match part.letter + self.stage.feedback.letter:
            case "RR":
                return quotient(show(self.stage.feedback), show(part))
            case "CC":
                return quotient(show(part), show(self.stage.feedback))
            case "RC":
                return quotient(1, product(show(part), show(self.stage.feedback)))
            case _:
                return product(show(self.stage.feedback), show(part))

    def in_time(self) -> Any:
        """The output as it is solved for: a term for each input, and what is held."""
        terms: list[Any] = [] if self.stage.initial == 0 else [self.stage.initial]
        for (name, part), (_, k) in zip(self.stage.inputs, exact.stage_gains(self.stage), strict=True):
            v: Any = self._here(name)
            moved = self.starts.get(name, 0) if part.letter == self.stage.feedback.letter == "C" else 0
            if k < 0:
                v = exact.of_time(self.system.symbol(name), k)
            elif k > 0:
                v = derivative(
                    denoted(self.system.symbol(name), exact.of_time(self.system.symbol(name), 0)), sp.Symbol(TIME)
                )
            terms.append(product(-1, self.gain(part), less(v, moved)))
        return sum_of(terms)

    def _here(self, name: str) -> Expr:
        varied = any(k for k in self.response.terms.get(name, {}))
        symbol = self.system.symbol(name)
        return exact.of_time(symbol, 0) if varied else symbol

    def impedances(self) -> Iterator[tuple[str, Any]]:
        """The index and the impedance of each part, that of the feedback last."""
        for j, part in zip((*range(1, len(self.stage.inputs) + 1), 0), self.parts, strict=True):
            Z = by_name(part)
            yield self.index(j), Z if part.letter == "R" else quotient(1, product(sp.Symbol(S), Z))

    def by_impedances(self, signals: Mapping[str, Any] | None = None) -> Any:
        """−Σ (Z_f/Z) V, and what is held over s; with other formulas in the place of transforms, where given."""
        *inputs, (index, Z_f) = self.impedances()
        terms = []
        for (name, part), (own, Z) in zip(self.stage.inputs, inputs, strict=True):
            ratio = quotient(denoted(f"Z_{{{index}}}", Z_f), denoted(f"Z_{{{own}}}", Z))
            terms.append(product(-1, ratio, self._arriving(name, part, signals)))
        return sum_of([*terms, *self._held()])

    def in_s(self, signals: Mapping[str, Any] | None = None) -> Any:
        """The same with the quotients of impedances."""
        s, terms = sp.Symbol(S), []
        for (name, part), (_, k) in zip(self.stage.inputs, exact.stage_gains(self.stage), strict=True):
            ratio = self.gain(part) if k == 0 else self._with_s(part, k, s)
            terms.append(product(-1, ratio, self._arriving(name, part, signals)))
        return sum_of([*terms, *self._held()])

    def _with_s(self, part: Part, k: int, s: Any) -> Any:
        feedback = by_name(self.stage.feedback)
        return product(s, feedback, by_name(part)) if k > 0 else quotient(1, product(s, by_name(part), feedback))

    def _arriving(self, name: str, part: Part, signals: Mapping[str, Any] | None) -> Any:
        """The transform of a signal; a capacitor passes its change since t = 0."""
        V = (signals or {}).get(name, self.system.transform(name))
        moved = self.starts.get(name, 0) if part.letter == "C" else 0
        return difference(V, quotient(moved, sp.Symbol(S))) if moved != 0 else V

    def _held(self) -> list[Any]:
        return [] if self.stage.initial == 0 else [quotient(self.stage.initial, sp.Symbol(S))]
