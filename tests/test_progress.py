"""What is told of progress: to a function, in a notebook, on a terminal, and nowhere else."""

import io
import sys
from contextlib import contextmanager
from types import ModuleType, SimpleNamespace

import pytest

import solver
from solver import progress

PROBLEM = {"system": {"A": [[0, 1], [-2, -3]]}, "find": {"a": "stability", "b.1": "eigenstructure"}}


class Handle:
    """A display of IPython as far as it is used: notes what it shows."""

    def __init__(self, notes, bundle):
        self.notes = notes
        notes.append(("new", bundle))

    def update(self, bundle, *, raw):
        assert raw
        self.notes.append(("same", bundle))


@pytest.fixture
def notebook(monkeypatch):
    """An IPython that works for a notebook; yields what it shows, and lets a test begin another cell."""
    notes, cells = [], ["first"]
    shell = SimpleNamespace(kernel=object(), get_parent=lambda: {"header": {"msg_id": cells[-1]}})
    package, module = ModuleType("IPython"), ModuleType("IPython.display")
    package.get_ipython = lambda: shell
    module.display = lambda bundle, *, raw, display_id: Handle(notes, bundle) if raw and display_id else None
    monkeypatch.setitem(sys.modules, "IPython", package)
    monkeypatch.setitem(sys.modules, "IPython.display", module)
    monkeypatch.setattr(progress._Display, "latest", ("", None))
    return SimpleNamespace(notes=notes, cells=cells, shell=shell)


@pytest.mark.parametrize("limits", [{}, {"seconds": 60}])
def test_a_function_is_told_of_each_part(limits):
    told = []
    solution = solver.solve(PROBLEM, progress=lambda *each: told.append(each), **limits)
    assert solution.status == "verified"
    if limits:  # ten times a second, so maybe never
        assert all(0 <= done < total == 2 and doing.startswith("part ") for done, total, doing in told)
    else:
        assert told == [(0, 2, "part a"), (1, 2, "part b.1"), (2, 2, "writing")]


def test_marking_is_told_too():
    told = []
    solver.check(PROBLEM, {"a": {"verdict": "stable"}}, progress=lambda *each: told.append(each))
    assert told == [(0, 2, "part a"), (1, 2, "part b.1"), (2, 2, "writing")]


def test_a_notebook_shows_it_in_one_place_and_leaves_nothing(notebook):
    for _ in range(2):
        solver.solve(PROBLEM)
    assert [how for how, _ in notebook.notes].count("new") == 1
    assert [each["text/plain"] for _, each in notebook.notes] == [
        "part a: 0 of 2 done", "part b.1: 1 of 2 done", "writing: 2 of 2 done", "",
    ] * 2  # fmt: skip
    assert '<progress value="1" max="2" aria-label="part b.1">' in notebook.notes[1][1]["text/html"]
    assert notebook.notes[-1][1] == {"text/plain": "", "text/html": ""}
    notebook.cells.append("second")
    solver.solve(PROBLEM)
    assert [how for how, _ in notebook.notes].count("new") == 2


def test_what_is_shown_goes_away_where_it_ends_badly(notebook):
    def fail():
        with progress.shown() as tell:
            tell(0, 1, "<a>")
            raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        fail()
    assert 'aria-label="&lt;a&gt;"' in notebook.notes[0][1]["text/html"]
    assert notebook.notes[-1][1]["text/html"] == ""


def test_a_browser_is_not_told_of_the_same_ten_times_at_once(notebook):
    with progress.shown() as tell:
        for number in range(10):
            tell(0, 1, f"{number} draws")
    assert len(notebook.notes) == 2


@pytest.mark.parametrize(("asked", "shell"), [(False, "kernel"), (None, "a terminal"), (None, "none")])
def test_elsewhere_nothing_is_shown(notebook, monkeypatch, capsys, asked, shell):
    if shell == "a terminal":
        del notebook.shell.kernel
    if shell == "none":
        monkeypatch.delitem(sys.modules, "IPython")
    solver.solve(PROBLEM, progress=asked)
    assert not notebook.notes
    assert capsys.readouterr() == ("", "")


def test_a_terminal_shows_a_bar_when_asked(monkeypatch, capsys):
    monkeypatch.delitem(sys.modules, "IPython", raising=False)
    solver.solve(PROBLEM, progress=True)
    assert capsys.readouterr() == ("", "")
    stream = io.StringIO()
    stream.isatty = lambda: True
    monkeypatch.setattr(sys, "stderr", stream)
    solver.solve(PROBLEM)
    assert not stream.getvalue()
    solver.solve(PROBLEM, progress=True)
    assert "2/2" in stream.getvalue()


@contextmanager
def kernel():
    """A real kernel of IPython."""
    manager = pytest.importorskip("jupyter_client.manager")
    pytest.importorskip("ipykernel")
    running, client = manager.start_new_kernel(kernel_name="python3")
    try:
        yield client
    finally:
        client.stop_channels()
        running.shutdown_kernel(now=True)


@pytest.mark.slow
def test_a_real_notebook_shows_progress_and_then_the_page():
    seen = []
    code = f"import solver\nsolver.solve({PROBLEM!r})"
    with kernel() as client:
        done = client.execute_interactive(code, timeout=120, output_hook=seen.append)
    assert done["content"]["status"] == "ok"
    shown = [(each["msg_type"], each["content"]["data"]) for each in seen if "data" in each["content"]]
    assert [(kind, data["text/plain"]) for kind, data in shown] == [
        ("display_data", "part a: 0 of 2 done"),
        ("update_display_data", "part b.1: 1 of 2 done"),
        ("update_display_data", "writing: 2 of 2 done"),
        ("update_display_data", ""),
        ("execute_result", "<worked solution of 'Problem': verified>"),
    ]
    assert shown[-1][1]["text/html"].startswith("<iframe ")
    assert not [each for each in seen if each["msg_type"] == "stream"]
