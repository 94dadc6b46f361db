"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.transforms.comparison import (
    AllCompared,
    Divided,
    QuadraticDivision,
    compared_at_all,
    divided_again,
    is_found_otherwise,
)
from solver.exact.transforms.images import DelayedImage, RationalImage, ratio_of_images, rational_image, read_image
from solver.exact.transforms.jumps import (
    ActingPiece,
    ImpulseBalance,
    acting_pieces,
    fitted_constants,
    impulse_balance,
    jumps_of_inputs,
    right_sides,
    values_after,
)
from solver.exact.transforms.long_division import DivisionRow, LongDivision, long_division
from solver.exact.transforms.operators import Operators, images_of_unknowns, operators_of
from solver.exact.transforms.poles import Pole, polar_pairs, poles_of
from solver.exact.transforms.products import factors_for_convolution
from solver.exact.transforms.rules import (
    TransformedTerm,
    TransformPiece,
    abscissa_of,
    late_image,
    transform_of_pieces,
    transform_pieces,
)
from solver.exact.transforms.sampled import Base, Sample, SampledImage, base_of, sampled_image
from solver.exact.transforms.sequence_images import (
    DelayedSequenceImage,
    SequenceImage,
    is_in_inverse_powers,
    read_sequence_image,
    sequence_image,
)
from solver.exact.transforms.sequences import (
    SequenceTerm,
    moved_image,
    radius_of,
    sequence_pieces,
    sequence_transform,
)

__all__ = [
    "ActingPiece",
    "AllCompared",
    "Base",
    "DelayedImage",
    "DelayedSequenceImage",
    "Divided",
    "DivisionRow",
    "ImpulseBalance",
    "LongDivision",
    "Operators",
    "Pole",
    "QuadraticDivision",
    "RationalImage",
    "Sample",
    "SampledImage",
    "SequenceImage",
    "SequenceTerm",
    "TransformPiece",
    "TransformedTerm",
    "abscissa_of",
    "acting_pieces",
    "base_of",
    "compared_at_all",
    "divided_again",
    "factors_for_convolution",
    "fitted_constants",
    "images_of_unknowns",
    "impulse_balance",
    "is_found_otherwise",
    "is_in_inverse_powers",
    "jumps_of_inputs",
    "late_image",
    "long_division",
    "moved_image",
    "operators_of",
    "polar_pairs",
    "poles_of",
    "radius_of",
    "ratio_of_images",
    "rational_image",
    "read_image",
    "read_sequence_image",
    "right_sides",
    "sampled_image",
    "sequence_image",
    "sequence_pieces",
    "sequence_transform",
    "transform_of_pieces",
    "transform_pieces",
    "values_after",
]
