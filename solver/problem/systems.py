"""A system as a problem file gives it, read into an exact object by the kind that its keys tell."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import sympy as sp

from solver.problem.branches import node_name_of, read_branch
from solver.problem.components import read_component
from solver.problem.context import Earlier
from solver.problem.functions_of_time import FunctionsOfTime
from solver.problem.lexicon import BARRED, Lexicon, name_of
from solver.problem.library import moved, named_model
from solver.problem.matrices import counted, expect_shape, is_flat, read_matrix
from solver.problem.nodes import MappingNode, Node, ScalarNode, SequenceNode, scalar
from solver.problem.rational_functions import Rational
from solver.problem.references import answers_of, earlier_part, read_reference
from solver.problem.source import Report, did_you_mean
from solver.problem.transfer_functions import read_transfer_function
from solver.symbols import SAMPLES
from solver.systems import StateSpace, System, kinds

if TYPE_CHECKING:
    from solver.systems.kind import Reader

Times = Mapping[str, sp.Expr | None]
"""The sampling periods of the earlier parts whose answers are in discrete time; None where one is not given."""
NOTHING = StateSpace(A=sp.ImmutableMatrix(0, 0, []), bare=True)
"""Stands for the system of a question that is about none."""


def read_system(
    node: MappingNode, lexicon: Lexicon, earlier: Earlier = MappingProxyType({}), times: Times = MappingProxyType({})
) -> System:
    """Return the system of a mapping whose shape is right; raises Fault with everything else that is wrong.

    `earlier` are the parts to which it may refer, `times` the sampling periods of those of them in discrete time.
    """
    reader: Reader = SystemReader(node, lexicon, earlier, times)
    kind = next(kinds()[entry.key.text] for entry in node if entry.key.text in kinds())
    system: System = kind.read(reader)
    return system


class SystemReader(FunctionsOfTime):
    """Reads what stands under the keys of a system; keeps faults until all of them are raised."""

    def __init__(self, node: MappingNode, lexicon: Lexicon, earlier: Earlier, times: Times) -> None:
        self.node = node
        self.given = (earlier, times)
        self.earlier = earlier
        self.times = times
        self.lexicon = lexicon
        self.report = Report()
        self.discrete = "time" in node and scalar(node["time"]).text == "discrete"
        self.sample_time: sp.Expr | None = None
        with self.report:
            self.sample_time = self._sample_time()

    @property
    def barred(self) -> Mapping[str, str]:
        """Names that can't occur in the entries of a system."""
        return BARRED | SAMPLES if self.discrete else BARRED

    def _sample_time(self) -> sp.Expr | None:
        if "sample_time" not in self.node:
            return None
        if not self.discrete:
            raise self.node.entries["sample_time"].key.fault("sample_time needs time: discrete beside it")
        value = self.lexicon.expression(self.node["sample_time"], barred=self.barred)
        if value.is_positive is False:
            raise self.node["sample_time"].fault("sample_time must be positive")
        return value

    def conclude(self) -> None:
        """Raise Fault with everything that is wrong, if anything is."""
        self.report.conclude()

    @property
    def keys(self) -> Mapping[str, str]:
        """The plain spelling of each key that is there, in the order of the file: theta for θ."""
        found = {}
        for entry in self.node:
            with self.report:
                found[entry.key.text] = name_of(entry.key)
        return found

    def within(self, key: str) -> SystemReader:
        """Return what reads the mapping under a key, an empty one if it is absent; its faults are kept here too."""
        node = self.node.get(key)
        return self._reads(node if isinstance(node, MappingNode) else MappingNode(self.node.place, {}))

    def each(self, key: str) -> list[SystemReader]:
        """Return what reads each mapping of the list under a key; a mapping by itself is a list of one."""
        given = self.node.get(key)
        listed = (given,) if isinstance(given, MappingNode) else _items(given) if given is not None else ()
        return [self._reads(item) for item in listed if isinstance(item, MappingNode)]

    def _reads(self, node: MappingNode) -> SystemReader:
        inner = SystemReader(node, self.lexicon, *self.given)
        inner.report, inner.discrete, inner.sample_time = self.report, self.discrete, self.sample_time
        inner.timed = self.timed
        return inner

    def complain(
        self, key: str, message: str, *, at_key: bool = False, item: int | None = None, like: Sequence[str] = ()
    ) -> None:
        """Keep a fault at the value of the key, at one item of it, or at the key itself; one `like` it is suggested."""
        entry = self.node.entries[key]
        node = entry.key if at_key else entry.value if item is None else self._scalars(key)[item]
        meant = did_you_mean(node.text, like) if like and isinstance(node, ScalarNode) else ""
        self.report.diagnostics.append(node.diagnostic(message, meant))

    def gives(self, key: str) -> bool:
        """Whether the key is there."""
        return key in self.node

    def is_zero(self, key: str) -> bool:
        """Whether a single 0 stands under the key."""
        return is_flat(self.node[key]) and self.node[key].plain() == "0"

    def matrix(
        self, key: str, flat: str = "", shape: tuple[int | None, int | None] = (None, None), like: str = ""
    ) -> sp.ImmutableMatrix | None:
        """Return the matrix of that name and shape; None if it is absent or wrong."""
        if key not in self.node:
            return None
        with self.report:
            matrix: sp.ImmutableMatrix = read_matrix(self.node[key], key, self.lexicon, flat, self.barred)
            expect_shape(matrix, shape, self.node[key], key, like)
            return matrix
        return None

    def names(self, key: str, number: int | None = None) -> tuple[str, ...]:
        """Return the names under the key, () if there are none or they are wrong; `number` of them if it is known."""
        with self.report:
            return self._names(key, number)
        return ()

    def _names(self, key: str, number: int | None) -> tuple[str, ...]:
        if key not in self.node:
            return ()
        listed = self.node[key]
        items = listed.items if isinstance(listed, SequenceNode) else (listed,)
        names = tuple(name_of(scalar(item)) for item in items)
        for position, item in enumerate(items):
            if names[position] in names[:position]:
                raise item.fault(f"the name '{names[position]}' is given twice")
        if number is not None and len(names) != number:
            raise listed.fault(f"{counted(number, key[:-1], key)} but {counted(len(names), 'name', 'names')}")
        return names

    def earlier_part(self, key: str) -> tuple[str, tuple[str, ...]]:
        """Return an earlier part and the names of its answers, "" if it is wrong; its time is the system's."""
        with self.report:
            part, task, method = earlier_part(self.node[key], self.earlier)
            self.discrete, self.sample_time = part in self.times, self.times.get(part)
            return part, answers_of(task, method)
        return "", ()

    def named_model(self, key: str) -> System | None:
        """Return the system of the model of the library that is named; what is wrong with it stands at the name."""
        with self.report:
            name = scalar(self.node[key])
            system = moved(named_model(name).root["system"], name.place)
            return read_system(system, self.lexicon) if isinstance(system, MappingNode) else None
        return None

    def gain(self, key: str) -> Any:
        """Return a matrix, or the part and the answer it is taken from; None if it is absent or wrong."""
        given = self.node.get(key)
        if not isinstance(given, MappingNode):
            return self.matrix(key, "row")
        with self.report:
            if "from" not in given:
                raise given.fault("a matrix, or {from: part}, is expected here")
            return read_reference(given, "K", self.earlier)
        return None

    def texts(self, key: str) -> list[str]:
        """Return the texts of a list as they are written."""
        return [item.text for item in self._scalars(key)]

    def value_inside(self, key: str, item: int, at: int, length: int | None = None) -> sp.Expr | None:
        """Return the expression that stands in the text of an item from a place on; None if it is wrong."""
        with self.report:
            return self.lexicon.expression(self._scalars(key)[item].part(at, length), barred=self.barred)
        return None

    def complain_inside(self, key: str, item: int, span: tuple[int, int], message: str, suggestion: str = "") -> None:
        """Keep a fault within the text of an item: where it begins, and its length."""
        with self.report:
            raise self._scalars(key)[item].fault_inside(message, *span, suggestion=suggestion)

    def component(self, key: str) -> tuple[str, str, sp.Expr] | None:
        """Return the letter of a component, R or C, its name, "" where it has none, and its value; None if wrong."""
        with self.report:
            return read_component(self.node[key], self.lexicon, self.barred)
        return None

    def value(self, key: str) -> sp.Expr | None:
        """Return the expression under the key, None if it is absent or wrong."""
        with self.report:
            return self.lexicon.expression(self.node[key], barred=self.barred) if key in self.node else None
        return None

    def quotient(self, key: str) -> Rational | None:
        """Return the proper quotient of polynomials under the key, None if it is wrong."""
        return self._quotient(self.node[key], delayed=True)

    def _quotient(self, node: Node, *, delayed: bool = False) -> Rational | None:
        with self.report:
            return read_transfer_function(node, self.lexicon, self.discrete, delayed=delayed)
        return None

    def polynomial(self, key: str) -> Sequence[sp.Expr]:
        """Return the coefficients of a polynomial, the highest power first; none if it is wrong."""
        return self._polynomial(self.node[key])

    def _polynomial(self, node: Node) -> tuple[sp.Expr, ...]:
        with self.report:
            found = read_transfer_function(node, self.lexicon, self.discrete, proper=False)
            if found.denominator.degree():
                raise node.fault("a polynomial is expected here, not a quotient")
            scaled = found.numerator.quo_ground(found.denominator.LC())
            return tuple(scaled.all_coeffs())
        return ()

    def polynomials(self, key: str) -> list[list[tuple[sp.Expr, ...]]]:
        """Return the coefficients of a matrix of polynomials, row by row; none for one that is wrong."""
        return [[self._polynomial(item) for item in items] for items in self._rows(key)]

    def quotients(self, key: str, *, delayed: bool = False) -> list[list[Rational]]:
        """Return a matrix of proper quotients of polynomials; a wrong one is missing in its row."""
        lists = self._rows(key)
        return [
            [entry for item in items if (entry := self._quotient(item, delayed=delayed)) is not None] for items in lists
        ]

    def branches(self, key: str) -> list[tuple[str, str, sp.Expr]]:
        """Return the branches [from, to, gain] of a graph; those that cannot be read are missing, and told."""
        found = []
        for row in _items(self.node[key]):
            with self.report:
                found.append(read_branch(row, self.lexicon, self.discrete))
        return found

    def node_name(self, key: str) -> str:
        """Return the name of a node of a graph; "" if it is wrong."""
        with self.report:
            return node_name_of(scalar(self.node[key]))
        return ""

    def complain_branch(self, key: str, item: int, message: str) -> None:
        """Keep a fault at a branch."""
        self.report.diagnostics.append(_items(self.node[key])[item].diagnostic(message))

    def _rows(self, key: str) -> list[tuple[Node, ...]]:
        """The items of each row; complains of rows that have not the length of the first."""
        lists = [row.items for row in _items(self.node[key]) if isinstance(row, SequenceNode)]
        for row, items in zip(_items(self.node[key]), lists, strict=True):
            if len(items) != len(lists[0]):
                message = f"this row has {counted(len(items), 'entry', 'entries')}, row 1 has {len(lists[0])}"
                self.report.diagnostics.append(row.diagnostic(message))
        return lists


def _items(node: Node) -> tuple[Node, ...]:
    return node.items if isinstance(node, SequenceNode) else ()
