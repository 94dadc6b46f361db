"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.time_response.input_generators import Piece, later, read_inputs
from solver.exact.time_response.intervals import by_intervals
from solver.exact.time_response.long_run import constant_root, decays, horizon
from solver.exact.time_response.peaks import Peak
from solver.exact.time_response.response import (
    ClosedForm,
    Response,
    piece_response,
    response,
    shifted,
    weighting,
)
from solver.exact.time_response.standard_form import StandardForm, standard_form
from solver.exact.time_response.stationary import Stationary
from solver.exact.time_response.steady_state import SteadyState, steady_state

__all__ = [
    "ClosedForm",
    "Peak",
    "Piece",
    "Response",
    "StandardForm",
    "Stationary",
    "SteadyState",
    "by_intervals",
    "constant_root",
    "decays",
    "horizon",
    "later",
    "piece_response",
    "read_inputs",
    "response",
    "shifted",
    "standard_form",
    "steady_state",
    "weighting",
]
