"""The transfer function of a signal-flow graph or block diagram: by Mason's rule, or by eliminating its nodes."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Check, Derivation, Given, Options, Task
from solver.lazy import numeric
from solver.numeric.judges import loops as judges
from solver.tasks.loops import flow_mistakes
from solver.tasks.loops.flow_steps import by_elimination_of, by_mason_of, graph_of

if TYPE_CHECKING:
    from solver.systems import SignalFlow


@dataclass(frozen=True, kw_only=True)
class ReductionOptions(Options):
    """Nothing: input and output are those of the graph."""


block_diagram_reduction: Task[SignalFlow, ReductionOptions] = Task(
    "block_diagram_reduction",
    title="Reduction of a block diagram",
    doc="The transfer function of a signal-flow graph, with its paths and loops or node by node.",
    needs=("signal_flow",),
    options=ReductionOptions,
    answers=[
        AnswerName("G", "T", "the transfer function from the input to the output", principal=True,
                   earned=("paths", "loops", "no_loops", "determinant", "cofactors", "equations", "eliminate")),
        AnswerName("forward_paths", "P_k", "the gains of the forward paths", ("mason",), earned=("paths",)),
        AnswerName("loops", "L_k", "the gains of the loops", ("mason",), earned=("loops", "no_loops")),
        AnswerName("determinant", r"\Delta", "the determinant of the graph", ("mason",), earned=("determinant",)),
    ],
)  # fmt: skip


@block_diagram_reduction.method("mason", title="Mason's rule", source="S. J. Mason, Proc. IRE 44 (1956), 920–926")
def by_mason(given: Given[SignalFlow, ReductionOptions]) -> Derivation[Answers]:
    """G = Σ Pₖ Δₖ/Δ."""
    edges = yield from graph_of(given.system)
    found = yield from by_mason_of(given.system, edges)
    return Answers(
        G=found.transfer,
        forward_paths=[path.gain for path in found.paths],
        loops=[loop.gain for loop in found.loops],
        determinant=found.determinant,
    )


@block_diagram_reduction.method(
    "elimination", title="Elimination of nodes", source="Ogata, Modern Control Engineering, §2–3"
)
def by_elimination(given: Given[SignalFlow, ReductionOptions]) -> Derivation[Answers]:
    """The equation of a node put into those of the nodes that follow it, until input and output are left."""
    edges = yield from graph_of(given.system)
    return Answers(G=(yield from by_elimination_of(given.system, edges)))


SOLVED = "mpmath.lu_solve at random points"
TOLERANCE = 1e-20


def _branches(given: Given[SignalFlow, ReductionOptions]) -> list[tuple[str, str, Any]]:
    return [(each.source, each.target, each.gain) for each in given.system.branches]


@block_diagram_reduction.verification("G")
def solves_the_equations(given: Given[SignalFlow, ReductionOptions], answers: Answers) -> Iterable[Check]:
    """The linear equations of the graph in numbers."""
    graph = given.system
    residual = partial(judges.transfer_residual, _branches(given), graph.input, graph.output, answers["G"])
    yield numeric.check_residual("$y = G\\,r$ in the equations of the graph", SOLVED, residual, TOLERANCE, answer="G")


@block_diagram_reduction.verification("determinant")
def is_that_of_the_equations(given: Given[SignalFlow, ReductionOptions], answers: Answers) -> Iterable[Check]:
    """Δ = det(I − A), A the matrix of the gains."""
    residual = partial(judges.determinant_residual, _branches(given), answers["determinant"])
    yield numeric.check_residual(r"$\Delta = \det(I - A)$", "mpmath.det at random points", residual,
                                 TOLERANCE, answer="determinant")  # fmt: skip


@block_diagram_reduction.verification("forward_paths")
def are_all_paths(given: Given[SignalFlow, ReductionOptions], answers: Answers) -> Iterable[Check]:
    """Paths counted over sets of nodes, their gains in numbers."""
    graph = given.system
    right = judges.are_paths(_branches(given), graph.input, graph.output, list(answers["forward_paths"]))
    yield Check.that("these are the gains of all forward paths", "counted", right, answer="forward_paths")


@block_diagram_reduction.verification("loops")
def are_all_loops(given: Given[SignalFlow, ReductionOptions], answers: Answers) -> Iterable[Check]:
    """Loops counted over sets of nodes, their gains in numbers."""
    right = judges.are_loops(_branches(given), list(answers["loops"]))
    yield Check.that("these are the gains of all loops", "counted", right, answer="loops")


flow_mistakes.register(block_diagram_reduction)
