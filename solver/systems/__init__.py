"""Exact systems: small frozen objects."""

from solver.systems.state_space import StateSpace
from solver.systems.transfer_function import TransferFunction

System = StateSpace | TransferFunction

__all__ = ["StateSpace", "System", "TransferFunction"]
