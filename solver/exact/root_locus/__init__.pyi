"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.root_locus.breakaway import Meeting, meetings, turning_polynomial
from solver.exact.root_locus.crossings import (
    BoundaryParts,
    Crossing,
    Range,
    crossings,
    in_squares,
    on_boundary,
    stable_gains,
)
from solver.exact.root_locus.directions import Arrow, Bearings, arrivals, degrees_of, departures
from solver.exact.root_locus.equation import (
    LocusEquation,
    PlacedRoot,
    affine_parts,
    expressions_of,
    locus_equation,
    roots_with_factors,
    written,
)
from solver.exact.root_locus.lines import Asymptotes, RealPoint, asymptotes, real_axis_segments, real_points

__all__ = [
    "Arrow",
    "Asymptotes",
    "Bearings",
    "BoundaryParts",
    "Crossing",
    "LocusEquation",
    "Meeting",
    "PlacedRoot",
    "Range",
    "RealPoint",
    "affine_parts",
    "arrivals",
    "asymptotes",
    "crossings",
    "degrees_of",
    "departures",
    "expressions_of",
    "in_squares",
    "locus_equation",
    "meetings",
    "on_boundary",
    "real_axis_segments",
    "real_points",
    "roots_with_factors",
    "stable_gains",
    "turning_polynomial",
    "written",
]
