"""The result of an earlier part of the problem, taken as a system: its A B C D, or its transfer function."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.lazy import sympy as sp
from solver.systems.kind import Gain, Key, Kind, Reader, System, Value
from solver.systems.loops import StateFeedback
from solver.systems.state_space import StateSpace
from solver.systems.transfer_function import TransferFunction

if TYPE_CHECKING:
    from sympy import Expr, Symbol

TRANSFER = ("G", "controller", "compensator")
"""Answers that are taken as a transfer function where a part answers no A, the first that it has."""


PATHS = frozenset({"transfer_function", "path", "open_loop", "characteristic_equation"})
"""What a transfer function, found or to be found, can be asked for."""


@dataclass(frozen=True)
class EarlierPart:
    """What the part `part` answers, a system whose matrices are not known yet; `gain` closes the loop around it.

    `answers` are the names of the part's answers; a gain is a matrix, or the part and the answer that it is taken from.
    """

    part: str
    answers: tuple[str, ...]
    gain: Any = None
    discrete: bool = False
    sample_time: Expr | None = None

    @property
    def kind(self) -> str:
        """The name of the kind that words it."""
        return "earlier_part"

    @property
    def parameters(self) -> tuple[Symbol, ...]:
        """None is known yet."""
        return ()

    @property
    def provides(self) -> frozenset[str]:
        """The matrices that the part answers; a transfer function can be realized."""
        if "A" not in self.answers:
            return frozenset({"A", "B", "C", "D"}) | PATHS
        names = {name for name in ("A", "B", "C", "D") if name in self.answers}
        return frozenset(names | {"matrix"} | (PATHS if {"B", "C"} <= names else set()))

    @property
    def described(self) -> str:
        """What it is given by, in words."""
        return f"the system is the result of part {self.part}"

    def size(self, of: str) -> int | None:  # noqa: ARG002 - not known yet
        """Return None: the sizes are not known yet."""
        return None

    def names(self, of: str) -> tuple[str, ...]:  # noqa: ARG002 - there are none
        """Return no names."""
        return ()

    def taken(self, found: Mapping[str, Any], gain: Any) -> System | None:
        """Return the system that the part found, with the loop closed by the gain if there is one; None without any."""
        transfer = next((found[name] for name in TRANSFER if name in found), None)
        if "A" not in found and transfer is None:
            return None
        if "A" in found:
            B, C, D = (found.get(name) for name in "BCD")
            if D is None and B is not None and C is not None:
                D = sp.ImmutableMatrix(sp.zeros(C.rows, B.cols))
            plant: System = StateSpace(found["A"], B, C, D, None, self.discrete, self.sample_time)
        else:
            plant = self._transfer_function(transfer)
        return plant if gain is None else StateFeedback(plant, gain)

    def _transfer_function(self, G: Any) -> TransferFunction:
        """G in lowest terms, as the part answers it."""
        matrix = sp.ImmutableMatrix(G) if isinstance(G, sp.MatrixBase) else sp.ImmutableMatrix([[G]])
        pairs = [[sp.fraction(sp.together(entry)) for entry in row] for row in matrix.tolist()]
        numerators, denominators = (tuple(tuple(sp.expand(pair[i]) for pair in row) for row in pairs) for i in (0, 1))
        x = sp.Symbol("z" if self.discrete else "s")
        return TransferFunction(matrix, numerators, denominators, x, self.discrete, self.sample_time)


def _read(reader: Reader) -> EarlierPart:
    """Return the reference; the part must answer a system."""
    part, answers = reader.earlier_part("from")
    if part and "A" not in answers and not set(TRANSFER) & set(answers):
        reader.complain("from", f"part {part} answers no system: neither A nor a transfer function G")
    gain = reader.gain("gain")
    reader.conclude()
    return EarlierPart(part, answers, gain, reader.discrete, reader.sample_time)


EARLIER_PART = Kind(
    "earlier_part",
    doc="The result of an earlier part.",
    keys=(
        Key("from", Value(), "the part whose A, B, C, D, or G, is the system", required=True),
        Key("gain", Gain(), "state feedback u = −K x around it, a matrix or {from: part}"),
    ),
    read=_read,
    example=(("from: a", "the A, B, C, D, or the G, that part a answers"),),
)
