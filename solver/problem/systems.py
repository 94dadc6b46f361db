"""A system as a problem file gives it, read into an exact object."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from solver.problem.lexicon import MEANINGS, SAMPLES, Lexicon, name_of
from solver.problem.matrices import counted, expect_shape, is_flat, read_matrix
from solver.problem.nodes import MappingNode, Node, SequenceNode, scalar
from solver.problem.rational_functions import Rational
from solver.problem.source import Report
from solver.problem.transfer_functions import read_transfer_function
from solver.systems import StateSpace, System, TransferFunction

NOTHING = StateSpace(A=sp.ImmutableMatrix(0, 0, []), bare=True)
"""Stands for the system of a question that is about none."""


def read_system(node: MappingNode, lexicon: Lexicon) -> System:
    """Return the system of a mapping whose shape is right; raises Fault with everything else that is wrong."""
    discrete = "time" in node and scalar(node["time"]).text == "discrete"
    report = Report()
    sample_time = None
    system: System = NOTHING
    with report:
        sample_time = _sample_time(node, lexicon, discrete)
    with report:
        if "transfer_function" in node or "transfer_matrix" in node:
            system = _transfer_function(node, lexicon, discrete, sample_time)
        elif "matrix" in node:
            A = read_matrix(node["matrix"], "matrix", lexicon, barred=_barred(discrete))
            system = StateSpace(A, discrete=discrete, sample_time=sample_time, bare=True)
        else:
            system = _StateSpaceReader(node, lexicon, discrete).system(sample_time)
    report.conclude()
    return system


def provided(system: System) -> frozenset[str]:
    """Return what tasks can ask of the system: "A", "B", "C", "D", "initial_state", "matrix", "transfer_function"."""
    if isinstance(system, TransferFunction):  # the engine realizes it for tasks about the state space
        return frozenset({"transfer_function", "A", "B", "C", "D"})
    given = {"B": system.B, "C": system.C, "D": system.D, "initial_state": system.x0, "x0": system.x0}
    names = {name for name, value in given.items() if value is not None}
    if system.A.rows:
        names |= {"matrix", "A"} if system.A.rows == system.A.cols else {"matrix"}
    return frozenset(names | ({"transfer_function"} if {"B", "C"} <= names else set()))


def described(system: System) -> str:
    """Return what the system is given by, in words, for messages."""
    if isinstance(system, TransferFunction):
        return "the system is a transfer function"
    matrices = [name for name in ("A", "B", "C", "D") if name in provided(system)]
    if not matrices:
        return "the matrix is not square" if system.A.rows else "there is no system"
    return "the system has only " + (", ".join(matrices[:-1]) + " and " + matrices[-1] if matrices[1:] else matrices[0])


def _barred(discrete: bool) -> Mapping[str, str]:
    """Names that can't occur in the entries of a system."""
    return MEANINGS | SAMPLES if discrete else MEANINGS


def _sample_time(node: MappingNode, lexicon: Lexicon, discrete: bool) -> sp.Expr | None:
    if "sample_time" not in node:
        return None
    if not discrete:
        raise node.entries["sample_time"].key.fault("sample_time needs time: discrete beside it")
    value = lexicon.expression(node["sample_time"], barred=_barred(discrete))
    if value.is_positive is False:
        raise node["sample_time"].fault("sample_time must be positive")
    return value


def _names(node: MappingNode, key: str, number: int | None) -> tuple[str, ...]:
    """Return the names of states, inputs or outputs; there must be `number` of them if that is known."""
    if key not in node:
        return ()
    listed = node[key]
    items = listed.items if isinstance(listed, SequenceNode) else (listed,)
    names = tuple(name_of(scalar(item)) for item in items)
    for position, item in enumerate(items):
        if names[position] in names[:position]:
            raise item.fault(f"the name '{names[position]}' is given twice")
    if number is not None and len(names) != number:
        raise listed.fault(f"{counted(number, key[:-1], key)} but {counted(len(names), 'name', 'names')}")
    return names


