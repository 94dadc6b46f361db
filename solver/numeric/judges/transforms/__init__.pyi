"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.transforms.inverse import values_in_time
from solver.numeric.judges.transforms.laplace import transform_of

__all__ = ["transform_of", "values_in_time"]
