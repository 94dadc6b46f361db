"""Many files at a time: what is written and told is what one file after the other gives, whoever solves them."""

import os
import pty
import re
import subprocess
import sys
from pathlib import Path

import pytest

from solver.cli.batch import solve_whole
from solver.cli.executing import Workers
from solver.executors import Processes
from solver.limits import Exceeded
from tests.helpers.small_problems import GOOD

BAD = "system: {A: [[0, 1], [-2, -3]]}\nfind: {a: {task: stabilty}}\n"
SINGULAR = "system: {A: [[0, 1], [-2, -3]]}\nfind: {a: {task: similarity_transformation, T: [[1, 1], [1, 1]]}}\n"
LIMITS = ("--time-limit", "2", "--memory-limit", "64")

pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="the task is known to forked children")


@pytest.fixture
def forked(monkeypatch):
    """Let workers be forked from this process, so that they know of the difficult task."""
    monkeypatch.setattr("solver.executors.processes.start_method", lambda: "fork")


def contents(folder):
    """The files written; the record that a rerun keeps is hidden."""
    return {path.name: path.read_bytes() for path in sorted(Path(folder).iterdir()) if path.name[0] != "."}


@pytest.fixture
def files(difficult_file, tmp_path):
    """Good files, and others that are at fault, stuck, too large, dead, buggy."""
    methods = {"stuck": ("easy", "endless", "easy"), "greedy": ("greedy", "easy"), "dead": ("easy", "deadly", "buggy")}
    for name, asked in methods.items():
        difficult_file(*asked, name=f"{name}.yaml")
    for name, text in {"good": GOOD, "bad": BAD, "singular": SINGULAR, "last": GOOD.replace("-3", "-4")}.items():
        (tmp_path / f"{name}.yaml").write_text(text, encoding="utf-8")
    return [f"{name}.yaml" for name in ("stuck", "good", "bad", "dead", "missing", "singular", "greedy", "last")]


def test_the_number_of_processes_changes_nothing(solve, forked, files):
    """Nor does one call for each file; only the part that is stuck, dead or too large is lost."""
    alone = [solve(file, *LIMITS, "-f", "html,json", "-o", "alone/") for file in files]
    for jobs in (1, 3):
        done = solve(*files, *LIMITS, "-f", "html,json", "-o", f"jobs-{jobs}/", "--jobs", jobs)
        assert contents(f"jobs-{jobs}") == contents("alone")
        assert done.out.replace(f"jobs-{jobs}/", "alone/") == "".join(each.out for each in alone)
        assert done.err == "".join(each.err for each in alone)
        assert done.code == max(each.code for each in alone) == 2
    assert set(contents("alone")) == {f"{name}.{kind}" for name in ("stuck", "good", "dead", "greedy", "last")
                                      for kind in ("html", "json")}  # fmt: skip
    stuck = next(each for each in alone if "time limit" in each.out)
    assert stuck.out.count("verified") == 2


class Hasty(Processes):
    """No file is solved whole: its process meets its limit, or dies."""

    def calls(self, limits, function, calls):
        if function is solve_whole:
            yield from ((place, Exceeded("it was stopped")) for place, _ in enumerate(calls))
        else:
            yield from super().calls(limits, function, calls)


@pytest.mark.parametrize("jobs", [1, 3])
def test_a_file_that_was_stopped_before_it_was_read_costs_the_others_nothing(solve, monkeypatch, tmp_path, jobs):
    for name, text in {"bad": "title: [broken\n", "q1": GOOD, "q2": GOOD.replace("-3", "-4"), "unknown": BAD}.items():
        (tmp_path / f"{name}.yaml").write_text(text, encoding="utf-8")
    usual = solve(".", "-o", "usual/", "--jobs", jobs)
    monkeypatch.setattr(Workers, "executor", lambda workers: Hasty(workers.processes))
    done = solve(".", "-o", "out/", "--jobs", jobs)
    assert (done.code, done.err) == (2, usual.err)
    assert "bad.yaml" in done.err
    assert "internal error" not in done.err
    assert contents("out") == contents("usual")
    assert set(contents("out")) == {"q1.html", "q2.html"}


