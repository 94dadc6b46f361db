"""A draw is judged, solved and verified in one call, and what comes of draws is looked at in their order."""

from __future__ import annotations

from dataclasses import replace

import pytest

from solver import engine
from solver.document.model import Presentation
from solver.papers.judging import Rejection
from solver.papers.making import Wanted, made, made_of, tried
from solver.problem.members import member_text
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue
from tests.papers.conftest import FAMILY
from tests.papers.searching import Here, candidates

TEXT = FAMILY.replace("  f: {task", "  e: controllability\n  f: {method: [ackermann, bass_gura], task")


def conditions():
    source = Source("family.yaml", TEXT)
    family = read_problem(source, catalogue()).family
    return member_text(source, {"a": "3", "b": "2", "p": "-4"}), source.name, family.required, family.nice


def test_what_was_found_to_judge_a_draw_is_not_derived_again(monkeypatch):
    derived, found_by = [], engine._found_by

    def noting(method, part, *rest):
        derived.append((part.id, method))
        return found_by(method, part, *rest)

    monkeypatch.setattr(engine, "_found_by", noting)
    assert tried(*conditions(), made, Wanted()).made.status == "verified"
    own = [each for each in derived if each[0]]  # a word of `require` is no part
    assert sorted(own) == [("e", "rank"), ("f", "ackermann"), ("f", "bass_gura")]


@pytest.mark.parametrize("detail", ["full", "tutor"])
def test_a_member_is_told_as_if_it_were_solved_alone(detail):
    wanted = Wanted(("html", "md"), Presentation(detail))
    text, name, *_ = given = conditions()
    alone = made_of(text, name, made, replace(wanted, difficulty=True))
    assert alone.files.keys() == {".html", ".md"}
    assert tried(*given, made, replace(wanted, difficulty=True)).made == alone


def test_one_that_is_no_member_is_not_made():
    text, name, required, nice = conditions()
    assert tried(text.replace("b: 2", "b: 1/2"), name, required, nice, None, None) == Rejection("f.K: integers")


@pytest.mark.parametrize("wanted", [1, 6, 100])
def test_draws_are_looked_at_in_their_order_whichever_is_through_first(search_of, wanted):
    search, other = search_of(most=70), search_of(most=70, executor=Here(3))
    assert candidates(other, wanted) == candidates(search, wanted)
    assert (other.draws, other.found, other.rejections) == (search.draws, search.found, search.rejections)
    assert other.judgements == search.judgements
    assert (other.draws == 70) is (wanted == 100)


def test_no_more_draws_are_tried_than_may_be_wanted(search_of):
    plain = "parameters: {a: 2}\nvary: {a: {from: 1, to: 50}}\nsystem: {A: [[0, 1], [-a, -1]]}\nfind: {f: stability}\n"
    for wanted in (1, 2, 7):
        search = search_of(plain, executor=Here(3))
        assert len(candidates(search, wanted)) == search.executor.made == wanted
