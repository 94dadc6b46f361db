"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.loops.errors import (
    ErrorConstants,
    LongRun,
    error_constants,
    error_transform,
    lasting,
    long_run,
    rational,
    transform_of,
    usual_parts,
)

__all__ = [
    "ErrorConstants",
    "LongRun",
    "error_constants",
    "error_transform",
    "lasting",
    "long_run",
    "rational",
    "transform_of",
    "usual_parts",
]
