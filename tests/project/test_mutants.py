"""The tool that makes slips in the program: which ones, in a sample that stays, and whether a test's eye is seen."""

import ast
import builtins
import importlib
import multiprocessing
import os
import resource
import subprocess
import sys
import time
from collections import Counter
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tools.mutants.__main__ import candidates, equivalents, sample, sample_of_each, table
from tools.mutants.noting import MEMORY, Program
from tools.mutants.operators import mutants_of
from tools.mutants.reached import Reached, Record, read
from tools.mutants.running import Chosen, chosen_for, outcomes

ROOT = Path(__file__).parents[2]
ROUTH = ROOT / "solver" / "exact" / "stability" / "routh.py"


def reached_by(slip, seconds):
    """What is known when these tests run the line of a slip, and no others."""
    ran = np.full((len(seconds), 1), 0b10000000, dtype=np.uint8)
    return Reached(seconds, [Record([*seconds], {slip.file: (0, [(slip.line, slip.line)])}, ran)])


def slips(tmp_path, code):
    path = tmp_path / "file.py"
    path.write_text(code, encoding="utf-8")
    return list(mutants_of(path, tmp_path))


@pytest.mark.parametrize(
    ("expression", "changed"),
    [
        ("a - b", {"(a + b)", "(a)"}),
        ("a * b", {"(a)", "(b)"}),
        ("-a", {"(a)"}),
        ("a and b", {"(a or b)", "(a)", "(b)"}),
        ("not a", {"(a)"}),
        ("a < b", {"(a <= b)"}),
        ("a < 1e-9", set()),
        ("a > 0.0", {"(a >= 0.0)"}),
        ("a is None", {"(a is not None)"}),
        ("a[3]", {"a[4]"}),
        ("True", {"False"}),
        ("f(a, b)", {"f(b, a)"}),
        ("zip(a, b, strict=True)", set()),
        ("np.allclose(a, b, atol=c)", set()),
        ("product(a, b)", {"product(b, a)"}),
        ("product(-a, 1.0)", {"product(a, 1.0)"}),
        ("Check.that('it is so', 'numpy', a)", set()),
        ("'a' + b", set()),
        ("[a] + b", set()),
        ("f'{a + b}'", set()),
        ("cast(a, -1)", set()),
        ("gc.set_threshold(a, 20)", set()),
        ("lru_cache(a + 20)(b)", set()),
        ("random.randint(-a, 30)", set()),
        ("f(10) ** -(a + 3)", set()),
        ("a < f(10) ** (-a // 2)", set()),
        ("10**3 < a", {"10**3 <= a", "11**3 < a", "10**4 < a"}),
        ("N(a, 30)", {"N(30, a)"}),
        ("1 + abs(a)", {"(1 - abs(a))", "(1)"}),
    ],
)
def test_the_slips_of_an_expression(tmp_path, expression, changed):
    found = slips(tmp_path, f"def f(a, b):\n    return {expression}\n")
    results = {each.applied((tmp_path / "file.py").read_bytes()).decode().split("return ")[1] for each in found}
    assert {ast.unparse(ast.parse(result)) for result in results} == {ast.unparse(ast.parse(c)) for c in changed}
    assert {each.function for each in found} <= {"f"}


def test_what_is_not_computed_is_left_alone(tmp_path):
    code = '"""A text - with 1."""\nif TYPE_CHECKING:\n    x = 1\n\n\n@f(1)\ndef g(x: "a - b") -> "1":\n    "No 2."\n'
    code += 'if __name__ == "__main__":\n    exit(g(1))\n'
    assert slips(tmp_path, code) == []


def test_what_a_refusal_says_is_left_alone_and_what_it_decides_is_not(tmp_path):
    code = "def f(a):\n    raise g({} if a == {} else {}, h(a, 'x'))\n"
    assert {each.kind for each in slips(tmp_path, code.format("'one way'", "'b'", "'the other'"))} == {
        "swapped argument"
    }
    for deciding in (code.format("'one'", 2, "'other'"), code.format("'one way'", 2, "k(a)")):
        assert {"comparison", "constant"} <= {each.kind for each in slips(tmp_path, deciding)}


