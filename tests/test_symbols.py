"""The glossary is whole: every name has its meaning, its counterpart and a symbol in every notation."""

import re
from pathlib import Path

import pytest

from solver.symbols import (
    COMPLEX,
    CONTINUOUS,
    COURSE,
    MEANINGS,
    NOTATIONS,
    OTHER_TIME,
    POLYNOMIAL,
    QUANTITIES,
    RESERVED,
    SAMPLES,
    TIME,
    VARIABLES,
)
from solver.tasks import catalogue

PROJECT = Path(__file__).parents[1]
LISTED = re.compile(r"""[{(\[]["'](?:s|z|t|k|lamda|tau)["'], ["'](?:s|z|t|k|lamda|tau)["'],""")


def test_every_variable_is_declared_once_with_its_meaning():
    names = [each.name for each in VARIABLES]
    assert len(names) == len(set(names))
    assert all(each.meaning and each.domain in ("complex", "real", "integer") for each in VARIABLES)
    assert set(MEANINGS) | set(SAMPLES) == RESERVED == {"s", "z", "t", "k", "lamda"}


def test_variables_of_the_two_kinds_of_time_stand_for_each_other():
    assert OTHER_TIME == {True: {"s": "z", "t": "k"}, False: {"z": "s", "k": "t"}}


def test_variables_are_sorted_by_what_is_made_of_them():
    assert POLYNOMIAL == COMPLEX == {"s", "z", "lamda"}
    assert {"t", "k", "tau"} == TIME
    assert {"s", "z", "lamda", "t"} == CONTINUOUS


@pytest.mark.parametrize("notation", NOTATIONS)
def test_every_notation_has_a_symbol_for_every_quantity(notation):
    assert NOTATIONS[notation].keys() == {each.name for each in QUANTITIES}
    assert all(NOTATIONS[notation].values())


def test_the_quantities_are_those_whose_symbols_templates_phrases_and_answers_ask_for():
    asked = re.compile(r"\bsym\.(\w+)|\\\\?sym\{(\w+)\}")
    files = [path for folder in ("templates", "solver") for path in (PROJECT / folder).rglob("*.*")]
    texts = [path.read_text(encoding="utf-8") for path in files if path.suffix in {".py", ".jinja", ".yaml"}]
    names = {name for text in texts for found in asked.findall(text) for name in found if name}
    answers = {answer for name in catalogue() for answer in catalogue()[name].answers}
    quantities = {each.name for each in QUANTITIES}
    assert names <= quantities <= names | answers


def test_a_notation_differs_where_it_says_so():
    assert (NOTATIONS[COURSE]["K"], NOTATIONS["ogata"]["K"], NOTATIONS["ogata"]["L"]) == ("K_f", "K", "K_e")
    assert NOTATIONS["ogata"]["damping_ratio"] == r"\zeta"


def test_no_other_file_lists_the_reserved_names():
    files = [path for path in (PROJECT / "solver").rglob("*.py") if path.name != "symbols.py"]
    listed = {path.name: LISTED.findall(path.read_text(encoding="utf-8")) for path in files}
    assert not {name: found for name, found in listed.items() if len(found) > 0}
