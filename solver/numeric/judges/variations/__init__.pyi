"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.variations.paths import Path, paths, variation_residual

__all__ = ["Path", "paths", "variation_residual"]
