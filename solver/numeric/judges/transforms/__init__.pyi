"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.transforms.equations import Problem, sides_in_time, transformed_sides
from solver.numeric.judges.transforms.fractions import are_partial
from solver.numeric.judges.transforms.inverse import values_in_time
from solver.numeric.judges.transforms.laplace import transform_of
from solver.numeric.judges.transforms.recursions import Recursion, first_values, values_of_recursion
from solver.numeric.judges.transforms.sequences import (
    sampled_values,
    samples_of_image,
    series_of,
    telling_samples,
    values_of_image,
)

__all__ = [
    "Problem",
    "Recursion",
    "are_partial",
    "first_values",
    "sampled_values",
    "samples_of_image",
    "series_of",
    "sides_in_time",
    "telling_samples",
    "transform_of",
    "transformed_sides",
    "values_in_time",
    "values_of_image",
    "values_of_recursion",
]
