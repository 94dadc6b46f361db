"""The generator of all that is drawn: the same on every machine, in every version of Python.

Integers of 64 bits only, in the arithmetic modulo 2⁶⁴ of SplitMix64 (Steele, Lea and Flood 2014); see
`docs/families.md`. Nothing is drawn in a row: draw number i of a seed is known without those before it.
"""

from __future__ import annotations

from collections.abc import Iterator

WIDTH = 64
MASK = 2**WIDTH - 1
GOLDEN = 0x9E3779B97F4A7C15
ROUNDS = 8


def mixed(value: int) -> int:
    """Return 64 bits that depend on each bit of a number of 64: the last stage of SplitMix64."""
    value = (value + GOLDEN) & MASK
    value = ((value ^ (value >> 30)) * 0xBF58476D1CE4E5B9) & MASK
    value = ((value ^ (value >> 27)) * 0x94D049BB133111EB) & MASK
    return value ^ (value >> 31)


def hashed(*numbers: int) -> int:
    """Return 64 bits that depend on some whole numbers of any size, and on their order."""
    state = 0
    for number in numbers:
        rest = abs(number)
        state = mixed(state ^ (number < 0))
        while True:
            state = mixed(state ^ (rest & MASK))
            rest >>= WIDTH
            if not rest:
                break
    return state


def stream(*numbers: int) -> Iterator[int]:
    """Yield numbers of 64 bits without end, those that belong to some whole numbers (a seed, an index)."""
    state = hashed(*numbers)
    while True:
        state = (state + GOLDEN) & MASK
        yield mixed(state)


def below(bound: int, bits: Iterator[int]) -> int:
    """Return a number from 0 to bound − 1, each as likely as the others; `bound` is at most 2⁶⁴."""
    least = 2**WIDTH % bound  # so many numbers are too many to share out evenly
    return next(number for number in bits if number >= least) % bound


class Permutation:
    """An order of the numbers from 0 to size − 1 that belongs to a seed; `at` gives the number at a place.

    A Feistel network permutes the numbers of twice as many bits as half of the size has; what it takes out of
    the list is permuted again until it is inside.
    """

    def __init__(self, size: int, seed: int) -> None:
        self.size = size
        self.half = max(1, ((size - 1).bit_length() + 1) // 2)
        self.keys = [hashed(seed, turn) for turn in range(ROUNDS)]

    def at(self, index: int) -> int:
        """Return the number at a place from 0 to size − 1."""
        low = 2**self.half - 1
        while True:
            left, right = index >> self.half, index & low
            for key in self.keys:
                left, right = right, left ^ (self._scrambled(key, right) & low)
            index = left << self.half | right
            if index < self.size:
                return index

    def _scrambled(self, key: int, number: int) -> int:
        """Return at least as many bits as half of the size has."""
        if self.half <= WIDTH:
            return mixed(key ^ number)
        return sum(hashed(key, number, place) << WIDTH * place for place in range(self.half // WIDTH + 1))
