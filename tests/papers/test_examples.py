"""Every family in problems/families has members enough for a class with variants."""

import pytest

from solver.limits import Limits
from solver.papers.families import family_of, members
from solver.papers.judging import Judged, judged
from solver.papers.making import Making, Wanted, made
from solver.papers.search import Search
from solver.problem.files import load
from solver.problem.reader import read_problem
from solver.tasks import catalogue
from tests.helpers.solved import PROBLEMS, by_problem

FAMILIES = [path for path in PROBLEMS if path.parent.name == "families"]


@pytest.mark.parametrize(**by_problem(FAMILIES))
def test_the_default_is_a_member_itself(path):
    source = load(path)
    family = family_of(read_problem(source, catalogue()))
    assert isinstance(judged(source.text, source.name, family.required, family.nice), Judged)


@pytest.mark.parametrize(**by_problem(FAMILIES, quick=[]))
def test_there_are_four_members(path, loaded):
    source = load(path)
    search = Search(source, family_of(read_problem(source, catalogue())), seed=1)
    making = Making(made, Wanted(formats=("html",), difficulty=True), Limits())
    found = list(members(search, 4, making, path.stem))
    assert [member.name for member in found] == [f"{path.stem}-0{number}" for number in range(1, 5)]
    assert all(member.made.difficulty.decimals == 0 for member in found)
    assert all(b"Verified" in member.made.files[".html"] for member in found)