def test_letters_of_several_bytes_do_not_move_a_slip(tmp_path):
    (sign,) = [each for each in slips(tmp_path, "x = 'λ', a + b\n") if each.kind == "sign"]
    assert sign.applied((tmp_path / "file.py").read_bytes()).decode() == "x = 'λ', (a - b)\n"


def test_a_sample_keeps_its_members_when_lines_move(tmp_path):
    before = sample(slips(tmp_path, "def f(a, b):\n    return [a - b, a < b, a * b]\n"), 3, seed=1)
    after = sample(slips(tmp_path, "\n\ndef f(a, b):\n    return [a - b, a < b, a * b]\n"), 3, seed=1)
    assert [each.key for each in before] == [each.key for each in after]
    assert before != sample(before, 3, seed=2) or len(before) < 2


def test_a_sample_of_each_has_so_many_of_every_folder():
    chosen = sample_of_each(candidates([ROOT / "solver" / "exact", ROOT / "solver" / "options"]), 3, seed=1)
    counts = Counter(each.place for each in chosen)
    assert counts["options"] == counts["exact/stability"] == counts["exact/linear_algebra"] == 3


WATCHED = """\
import os


def f(x):
    "A text is no statement."
    if x > 0:
        y = [
            x,
            1,
        ]
    elif x < 0:
        y = []
    else:
        def g():
            return 2
        y = [g()]
    for _ in y:
        try:
            x = 1 / x
        except ZeroDivisionError:
            pass
    return y
"""


@pytest.mark.parametrize("forked", [False, True])
@pytest.mark.parametrize(
    ("x", "ran"),
    [
        (1, {6, 7, 17, 18, 19, 22}),
        (-1, {6, 11, 12, 17, 22}),
        (0, {6, 11, 14, 15, 16, 17, 18, 19, 21, 22}),
    ],
)
def test_a_statement_that_runs_is_noted_in_forked_processes_too(tmp_path, monkeypatch, x, ran, forked):
    (tmp_path / "watched_for_slips.py").write_text(WATCHED, encoding="utf-8")
    program = Program(tmp_path)
    monkeypatch.setattr(sys, "meta_path", [*sys.meta_path])
    monkeypatch.setattr(builtins, MEMORY, None, raising=False)
    monkeypatch.syspath_prepend(str(tmp_path))
    program.watch("watched_for_slips")
    module = importlib.import_module("watched_for_slips")
    program.ran()
    if forked:
        process = multiprocessing.get_context("fork").Process(target=module.f, args=(x,))
        process.start()
        process.join()
    else:
        module.f(x)
    lines = {first for (first, _), did in zip(program.lines, program.ran(), strict=True) if did}
    assert lines == ran
    assert not any(program.ran())


def test_what_a_run_of_tests_writes_down_is_read(tmp_path):
    code = "import sys, tools.mutants.reached as r; from pathlib import Path; r.FOLDER = Path(sys.argv[1]); "
    code += "import pytest; sys.exit(pytest.main([*sys.argv[2:]], plugins=[r]))"
    test = "tests/exact/test_routh.py::test_a_leading_zero_is_refused"
    reading = "tests/problem/test_options.py::test_defaults_are_filled_in"
    command = [sys.executable, "-c", code, str(tmp_path), "-q", "-p", "no:cacheprovider", "-n", "0", test, reading]
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTEST_")}
    subprocess.run(command, cwd=ROOT, env={**environment, "PYTHONPATH": str(ROOT)}, check=True, capture_output=True)
    reached = read(tmp_path)
    assert [*reached.seconds] == [test, reading]
    assert reached.seconds[test] > 0
    statements = [line for line in range(1, 200) if reached.tests_of("solver/exact/stability/routh.py", line)]
    assert statements
    assert reached.tests_of_file("solver/exact/stability/routh.py") == {test}
    assert reached.tests_of_file("solver/problem/reader.py") == {reading}  # a conftest imports it
    assert not reached.tests_of_file("solver/cli/__init__.py")


def test_the_program_with_a_slip_is_still_python():
    files = sorted((ROOT / "solver").rglob("*.py"))[::12]
    for each in sample(candidates(files), 100, seed=1):
        changed = each.applied((ROOT / each.file).read_bytes())
        assert ast.dump(ast.parse(changed)) != ast.dump(ast.parse((ROOT / each.file).read_bytes())), each


