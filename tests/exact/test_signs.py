"""Signs under conditions: what is decided holds at every point that satisfies them."""

from __future__ import annotations

import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from solver.conditions import Condition, Parameter, assumed_of, conditions_of, without_conditions
from solver.exact.linear_algebra.radicals import complex_parts, over_root, square_root, without_bars
from solver.exact.linear_algebra.signs import always_holds, contradict, possible_signs, values_of
from solver.exact.linear_algebra.spectrum import spectrum
from solver.exact.stability.inequalities import sign_of

ASSUMED = [{"real": True}, {"real": True}, {"positive": True}, {"negative": True}, {"real": True, "nonzero": True}]
RELATIONS = {">": lambda x: x > 0, ">=": lambda x: x >= 0, "!=": lambda x: x != 0}
GRID = [sp.Rational(n, 2) for n in range(-7, 8)] + [sp.Integer(40), sp.Integer(-40), sp.Rational(1, 50)]
a, b, c, d = REAL = sp.symbols("a b c d", real=True)


def with_conditions(listed, symbols=REAL):
    told = tuple(Condition(difference, relation) for difference, relation in listed)
    return {x: Parameter(x.name, told, **assumed_of(x)) for x in symbols}


def signs(x, listed, symbols=REAL):
    return set(possible_signs(sp.sympify(x).xreplace(with_conditions(listed, symbols))))


@st.composite
def polynomials(draw, symbols, terms=3):
    monomials = st.lists(st.tuples(st.sampled_from(symbols), st.integers(1, 2)), max_size=2)
    listed = draw(st.lists(st.tuples(st.integers(-3, 3).filter(bool), monomials), min_size=1, max_size=terms))
    return sp.Add(*(n * sp.Mul(*(x**power for x, power in monomial)) for n, monomial in listed))


@st.composite
def questions(draw):
    assumed = draw(st.lists(st.sampled_from(ASSUMED), min_size=1, max_size=3))
    symbols = [sp.Symbol(name, **each) for name, each in zip("abc", assumed, strict=False)]
    simple = st.sampled_from([s * x - n for x in symbols for s in (1, -1) for n in (-2, 0, 1, sp.sqrt(2))])
    compared = st.sampled_from([x - n * y for x in symbols for y in symbols for n in (1, 2)])
    listed = st.lists(
        st.tuples(st.one_of(simple, compared, polynomials(symbols, 2)), st.sampled_from(sorted(RELATIONS))),
        min_size=1,
        max_size=3,
    )
    conditions = [(x, relation) for x, relation in draw(listed) if x.free_symbols]
    asked = draw(polynomials(symbols))
    if conditions and draw(st.booleans()):
        asked = draw(st.sampled_from([1, -1, 2])) * conditions[0][0] + draw(polynomials(symbols, 1)) ** 2
    return symbols, conditions, sp.expand(asked)


def admissible(symbols, conditions, point):
    as_assumed = all(
        not (x.is_positive and v <= 0) and not (x.is_negative and v >= 0) and not (x.is_nonzero and v == 0)
        for x, v in point.items()
    )
    return as_assumed and all(RELATIONS[relation](x.xreplace(point)) for x, relation in conditions)


@settings(max_examples=60, deadline=None)
@given(questions(), st.randoms(use_true_random=False))
def test_a_sign_that_is_decided_is_that_at_every_point(question, random):
    symbols, conditions, asked = question
    assume(asked.free_symbols)
    found = signs(asked, conditions, symbols)
    for _ in range(200):
        point = {x: random.choice(GRID) for x in symbols}
        if admissible(symbols, conditions, point):
            assert int(sp.sign(asked.xreplace(point))) in found, (conditions, asked, point)


@settings(max_examples=30, deadline=None)
@given(questions(), st.randoms(use_true_random=False))
def test_conditions_that_contradict_each_other_hold_nowhere(question, random):
    symbols, conditions, _ = question
    if contradict(tuple(Condition(*each) for each in conditions)):
        points = [{x: random.choice(GRID) for x in symbols} for _ in range(300)]
        assert not any(admissible(symbols, conditions, point) for point in points)


