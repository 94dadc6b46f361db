"""Exact systems: small frozen objects, and the kinds in which a problem can give them, one file a kind."""

from __future__ import annotations

from functools import cache
from importlib import import_module
from pathlib import Path

from solver.jets import jet_symbol
from solver.systems.characteristic_equation import CharacteristicEquation
from solver.systems.circuit import Circuit, signals_of, symbol_of
from solver.systems.earlier_part import EarlierPart
from solver.systems.equations import Equations
from solver.systems.functional import Functional
from solver.systems.kind import Kind, System
from solver.systems.lagrangian import Lagrangian
from solver.systems.late_input import LateInput
from solver.systems.loops import LateLoop, LatePath, MatrixFeedback, OpenLoop, OutputFeedback, StateFeedback
from solver.systems.op_amp import OpAmp
from solver.systems.polynomial import Polynomial
from solver.systems.polynomial_matrix import PolynomialMatrix
from solver.systems.signal_flow import SignalFlow
from solver.systems.state_space import StateSpace
from solver.systems.transfer_function import DeadTime, DelayedMatrix, TransferFunction


@cache
def kinds() -> dict[str, Kind]:
    """Return the kinds of this folder by the key that tells them, in the order of the files. Imports no algebra."""
    files = sorted(path.stem for path in Path(__file__).parent.glob("*.py") if path.stem not in ("__init__", "kind"))
    modules = [import_module(f"{__name__}.{name}") for name in files]
    declared = [value for module in modules for value in vars(module).values() if isinstance(value, Kind)]
    return {kind.tells: kind for kind in declared}


__all__ = [
    "CharacteristicEquation",
    "Circuit",
    "DeadTime",
    "DelayedMatrix",
    "EarlierPart",
    "Equations",
    "Functional",
    "Kind",
    "Lagrangian",
    "LateInput",
    "LateLoop",
    "LatePath",
    "MatrixFeedback",
    "OpAmp",
    "OpenLoop",
    "OutputFeedback",
    "Polynomial",
    "PolynomialMatrix",
    "SignalFlow",
    "StateFeedback",
    "StateSpace",
    "System",
    "TransferFunction",
    "jet_symbol",
    "kinds",
    "signals_of",
    "symbol_of",
]
