"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.time_response.input_generators import Piece, later, read_inputs
from solver.exact.time_response.long_run import constant_root, decays, horizon
from solver.exact.time_response.peaks import Peak
from solver.exact.time_response.response import ClosedForm, Response, piece_response, response, shifted

__all__ = [
    "ClosedForm",
    "Peak",
    "Piece",
    "Response",
    "constant_root",
    "decays",
    "horizon",
    "later",
    "piece_response",
    "read_inputs",
    "response",
    "shifted",
]
