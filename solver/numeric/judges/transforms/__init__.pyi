"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.transforms.equations import Problem, sides_in_time, transformed_sides
from solver.numeric.judges.transforms.inverse import values_in_time
from solver.numeric.judges.transforms.laplace import transform_of

__all__ = ["Problem", "sides_in_time", "transform_of", "transformed_sides", "values_in_time"]