def _transfer_function(
    node: MappingNode, lexicon: Lexicon, discrete: bool, sample_time: sp.Expr | None
) -> TransferFunction:
    if "transfer_function" in node:
        rows = [[read_transfer_function(node["transfer_function"], lexicon, discrete)]]
    else:
        rows = _transfer_matrix(node["transfer_matrix"], lexicon, discrete)
    return TransferFunction(
        matrix=sp.ImmutableMatrix([[entry.cancelled() for entry in row] for row in rows]),
        numerators=tuple(tuple(entry.numerator.as_expr() for entry in row) for row in rows),
        denominators=tuple(tuple(entry.denominator.as_expr() for entry in row) for row in rows),
        variable=sp.Symbol("z" if discrete else "s"),
        discrete=discrete,
        sample_time=sample_time,
        input_names=_names(node, "inputs", len(rows[0])),
        output_names=_names(node, "outputs", len(rows)),
    )


def _transfer_matrix(node: Node, lexicon: Lexicon, discrete: bool) -> list[list[Rational]]:
    report = Report()
    rows: list[list[Rational]] = []
    for row in node.items if isinstance(node, SequenceNode) else ():
        items = row.items if isinstance(row, SequenceNode) else ()
        rows.append([])
        for item in items:
            with report:
                rows[-1].append(read_transfer_function(item, lexicon, discrete))
        first = node.items[0] if isinstance(node, SequenceNode) else row
        if isinstance(first, SequenceNode) and len(items) != len(first.items):
            message = f"this row has {counted(len(items), 'entry', 'entries')}, row 1 has {len(first.items)}"
            report.diagnostics.append(row.diagnostic(message))
    report.conclude()
    return rows


class _StateSpaceReader:
    """Reads A, B, C, D and the initial state, and checks that their shapes fit."""

    def __init__(self, node: MappingNode, lexicon: Lexicon, discrete: bool) -> None:
        self.node = node
        self.lexicon = lexicon
        self.discrete = discrete
        self.report = Report()

    def system(self, sample_time: sp.Expr | None) -> StateSpace:
        """Return the system; raises Fault with everything that is wrong."""
        A = self.matrix("A", "", (None, None))
        n = A.rows if A is not None else None
        if A is not None and A.rows != A.cols:
            self.report.diagnostics.append(self.node["A"].diagnostic(f"A must be square, it is {A.rows}×{A.cols}"))
            n = None
        B = self.matrix("B", "column", (n, None), " like A")
        C = self.matrix("C", "row", (None, n), " like A")
        D = self.feedthrough(B, C)
        x0 = self.matrix("initial_state", "column", (n, 1), " like A")
        states = self.names("states", n)
        inputs = self.names("inputs", B.cols if B is not None else None)
        outputs = self.names("outputs", C.rows if C is not None else None)
        self.report.conclude()
        assert A is not None  # noqa: S101 - the shape was checked, and what is wrong with A concluded above
        return StateSpace(A, B, C, D, x0, self.discrete, sample_time, states, inputs, outputs)

    def names(self, key: str, size: int | None) -> tuple[str, ...]:
        """Return the names under the key, or () if there are none or they are wrong."""
        with self.report:
            return _names(self.node, key, size)
        return ()

    def matrix(
        self, name: str, flat: str, shape: tuple[int | None, int | None], like: str = ""
    ) -> sp.ImmutableMatrix | None:
        """Return the matrix of that name and shape; None if it is absent or wrong."""
        if name not in self.node:
            return None
        with self.report:
            matrix: sp.ImmutableMatrix = read_matrix(self.node[name], name, self.lexicon, flat, _barred(self.discrete))
            expect_shape(matrix, shape, self.node[name], name, like)
            return matrix
        return None

    def feedthrough(self, B: sp.ImmutableMatrix | None, C: sp.ImmutableMatrix | None) -> sp.ImmutableMatrix | None:
        """Return D: as given, zero if absent, None without B and C; a single 0 is a zero matrix of any shape."""
        given = "D" in self.node
        if given and not ("B" in self.node and "C" in self.node):
            self.report.diagnostics.append(self.node.entries["D"].key.diagnostic("D needs both B and C"))
        if B is None or C is None:
            return None
        if given and not (is_flat(self.node["D"]) and self.node["D"].plain() == "0"):
            return self.matrix("D", "row" if C.rows == 1 else "column", (C.rows, B.cols), " (outputs × inputs)")
        return sp.ImmutableMatrix(sp.zeros(C.rows, B.cols))
