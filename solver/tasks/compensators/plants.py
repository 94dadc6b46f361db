"""The plant of a question as an open loop, however the question gives it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation.conversion import converted

if TYPE_CHECKING:
    from solver.systems import OpenLoop


def loop_of(system: Any) -> OpenLoop:
    """Return the open loop without the steps that lead to it. Raises Unsolved where there is none."""
    steps = converted(system, ("open_loop",))
    while True:
        try:
            next(steps)
        except StopIteration as end:
            loop: OpenLoop = end.value
            return loop
