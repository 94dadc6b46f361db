"""What sampling does to poles, as the question states it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp


def sampled_poles(poles: Sequence[Any], period: Any) -> list[Any]:
    """Return e^{sT} of each pole s as it stands, to be evaluated."""
    return [sp.exp((sp.Integer(0) + s) * period, evaluate=False) for s in poles]
