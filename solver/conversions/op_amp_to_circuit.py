"""Stages of operational amplifiers as a circuit."""

from __future__ import annotations

from solver.derivation import Derivation, Step, lemma
from solver.derivation.conversion import conversion
from solver.systems import Circuit, OpAmp
from solver.tasks.analog.stage_netlists import circuit_of


@conversion(OpAmp, Circuit, gives=lambda has: {"circuit", *(has & {"inputs", "initial_state"})})
@lemma("op_amp")
def as_circuit(system: OpAmp) -> Derivation[Circuit]:
    """The netlist; the states are the voltages of capacitors, those in a feedback counted from the output."""
    circuit = circuit_of(system)
    yield Step("netlist", unclaimed="the elements as they are connected", circuit=circuit)
    return circuit
