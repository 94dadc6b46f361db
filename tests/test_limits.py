"""A part that takes too long, too much memory, or the process down costs nothing but itself."""

import resource
import signal
import subprocess
import sys
import time
from dataclasses import fields, is_dataclass
from enum import StrEnum
from pathlib import Path

import pytest

from solver.derivation import Status
from solver.document.model import Presentation
from solver.document.works import document_of
from solver.engine import solve_problem
from solver.limits import Child, Limits, Supervision, in_child, solve_within
from solver.limits.call import Exceeded, call_within
from solver.limits.child import cause_of_death, restrict
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue
from tests.helpers.difficult_task import difficult, problem_text

LIMITS = Limits(seconds=1.0, megabytes=200)
ROOT = Path(__file__).parents[1]

pytestmark = pytest.mark.skipif(
    not sys.platform.startswith("linux"), reason="the task is known to forked children only"
)


@pytest.fixture(autouse=True)
def registered(monkeypatch):
    monkeypatch.setitem(catalogue(), "difficult", difficult)


def solved(*methods, limits=LIMITS, **options):
    problem = read_problem(Source("<test>", problem_text(*methods)), catalogue())
    return solve_problem(problem, in_child(limits, Supervision(**options))).parts


@pytest.mark.parametrize(
    ("method", "reason"),
    [
        ("endless", "time limit of 1 s"),
        ("greedy", "memory limit of 200 MB"),
        ("bottomless", "its expressions are nested too deeply"),
        ("deadly", "its computation was ended by the system (signal SIGSEGV)"),
        ("quitting", "its computation ended unexpectedly"),
        ("buggy", "internal error: KeyError: 'a bug'; please report it"),
        ("unsolvable", "The plant is a constant: it has no pole to move."),
    ],
)
def test_only_the_part_itself_is_unsolved_and_says_why(method, reason):
    before, part, after = solved("easy", method, "easy")
    assert (part.status, str(part.reason)) == (Status.UNSOLVED, reason)
    assert before.status is after.status is Status.VERIFIED
    assert before.answers == after.answers
    assert not part.answers


def test_an_answer_that_is_no_mathematics_stays_in_the_child_and_costs_no_other():
    function, after = solved("unpicklable", "easy")
    assert not function.answers
    assert after.status is Status.VERIFIED


def test_what_is_sent_is_made_of_texts_and_numbers_only(read_example):
    replies = solve_within(read_example("two-methods"), presentation=Presentation(data=True)).replies
    assert len(replies) == 3
    assert {type(each) for _, reply in replies for each in leaves(reply)} <= {str, int, float, bool, type(None)}


def leaves(value):
    """What plain data are made of, down to the texts and numbers; of anything else the thing itself."""
    if isinstance(value, StrEnum):
        yield str(value)
    elif isinstance(value, list | tuple):
        yield from (leaf for each in value for leaf in leaves(each))
    elif isinstance(value, dict):
        yield from (leaf for entry in value.items() for each in entry for leaf in leaves(each))
    elif is_dataclass(value) and type(value).__module__.startswith("solver."):
        yield from (leaf for each in fields(value) for leaf in leaves(getattr(value, each.name)))
    else:
        yield value


@pytest.mark.parametrize("presentation", [Presentation("key"), Presentation("tutor", sources=False)])
def test_a_solution_is_told_as_it_was_asked_for(read_example, presentation):
    problem = read_example("two-methods")
    within, here = solve_within(problem, presentation=presentation), document_of(solve_problem(problem), presentation)
    assert within.document("a.yaml").presentation == presentation
    assert within.document().markdown() == here.markdown()


def test_what_was_not_worded_in_the_child_is_told_without_its_steps(read_example):
    problem = read_example("two-methods")
    without, whole = solve_within(problem).document(), document_of(solve_problem(problem))
    assert without.presentation == Presentation()
    assert [part.answers for part in without.parts] == [part.answers for part in whole.parts]
    assert not any(part.steps for part in without.parts)


def test_a_part_that_cannot_be_worded_is_lost_and_no_other():
    problem = read_problem(Source("<test>", problem_text("easy", "speechless", "easy")), catalogue())
    within, here = solve_within(problem, LIMITS, Presentation()).document(), document_of(solve_problem(problem))
    for document in (within, here):
        before, part, after = document.parts
        assert before.status is after.status is Status.VERIFIED
        assert (part.status, part.answers, part.steps) == (Status.UNSOLVED, (), ())
        assert "cannot be worded: the macro" in part.reason
        assert "Do it." in document.html()


