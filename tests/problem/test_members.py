"""Members of families as texts: what is put in, what is left out, what stays, and that it is what is solved."""

from __future__ import annotations

import pytest

from solver.problem.members import headed, member_text, root_of, with_letters, written
from solver.problem.reader import problem_of, read_problem
from solver.problem.source import Source
from solver.problem.yaml_tree import parse_yaml
from solver.tasks import catalogue

BLOCK = """\
# a comment that stays
title: A family
vary:
  a: {from: 1, to: 9}
  beta:
    choose:
      - 1/2
      - sqrt(2)
# about parameters
parameters:
  a: 2   # the default
  β: 3
require: ["a != 2",
          controllable]
nice: {f.polynomial: integers}   # behind it

system: {matrix: [[0, 1], [-a, -beta]]}
find:
  f: characteristic_polynomial
"""
MEMBER = """\
# a comment that stays
title: A family
# about parameters
parameters:
  a: 7   # the default
  β: sqrt(2)

system: {matrix: [[0, 1], [-a, -beta]]}
find:
  f: characteristic_polynomial
"""
FLOW = (
    '{title: "A: family", parameters: {a: 2, b: 3}, vary: {a: {from: 1, to: 9}}, require: [a != 2], '
    'system: {matrix: [[0, "1"], [-a, -b]]}, display: exact, show: {source: false}, find: {f: eigenstructure}}'
)


def test_all_but_the_values_and_the_family_stays_as_it_was():
    assert member_text(Source("f.yaml", BLOCK), {"a": "7", "beta": "sqrt(2)"}) == MEMBER
    assert headed(MEMBER, "One") == f"# One\n{MEMBER}"


@pytest.mark.parametrize(
    "text", [BLOCK, BLOCK.replace("\n", "\r\n"), "\ufeff" + BLOCK, BLOCK.rstrip("\n"), BLOCK + "vary2: 1\n"[:0]]
)
def test_a_member_is_read_as_the_family_with_other_defaults(text):
    member = member_text(Source("f.yaml", text), {"a": "-7", "beta": "1/2"})
    expected = text.replace("a: 2 ", "a: -7 ").replace("β: 3", "β: 1/2")
    read = read_problem(Source("f.yaml", member), catalogue())
    assert read.family is None
    assert read.parts == read_problem(Source("f.yaml", expected), catalogue()).parts


def test_the_last_key_of_a_file_may_be_that_of_a_family():
    start = "parameters: {a: 2}\nsystem: {matrix: [[a]]}\nfind: {f: eigenstructure}\n"
    for end in (
        "vary: {a: {from: 1, to: 9}}",
        "vary:\n  a:\n    from: 1\n    to: 9\n\n",
        "vary: {a:\n  {from: 1, to: 9}\n}\n",
    ):
        assert member_text(Source("f.yaml", start + end), {"a": "5"}).rstrip() == start.replace("2", "5").rstrip()


def test_a_file_in_braces_is_written_anew():
    member = member_text(Source("f.yaml", FLOW), {"a": "9"})
    family, read = (
        read_problem(Source("f.yaml", text), catalogue()) for text in (FLOW.replace("a: 2", "a: 9"), member)
    )
    assert (read.title, read.parts, read.display, read.family) == (family.title, family.parts, family.display, None)


def test_what_is_written_is_read_back():
    texts = ['[1, -2, "a: b", "x\\ny", yes, "true", true, null, "", -3 ± 2j, "*a", 2*(s+1), {k: [1]}]', "{a b: 'c'}"]
    for text in texts:
        node = parse_yaml(Source("f.yaml", text))
        again = parse_yaml(Source("f.yaml", written(node)))
        assert again.plain() == node.plain()


def test_letters_stand_for_what_is_drawn():
    source = Source("f.yaml", BLOCK)
    root = with_letters(root_of(source), {"a", "beta"}, {"a": "positive"})
    problem = problem_of(source, root, catalogue())
    assert set(problem.symbols) == {"a", "beta"}
    assert problem.symbols["a"].is_positive
    assert problem.parameters == {}
