"""Where solutions go: what -o and -f mean for one problem and for several, what is never overwritten, whole files."""

import io
import os
import sys
from pathlib import Path

import click
import pytest

from solver.cli.destination import Destination, write_whole
from solver.cli.group import looks_like_file
from solver.cli.progress import Meter
from solver.limits import Progress


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "out").mkdir()
    return tmp_path


@pytest.mark.parametrize(
    ("output", "formats", "problems", "written"),
    [
        (None, None, ("a.yaml",), {"a.html"}),
        (None, None, ("sub/a.YML",), {"sub/a.html"}),
        (None, ("html", "latex"), ("a.yaml", "b.txt"), {"a.html", "a.tex", "b.txt.html", "b.txt.tex"}),
        (None, None, ("-",), {"solution.html"}),
        ("out", None, ("a.yaml",), {"out/a.html"}),
        ("new/", ("json",), ("a.yaml",), {"new/a.json"}),
        ("new", None, ("a.yaml", "b.yaml"), {"new/a.html", "new/b.html"}),
        ("out", None, ("x/a.yaml", "y/a.yaml", "y/b.yaml"), {"out/x-a.html", "out/y-a.html", "out/b.html"}),
        ("out", None, ("x/a.yaml", "y/A.yaml"), {"out/x-a.html", "out/y-A.html"}),
        ("out", None, ("1/x/a.yaml", "2/x/a.yaml"), {"out/1-x-a.html", "out/2-x-a.html"}),
        ("out", None, ("x/a.yaml", "x/a.yml"), {"out/a.html", "out/a-2.html"}),
        ("new", ("html", "json"), ("a.yaml",), {"new/a.html", "new/a.json"}),
        ("new", None, ("a.yaml",), {"new"}),
        ("x.tex", None, ("a.yaml",), {"x.tex"}),
        ("x.TEX", ("json",), ("a.yaml",), {"x.TEX"}),
        ("-", ("json",), ("a.yaml",), set()),
        ("-", None, ("-",), set()),
    ],
)
def test_the_files_that_are_written(output, formats, problems, written):
    destination = Destination.named(output, formats, problems)
    found = [path.as_posix() for problem in problems for path in destination.paths(problem).values()]
    assert sorted(found) == sorted(written)
    assert destination.standard_output == (output == "-")


@pytest.mark.parametrize(
    ("output", "formats", "problems", "message"),
    [
        ("-", ("html", "json"), ("a.yaml",), "one problem in one format"),
        ("key.pdf", ("pdf", "html"), ("a.yaml",), "name a folder, key/, or pdf alone with -f pdf"),
        (
            "key.PDF",
            ("json", "html"),
            ("a.yaml", "b.yaml"),
            "key.PDF is one file, and several .*: name a folder, key/.$",
        ),
        ("-", None, ("a.yaml", "b.yaml"), "one problem in one format"),
        ("a.yaml", ("html",), ("a.yaml",), "a.yaml is a problem file"),
        ("b.yaml", ("html",), ("b.yaml",), "b.yaml is a problem file"),
        (None, None, ("x/a.yaml", "x/a.yml"), "the solution of x/a.yaml and the solution of x/a.yml would both"),
    ],
)
def test_what_does_not_fit_together_is_refused(output, formats, problems, message):
    with pytest.raises(click.UsageError, match=message):
        Destination.named(output, formats, problems)


def test_a_folder_may_be_called_like_a_file_where_it_is_there_or_said_to_be_one(folder):
    (folder / "old.pdf").mkdir()
    for name in ("old.pdf", "new.pdf/"):
        assert Destination.named(name, ("pdf", "html"), ("a.yaml",)).folder == Path(name)


def test_a_file_that_is_named_without_its_ending_is_suggested(solve, folder):
    (folder / "placement.yaml").write_text("", encoding="utf-8")
    done = solve("placement", "-f", "html")
    assert done.code == 2
    assert "No such command 'placement'. Did you mean placement.yaml?" in done.err


def test_the_same_problem_twice_is_written_once_over():
    assert Destination.named("out", None, ("a.yaml", "a.yaml")).folder == Path("out")


def test_a_pdf_does_not_go_to_a_terminal(monkeypatch):
    monkeypatch.setattr("sys.stdout.isatty", lambda: False)
    assert Destination.named("-", ("pdf",), ("a.yaml",)).standard_output
    monkeypatch.setattr("sys.stdout.isatty", lambda: True)
    assert Destination.named("-", ("html",), ("a.yaml",)).standard_output
    with pytest.raises(click.UsageError, match="not for a terminal"):
        Destination.named("-", ("pdf",), ("a.yaml",))


def test_a_file_keeps_its_mode_a_new_one_has_the_usual_and_a_link_stays_one(folder):
    write_whole(folder / "made" / "deep" / "new", b"1")
    usual = folder / "usual"
    usual.touch()
    assert (folder / "made" / "deep" / "new").stat().st_mode == usual.stat().st_mode
    usual.chmod(0o640)
    (folder / "link").symlink_to(usual)
    write_whole(folder / "link", b"2")
    assert (folder / "link").is_symlink()
    assert (usual.read_bytes(), usual.stat().st_mode & 0o777) == (b"2", 0o640)
    assert sorted(each.name for each in folder.iterdir()) == ["link", "made", "out", "usual"]


def test_what_cannot_be_written_leaves_nothing_and_says_why(folder, monkeypatch):
    (folder / "kept").write_bytes(b"old")

    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "replace", full)
    with pytest.raises(click.ClickException, match=r"cannot write .*kept: No space left on device; say with -o"):
        write_whole(folder / "kept", b"new")
    assert [each.name for each in folder.iterdir() if each.is_file()] == ["kept"]
    assert (folder / "kept").read_bytes() == b"old"


def test_what_is_no_regular_file_is_written_to(folder):
    os.mkfifo(folder / "pipe")
    reader = os.open(folder / "pipe", os.O_RDONLY | os.O_NONBLOCK)
    write_whole(folder / "pipe", b"through")
    assert os.read(reader, 100) == b"through"
    os.close(reader)


@pytest.mark.parametrize(
    ("word", "is_file"),
    [("-", True), ("a.yaml", True), ("A.YML", True), ("a/b", True), ("a\\b", True), ("out", True), ("tasks", False)],
)
def test_which_words_mean_a_file(word, is_file):
    assert looks_like_file(word) is is_file


@pytest.mark.parametrize(
    ("files", "shown", "share"), [(1, "part a by modal", 1.5), (3, "x.yaml (2 of 3), part a by modal", 1.5)]
)
def test_a_terminal_is_shown_how_far_it_is(monkeypatch, files, shown, share):
    stream, told = io.StringIO(), []
    monkeypatch.setattr(sys, "stderr", stream)
    meter = Meter(files)
    with meter.file("x.yaml") as notify:
        assert notify is None
    stream.isatty = lambda: True
    monkeypatch.setattr("rich.progress.Progress.update", lambda *_, **values: told.append(values))
    meter.next_file()
    with meter.file("x.yaml") as notify:
        notify(Progress("a", "modal", 1, 2))
    assert told == [{"description": shown, "completed": share}]
    assert "x.yaml" in stream.getvalue()
