"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.digital.jury import (
    DiscCounts,
    JuryConditions,
    JuryRow,
    JuryTable,
    bilinear_image,
    disc_counts,
    inside_by_jury,
    jury_conditions,
    jury_table,
    off_the_point_minus_one,
)

__all__ = [
    "DiscCounts",
    "JuryConditions",
    "JuryRow",
    "JuryTable",
    "bilinear_image",
    "disc_counts",
    "inside_by_jury",
    "jury_conditions",
    "jury_table",
    "off_the_point_minus_one",
]
