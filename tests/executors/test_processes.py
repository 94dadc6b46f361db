"""Calls by processes: shared by a few that go on, each ended alone, and none left behind."""

import os
import signal
import subprocess
import sys
from multiprocessing import active_children
from pathlib import Path

import pytest

from solver.executors import Processes
from solver.executors.starting import start_method
from solver.limits import Exceeded, Limits
from tests.helpers.calls import (
    deep,
    die,
    fail,
    greedy,
    hears_interrupts,
    modules,
    process_after,
    start_child,
    wait_until,
)

ROOT = Path(__file__).parents[2]

pytestmark = pytest.mark.skipif(not hasattr(os, "killpg"), reason="signals and groups of processes are those of POSIX")


@pytest.fixture(scope="module")
def two():
    with Processes(2) as executor:
        yield executor


def is_running(pid):
    """Whether there is such a process, and not only what is left of it."""
    try:
        return "\nState:\tZ" not in Path(f"/proc/{pid}/status").read_text(encoding="ascii")
    except OSError:
        return False


def test_workers_are_forked_from_a_server_where_that_is_safe():
    assert start_method() == ("forkserver" if sys.platform.startswith("linux") else "spawn")


def test_many_calls_are_shared_by_a_few_processes_that_stay(two):
    found = dict(two.calls(Limits(20), process_after, [(0.05,)] * 8))
    assert sorted(found) == list(range(8))
    again = dict(two.calls(Limits(20), process_after, [(0.05,)] * 4))
    assert len({*found.values(), *again.values()}) == 2
    assert os.getpid() not in found.values()


def test_results_come_in_order_where_that_is_wanted(two):
    calls = ((0.4 if place == 0 else 0, place) for place in range(5))
    assert list(two.in_order(Limits(20), max, ((place, seconds) for seconds, place in calls))) == [0.4, 1, 2, 3, 4]


def test_calls_are_taken_as_they_are_made(two):
    taken = []

    def calls():
        for place in range(6):
            taken.append(place)
            yield (place, place)

    found = two.calls(Limits(20), divmod, ((a + 1, b + 1) for a, b in calls()))
    next(found)
    assert len(taken) <= 4
    assert len(list(found)) == 5


@pytest.mark.parametrize(
    ("function", "argument", "reason"),
    [
        (process_after, -1, "time limit of 1 s"),
        (greedy, 400, "memory limit of 200 MB"),
        (fail, "a fault", "internal error: ValueError: a fault; please report it"),
        (deep, 100_000, "its result is nested too deeply"),
        (die, signal.SIGKILL, "its computation was ended by the system (signal SIGKILL)"),
        (die, signal.SIGSEGV, "its computation was ended by the system (signal SIGSEGV)"),
        (os._exit, 3, "its computation ended unexpectedly"),
    ],
)
def test_a_call_that_meets_a_limit_costs_only_itself(two, function, argument, reason):
    limits = Limits(1.0, 200)
    (place, ended), *_ = two.calls(limits, function, [(argument,)])
    assert (place, type(ended), str(ended.reason)) == (0, Exceeded, reason)
    assert list(two.in_order(limits, divmod, [(9, 2)] * 3)) == [(4, 1)] * 3


def test_among_others_it_is_the_only_one_that_is_lost(two):
    found = list(two.in_order(Limits(1.0), process_after, [(0,), (-1,), (0,), (0.2,), (0,)]))
    assert [type(each) for each in found] == [int, Exceeded, int, int, int]


def test_a_process_killed_from_outside_costs_the_call_it_was_at(two):
    calls = two.calls(Limits(60), process_after, [(0,), (30,), (0,)])
    _, pid = next(calls)
    busy = next(worker for worker in _workers_of(pid) if worker != pid)
    os.kill(busy, signal.SIGKILL)
    found = dict(calls)
    assert "signal SIGKILL" in str(found[1].reason)
    assert isinstance(found[2], int)


def _workers_of(pid):
    """The processes that have the same parent."""
    of = int(Path(f"/proc/{pid}/stat").read_text(encoding="ascii").split()[3])
    return [int(each) for each in Path(f"/proc/{of}/task/{of}/children").read_text(encoding="ascii").split()]


def test_time_is_counted_from_when_a_process_is_ready():
    with Processes(1) as executor:
        assert list(executor.in_order(Limits(0.2), divmod, [(7, 2)])) == [(3, 1)]


