"""∂ᵐf/∂xᵐ."""

from __future__ import annotations

from solver.numeric.evaluation.operations.derivative import ORACLE, SAMPLED, evaluate

__all__ = ["ORACLE", "SAMPLED", "evaluate"]
