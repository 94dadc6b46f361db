"""What the options of a part are read in: the names, the system, the earlier parts."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from solver.derivation import Task
from solver.problem.equations import EquationReader
from solver.problem.lexicon import BARRED, Lexicon, name_of
from solver.problem.matrices import expect_shape, is_flat, read_entries, read_matrix
from solver.problem.nodes import Node, ScalarNode
from solver.problem.poles import read_conjugate_list
from solver.problem.transfer_functions import read_transfer_function
from solver.symbols import OTHER_TIME, SAMPLES
from solver.systems import EarlierPart, StateSpace, System

Earlier = Mapping[str, tuple[Task[Any, Any], str] | None]
"""The earlier parts with their task and first method; None for one that could not be read."""


@dataclass(frozen=True)
class Context:
    """What the options of a part are read in.

    `system` is None where it could not be read; then what depends on its size is not checked. `earlier` has the task
    and the first method of each part before this one, or None for a part that could not be read. `around` are the
    names in what closes a loop around the system, None where that is taken from an earlier part.
    """

    lexicon: Lexicon
    system: System | None
    discrete: bool = False
    earlier: Earlier = field(default_factory=dict)
    around: frozenset[str] | None = frozenset()

    def size(self, of: int | str | None) -> int | None:
        """Return a number of rows or columns: itself, or that of "n" states, "m" inputs, "p" outputs if known."""
        if not isinstance(of, str):
            return of
        return None if self.system is None else self.system.size(of)

    def names(self, of: str) -> tuple[str, ...]:
        """Return the names of the system's inputs, outputs or states, if it gives them."""
        return () if self.system is None else self.system.names(of)

    @property
    def has_no_inputs(self) -> bool:
        """Whether the system names its inputs where it has some, and has none."""
        return not getattr(self.system, "inputs", (None,))

    def _variables(self, declared: Collection[str]) -> tuple[str, ...]:
        """Return the variables of an expression without those of the other kind of time."""
        other = OTHER_TIME[self.discrete]
        return tuple(name for name in declared if other.get(name) not in declared)

    def names_in_the_system(self) -> tuple[list[str] | None, list[str]]:
        """Return the names of parameters, states, inputs and outputs (None: not known), and the numbers of states."""
        if self.system is None or self.around is None or isinstance(self.system, EarlierPart):
            return None, []
        known = sorted({*(str(symbol.name) for symbol in self.system.parameters), *self.around})
        if not isinstance(self.system, StateSpace):
            return known, []
        known += [name for of in ("state", "input", "output") for name in self.names(of)]
        numbers = [str(number + 1) for number in range(self.system.order)]
        known += [] if self.names("state") else [f"x{number}" for number in numbers]  # states go by these names
        return known, numbers

    def expression(self, node: Node, declared: Collection[str] = ()) -> sp.Expr:
        """Return a value as an expression in parameters and in the variables declared; raises Fault."""
        return self.lexicon.expression(node, self._variables(declared), self._barred)

    def jet(self, node: ScalarNode) -> tuple[str, int]:
        """Return a function of time and the order of its derivative (samples ahead); raises Fault."""
        return EquationReader(self.lexicon, discrete=self.discrete).jet(node)

    def symbol(self, node: ScalarNode) -> sp.Symbol:
        """Return the symbol of a name that has no value, with what is assumed of it; raises Fault."""
        name = name_of(node)
        if name in self.lexicon.values:
            raise node.fault(f"'{name[:40]}' has a value in 'parameters'")
        found: sp.Symbol = self.lexicon.symbols.get(name, sp.Symbol(name, real=True))
        return found

    def relation(self, node: ScalarNode) -> tuple[Any, Any]:
        """Return left and right side of an equation between expressions, or an expression and zero; raises Fault."""
        sides: tuple[Any, ...] = EquationReader(self.lexicon, discrete=False).relation(node, ())
        return sides[0], sides[1]

    def conjugate_list(self, node: Node) -> tuple[sp.Expr, ...]:
        """Return complex numbers closed under conjugation; raises Fault."""
        return read_conjugate_list(node, self.lexicon)

    def transfer_function(self, node: Node) -> sp.Expr:
        """Return a rational function of one channel in lowest terms; raises Fault."""
        return read_transfer_function(node, self.lexicon, self.discrete).cancelled()

    def quotient(self, node: Node, *, unity: bool = False) -> sp.Expr:
        """Return a quotient of polynomials, proper or not, in lowest terms; 1 where the node says so in a word."""
        if unity:
            return sp.Integer(1)
        return read_transfer_function(node, self.lexicon, self.discrete, proper=False).cancelled()

    def quotients(self, node: Node, name: str) -> sp.ImmutableMatrix:
        """Return a matrix of quotients of polynomials, proper or not, in lowest terms; raises Fault."""
        return read_entries(node, name, self.quotient)

    def matrix(
        self, node: Node, name: str, shape: tuple[int | str | None, int | str | None], flat: str
    ) -> sp.ImmutableMatrix:
        """Return a matrix of a shape, where a size is a number or that `of` the system; raises Fault.

        A flat list that can only be a column, or a row, is that; any other is what `flat` says.
        """
        rows, columns = map(self.size, shape)
        if is_flat(node) and (columns == 1) != (rows == 1):
            flat = "column" if columns == 1 else "row"
        matrix = read_matrix(node, name, self.lexicon, flat, self._barred)
        owners = {"n": " for the states", "m": " for the inputs", "p": " for the outputs"}
        expect_shape(matrix, (rows, None), node, name, owners.get(str(shape[0]), ""))
        expect_shape(matrix, (None, columns), node, name, owners.get(str(shape[1]), ""))
        return matrix

    @property
    def _barred(self) -> Mapping[str, str]:
        """Names that can't stand in a value, but for the variables it is declared to have."""
        return BARRED | SAMPLES if self.discrete else BARRED