def test_standard_input_is_one_of_the_files(process, good):
    done = process("-", "good.yaml", "-o", "out/", stdin=GOOD.encode())
    assert (done.code, done.err) == (0, "")
    assert done.out.index("wrote out/solution.html") < done.out.index("wrote out/good.html")


def test_what_cannot_be_written_is_told_in_its_place(solve, forked, good, tmp_path):
    (tmp_path / "other.yaml").write_text(GOOD, encoding="utf-8")
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "good.html").mkdir()
    done = solve("good.yaml", "other.yaml", "-f", "html,md", "-o", "out/")
    assert done.code == 2
    assert done.err.count("error:") == 1
    assert "good.yaml: error: cannot write out/good.html" in done.err
    assert [line for line in done.out.splitlines() if line.startswith("wrote")] == [
        "wrote out/good.md", "wrote out/other.html", "wrote out/other.md"
    ]  # fmt: skip


def test_images_come_with_their_problem(solve, forked, good, tmp_path):
    picture = '<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><rect width="9" height="9"/></svg>'
    (tmp_path / "plan.svg").write_text(picture, encoding="utf-8")
    text = 'statement: "A plan: ![a square](plan.svg)"\n' + GOOD.partition("\n")[2]
    (tmp_path / "drawn.yaml").write_text(text, encoding="utf-8")
    done = solve("drawn.yaml", "good.yaml", "-f", "html", "-o", "out/")
    assert done.code == 0, done.err
    assert "image/svg+xml" in (tmp_path / "out" / "drawn.html").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--jobs", 0), "0 is not in the range"),
        (("--engine", "dusk"), "'dusk' is not one of 'processes', 'dask'"),
        (("--scheduler", "tcp://here:8786"), "add --engine dask"),
        (("--engine", "dask", "--scheduler", "here"), "tcp://host:8786"),
        (("--engine", "dask", "--scheduler", "tcp://here:8786", "--jobs", 2), "a cluster has the workers that it has"),
    ],
)
def test_options_that_do_not_fit_are_refused(solve, good, words, message):
    done = solve("good.yaml", "good.yaml", *words)
    assert done.code == 2
    assert message in done.err


def run_at_terminal(words, folder):
    """Run the command line with standard error a terminal; return what goes there and what goes to standard output."""
    parent, its_end = pty.openpty()
    env = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[2]), "TERM": "xterm", "COLUMNS": "80"}
    process = subprocess.Popen([sys.executable, "-m", "solver", *words], cwd=folder, env=env, stdout=subprocess.PIPE,
                               stderr=its_end)  # fmt: skip
    os.close(its_end)
    seen = b""
    while True:
        try:
            part = os.read(parent, 4096)
        except OSError:
            break
        if not part:
            break
        seen += part
    return seen.decode(), process.stdout.read().decode(), process.wait()


def test_progress_is_shown_on_a_terminal_and_output_goes_where_it_belongs(tmp_path):
    for name in ("one", "two", "three"):
        (tmp_path / f"{name}.yaml").write_text(GOOD, encoding="utf-8")
    seen, out, code = run_at_terminal(["one.yaml", "two.yaml", "three.yaml", "-o", "out/", "--jobs", "2"], tmp_path)
    assert code == 0
    assert "solving" in seen
    assert "3/3" in seen
    assert "wrote" not in seen
    assert out.count("wrote out/") == 3


FAMILY = "parameters: {a: 2}\nvary: {a: {from: 1, to: 9}}\n" + GOOD.replace("-3", "-a")
EXAM = (
    "exam: E\nquestions: [{problem: family.yaml}, {problem: good.yaml}, {problem: family.yaml}]\nvariants: {count: 3}\n"
)


@pytest.mark.parametrize(
    ("words", "shown"),
    [(("variants", "family.yaml", "--count", "3"), {"3/3"}), (("exam", "exam.yaml"), {"7/7", "3/3"})],
)
def test_variants_and_exams_show_how_many_are_done_and_the_time_left(tmp_path, words, shown):
    for name, text in {"family": FAMILY, "good": GOOD, "exam": EXAM}.items():
        (tmp_path / f"{name}.yaml").write_text(text, encoding="utf-8")
    seen, _, code = run_at_terminal([*words, "--jobs", "2"], tmp_path)
    assert code == 0
    assert {each for each in shown if each not in seen} == set()
    assert re.search(r"\d:\d\d:\d\d", seen)
