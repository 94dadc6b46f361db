"""Families of problems as they are read: what is drawn, what must hold, what must come out, what is wrong."""

from __future__ import annotations

import jsonschema
import pytest
import sympy as sp
import yaml

from solver.problem.schema import json_schema

PLANT = "system: {A: [[0, 1], [-a, -b]], B: [0, 1]}\nparameters: {a: 2, b: 3}\n"
FIND = "find: {a: controllability, b: {task: placement, poles: [-1, -2]}}\n"


def of(text):
    return PLANT + FIND + text


def test_steps_and_lists_are_exact_and_written_as_they_were(read):
    text = of("vary: {a: {from: 1, to: 3}, b: {from: -1, to: 1, step: 1/2}}")
    a, b = read(text).family.varied
    assert (a.name, a.values, a.texts) == ("a", (1, 2, 3), ("1", "2", "3"))
    assert b.values == (-1, -sp.Rational(1, 2), 0, sp.Rational(1, 2), 1)
    assert b.texts == ("-1", "-1/2", "0", "1/2", "1")
    a, b = read(of("vary: {a: {from: 0.1, to: 0.35, step: 0.1}, b: {choose: [sqrt(2), 0.5, -3]}}")).family.varied
    assert a.texts == ("0.1", "0.2", "0.3")
    assert (b.values, b.texts) == ((sp.sqrt(2), sp.Rational(1, 2), -3), ("sqrt(2)", "0.5", "-3"))


def test_the_size_is_that_of_all_choices(read):
    assert read(of("vary: {a: {from: 1, to: 9}, b: {choose: [1, 2]}}")).family.size == 18
    assert read(of("")).family is None


def test_conditions_and_words_are_told_apart(read):
    family = read(of('vary: {a: {from: 1, to: 9}}\nrequire: ["a != 2", controllable]\nnice: {b.K: integers}')).family
    assert [(each.text, each.chain is None) for each in family.required] == [("a != 2", False), ("controllable", True)]
    assert [each.text for each in family.nice] == ["b.K: integers"]


def test_a_family_is_solved_as_its_default_member(read):
    plain, family = read(of("")), read(of("vary: {a: {from: 5, to: 9}}"))
    assert plain.parts == family.parts
    assert plain.system == family.system


def test_a_condition_may_be_about_what_follows_from_what_is_drawn(read):
    text = of("vary: {a: {from: 1, to: 9}}\nrequire: [c > 3]").replace("{a: 2, b: 3}", "{a: 2, c: 2a, b: c}")
    (chain,) = (each.chain for each in read(text).family.required)
    assert {x.name for side in chain.sides for x in side.free_symbols} == {"a"}


@pytest.mark.parametrize(
    ("written", "signs"),
    [
        ("a b = 6", ("=",)),
        ("a == b", ("=",)),
        ("0 < a <= b", ("<", "<=")),
        ("a^2 = 4b = 4", ("=", "=")),
        ("a ≠ b", ("!=",)),
    ],
)
def test_equations_and_chains_are_conditions(read, written, signs):
    family = read(of(f'vary: {{a: {{from: 1, to: 9}}, b: {{from: 1, to: 9}}}}\nrequire: ["{written}"]')).family
    assert [each.chain.signs for each in family.required] == [signs]


@pytest.mark.parametrize(
    ("text", "wrong"),
    [
        ("vary: {a: {frm: 1, to: 9}}", ["4:12-15 unknown key 'frm'"]),
        ("vary: {a: {frm: 1}}", ["4:11-19 'to' is missing here", "4:12-15 unknown key 'frm'"]),
        ("vary: {a: 3}",
         ["4:11-12 what is drawn from, {from: 1, to: 9} or {choose: [1, 2, 5]}, is expected here, not 3"]),
        ("vary: {}", ["4:7-9 nothing is drawn here"]),
        ("vary: {q: {from: 1, to: 2}}", ["4:8-9 'q' has no value under 'parameters'"]),
        ("vary: {a: {from: 3, to: 2}}", ["4:25-26 this is less than 'from', 3"]),
        ("vary: {a: {from: 1, to: 2, step: -1}}", ["4:34-36 the step must be positive"]),
        ("vary: {a: {from: 1, to: 1e9}}", ["4:25-28 there are 1000000000 values; at most 10000 can be drawn from"]),
        ("vary: {a: {from: sqrt(2), to: 9}}", ["4:18-25 a rational number is expected here"]),
        ("vary: {a: {from: b, to: 9}}", ["4:18-19 a number is expected here, not b"]),
        ("vary: {a: {choose: [1, 1]}}", ["4:24-25 '1' is in the list already"]),
        ("vary: {a: {choose: [1]}}", ["4:11-24 'a' has one value only: leave it to 'parameters'"]),
        ("vary: {a: {from: 1, to: 3, choose: [1, 2]}}",
         ["4:12-16 'from' and 'to' cannot stand beside 'choose'"]),
        ("vary: {a: {choose: [1, 2], step: 1, stp: 2}}",
         ["4:28-32 'step' cannot stand beside 'choose'", "4:37-40 unknown key 'stp'"]),
        ("vary: {a: {from: 1, to: 3, sign: odd}}", ["4:28-32 unknown key 'sign'"]),
        ("require: [controllable]", ["4:10-24 'require' is about a family: 'vary' is missing"]),
        ("vary: {a: {from: 1, to: 9}}\nrequire: [controlable]", ["5:11-22 'controlable' cannot be required"]),
        ("vary: {a: {from: 1, to: 9}}\nrequire: [3 > 2]",
         ["5:11-16 a condition is about parameters, and there is none here"]),
        ("vary: {a: {from: 1, to: 9}}\nrequire: [b > 5]", ["5:11-16 this condition never holds"]),
        ("vary: {a: {from: 1, to: 9}}\nrequire: [b = 5]", ["5:11-16 this condition never holds"]),
        ("vary: {a: {from: 1, to: 9}}\nrequire: [a =]",
         ["5:13-14 an expression is expected on both sides of the relation"]),
        ("vary: {a: {from: 1, to: 9}}\nrequire: [0 < a = b]", ["5:11-20 all signs of a chain point the same way"]),
        ("vary: {a: {from: 1, to: 9}}\nrequire: [a => 2]", ["5:13-15 '=>' is no relation"]),
        ("vary: {a: {from: 1, to: 9}}\nrequire: [x > 2]",
         ["5:11-16 'x' is not drawn: 'require' is about the names under 'vary'"]),
        ("vary: {a: {from: 1, to: 9}}\nnice: {b.KK: integers}", ["5:8-12 placement has no answer 'KK'"]),
        ("vary: {a: {from: 1, to: 9}}\nnice: {z.K: integers}", ["5:8-11 there is no part 'z'"]),
        ("vary: {a: {from: 1, to: 9}}\nnice: {b.K: whole}",
         ["5:13-18 'whole' is not known here; it is one of integers, rationals, exact"]),
    ],
)  # fmt: skip
def test_what_is_wrong_is_told_at_its_place(complaints, text, wrong):
    assert complaints(of(text)) == wrong


def test_the_schema_knows_families(catalogue, read):
    validator = jsonschema.Draft202012Validator(json_schema(catalogue))
    good = of("vary: {a: {from: 1, to: 9, step: 1/2}, b: {choose: [1, 2]}}\nrequire: [a != 2]\nnice: {b.K: integers}")
    read(good)
    validator.validate(yaml.safe_load(good))
    for bad in ("vary: {a: 3}", "vary: {a: {from: 1}}", "nice: {b.K: whole}"):
        assert not validator.is_valid(yaml.safe_load(of(bad)))
