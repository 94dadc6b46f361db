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
from solver.exact.transforms.operators import Operators, images_of_unknowns, operators_of
from solver.exact.transforms.poles import Pole, poles_of
from solver.exact.transforms.products import factors_for_convolution
from solver.exact.transforms.rules import (
    TransformedTerm,
    TransformPiece,
    abscissa_of,
    late_image,
    transform_of_pieces,
    transform_pieces,
)

__all__ = [
    "AllCompared",
    "DelayedImage",
    "Divided",
    "Division",
    "Operators",
    "Pole",
    "RationalImage",
    "TransformPiece",
    "TransformedTerm",
    "abscissa_of",
    "compared_at_all",
    "divided_again",
    "factors_for_convolution",
    "images_of_unknowns",
    "is_found_otherwise",
    "late_image",
    "operators_of",
    "poles_of",
    "ratio_of_images",
    "rational_image",
    "read_image",
    "transform_of_pieces",
    "transform_pieces",
]
