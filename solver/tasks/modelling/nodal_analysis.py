"""Lemma: the transfer function of a circuit by impedances and nodal analysis."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact, systems
from solver.lazy import sympy as sp
from solver.matrices import entry_alone
from solver.stated.algebra import product
from solver.tasks.modelling.circuit_figures import schematic_of
from solver.tasks.modelling.elimination import elimination_of
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.systems import Circuit, TransferFunction


@lemma("nodal_analysis")
def transfer_function_of_circuit(circuit: Circuit) -> Derivation[TransferFunction]:
    """Node voltages from the current law at each node, the outputs by them. Raises Unsolved."""
    s = sp.Symbol("s")
    if not circuit.inputs:
        raise Unsolved("circuits/no_input")
    model = exact.nodal_model(circuit, s)
    if model is None:
        raise Unsolved("circuits/no_voltages")
    yield Step("nodes", unclaimed="names", nodes=[each for each in circuit.nodes if each != "0"],
               figures=schematic_of(circuit))  # fmt: skip
    stored = [(sp.Symbol(f"Z_{each.name}"), Z) for each, Z in model.impedances if each.letter in "LC"]
    if stored:
        yield Step("impedances", unclaimed="the laws of the elements, transformed", impedances=stored)
    values, needed = model.solved.values, set(model.needed)
    for kind in ("sources", "shorts", "currents", "outputs"):
        laws = [law for law in getattr(model, kind) if law in needed]
        if laws:
            yield Step(kind, claims=dict(_held(laws, values)), laws=laws)
    yield from elimination_of(model.solved, [(law.left, law.right) for law in model.equations])
    yield _transfer(model)
    if any(sp.degree(N, s) > sp.degree(model.chi, s) for row in model.numerators for N in row if N != 0):
        raise Unsolved("equations/improper")
    denominators = tuple(tuple(model.chi for _ in row) for row in model.numerators)
    return systems.TransferFunction(model.matrix, model.numerators, denominators, s, input_names=circuit.inputs)


def _held(laws: list[exact.Law], values: Mapping[Symbol, Expr]) -> Iterator[tuple[str, Claim]]:
    """Each law with the values that were found."""
    for law in laws:
        says = Phrase("the law at {name}", name=law.of)
        yield f"of_{law.of}_{law.left}", Claim(law.left.xreplace(values), law.right.xreplace(values), says)


def _transfer(model: exact.NodalModel) -> Step:
    """The outputs, and the transfer function read off from them."""
    circuit, values = model.circuit, dict(model.solved.values)
    y, found = (sp.ImmutableMatrix(list(each)) for each in (circuit.outputs, model.found))
    u = sp.ImmutableMatrix([systems.symbol_of(name) for name in circuit.inputs])
    G = entry_alone(model.matrix)
    claims = {
        "outputs": Claim(entry_alone(y.xreplace(values)), entry_alone(found), "the outputs"),
        "G": Claim(product(G, entry_alone(u)), entry_alone(found), "$G(s)$ times the inputs"),
    }
    pairs = [(asked, value) for asked, value in zip(circuit.outputs, model.found, strict=True) if asked != value]
    return Step("transfer", claims=claims, x=model.variable, G=G, pairs=pairs, several=model.matrix.shape != (1, 1))
