"""Whatever is wrong outside of the mathematics is said in words, with exit code 2, and never as a traceback."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from solver.cli import destination
from solver.cli.executing import Workers
from solver.executors import Processes
from tests.helpers.small_problems import GOOD


def names(folder):
    return sorted(path.name for path in folder.iterdir())


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["chekc", "good.yaml"], "Did you mean 'check'?"),
        (["good.yml"], "did you mean 'good.yaml'?"),
        (["folder/good.yaml"], "there is no such file"),
        (["good.yaml", "-f", "htlm"], "Did you mean html?"),
        (["good.yaml", "-f", ","], "no format named"),
        (["good.yaml", "--detail", "ful"], "'full'"),
        (["good.yaml", "--templates", "nowhere"], "does not exist"),
        (["good.yaml", "--time-limit", "0"], "0"),
        (["good.yaml", "--time-limit", "nan"], "nan"),
        (["good.yaml", "--time-limit", "86401"], "86401"),
        (["good.yaml", "--memory-limit", "1"], "16"),
        (["good.yaml", "--colour"], "No such option"),
        (["good.yaml", "-o", "-", "-f", "json,md"], "one format"),
        (["good.yaml", "other.yaml", "-o", "-"], "one FILE"),
        (["good.yaml", "-o", "good.yaml"], "will not be overwritten"),
        (["check", "good.yaml", "answers.yaml"], "there is no such file"),
        (["tasks", "eigenstrcture"], "Did you mean 'eigenstructure'?"),
        (["tasks", "eigen"], "Did you mean 'eigenstructure'?"),
        (["new", "nothing_like_it"], "`solve tasks` lists them"),
        (["new", "eigenstructure", "-o", "good.yaml"], "exists already"),
        (["run"], "Missing argument"),
    ],
)
def test_a_wrong_command_is_explained(solve, good, words, said):
    done = solve(*words)
    assert done.code == 2
    assert said in done.err
    assert not done.out
    assert good.read_text(encoding="utf-8") == GOOD


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"\n\n",
        b"\x00\x01\x02\xff" * 100,
        bytes(range(256)) * 4,
        b"title: " + b"[" * 100_000,
        b"a: &x [*x]",
        b"- just\n- a list",
        b"system: {A: [[1]]}\nfind: {a: characteristic_polynomial, a: eigenstructure}",
        b"system: {A: [[\"__import__('os').system('true')\"]]}\nfind: {a: eigenstructure}",
        b"system: {A: [[9^9^9^9]]}\nfind: {a: eigenstructure}",
        "system: {A: [[\u202e1]]}\nfind: {a: eigenstructure}".encode(),
        b"system: {A: [[.nan]]}\nfind: {a: eigenstructure}",
        b"!!python/object/apply:os.system [true]",
    ],
    ids=range(13),
)
def test_a_hostile_file_is_refused_with_its_place(solve, tmp_path, content):
    (tmp_path / "hostile.yaml").write_bytes(content)
    done = solve("hostile.yaml")
    assert done.code == 2
    assert done.err.startswith("hostile.yaml")
    assert "Traceback" not in done.err
    assert "internal error" not in done.err
    assert names(tmp_path) == ["hostile.yaml"]


def test_an_empty_folder_is_refused(solve, tmp_path):
    (tmp_path / "folder.yaml").mkdir()
    assert "there is no problem file in this folder" in solve("folder.yaml").err


def test_a_pipe_is_refused_and_does_not_block(solve, tmp_path):
    os.mkfifo(tmp_path / "pipe.yaml")
    assert "it is not a regular file" in solve("pipe.yaml").err


def test_a_file_that_may_not_be_read_is_refused(solve, good, monkeypatch):
    def forbidden(*_):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "open", forbidden)
    done = solve("good.yaml")
    assert (done.code, done.err) == (2, "good.yaml: error: no permission to read it\n")


def test_output_that_cannot_be_written_is_the_users_fault_and_leaves_nothing(solve, good, tmp_path):
    (tmp_path / "a-file").write_text("kept", encoding="utf-8")
    done = solve("good.yaml", "-o", "a-file/page.html")
    assert done.code == 2
    assert "cannot write a-file/page.html" in done.err
    assert names(tmp_path) == ["a-file", "good.yaml"]


def test_a_folder_that_may_not_be_written_to_is_said_once_and_other_formats_are_tried(solve, good, monkeypatch):
    def full(**_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(destination.tempfile, "mkstemp", full)
    done = solve("good.yaml", "-f", "html,json")
    assert done.code == 2
    assert done.err.count("No space left on device") == 2
    assert "χ(λ)" in done.out


def test_a_page_is_replaced_whole_or_not_at_all(solve, good, tmp_path, monkeypatch):
    page = tmp_path / "good.html"
    page.write_text("the old page", encoding="utf-8")
    page.chmod(0o640)

    def interrupted(*_):
        raise OSError(5, "Input/output error")

    with monkeypatch.context() as broken:
        broken.setattr(Path, "replace", interrupted)
        assert solve("good.yaml").code == 2
    assert page.read_text(encoding="utf-8") == "the old page"
    assert names(tmp_path) == ["good.html", "good.yaml"]
    assert solve("good.yaml").code == 0
    assert page.read_text(encoding="utf-8").startswith("<!DOCTYPE")
    assert page.stat().st_mode & 0o777 == 0o640


def test_what_is_not_a_regular_file_is_written_to_and_not_replaced(solve, good):
    assert solve("good.yaml", "-o", "/dev/null").code == 0
    assert not Path("/dev/null").is_file()


def test_a_bug_is_reported_in_words_and_its_traceback_is_kept_for_whoever_asks(solve, good, monkeypatch):
    def broken(*_, **__):
        raise ZeroDivisionError("of our own making")

    monkeypatch.setattr("solver.render.page.encoded_page", broken)
    done = solve("good.yaml")
    assert done.code == 1
    assert "good.yaml: internal error: ZeroDivisionError: of our own making" in done.err
    assert "please report it" in done.err
    assert "Traceback" not in done.err
    monkeypatch.setenv("SOLVE_DEBUG", "1")
    assert "Traceback" in solve("good.yaml").err


def test_a_bug_in_one_file_does_not_stop_the_rest(solve, good, tmp_path, monkeypatch):
    (tmp_path / "second.yaml").write_text(GOOD, encoding="utf-8")
    from solver.render import page  # noqa: PLC0415 - what is replaced

    original = page.encoded_page

    def broken_for_one(document, **options):
        if document.name == "good.yaml":
            raise ZeroDivisionError
        return original(document, **options)

    monkeypatch.setattr(page, "encoded_page", broken_for_one)
    monkeypatch.setattr(Workers, "executor", lambda _: Processes(1, "fork"))  # which has what is replaced here
    assert solve("good.yaml", "second.yaml").code == 1
    assert (tmp_path / "second.html").is_file()


def test_neither_tex_nor_typst_is_said_and_the_page_is_still_written(solve, good, tmp_path, monkeypatch):
    monkeypatch.setattr("shutil.which", lambda *_, **__: None)
    monkeypatch.setattr("solver.render.pdf.find_spec", lambda _: None)
    done = solve("good.yaml", "-f", "pdf,html")
    assert done.code == 2
    assert "there is neither TeX" in done.err
    assert "wrote good.html" in done.out
    assert not (tmp_path / "good.pdf").exists()


def test_parts_that_misbehave_are_unsolved_and_the_page_has_the_rest(solve, difficult_file, tmp_path):
    path = difficult_file("easy", "endless", "easy")
    done = solve(path, "--time-limit", "0.5")
    assert done.code == 1
    assert "unsolved: time limit of 0.5 s" in done.out
    assert done.out.count("verified: 1 of 1 checks passed") == 2
    page = (tmp_path / "difficult.html").read_text(encoding="utf-8")
    assert "time limit of 0.5 s" in page


def test_the_memory_limit_is_kept(solve, difficult_file):
    done = solve(difficult_file("greedy"), "--memory-limit", "100")
    assert done.code == 1
    assert "unsolved: memory limit of 100 MB" in done.out


def test_a_failed_check_is_shown_with_its_table(solve, difficult_file):
    done = solve(difficult_file("wrong"))
    assert done.code == 1
    assert "failed: 1 of 1 checks failed" in done.out
    assert "comparison" in done.out


def test_parts_that_are_not_verified_are_told_on_standard_error_beside_a_document(solve, difficult_file):
    done = solve(difficult_file("easy", "unsolvable"), "-f", "json", "-o", "-")
    assert done.code == 1
    assert done.err == "part b (unsolvable): unsolved: The plant is a constant: it has no pole to move.\n"


ENDLESS = """
import signal
import sys
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell that runs tests in the background has it ignored
from tests.helpers.difficult_task import difficult
from solver.tasks import catalogue
catalogue()["difficult"] = difficult
from solver.cli import main
sys.exit(main(["difficult.yaml"]))
"""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="looks into /proc")
@pytest.mark.parametrize(("number", "code"), [(signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGHUP, 129)])
def test_a_signal_ends_the_command_and_its_child_quietly(difficult_file, tmp_path, number, code):
    difficult_file("endless")
    told = tmp_path / "pid"
    env = {**os.environ, "DIFFICULT_PID_FILE": str(told), "PYTHONPATH": str(Path(__file__).parents[2])}
    with subprocess.Popen([sys.executable, "-c", ENDLESS], cwd=tmp_path, env=env, stderr=subprocess.PIPE) as process:
        end = time.monotonic() + 60
        while not (told.exists() and told.read_text()) and time.monotonic() < end:
            time.sleep(0.05)
        child = int(told.read_text())
        process.send_signal(number)
        while True:
            try:
                _, errors = process.communicate(timeout=10)
                break
            except subprocess.TimeoutExpired:  # Python loses an interrupt that comes while it tidies up after an import
                assert time.monotonic() < end + 60
                process.send_signal(number)
    assert process.returncode == code
    assert b"Traceback" not in errors or b"Exception ignored" in errors
    assert not Path(f"/proc/{child}").exists()


def test_a_reader_that_has_seen_enough_is_no_error(tmp_path):
    reader, writer = os.pipe()
    os.close(reader)
    env = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])}
    command = [sys.executable, "-m", "solver", "tasks"]
    done = subprocess.run(command, cwd=tmp_path, env=env, stdout=writer, stderr=subprocess.PIPE, check=False)
    os.close(writer)
    assert done.returncode == 128 + signal.SIGPIPE
    assert not done.stderr
