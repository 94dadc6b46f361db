"""How many examples a generated test tries: all of them in `make test-whole`, a part of them in the others."""

from hypothesis import settings

ALL = 100
"""What the profile says that tries all; a profile that says 25 tries a quarter."""


def tried(number: int) -> settings:
    """The settings of a test that tries so many examples, or the profile's share of them."""
    return settings(max_examples=max(3, number * settings().max_examples // ALL))
