"""`solve problem.yaml`: what is written where, what is printed, and with which exit code it ends."""

import io
import json
import os
import sys
from dataclasses import replace

import pytest
import sympy as sp

from solver.document.formats import FORMATS
from tests.helpers.small_problems import BAD, GOOD
from tests.helpers.solved import EXAMPLES, PROBLEMS, by_problem, document_of_problem

SUFFIXES = {"html": ".html", "latex": ".tex", "md": ".md", "json": ".json", "text": ".txt"}


def test_a_solved_problem_is_summarised_and_its_page_is_beside_it(solve, good):
    done = solve("good.yaml")
    assert done.code == 0
    assert "χ(λ) = λ² + 3λ + 2" in done.out
    assert "verified: " in done.out
    assert done.out.rstrip().endswith("wrote good.html")
    assert good.with_suffix(".html").read_text(encoding="utf-8").startswith("<!DOCTYPE html>")
    assert not done.err


def test_all_formats_are_written_into_a_folder_that_is_made(solve, good):
    assert solve("good.yaml", "-f", "html,latex,md,json,text", "-o", "made/for/it/").code == 0
    assert {path.name for path in (good.parent / "made/for/it").iterdir()} == {
        f"good{suffix}" for suffix in SUFFIXES.values()
    }


@pytest.mark.parametrize("format_", SUFFIXES)
def test_one_format_can_be_written_to_standard_output_and_nothing_else_is(solve, good, format_):
    done = solve("good.yaml", "-f", format_, "-o", "-")
    assert done.code == 0
    assert not done.err
    assert "A small problem" in done.out
    assert "wrote" not in done.out
    assert [path.name for path in good.parent.iterdir()] == ["good.yaml"]


@pytest.mark.parametrize(
    ("name", "start"), [("x.json", "{"), ("x.tex", "\\documentclass"), ("x.html", "<!DOCTYPE"), ("x", "<!DOC")]
)
def test_the_ending_of_the_output_file_names_the_format(solve, good, name, start):
    assert solve("good.yaml", "-o", name).code == 0
    assert (good.parent / name).read_text(encoding="utf-8").lstrip("% \n").startswith((start, "solve"))


def test_the_json_has_exactly_the_keys_that_were_promised(solve, good):
    data = json.loads(solve("good.yaml", "-f", "json", "-o", "-").out)
    assert list(data) == ["version", "title", "status", "symbols", "parts"]
    assert (data["version"], data["title"], data["status"]) == (1, "A small problem", "verified")
    polynomial, spectrum = data["parts"]
    asked = ["out_of", "question", "system"]
    assert list(polynomial) == ["id", "task", "method", "status", *asked, "answers", "checks", "steps"]
    assert list(spectrum) == ["id", "task", "method", "status", "marks", *asked, "answers", "checks", "steps"]
    assert spectrum["marks"] == 2.5
    assert list(polynomial["answers"]["polynomial"]) == ["value", "latex", "symbol"]
    assert all(list(check) == ["claim", "oracle", "residual", "tolerance", "status"] for check in polynomial["checks"])
    assert all(list(step) == ["kind", "title", "text", "values", "steps"] for step in polynomial["steps"])


def test_the_values_of_the_json_are_read_back_by_sympy(solve, good):
    data = json.loads(solve("good.yaml", "-f", "json", "-o", "-").out)
    names = {name: sp.Symbol(name) for name in data["symbols"]}
    answers = {
        name: sp.sympify(answer["value"], locals=names)
        for part in data["parts"]
        for name, answer in part["answers"].items()
    }
    lamda = sp.Symbol("lamda")
    assert answers["polynomial"] == lamda**2 + 3 * lamda + 2
    assert sorted(answers["eigenvalues"]) == [-2, -1]
    V = answers["right_eigenvectors"]
    assert sp.Matrix([[0, 1], [-2, -3]]) * V == V * sp.diag(*answers["eigenvalues"])


def test_the_level_of_detail_decides_how_much_is_written(solve, good):
    brief, full, tutor = (
        len(solve("good.yaml", "-f", "md", "-o", "-", "--detail", level).out) for level in ("brief", "full", "tutor")
    )
    assert brief < full <= tutor


def test_a_command_wins_over_a_file_of_its_name(solve, good):
    good.rename(good.with_name("tasks"))
    done = solve("tasks", "characteristic_polynomial")
    assert done.code == 0
    assert done.out.startswith("characteristic_polynomial")


def test_own_templates_come_first(solve, good, tmp_path):
    folder = tmp_path / "mine" / "wording" / "characteristic_polynomial"
    folder.mkdir(parents=True)
    text = "{% macro question(system, options) %}\nWhat is it, students?\n{% endmacro %}\n"
    (folder / "question.md.jinja").write_text(text, encoding="utf-8")
    assert "What is it, students?" in solve("good.yaml", "-f", "md", "-o", "-", "--templates", "mine").out


def test_a_wrong_template_is_the_users_fault_and_is_named(solve, good, tmp_path):
    folder = tmp_path / "mine" / "wording" / "characteristic_polynomial"
    folder.mkdir(parents=True)
    (folder / "question.md.jinja").write_text("{% macro question( %}", encoding="utf-8")
    done = solve("good.yaml", "--templates", "mine")
    assert done.code == 2
    assert "characteristic_polynomial/question.md.jinja" in done.err


def test_a_mistake_in_the_file_is_shown_at_its_place_with_a_suggestion(solve, tmp_path):
    (tmp_path / "bad.yaml").write_text(BAD, encoding="utf-8")
    done = solve("bad.yaml")
    assert done.code == 2
    assert not done.out
    assert done.err.startswith("bad.yaml:5:")
    assert "^^^" in done.err
    assert "did you mean 'eigenstructure'?" in done.err


