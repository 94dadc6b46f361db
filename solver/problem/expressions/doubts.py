"""What an engineer could read in two ways: refused in problem files, decided by whoever reads a student's answer."""

from __future__ import annotations

from collections.abc import Callable
from enum import StrEnum


class Doubt(StrEnum):
    """A place of the grammar with two readings; the value says the one that `True` stands for."""

    PRODUCT = "in 1/2 x the x stands below the fraction bar"
    EXPONENT = "in e^-2 t, with a space, the t belongs to the exponent"
    ROOT = "in sqrt 3 x the x stands under the root"
    ARGUMENT = "in sin t/2, sin t^2 and cos 2*t all belongs to the argument"


Decide = Callable[[Doubt], bool]
"""Says which reading is meant; where there is none, what is in doubt is refused."""