@pytest.mark.parametrize(
    ("listed", "x", "expected"),
    [
        ([(a, ">"), (1 - a, ">")], 1 - a**2, {1}),
        ([(1 - a**2, ">")], a - 1, {-1}),
        ([(a - b, "!=")], (a - b) ** 2, {1}),
        ([(a - b, "!=")], a - b, {-1, 1}),
        ([(a - b, ">"), (b, ">")], a**2 - b**2, {1}),
        ([(a - b, ">"), (b - c, ">")], c - a, {-1}),
        ([(a * d - b * c, ">")], b * c - a * d, {-1}),
        ([(a * d - b * c, ">")], a * d - b * c + d**2, {1}),
        ([(b**2 - 4 * a * c, ">"), (a, ">"), (c, ">")], b**2 - 3 * a * c, {1}),
        ([(b**2 - 4 * a * c, ">"), (a, ">"), (b, ">"), (c, ">")], b - 2 * sp.sqrt(a * c), {1}),
        ([(a - 3, ">="), (5 - a, ">=")], (a - 3) * (6 - a), {0, 1}),
        ([(a - 3, ">="), (5 - a, ">=")], a - 2, {1}),
        ([(a, ">"), (1 - a, ">"), (b, ">"), (1 - b, ">")], 1 - a * b, {1}),
        ([(a - b, ">"), (1 - a, ">"), (b, ">")], 1 - b, {1}),
        ([(a - b, ">="), (b - a, ">=")], a - b, {0}),
        ([(sp.sqrt(2) - a, ">"), (a, ">")], 2 - a**2, {1}),
        ([(a**2 - 1, ">")], a, {-1, 1}),
        ([(a + b, ">")], a**3 + b**3, {1}),
        ([(a, ">")], a - b, {-1, 0, 1}),
        ([(a * b, ">")], a * b + c**2, {1}),
        ([(a * b, ">")], 1 / (a * b), {1}),
    ],
)
def test_signs_that_a_person_would_see(listed, x, expected):
    assert signs(x, listed) == expected


def test_sign_of_takes_conditions():
    names = with_conditions([(a - b, ">"), (b, ">")])
    assert sign_of((b - a).xreplace(names)) == -1
    assert sign_of((a + b + 1).xreplace(names)) == 1
    assert sign_of((a - 2 * b).xreplace(names)) is None


def test_nothing_remembered_of_symbols_with_conditions_is_taken_for_those_without():
    names = with_conditions([(b**2 - 4 * c, ">")])
    A = sp.ImmutableMatrix([[0, 1], [-c, -b]])
    assert [root.kind for root in spectrum(A.xreplace(names)).roots] == ["surd", "surd"]
    assert [root.kind for root in spectrum(A).roots] == ["symbolic", "symbolic"]
    turned = with_conditions([(4 * c - b**2, ">")])
    assert [root.kind for root in spectrum(A.xreplace(turned)).roots] == ["complex", "complex"]
    assert [root.kind for root in spectrum(A).roots] == ["symbolic", "symbolic"]


def test_contradictions_and_conditions_that_say_nothing():
    assert contradict((Condition(a - b, ">"), Condition(b - c, ">"), Condition(c - a, ">")))
    assert contradict((Condition(-(a**2), ">"),))
    assert not contradict((Condition(a - b, ">"), Condition(b - c, ">")))
    assert always_holds(Condition(a**2, ">="))
    assert always_holds(Condition(a**2 + b**2 + 1, ">"))
    assert not always_holds(Condition(a**2, ">"))


def test_the_values_that_are_left_of_a_symbol():
    names = with_conditions([(a - 2, ">="), (10 - a, ">")])
    assert values_of(names[a]) == (2, 10, True, False)
    assert values_of(with_conditions([(a - 2, "!=")])[a]) is None
    assert values_of(a) is None


def test_a_parameter_is_its_name_its_assumptions_and_its_conditions():
    names, same, other = (with_conditions([(x, ">")]) for x in (a - b, a - b, b - a))
    assert names[a] == same[a]
    assert hash(names[a]) == hash(same[a])
    assert names[a] not in (other[a], a)
    assert without_conditions(names[a] + other[b]) == a + b
    assert conditions_of([names[a], names[b], c]) == (Condition(a - b, ">"),)


def test_roots_and_absolute_values_are_written_as_a_person_would():
    names = with_conditions([(a - b, ">"), (c, ">"), (1 - c, ">")])
    p, q, r = (names[x] for x in (a, b, c))
    assert without_bars(sp.Matrix([[sp.Abs(q - p), sp.Abs(p + q)]])) == sp.Matrix([[p - q, sp.Abs(p + q)]])
    assert square_root((q - p) ** 2) == p - q
    assert square_root(1 - r**2) == sp.sqrt(1 - r**2)
    assert over_root(r * sp.sqrt(1 - r**2) / (r**2 - 1)) == -r / sp.sqrt(1 - r**2)


def test_a_root_of_what_is_positive_is_real():
    r = with_conditions([(c, ">"), (1 - c, ">")])[c]
    assert complex_parts(-r + sp.I * sp.sqrt(1 - r**2)) == (-r, sp.sqrt(1 - r**2))
    assert complex_parts(-c + sp.I * sp.sqrt(1 - c**2)) != (-c, sp.sqrt(1 - c**2))
