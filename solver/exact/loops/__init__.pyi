"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.loops.errors import (
    ErrorConstants,
    LongRun,
    error_constants,
    error_transform,
    held_where,
    lasting,
    long_run,
    rational,
    transform_of,
    usual_parts,
)
from solver.exact.loops.flow_graphs import (
    Mason,
    Removed,
    Route,
    longest_row,
    mason,
    merged,
    next_node,
    node_removed,
    node_signals,
    transfer_form,
)

__all__ = [
    "ErrorConstants",
    "LongRun",
    "Mason",
    "Removed",
    "Route",
    "error_constants",
    "error_transform",
    "held_where",
    "lasting",
    "long_run",
    "longest_row",
    "mason",
    "merged",
    "next_node",
    "node_removed",
    "node_signals",
    "rational",
    "transfer_form",
    "transform_of",
    "usual_parts",
]