def test_a_formula_that_cannot_be_drawn_loses_its_part_only():
    text = "system: {matrix: [[1, 1], [0, 1]]}\nfind:\n  a: {task: matrix_function, function: abs(A)}\n  b: stability\n"
    document = document_of(solve_problem(read_problem(Source("<test>", text), catalogue())))
    assert [part.status for part in document.parts] == [Status.UNSOLVED, Status.VERIFIED]
    assert "asymptotically stable" in document.markdown()


def test_an_answer_whose_algebra_refers_to_functions_within_functions_is_sent():
    text = "system: {A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0]}\n"
    text += 'find:\n  a: {task: response, kind: zero_state, input: "sin(2t + pi/4)"}\n'
    problem = read_problem(Source("<test>", text), catalogue())
    (part,) = solve_problem(problem, in_child()).parts
    assert (part.status, part.answers) == (Status.VERIFIED, solve_problem(problem).parts[0].answers)


def test_a_question_that_is_wrong_is_refused_at_its_place_before_anything_is_solved():
    text = problem_text("endless") + "  b: {task: difficult, system: {matrix: [[-1]]}, prompt: Do it.}\n"
    with pytest.raises(InputError) as caught:
        solve_problem(read_problem(Source("file.yaml", text), catalogue()), in_child(LIMITS))
    assert caught.value.render().startswith("file.yaml:5:13: error: it begins with -1\n")
    assert "^^^^^^^^^" in caught.value.render()


def test_judging_a_question_is_stopped_by_the_limit_and_costs_its_methods_only():
    text = problem_text("easy").replace("method: easy", "method: [easy, endless], system: {matrix: [[-2]]}")
    text += "  b: {task: difficult, method: easy, prompt: Do it.}\n"
    first, second, after = solve_problem(
        read_problem(Source("<test>", text), catalogue()), in_child(Limits(seconds=0.5))
    ).parts
    assert str(first.reason) == str(second.reason) == "time limit of 0.5 s"
    assert [part.method for part in (first, second)] == ["easy", "endless"]
    assert after.status is Status.VERIFIED


def test_one_stuck_method_of_a_part_does_not_lose_the_others():
    text = problem_text("easy").replace("method: easy", "method: [endless, easy]")
    problem = read_problem(Source("<test>", text), catalogue())
    stuck, easy = solve_problem(problem, in_child(Limits(seconds=0.5))).parts
    assert (stuck.id, stuck.method, stuck.status) == ("a", "endless", Status.UNSOLVED)
    assert (easy.id, easy.method, easy.status) == ("a", "easy", Status.VERIFIED)


def test_each_part_has_the_whole_time_and_a_new_child_each_time():
    parts = solved("endless", "endless", "easy", limits=Limits(seconds=0.4))
    assert [part.status for part in parts] == [Status.UNSOLVED, Status.UNSOLVED, Status.VERIFIED]
    assert all(0.4 <= part.seconds < 5 for part in parts[:2])


@pytest.mark.parametrize(
    ("methods", "children"),
    [
        (("easy", "buggy", "unsolvable", "wrong", "easy"), 1),
        (("easy", "endless", "easy"), 2),
        (("deadly", "easy", "greedy", "easy"), 3),
    ],
)
def test_a_child_goes_on_as_long_as_it_can(monkeypatch, methods, children):
    started = []

    def start():
        started.append(Child())
        return started[-1]

    monkeypatch.setattr("solver.limits.supervisor.Child", start)
    solved(*methods)
    assert len(started) == children
    assert all(child.channel.closed for child in started)


def test_a_child_that_is_not_ended_does_not_outlive_its_parent():
    program = "from solver.limits import Child; child = Child(); print(child.process.pid)"
    done = subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, check=True, timeout=60)
    assert not Path(f"/proc/{int(done.stdout)}").exists()


@pytest.mark.parametrize("code", [None, 0, 1, 3])
def test_an_end_without_a_signal_is_unexpected(code):
    assert cause_of_death(code) == "its computation ended unexpectedly"


def test_the_signal_that_ended_a_child_is_named():
    assert cause_of_death(-signal.SIGKILL) == "its computation was ended by the system (signal SIGKILL)"
    assert "(signal SIGHUP)" in cause_of_death(-1)


def test_a_wrong_answer_is_failed_and_not_mistaken_for_unsolved():
    (part,) = solved("wrong")
    assert part.status is Status.FAILED


def test_progress_is_told_while_a_part_is_being_solved():
    seen = []
    solved("easy", "endless", limits=Limits(seconds=0.5), notify=seen.append)
    assert {(each.part, each.method, each.index, each.total) for each in seen} >= {("b", "endless", 1, 2)}


