"""A folder solved again: what did not change is neither solved nor written, and told as before."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from solver.executors import Processes
from tests.helpers.small_problems import BAD, GOOD

UNSOLVED = GOOD.replace("a: characteristic_polynomial", "a: {task: pole_placement, poles: [-1, -2]}").replace(
    "[-2, -3]]}", "[-2, -3]], B: [0, 0]}"
)


@pytest.fixture
def course(tmp_path):
    """Problems in a folder: good ones, one that has no solution, one that is at fault."""
    folder = tmp_path / "in"
    folder.mkdir()
    for name, text in {"a": GOOD, "b": GOOD.replace("small", "second"), "u": UNSOLVED, "x": BAD}.items():
        (folder / f"{name}.yaml").write_text(text, encoding="utf-8")
    return folder


@pytest.fixture
def solved(monkeypatch):
    """Note which files are solved."""
    noted, calls = [], Processes.calls

    def noting(self, limits, function, these):
        these = list(these)
        noted.extend(Path(each[0].asked.file).stem for each in these)
        return calls(self, limits, function, these)

    monkeypatch.setattr(Processes, "calls", noting)
    return noted


def state(folder):
    return {path.name: (path.read_bytes(), path.stat().st_mtime_ns) for path in sorted(folder.glob("*.html"))}


def test_only_what_changed_is_solved_and_all_is_told_as_before(solve, course, solved, tmp_path):
    first = solve("in", "-o", "out")
    assert first.code == 2
    assert sorted(solved) == ["a", "b", "u", "x"]
    before = state(tmp_path / "out")
    solved.clear()
    assert solve("in", "-o", "out") == first
    assert solved == ["x"]  # what is at fault is read again
    assert state(tmp_path / "out") == before
    solved.clear()
    (course / "b.yaml").write_text(GOOD.replace("small", "third"), encoding="utf-8")
    (tmp_path / "out" / "u.html").unlink()
    assert solve("in", "-o", "out").code == 2
    assert sorted(solved) == ["b", "u", "x"]
    after = state(tmp_path / "out")
    assert after["a.html"] == before["a.html"]
    assert after["u.html"][0] == before["u.html"][0]
    assert b"third" in after["b.html"][0]


def test_options_count_and_again_makes_all_again(solve, course, solved):
    for name in "ux":
        (course / f"{name}.yaml").unlink()
    solve("in", "-o", "out")
    for words, made in (
        (["--detail", "brief"], ["a", "b"]),
        (["--detail", "brief", "--time-limit", 30], []),
        (["--detail", "brief", "--again"], ["a", "b"]),
        (["--language", "de"], ["a", "b"]),
    ):
        solved.clear()
        assert solve("in", "-o", "out", *words).code == 0
        assert sorted(solved) == made, words


@pytest.mark.parametrize(
    "content",
    [
        "[",
        "{}",
        '{"format": 0, "made": {}}',
        '{"format": 1, "made": {"solved ../in/a.yaml": {"key": 1}}}',
        "\xff" * 9,
        "[" * 9999,
    ],
)
def test_a_record_that_cannot_be_read_is_told_and_not_used(solve, course, content, tmp_path):
    for name in "bux":
        (course / f"{name}.yaml").unlink()
    first = solve("in", "-o", "out")
    (tmp_path / "out" / ".solve.json").write_bytes(content.encode("latin-1"))
    again = solve("in", "-o", "out")
    assert (again.code, again.out) == (first.code, first.out)
    assert "out/.solve.json is not used, and all is made again" in again.err


def test_a_record_leads_to_no_file_outside(solve, course, tmp_path, solved):
    for name in "bux":
        (course / f"{name}.yaml").unlink()
    solve("in", "-o", "out")
    path = tmp_path / "out" / ".solve.json"
    record = json.loads(path.read_text("utf-8"))
    (entry,) = record["made"].values()
    entry["files"] = {"../in/a.yaml": "0" * 64}
    path.write_text(json.dumps(record), encoding="utf-8")
    solved.clear()
    assert solve("in", "-o", "out").code == 0
    assert solved == ["a"]


def test_beside_the_files_nothing_is_kept(solve, course):
    (course / "x.yaml").unlink()
    solve("in")
    assert not list(course.glob(".solve*"))


def test_an_interrupted_run_goes_on_where_it_was(tmp_path, course):
    for number in range(12):
        (course / f"c{number:02}.yaml").write_text(GOOD.replace("small", f"number {number}"), encoding="utf-8")
    environment = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])}

    def command(out):
        return [sys.executable, "-m", "solver", "in", "-o", out, "--jobs", "1"]

    told = {"cwd": tmp_path, "env": environment, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    process = subprocess.Popen(command("out"), **told)
    while process.poll() is None and len(list((tmp_path / "out").glob("*.html"))) < 4:
        time.sleep(0.01)
    process.send_signal(signal.SIGTERM)
    process.communicate()
    early = state(tmp_path / "out")
    resumed = subprocess.run(command("out"), check=False, **told)
    whole = subprocess.run([*command("out"), "--again"], check=False, **told)
    after = state(tmp_path / "out")
    assert (resumed.returncode, resumed.stdout, resumed.stderr) == (whole.returncode, whole.stdout, whole.stderr)
    assert {name: content for name, (content, _) in early.items()}.items() <= {
        name: content for name, (content, _) in after.items()
    }.items()
    assert len(after) == 15