@pytest.mark.parametrize("known", equivalents(), ids=lambda each: f"{each['function']}: {each['after']}")
def test_a_slip_that_is_excused_can_be_made_and_has_its_reason(known):
    made = mutants_of(ROOT / known["file"], ROOT)
    assert any(
        (each.function, each.before, each.after) == (known["function"], known["before"], known["after"])
        for each in made
    )
    assert len(known["reason"]) > 20


def test_own_tests_come_first_and_the_quick_ones_of_each_function_before_its_other_cases():
    (slip, *_) = mutants_of(ROUTH, ROOT)
    seconds = {
        "tests/tasks/t.py::a": 0.1,
        "tests/exact/t.py::b[1]": 1,
        "tests/exact/t.py::b[2]": 2,
        "tests/exact/t.py::c": 3,
    }
    order = [test.rpartition(":")[2] for test in chosen_for(slip, reached_by(slip, seconds))]
    assert order == ["b[1]", "c", "b[2]", "a"]


def test_the_test_of_a_file_comes_before_others_of_its_room():
    (slip, *_) = mutants_of(ROUTH, ROOT)
    seconds = {"tests/exact/test_a.py::a": 0.1, "tests/exact/test_routh.py::b": 1, "tests/exact/test_routh.py::c": 0.5}
    order = chosen_for(slip, reached_by(slip, seconds))
    assert [test.rpartition(":")[2] for test in order] == ["c", "b", "a"]


def test_what_is_declared_is_seen_by_the_tests_of_the_tables_too():
    path = ROOT / "solver" / "tasks" / "time_response" / "response.py"
    slip = next(each for each in mutants_of(path, ROOT) if not each.function and each.before == "True")
    running, tables, other = "tests/tasks/test_response.py::a", "tests/project/test_tables.py::b", "tests/exact/t.py::c"
    record = Record([running], {slip.file: (0, [(100, 100)])}, np.array([[0b10000000]], dtype=np.uint8))
    reached = Reached({running: 1, tables: 1, other: 1}, [record])
    assert chosen_for(slip, reached) == [running, tables]


def test_where_a_slip_changes_the_names_of_cases_all_cases_are_run():
    class Item:
        def __init__(self, nodeid):
            self.nodeid = nodeid

    def left(*tests):
        items = [Item(test) for test in ("t::a[1]", "t::a[2]", "t::b[3]", "t::b[4]", "t::c")]
        Chosen(dict.fromkeys(tests, 0.1), "t").pytest_collection_modifyitems(items)
        return [item.nodeid for item in items]

    assert left("t::c", "t::a[2]") == ["t::c", "t::a[2]"]
    assert left("t::b[no longer]", "t::a[1]", "t::d") == ["t::b[3]", "t::b[4]", "t::a[1]"]


def test_a_test_has_its_own_time_and_the_limit_of_all_is_left_as_it_was():
    class Item:
        nodeid = "t::a"

    before = resource.getrlimit(resource.RLIMIT_CPU)
    around = Chosen({"t::a": 2.0}, "t").pytest_runtest_protocol(Item())
    next(around)
    left = resource.getrlimit(resource.RLIMIT_CPU)[0] - time.process_time()
    assert 26 <= left <= 27.5
    with pytest.raises(StopIteration):
        around.send(None)
    assert resource.getrlimit(resource.RLIMIT_CPU) == before


@pytest.mark.slow
def test_a_slip_is_killed_by_a_test_that_sees_it_and_survives_one_that_does_not():
    slip = next(each for each in mutants_of(ROUTH, ROOT) if each.kind == "sign")
    folder = "tests/exact/test_routh.py::test_"
    seeing, blind = f"{folder}textbook_arrays[coefficients0-rows0]", f"{folder}a_leading_zero_is_refused"
    found = {}
    for test in (seeing, blind):
        ((_, found[test]),) = outcomes([slip], reached_by(slip, {test: 0.1}), lanes=1)
    nothing = replace(slip, after=slip.before)
    reached = reached_by(slip, {seeing: 0.1})
    assert [outcome for _, outcome in outcomes([slip, nothing], reached, lanes=1)] == ["killed", "survived"]
    assert found == {seeing: "killed", blind: "survived"}
    assert "50%" in table({"exact": Counter(found.values())})