def test_progress_is_told_while_a_question_is_being_judged():
    seen = []
    text = problem_text("easy").replace("method: easy", "method: [easy, wrong], system: {matrix: [[-2]]}")
    problem = read_problem(Source("<test>", text), catalogue())
    solve_within(problem, Limits(seconds=0.3), supervision=Supervision(seen.append))
    assert {(each.part, each.method, each.index, each.total) for each in seen} == {("a", "", 0, 2)}


def test_what_is_done_meanwhile_is_done_once():
    calls = []
    solved("easy", "easy", meanwhile=lambda: calls.append(1))
    assert calls == [1]


def test_results_through_a_child_are_those_without_one(read_example):
    problem = read_example("two-methods")
    plain, through = solve_problem(problem, arithmetic=False), solve_problem(problem, in_child())
    assert [(part.id, part.method, part.status, part.answers) for part in plain.parts] == [
        (part.id, part.method, part.status, part.answers) for part in through.parts
    ]
    assert [[check.claim for check in part.checks] for part in plain.parts] == [
        [check.claim for check in part.checks] for part in through.parts
    ]


def test_answers_of_earlier_parts_reach_a_new_child():
    text = problem_text("easy", "deadly", "easy")
    text += "  d: {task: characteristic_polynomial, gain: {from: a, answer: F}}\n"
    text = text.replace("system: {A: [[1, 2], [3, 4]]}", "system: {A: [[1, 2], [3, 4]], B: [[1, 0], [0, 1]]}")
    parts = solve_problem(read_problem(Source("<test>", text), catalogue()), in_child(LIMITS)).parts
    assert parts[1].status is Status.UNSOLVED
    assert (parts[3].status, str(parts[3].answers["polynomial"])) == (Status.VERIFIED, "lamda**2")


@pytest.fixture
def read_example():
    from solver.problem.files import load  # noqa: PLC0415 - only here
    from solver.resources import root  # noqa: PLC0415

    return lambda name: read_problem(load(root("problems") / "examples" / f"{name}.yaml"), catalogue())


@pytest.mark.slow
def test_a_spawned_child_gives_the_same_results(read_example, monkeypatch):
    monkeypatch.setattr("solver.limits.child.FORKS", False)
    problem = read_example("two-methods")
    parts = solve_problem(problem, in_child()).parts
    assert [part.status for part in parts] == [Status.VERIFIED] * len(parts)
    assert [part.answers for part in parts] == [part.answers for part in solve_problem(problem).parts]


def deep(size):
    found = []
    for _ in range(size):
        found = [found]
    return found


def fails(error):
    raise error


@pytest.mark.parametrize(
    ("function", "argument", "seconds", "reason"),
    [
        (fails, MemoryError(), 20, "memory limit of 2000 MB"),
        (fails, RecursionError(), 20, "nested too deeply"),
        (fails, ValueError("a fault"), 20, "a fault"),
        (deep, 100_000, 20, "nested too deeply"),
        (time.sleep, 30, 0.25, "time limit of 0.25 s"),
    ],
)
def test_a_call_that_does_not_return_says_why(function, argument, seconds, reason):
    with pytest.raises(Exceeded) as ended:
        call_within(Limits(seconds, 2000), function, argument)
    assert reason in str(ended.value.reason)


def test_a_call_returns_what_the_function_does():
    assert call_within(Limits(20, 2000), divmod, 17, 5) == (3, 2)


def limits_here(limits, units):
    """Bytes of memory and seconds of time that this process may take from now on, once it has limits."""
    status = Path("/proc/self/status").read_text(encoding="ascii")
    taken = int(status.partition("VmSize:")[2].split()[0]) * 1024
    restrict(limits, units)
    return resource.getrlimit(resource.RLIMIT_AS)[0] - taken, resource.getrlimit(resource.RLIMIT_CPU)[0]


@pytest.mark.parametrize("units", [1, 3])
def test_memory_is_what_is_allowed_beyond_what_is_loaded_and_time_twice_that_of_all_units(units):
    memory, seconds = call_within(Limits(60, 4000), limits_here, Limits(20, 500), units)
    assert abs(memory - 500 * 2**20) < 20 * 2**20
    assert 2 * 20 * units < seconds < 2 * 20 * units + 20


def test_a_call_has_the_limits_of_one_unit():
    assert 40 < call_within(Limits(20, 2000), resource.getrlimit, resource.RLIMIT_CPU)[0] < 60


def test_the_default_limits_are_those_of_the_guide():
    guide = (ROOT / "docs" / "user-guide.md").read_text(encoding="utf-8")
    assert f"{Limits().seconds:g} s and {Limits().megabytes} MB by default" in guide
