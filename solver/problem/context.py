"""What the options of a part are read in: the names, the system, the earlier parts."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field

from solver.derivation import Task
from solver.problem.lexicon import MEANINGS, SAMPLES, Lexicon
from solver.systems import StateSpace, System, TransferFunction

OTHER_TIME = {True: {"t": "k", "s": "z"}, False: {"k": "t", "z": "s"}}
"""By whether time is discrete: variables of the other kind of time, and the ones that take their place."""


@dataclass(frozen=True)
class Context:
    """What the options of a part are read in.

    `system` is None where it could not be read; then what depends on its size is not checked. `earlier` has the task
    and the first method of each part before this one, or None for a part that could not be read.
    """

    lexicon: Lexicon
    system: System | None
    discrete: bool = False
    earlier: Mapping[str, tuple[Task, str] | None] = field(default_factory=dict)

    def size(self, of: int | str | None) -> int | None:
        """Return a number of rows or columns: itself, or that of "n" states, "m" inputs, "p" outputs if known."""
        if not isinstance(of, str):
            return of
        if isinstance(self.system, TransferFunction):
            return {"m": int(self.system.matrix.cols), "p": int(self.system.matrix.rows)}.get(of)
        if self.system is None:
            return None
        B, C = self.system.B, self.system.C
        sizes = {"n": self.system.order, "m": B.cols if B is not None else None, "p": C.rows if C is not None else None}
        return sizes[of]

    def names(self, of: str) -> tuple[str, ...]:
        """Return the names of the system's inputs, outputs or states, if it gives them."""
        if not isinstance(self.system, StateSpace):
            return ()
        named = {"input": self.system.input_names, "output": self.system.output_names, "state": self.system.state_names}
        return named[of]

    def variables(self, declared: Collection[str]) -> tuple[str, ...]:
        """Return the variables of an expression without those of the other kind of time."""
        other = OTHER_TIME[self.discrete]
        return tuple(name for name in declared if other.get(name) not in declared)

    @property
    def barred(self) -> Mapping[str, str]:
        """Names that can't stand in a value, but for the variables it is declared to have."""
        return MEANINGS | SAMPLES if self.discrete else MEANINGS
