from __future__ import annotations

import subprocess
import sys

import jsonschema
import pytest
import yaml

from solver.problem.reader import read_problem
from solver.problem.schema import json_schema
from solver.problem.shape import ProblemShape
from solver.problem.source import InputError, Source
from solver.problem.template import new_problem
from solver.tasks import catalogue as whole_catalogue


@pytest.fixture(scope="module")
def validator(catalogue):
    schema = json_schema(catalogue)
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


GOOD = [
    "title: x\nsystem: {A: [[0, 1], [-2, -3.5]], B: [0, 1]}\nfind: {a: stability, b: {task: stability, gain: [1, 2]}}",
    "system: {A: -2, time: discrete, sample_time: 0.1}\nfind: {a: {task: transition, method: [modal], marks: 2}}",
    "display: exact\nsystem: {transfer_function: {zeros: [1], poles: ['-3 ± 2j', 1]}}\nfind: {1: realization}",
    "display: {decimals: 4}\nfind: {a: realization}\n"
    "system: {transfer_matrix: [[1/s, {numerator: 1, denominator: [1, 1]}]]}\n",
    "parameters: {m: 1, k: 3/4}\nassume: {a: positive}\nsystem: {matrix: [[m, k], [a, 1]]}\nfind: {a: stability}",
    "system: {A: 1, B: 1}\nfind: {a: {task: placement, poles: -1}, b: {task: stability, gain: {from: a, answer: K}}}",
    "system: {A: 1, B: 1, C: 1}\nfind: {a: {task: options, band: 5%, dual: true, count: 3, output: 1, ratio: 14%}}",
]
BAD = [
    "system: {A: 1}",
    "system: {A: 1}\nfind: {}",
    "statment: x\nsystem: {A: 1}\nfind: {a: stability}",
    "system: {B: 1}\nfind: {a: stability}",
    "system: {A: 1, transfer_function: 1/s}\nfind: {a: stability}",
    "system: {A: {x: 1}}\nfind: {a: stability}",
    "system: {lagrangian: [x]}\nfind: {a: stability}",
    "system: {A: 1}\nfind: {a: stabilty}",
    "system: {A: 1}\nfind: {a: {task: stabilty}}",
    "system: {A: 1}\nfind: {a: {task: stability, method: stability}}",
    "system: {A: 1}\nfind: {a: {task: transition, method: laplce}}",
    "system: {A: 1}\nfind: {a: {task: transition, term: 3}}",
    "system: {A: 1}\nfind: {a: {task: transition, terms: 13, method: series}}",
    "system: {A: 1, B: 1}\nfind: {a: placement}",
    "system: {A: 1, B: 1}\nfind: {a: {task: placement}}",
    "system: {A: 1}\nfind: {a b: stability}",
    "assume: {m: positve}\nsystem: {A: 1}\nfind: {a: stability}",
    "display: exct\nsystem: {A: 1}\nfind: {a: stability}",
    "system: {A: 1}\nfind: {a: {task: options, band: 3%}}",
    "system: {A: 1}\nfind: {a: {task: options, dual: maybe}}",
    "system: {A: 1}\nfind: {a: {task: stability, gain: {form: a}}}",
]


@pytest.mark.parametrize("text", GOOD)
def test_what_is_read_fits_the_schema(validator, read, text):
    read(text)
    # as an editor sees it; its keys are texts
    data = {**yaml.safe_load(text)}
    data["find"] = {str(key): value for key, value in data["find"].items()}
    validator.validate(data)


@pytest.mark.parametrize("text", BAD)
def test_what_the_schema_refuses_is_not_read_either(validator, read, text):
    assert not validator.is_valid(yaml.safe_load(text))
    with pytest.raises(InputError):
        read(text)


def test_an_option_of_the_name_of_a_key_of_every_part_may_be_written_as_either():
    validator = jsonschema.Draft202012Validator(json_schema(whole_catalogue()))
    text = "system: {{A: [[a, b], [1, -1]]}}\nfind: {{a: {{task: stability_range, parameters: {}}}}}\n"
    for parameters, fits in (("[a]", True), ("a", True), ("{b: 2}", True), ("{b: [2]}", False), ("[[a]]", False)):
        data = yaml.safe_load(text.format(parameters))
        assert validator.is_valid(data) == fits
        if fits:
            read_problem(Source("file.yaml", text.format(parameters)), whole_catalogue())


def test_every_option_is_described_and_every_task_has_a_branch(catalogue):
    schema = json_schema(catalogue)
    for name, task in catalogue.items():
        properties = schema["$defs"][f"task_{name}"]["properties"]
        for option in task.options.values():
            assert properties[option.name]["description"].startswith(option.doc)
        assert {"task", "marks", "prompt", "system"} <= properties.keys()
    assert len(schema["$defs"]["Part"]["allOf"]) == len(catalogue)


def test_every_key_of_a_problem_is_described(catalogue):
    properties = json_schema(catalogue)["properties"]
    assert properties.keys() == ProblemShape.model_fields.keys()
    assert all(each.get("description") for each in properties.values())


def test_the_schema_and_new_files_need_no_algebra():
    code = (
        "import sys; from solver.problem.schema import json_schema; from solver.problem.template import new_problem\n"
        "from solver.tasks import catalogue\n"
        "json_schema(catalogue()); [new_problem(task) for task in catalogue().values()]\n"
        "assert 'sympy' not in sys.modules and 'numpy' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


NAMES = ["stability", "controllability", "transition", "placement", "realization", "subspaces", "desired", "options"]


@pytest.mark.parametrize("name", NAMES)
def test_a_new_file_can_be_read(catalogue, read, name):
    problem = read(new_problem(catalogue[name]))
    assert problem.parts[0].task == name
    assert problem.title == catalogue[name].title


@pytest.mark.parametrize("name", NAMES)
def test_every_option_of_a_new_file_can_be_uncommented(catalogue, read, name):
    task = catalogue[name]
    for option in task.options.values():
        if option.name == "parameters":
            continue  # names parameters of the system, and the example has none
        text = new_problem(task).replace("  # B:", "  B:").replace("  # C:", "  C:")
        text = text.replace(f"    # {option.name}: ", f"    {option.name}: ")
        if option.methods:
            text = text.replace(f"method: {task.methods_for(discrete=False)[0]}", f"method: {option.methods[0]}")
        if "system:" not in text and option.name == "gain":
            continue
        if name in ("realization", "subspaces") and option.name == "gain":
            continue
        assert option.name in read(text).parts[0].options


def test_the_small_catalogue_here_is_the_one_tested(catalogue):
    assert set(NAMES) == set(catalogue)


def test_a_title_that_yaml_would_misread_is_quoted(catalogue, read):
    task = catalogue["stability"]
    title = task.title
    try:
        task.title = "Poles: it's #1"
        assert read(new_problem(task)).title == task.title
    finally:
        task.title = title


def test_a_source_with_any_name_can_be_read(catalogue):
    problem = read_problem(Source("", new_problem(catalogue["stability"])), catalogue)
    assert problem.name == "problem"
