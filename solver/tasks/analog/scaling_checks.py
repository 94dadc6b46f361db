"""The judges' view of a scaling: the question's own equations, simulated and evaluated; no derivation takes part."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

from solver.derivation import Check, Claim, Given
from solver.lazy import numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import analog as judges
from solver.stated.algebra import quotient
from solver.tasks.analog.machine_form import machine_model
from solver.tasks.analog.machine_options import initial_of, states_of
from solver.tasks.modelling.questions import question_of
from solver.words import Phrase, Reason, formula

if TYPE_CHECKING:
    from solver.jets import Jet
    from solver.systems import Equations
    from solver.tasks.analog.machine_options import MachineOptions

SIMULATED = "scipy.linalg.expm, step by step"
EVALUATED = "the equations at random points"
CLOSE = 1e-11
"""What doubles leave of coefficients where the largest sizes are given."""


class Truth:
    """What is given, as numbers see it; the variables by name, in the order of the states."""

    def __init__(self, given: Given[Equations, MachineOptions]) -> None:
        options, own = given.options, given.system
        self.model = model = machine_model(own, initial_of(own, options))
        initial = initial_of(own, options) if model is own else model.initial
        self.reference, self.beta = options.volts, options.beta
        inputs = {name: (options.input or {}).get(name) for name in model.inputs}
        self.states = states_of(model)
        read = {} if self.states else {name: model.symbol((name, 0)) for name in model.unknowns}
        self.asked = judges.Asked(question_of(model), initial, inputs, read, (), self.beta, self.reference, {})
        self.given: Mapping[Jet, Any] = options.maximum or {}
        others = [jet for jet in self.given if jet not in self.states]
        self.jets = {str(model.symbol(jet)): jet for jet in (*(self.states or [(n, 0) for n in read]), *others)}

    @cached_property
    def sizes(self) -> Mapping[Jet, Any]:
        """The largest size of each variable: as given, else by simulation."""
        lacking = [jet for jet in self.jets.values() if jet not in self.given]
        found = judges.largest_sizes(self.asked) if lacking else {}
        return {jet: self.given[jet] if jet in self.given else sp.Float(found[jet], 17) for jet in self.jets.values()}

    @cached_property
    def factors(self) -> dict[Jet, Any]:
        """Reference over largest size; 1 for what stays zero."""
        return {jet: sp.S.One if size.is_zero else self.reference / size for jet, size in self.sizes.items()}

    @property
    def volts(self) -> dict[str, Jet]:
        """The variables in volts by name: X1, X2, … of the states, capitals of the others."""
        named = {f"X{i}": jet for i, jet in enumerate(self.states, 1)}
        return named | {name[0].upper() + name[1:]: jet for name, jet in self.jets.items() if jet not in self.states}

    @cached_property
    def near(self) -> float:
        """How near a value must be that rests on the largest sizes."""
        return CLOSE if all(jet in self.given for jet in self.jets.values()) else judges.accuracy(self.asked)


def of_maxima(given: Given[Equations, MachineOptions], answer: Any) -> Iterator[Check]:
    """Each largest size, and no other name."""
    truth = Truth(given)
    yield from _each(truth, answer, truth.sizes, "the largest size of ${x}$")


def of_factors(given: Given[Equations, MachineOptions], answer: Any) -> Iterator[Check]:
    """Reference over largest size, of each variable."""
    truth = Truth(given)
    yield from _each(truth, answer, truth.factors, "reference over the largest size of ${x}$")


def _each(truth: Truth, answer: Any, wanted: Mapping[Jet, Any], label: str) -> Iterator[Check]:
    """The values by name: exactly where all is given, else as near as a simulation can tell."""
    found = {str(name): value for name, value in dict(answer).items()}
    yield Check.that("the names of the variables", "compared", set(found) == set(truth.jets))
    for name, jet in truth.jets.items():
        if name not in found:
            continue
        says = Phrase(label, x=formula(truth.model.symbol(jet)))
        if jet in truth.given:
            yield numeric.check_claim(Claim(found[name], quotient(wanted[jet], sp.S.One)), says)
        else:
            gap = abs(complex(sp.N(found[name] - wanted[jet], 17)))
            yield Check.within(says, SIMULATED, gap / max(abs(float(wanted[jet])), 1e-300) if gap else 0.0, truth.near)


def of_equations(given: Given[Equations, MachineOptions], answer: Any) -> Iterator[Check]:
    """Each derivative of a voltage, at random points."""
    truth = Truth(given)
    found = {str(name): value for name, value in dict(answer).items()}
    names = [f"X{i}_dot" for i, _ in enumerate(truth.states, 1)] or [
        name for name, jet in truth.volts.items() if jet[0] in truth.model.unknowns
    ]
    yield Check.that("the names of the voltages", "compared", set(found) == set(names))
    if set(found) != set(names):
        return
    residuals = judges.scaled_residuals(truth.asked, truth.factors, [found[name] for name in names], truth.volts)
    for name, residual in zip(names, residuals, strict=True):
        near = max(truth.near, 1e-8 if numeric.holds_decimals([found[name]]) else 0.0)
        says = Phrase("the change of ${x}$", x=formula(sp.Symbol(name.removesuffix("_dot"), real=True)))
        yield Check.within(says, EVALUATED, residual, near)


def what_maxima_would_mean(given: Given[Equations, MachineOptions], answer: Any) -> Reason | None:
    """Whether nothing overloads with a value that is too large, or a variable leaves the range with one too small."""
    truth = Truth(given)
    found = {str(name): value for name, value in dict(answer).items()}
    if set(found) != set(truth.jets) or any(not value.is_real for value in found.values()):
        return None
    for name, jet in truth.jets.items():
        value, size = float(found[name]), float(truth.sizes[jet])
        if jet not in truth.given and abs(value - size) > 0.01 * size:
            values = {"x": truth.model.symbol(jet), "value": found[name], "size": sp.Float(size, 5)}
            return Reason("machines/needlessly_large", values) if value > size else Reason("machines/passed", values)
    return None
