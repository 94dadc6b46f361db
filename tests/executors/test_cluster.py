"""Calls by a real Dask cluster of two worker processes: what is found is the same, also when one of them is lost."""

import os
import signal
import subprocess
import sys
from contextlib import suppress
from pathlib import Path

import pytest

from solver.executors import Unavailable, cluster
from solver.executors.cluster import Cluster
from solver.limits import Exceeded, Limits
from tests.helpers.calls import die, fail, greedy, process_after, wait_until
from tests.helpers.small_problems import GOOD

pytest.importorskip("distributed")

pytestmark = [pytest.mark.slow, pytest.mark.skipif(not sys.platform.startswith("linux"), reason="tried on Linux")]


@pytest.fixture(scope="module")
def two():
    with Cluster(None, 2) as executor:
        yield executor


@pytest.fixture(scope="module")
def address(two):
    return two.client.cluster.scheduler_address


def test_calls_are_shared_by_the_workers_and_keep_their_limits(two):
    assert two.jobs == 2
    assert list(two.in_order(Limits(20), divmod, ((n, 3) for n in range(9)))) == [divmod(n, 3) for n in range(9)]
    first, stuck, last = two.in_order(Limits(1.0), process_after, [(0,), (-1,), (0,)])
    assert (type(first), type(last)) == (int, int)
    assert str(stuck.reason) == "time limit of 1 s"


@pytest.mark.parametrize(
    ("function", "argument", "reason"),
    [
        (greedy, 400, "memory limit of 200 MB"),
        (die, signal.SIGKILL, "its computation was ended by the system (signal SIGKILL)"),
        (fail, "a fault", "internal error: ValueError: a fault; please report it"),
    ],
)
def test_a_call_that_fails_says_why_and_costs_no_worker(two, function, argument, reason):
    before = set(two.client.run(os.getpid).values())
    (ended,) = two.in_order(Limits(20, 200), function, [(argument,)])
    assert (type(ended), str(ended.reason)) == (Exceeded, reason)
    assert set(two.client.run(os.getpid).values()) == before


def test_a_call_whose_worker_is_lost_is_made_by_another_one(two):
    calls = two.calls(Limits(60), process_after, [(0,), (2,), (2,), (2,), (0,)])
    next(calls)
    os.kill(next(iter(two.client.run(os.getpid).values())), signal.SIGKILL)
    found = dict(calls)
    assert len(found) == 4
    assert {type(each) for each in found.values()} == {int}


def test_files_are_solved_and_told_as_by_processes(solve, address, tmp_path):
    for name, text in {"one": GOOD, "two": GOOD.replace("-3", "-5"), "bad": GOOD.replace("find", "fnd")}.items():
        (tmp_path / f"{name}.yaml").write_text(text, encoding="utf-8")
    words = ("one.yaml", "bad.yaml", "two.yaml", "-f", "html,json", "-o", "out/", "--again")
    found = []
    for engine in (("--jobs", 1), ("--engine", "dask", "--scheduler", address)):
        done = solve(*words, *engine)
        found.append((done, {path.name: path.read_bytes() for path in (tmp_path / "out").iterdir()}))
    assert found[0] == found[1]
    assert found[0][0].code == 2


def test_variants_are_the_same(solve, address, tmp_path):
    text = "parameters: {a: 2}\nvary: {a: {from: 1, to: 9}}\n" + GOOD.replace("-3", "-a")
    (tmp_path / "family.yaml").write_text(text, encoding="utf-8")
    found = []
    for place, engine in enumerate((("--jobs", 2), ("--engine", "dask", "--scheduler", address))):
        done = solve("variants", "family.yaml", "--count", 3, "-f", "yaml,html", "-o", f"out-{place}", *engine)
        assert done.code == 0, done.err
        written = sorted((tmp_path / f"out-{place}").glob("*.*"))
        files = {path.name: path.read_bytes() for path in written if path.is_file()}
        found.append((done.out.replace(f"out-{place}", "out"), files))
    assert found[0] == found[1]


def test_a_scheduler_that_does_not_answer_is_told(solve, monkeypatch, tmp_path):
    monkeypatch.setattr(cluster, "PATIENCE", 1)
    (tmp_path / "one.yaml").write_text(GOOD, encoding="utf-8")
    done = solve("one.yaml", "one.yaml", "./two.yaml", "--engine", "dask", "--scheduler", "tcp://127.0.0.1:9")
    assert done.code == 2
    assert "tcp://127.0.0.1:9 does not answer" in done.err


def test_workers_with_another_version_are_refused(address, monkeypatch):
    monkeypatch.setattr(cluster, "__version__", "99")
    with pytest.raises(Unavailable, match=r"has version .* of the program, not 99"):
        Cluster(address).begin()


def test_without_dask_the_way_to_it_is_told(solve, monkeypatch, tmp_path):
    monkeypatch.setitem(sys.modules, "distributed", None)
    for name in ("one", "two"):
        (tmp_path / f"{name}.yaml").write_text(GOOD, encoding="utf-8")
    done = solve("one.yaml", "two.yaml", "--engine", "dask")
    assert done.code == 2
    assert "pip install 'solve-control[dask]'" in done.err


INTERRUPTED = """
import signal
import sys
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell that runs tests in the background has it ignored
from solver.cli import main
sys.exit(main(sys.argv[1:]))
"""


def processes_of(session):
    """The processes of a session that run."""
    found = []
    for path in Path("/proc").glob("[0-9]*/stat"):
        with suppress(OSError):
            _, _, fields = path.read_text(encoding="ascii", errors="replace").rpartition(")")
            state, _, _, its, *_ = fields.split()
            found += [path.parent.name] if int(its) == session and state != "Z" else []
    return found


@pytest.mark.parametrize("ready", [False, True])
def test_an_interrupt_ends_all_quietly(tmp_path, ready):
    """While the cluster starts, and while it works."""
    files = [f"{number}.yaml" for number in range(40)]
    for number, file in enumerate(files, 3):
        (tmp_path / file).write_text(GOOD.replace("-3", f"-{number}"), encoding="utf-8")
    env = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])}
    command = [sys.executable, "-c", INTERRUPTED, *files, "-o", "out/", "--engine", "dask", "--jobs", "2"]
    with subprocess.Popen(command, cwd=tmp_path, env=env, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          start_new_session=True) as process:  # fmt: skip
        if ready:
            process.stdout.readline()
        else:
            wait_until(lambda: len(processes_of(process.pid)) > 2)
        os.killpg(process.pid, signal.SIGINT)
        _, errors = process.communicate(timeout=60)
    assert (process.returncode, errors.decode().strip()) == (130, "interrupted")
    assert wait_until(lambda: not processes_of(process.pid))
