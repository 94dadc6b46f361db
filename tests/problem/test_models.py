"""`system: {model: NAME}`: the system of a file of the library, with values for its parameters or without."""

import pytest
import sympy as sp

from solver.problem.library import library_model, model_names
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue

SYSTEMS = [name for name in model_names() if library_model(name).system is not None]
FIND = "find: {a: state_space_model}\n"


def read(text):
    return read_problem(Source("<text>", text), catalogue())


def complaints(text):
    with pytest.raises(InputError) as caught:
        read(text)
    return [(each.line, each.column, each.message, each.suggestion, each.note) for each in caught.value.diagnostics]


@pytest.mark.parametrize("name", SYSTEMS)
def test_a_model_is_the_system_of_its_file(name):
    source = library_model(name).source
    ours = read(f"system: {{model: {name}}}\nfind: {{a: {{task: characteristic_polynomial, system: {{A: 1}}}}}}\n")
    theirs = read_problem(source, catalogue())
    assert ours.system == theirs.system
    assert {word: set(map(str, names)) for word, names in ours.assumed.items()} == {
        word: set(map(str, names)) for word, names in theirs.assumed.items()
    }


@pytest.mark.parametrize("name", SYSTEMS)
def test_every_name_of_a_model_says_what_it_is(name):
    model = library_model(name)
    system = read_problem(model.source, catalogue()).system
    named = model.meanings("assume")
    assert {str(symbol) for symbol in system.parameters} <= set(named)
    assert all(named.values())
    assert model.system.get("states") is not None
    assert model.comment(model.system["states"])


def parameters_of(text):
    return sorted(map(str, read(text).system.parameters))


def test_values_stand_in_the_problem_or_in_the_system():
    inside = "system: {model: quarter-car, parameters: {m_c: 300, m_w: 50, k1: 160000, k2: 16000}}\n"
    beside = "parameters: {m_c: 300, m_w: 50, k1: 160000, k2: 16000}\nsystem: {model: quarter-car}\n"
    assert parameters_of(inside + FIND) == parameters_of(beside + FIND) == ["d"]
    assert read(inside + FIND).system == read(beside + FIND).system


def test_parameters_without_a_value_stay_symbols_with_what_is_known_of_them():
    problem = read("system: {model: quarter-car, parameters: {d: 0}}\nassume: {k1: real}\n" + FIND)
    assert problem.system.parameters == tuple(
        sp.Symbol(name, **({"real": True} if name == "k1" else {"positive": True})) for name in "k1 k2 m_c m_w".split()
    )
    assert problem.assumed == {"positive": tuple(sp.symbols("m_c m_w k2", positive=True))}


def test_a_part_has_a_model_of_its_own():
    problem = read(
        "parameters: {R: 2}\nsystem: {A: R}\nfind: {a: stability, b: {task: stability, system: {model: rlc-series}}}"
    )
    assert sorted(map(str, problem.parts[1].system.parameters)) == ["C", "L"]
    assert problem.parts[1].assumed == {"positive": tuple(sp.symbols("L C", positive=True))}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("system: {model: quarter-caar}\n" + FIND, [
            (1, 17, "there is no model 'quarter-caar'", "quarter-car", "`solve models` lists what there is")]),
        ("system: {model: zzz}\n" + FIND, [
            (1, 17, "there is no model 'zzz'", "", f"there are {', '.join(model_names())}")]),
        ("system: {model: }\n" + FIND, [
            (1, 17, f"the name of a model ({', '.join(model_names())}) is expected here, not nothing", "", "")]),
        ("system: {model: quarter-car, time: discrete}\n" + FIND, [
            (1, 36, "the models of the library are in continuous time", "", "")]),
        ("system: {model: quarter-car, A: 1}\n" + FIND, [(1, 30, "'A' cannot stand beside 'model'", "", "")]),
        ("system: {model: quarter-car}\nparameters: {mc: 3}\n" + FIND, [
            (2, 14, "the parameter 'mc' occurs nowhere", "m_c", "")]),
        ("system: {model: quarter-car, parameters: {mc: 3}}\n" + FIND, [
            (1, 43, "the parameter 'mc' occurs nowhere", "m_c", "")]),
        ("system: {model: rlc-series, parameters: {C: 1/0}}\n" + FIND, [(1, 47, "division by zero", "", "")]),
        ("system: {model: general-balances}\n" + FIND, [
            (1, 17, "the model 'general-balances' holds laws, not a system", "", "`solve models` lists the others")]),
    ],
)  # fmt: skip
def test_what_is_wrong_is_told_at_its_place(text, expected):
    assert complaints(text) == expected