def test_the_algebra_is_loaded_and_nothing_of_the_caller(two):
    ((loaded, main, path),) = two.in_order(Limits(20), modules, [()])
    assert {"solver.exact.optimal.riccati", "scipy.linalg"} & set(loaded)
    assert "pytest" not in loaded
    assert main is None
    assert set(filter(None, sys.path)) <= set(path)


def test_an_interrupt_is_heard_by_the_parent_only(two):
    assert list(two.in_order(Limits(20), hears_interrupts, [()])) == [False]


def test_what_is_abandoned_is_ended():
    before = set(active_children())
    executor = Processes(2)
    calls = executor.calls(Limits(60), process_after, [(0,), (-1,), (-1,)])
    next(calls)
    workers = set(active_children()) - before
    assert len(workers) == 2
    calls.close()
    executor.close()
    assert not any(is_running(each.pid) for each in workers)


def test_a_worker_is_renewed_before_it_remembers_too_much(monkeypatch):
    monkeypatch.setattr("solver.executors.processes.RENEWED", 3)
    with Processes(1) as executor:
        found = list(executor.in_order(Limits(20), process_after, [(0,)] * 7))
    assert [found.count(pid) for pid in dict.fromkeys(found)] == [3, 3, 1]


def test_what_a_stuck_call_has_started_is_ended_with_it(two, tmp_path):
    list(two.calls(Limits(1.5), start_child, [(str(tmp_path / "pid"),)]))
    assert wait_until(lambda: not is_running(int((tmp_path / "pid").read_text(encoding="ascii"))))


STUCK = """
import sys
from solver.executors import Processes
from solver.limits import Limits
from tests.helpers.calls import process_after

with Processes(2) as executor:
    for _, pid in executor.calls(Limits(60), process_after, [(0,), (0,), (-1,), (-1,)]):
        print(pid, flush=True)
"""


@pytest.mark.parametrize(("number", "code"), [(signal.SIGINT, -signal.SIGINT), (signal.SIGKILL, -signal.SIGKILL)])
def test_no_process_is_left_when_the_parent_is_ended(number, code):
    """However it is ended: by Ctrl-C, which the whole group hears, or without a chance to do anything."""
    process = subprocess.Popen([sys.executable, "-c", STUCK], cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               start_new_session=True)  # fmt: skip
    pids = [int(process.stdout.readline()) for _ in range(2)]
    server = int(Path(f"/proc/{pids[0]}/stat").read_text(encoding="ascii").split()[3])
    (os.killpg if number == signal.SIGINT else os.kill)(process.pid, number)
    assert process.wait(20) == code
    assert wait_until(lambda: not any(map(is_running, [*pids, server])))
    told = process.stderr.read().decode()
    assert told.count("Traceback") == (1 if number == signal.SIGINT else 0), told  # the parent's own


FAMILY = """\\
parameters: {a: 1}
vary: {a: {from: 1, to: 9}}
system: {A: [[0, 1], [-a, -2]]}
find: {a: characteristic_polynomial}
"""
SCRIPT = f'''\
import solver
print("here")
found = solver.variants("""{FAMILY}""", count=2, seed=3, jobs=2)
print(len(found), found[0].solve().status)
'''


SLOW = [pytest.param(way, marks=pytest.mark.slow) for way in ("-c", "module")]


@pytest.mark.parametrize("way", ["script", "-", *SLOW])
def test_a_script_that_does_not_guard_its_main_is_not_run_again(tmp_path, way):
    (tmp_path / "lesson.py").write_text(SCRIPT, encoding="utf-8")
    (tmp_path / "random.py").write_text("raise SystemExit('the file of the folder was imported')", encoding="utf-8")
    words = {"script": ["lesson.py"], "-": ["-"], "-c": ["-c", SCRIPT], "module": ["-m", "lesson"]}[way]
    if way != "script":  # Python itself puts the folder first
        (tmp_path / "random.py").unlink()
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    if way == "script":
        (tmp_path / "own").mkdir()
        (tmp_path / "lesson.py").rename(tmp_path / "own" / "lesson.py")
        words = ["own/lesson.py"]
    done = subprocess.run([sys.executable, *words], cwd=tmp_path, input=SCRIPT, capture_output=True, text=True,
                          env=environment, timeout=120, check=False)  # fmt: skip
    assert (done.stdout, done.stderr, done.returncode) == ("here\n2 verified\n", "", 0)
