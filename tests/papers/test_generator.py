"""The generator: the same numbers everywhere, permutations, and no number likelier than another."""

from __future__ import annotations

from collections import Counter

import pytest
from hypothesis import given
from hypothesis import strategies as st

from solver.papers.generator import Permutation, below, hashed, mixed, stream


def test_it_is_splitmix64():
    """The numbers that Vigna's splitmix64.c gives for the states 0 and 1234567."""
    assert mixed(0) == 0xE220A8397B1DCDAF
    state, found = 1234567, []
    for _ in range(3):
        found.append(mixed(state))
        state = (state + 0x9E3779B97F4A7C15) % 2**64
    assert found == [6457827717110365317, 3203168211198807973, 9817491932198370423]


def test_the_numbers_of_a_seed_do_not_change():
    """Members of families are known by seed and number: another order would be another exam."""
    assert [Permutation(100, 7).at(i) for i in range(5)] == [56, 65, 39, 23, 17]
    assert [Permutation(10**30, 7).at(i) % 1000 for i in range(3)] == [989, 739, 600]


@given(st.integers(1, 700), st.integers(-(2**70), 2**70))
def test_each_number_comes_once(size, seed):
    order = Permutation(size, seed)
    assert sorted(map(order.at, range(size))) == list(range(size))


@pytest.mark.parametrize("size", [2, 9, 567, 2**40, 10**60])
def test_other_seeds_have_other_orders_and_no_number_is_likelier(size):
    firsts = [Permutation(size, seed).at(0) for seed in range(2000)]
    thirds = Counter(3 * first // size for first in firsts)
    expected = [(size * (k + 1) + 2) // 3 - (size * k + 2) // 3 for k in range(3)]
    for k, share in enumerate(expected):
        assert abs(thirds[k] - 2000 * share / size) < 150
    assert all(0 <= first < size for first in firsts)


def test_wide_sizes_are_permuted():
    order = Permutation(10**80, 3)
    found = {order.at(i) for i in range(50)}
    assert len(found) == 50
    assert max(found) > 10**79


def test_hashes_depend_on_all_numbers_and_on_their_order():
    found = {hashed(*numbers) for numbers in [(), (0,), (1,), (-1,), (0, 0), (1, 2), (2, 1), (2**64,), (2**64 + 1,)]}
    assert len(found) == 9


@given(st.integers(1, 50))
def test_what_is_drawn_below_a_bound_is_below_it(bound):
    bits = stream(4)
    assert all(0 <= below(bound, bits) < bound for _ in range(20))