def test_one_bad_file_does_not_stop_the_rest_and_the_worst_code_is_returned(solve, good, tmp_path):
    (tmp_path / "bad.yaml").write_text(BAD, encoding="utf-8")
    (tmp_path / "second.yaml").write_text(GOOD.replace("small", "second"), encoding="utf-8")
    done = solve("good.yaml", "bad.yaml", "missing.yaml", "second.yaml", "-o", "out/")
    assert done.code == 2
    assert {path.name for path in (tmp_path / "out").glob("[!.]*")} == {"good.html", "second.html"}
    assert "bad.yaml:5:" in done.err
    assert "missing.yaml: error: there is no such file" in done.err


def test_several_files_go_into_a_folder_even_if_it_has_no_slash(solve, good, tmp_path):
    (tmp_path / "second.yaml").write_text(GOOD, encoding="utf-8")
    assert solve("good.yaml", "second.yaml", "-o", "out").code == 0
    assert {path.name for path in (tmp_path / "out").glob("[!.]*")} == {"good.html", "second.html"}


def test_a_problem_can_come_from_standard_input(process, tmp_path):
    done = process("-", "-f", "md", "-o", "-", stdin=GOOD.encode())
    assert done.code == 0
    assert done.out.startswith("# A small problem")
    assert process("-", stdin=GOOD.encode()).code == 0
    assert (tmp_path / "solution.html").is_file()


@pytest.mark.parametrize(
    "content", [b"\xff\xfe\x00", b"", b"a: [", b"x" * 300_000], ids=["no text", "nothing", "cut off", "too long"]
)
def test_bad_standard_input_is_reported_like_a_bad_file(process, content):
    done = process("-", stdin=content)
    assert done.code == 2
    assert "<standard input>" in done.err
    assert "Traceback" not in done.err


def test_what_is_loaded_while_the_first_file_is_solved_changes_nothing(solve, good, monkeypatch):
    later = solve("good.yaml", "-f", "json", "-o", "-"), solve("good.yaml")
    monkeypatch.setattr("solver.cli.solving.begin_loading", lambda: True)
    assert (solve("good.yaml", "-f", "json", "-o", "-"), solve("good.yaml")) == later
    assert {done.code for done in later} == {0}


@pytest.mark.parametrize(("beyond", "code"), [(0, 0), (1, 2)])
def test_standard_input_may_be_as_large_as_a_file(solve, monkeypatch, beyond, code):
    text = GOOD + "#"
    content = text + "x" * (256 * 1024 - len(text) + beyond)
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(content.encode())))
    done = solve("-", "-f", "json", "-o", "-")
    assert done.code == code
    assert ("the input is larger than 256 KB" in done.err) == bool(code)


def test_the_table_of_checks_is_printed_when_asked_for(solve, good):
    assert "numpy.linalg" not in solve("good.yaml").out
    done = solve("good.yaml", "-v")
    assert "numpy.linalg" in done.out
    assert "passed" in done.out


def test_nothing_but_text_is_printed_where_there_is_no_terminal(process, good):
    done = process("good.yaml", "-v")
    assert "\x1b" not in done.out + done.err
    assert max(map(len, done.out.splitlines())) <= 100


def test_a_terminal_without_unicode_is_no_reason_to_stop(process, good):
    done = process("good.yaml", PYTHONIOENCODING="ascii", PYTHONUTF8="0")
    assert done.code == 0
    assert "verified" in done.out


def test_the_page_is_opened_in_a_browser(solve, good, monkeypatch):
    opened = []
    monkeypatch.setattr("webbrowser.open", lambda address: opened.append(address) or True)
    assert solve("good.yaml", "-f", "json,html", "--open").code == 0
    assert opened == [good.with_suffix(".html").as_uri()]
    assert solve("good.yaml", "-f", "json", "--open").code == 0
    assert opened[1:] == [good.with_suffix(".json").as_uri()]


def test_where_there_is_no_browser_it_says_so(solve, good, monkeypatch):
    monkeypatch.setattr("webbrowser.open", lambda address: False)
    done = solve("good.yaml", "--open")
    assert done.code == 0
    assert "open good.html yourself" in done.err


@pytest.mark.parametrize(**by_problem(PROBLEMS, EXAMPLES[::80], of=64))
def test_in_a_process_of_its_own_every_check_passes_and_the_bytes_are_the_same(process, path, tmp_path):
    """Among the tests everything is imported already, and so is what registers itself on import.

    Sets are gone through in another order there, as text has other hashes: on no page may that be seen.
    """
    seed = "1" if os.environ.get("PYTHONHASHSEED") != "1" else "2"
    done = process(path, "-f", "html,latex,json", "--detail", "tutor", "-o", "made/", PYTHONHASHSEED=seed)
    ours = replace(document_of_problem(path), name=path.name)
    for name in ("html", "latex", "json"):
        format_ = FORMATS[name]
        assert (tmp_path / "made" / path.stem).with_suffix(format_.suffix).read_bytes() == format_.write(ours), name
    parts = json.loads((tmp_path / "made" / f"{path.stem}.json").read_text(encoding="utf-8"))["parts"]
    checks = [check for part in parts for check in part["checks"]]
    assert done.code == (1 if any(part["status"] == "unsolved" for part in parts) else 0), done.err
    assert checks
    assert not [check for check in checks if check["status"] == "failed"]
    left = [check["reason"] for check in checks if check["status"] == "skipped"]
    assert all(reason.startswith("a display is not evaluated") for reason in left), left
