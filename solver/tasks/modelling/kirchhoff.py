"""Lemma: the state equations of a circuit by Kirchhoff's laws, along a tree of its branches."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact, systems
from solver.tasks.modelling.circuit_figures import schematic_of
from solver.tasks.modelling.elimination import elimination_of
from solver.words import Phrase

if TYPE_CHECKING:
    from solver.exact.modelling.circuits import CircuitModel, Law
    from solver.systems import Circuit, Equations


@lemma("kirchhoff")
def equations_of_circuit(circuit: Circuit) -> Derivation[Equations]:
    """L i' = v of each inductor and C v' = i of each capacitor, in states and inputs. Raises Unsolved."""
    tied = exact.degenerate(circuit)
    if tied is not None:
        what, elements = tied
        names = [element.name for element in elements]
        raise Unsolved("circuits/loop", names=names) if what == "loop" else Unsolved("circuits/cut", names=names)
    if not circuit.states:
        raise Unsolved("equations/no_states")
    model = exact.circuit_model(circuit)
    yield _tree(circuit)
    yield from _laws(model)
    if model.solved.tied:
        raise Unsolved("circuits/tied", relations=list(model.solved.tied))
    if model.solved.lacking:
        raise Unsolved("circuits/undetermined", symbols=list(model.solved.lacking))
    yield from elimination_of(model.solved, [law.sides for law in model.equations])
    yield _rates(model)
    return _equations(model)


def _tree(circuit: Circuit) -> Step:
    """The states, and the tree that the equations are written along."""
    tree = circuit.tree
    return Step(
        "tree",
        unclaimed="a choice",
        figures=schematic_of(circuit),
        branches=[each.name for each in tree.branches],
        links=[each.name for each in tree.links],
        states=[systems.symbol_of(name) for name in circuit.states],
    )


@lemma("kirchhoff")
def _laws(model: CircuitModel) -> Derivation[None]:
    """The laws that are needed: of elements, amplifiers, loops and cuts; they hold with what is found below."""
    needed = set(model.needed)
    for kind in ("laws", "shorts", "loops", "cuts", "nodes"):
        group = [law for law in getattr(model, kind) if law in needed]
        if group:
            yield Step(kind, claims=dict(_held(model, group)), laws=group)


def _held(model: CircuitModel, laws: list[Law]) -> Iterator[tuple[str, Claim]]:
    """Each law with the values that were found for its unknowns."""
    values = model.solved.values
    for law in laws:
        says = Phrase("the law at {name}", name=law.of)
        yield f"of_{law.of}", Claim(law.left.xreplace(values), law.right.xreplace(values), says)


def _rates(model: CircuitModel) -> Step:
    """The state equations and the outputs."""
    values = model.solved.values
    claims = {
        f"output{i}": Claim(output.xreplace(values), found, "output")
        for i, (output, found) in enumerate(zip(model.circuit.outputs, model.outputs, strict=True), 1)
    }
    pairs = zip(model.circuit.outputs, model.outputs, strict=True)
    outputs = [(asked, found) for asked, found in pairs if asked != found]
    rates = [(rate.factor * rate.derivative, rate.by, rate.value) for rate in model.rates]
    return Step("rates", claims=claims, rates=rates, outputs=outputs)


def _equations(model: CircuitModel) -> Equations:
    """The state equations with the outputs in states and inputs."""
    circuit = model.circuit
    jets = {systems.jet_symbol((name, 0)): (name, 0) for name in (*circuit.states, *circuit.inputs)}
    jets |= {systems.jet_symbol((name, 1)): (name, 1) for name in circuit.states}
    sides = tuple((rate.factor * rate.derivative, rate.value) for rate in model.rates)
    states = tuple((name, 0) for name in circuit.states)
    found = systems.Equations(sides, circuit.states, (), circuit.inputs, states, model.outputs, circuit.initial, jets)
    return found.assuming(circuit.assumed)
