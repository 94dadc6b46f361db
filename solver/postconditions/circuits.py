"""What was found of a circuit: compared with modified nodal analysis in numbers."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from solver.derivation import Check, Claim
from solver.numeric.judges import modelling as judges

ORACLE = "modified nodal analysis with numpy"
NEAR = 1e-8
VOLTAGES = "VEHO"
"""Elements whose currents are unknowns of their own in nodal analysis."""


def of_circuit_model(found: Any, circuit: Any) -> Iterator[Check | Claim]:
    """The laws hold; the state equations have the transfer functions and the natural frequencies of the circuit."""
    values = found.solved.values
    for law in found.needed:
        yield Claim(law.left.xreplace(values), law.right.xreplace(values))
    if found.solved.lacking or found.solved.tied:
        return
    rates = [(rate.factor, rate.value) for rate in found.rates]
    states = [rate.state for rate in found.rates]
    outputs = list(found.outputs) if circuit.is_linear else []
    moved, free = judges.state_residuals(circuit, rates, outputs, states)
    if outputs and circuit.inputs:
        yield Check.within("the outputs of the circuit at random $s$", ORACLE, moved, NEAR)
    yield Check.within("the natural frequencies of the circuit", ORACLE, free, NEAR)


def of_nodal_model(found: Any, circuit: Any, s: Any) -> Iterator[Check]:
    """The transfer functions are those of the circuit, the denominator has its natural frequencies."""
    if found is not None:
        names = [*(f"v_{node}" for node in circuit.nodes if node != "0"),
                 *(f"i_{each.name}" for each in circuit.elements if each.letter in VOLTAGES)]  # fmt: skip
        unknown = [name for name in names if name not in circuit.inputs]
        laws = len(found.sources) + len(found.shorts) + len(found.currents)
        yield Check.that("as many equations as unknowns", "counted", laws == len(unknown))
        residual = judges.transfer_residual(circuit, found.matrix, s)
        yield Check.within("the outputs of the circuit at random $s$", ORACLE, residual, NEAR)
        free = judges.frequencies_residual(circuit, found.chi, s)
        yield Check.within("the natural frequencies of the circuit", ORACLE, free, NEAR)
