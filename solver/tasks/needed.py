"""The systems that tasks get, for the type checker: what a task `needs` is there, since the engine has seen to it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.systems import StateSpace, TransferFunction

if TYPE_CHECKING:
    from sympy import ImmutableMatrix


class WithInput(StateSpace):
    """A system with B."""

    if TYPE_CHECKING:
        B: ImmutableMatrix


class WithOutput(StateSpace):
    """A system with C."""

    if TYPE_CHECKING:
        C: ImmutableMatrix


class WithBoth(WithInput, WithOutput):
    """A system with B and C."""


InputOutput = WithBoth | TransferFunction
"""A path from inputs to outputs."""
