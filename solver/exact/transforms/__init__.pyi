"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.transforms.comparison import (
    AllCompared,
    Divided,
    Division,
    compared_at_all,
    divided_again,
    is_found_otherwise,
)
from solver.exact.transforms.images import DelayedImage, RationalImage, ratio_of_images, rational_image, read_image

__all__ = [
    "AllCompared",
    "DelayedImage",
    "Divided",
    "Division",
    "RationalImage",
    "compared_at_all",
    "divided_again",
    "is_found_otherwise",
    "ratio_of_images",
    "rational_image",
    "read_image",
]
