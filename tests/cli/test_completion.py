"""What shells complete, asked as they ask it; and files to start from."""

import os
import shutil
import subprocess
import sys

import pytest

from solver.cli.beginnings import BEGINNINGS
from solver.cli.completing import SHELLS, _tasks
from solver.problem.library import model_names
from solver.tasks import catalogue

COMMAND = (sys.executable, "-m", "solver")


def completed(words, shell="bash", code=""):
    """Return what click proposes for the last of some words, in a process of its own."""
    told = {"_SOLVE_COMPLETE": f"{shell}_complete", "COMP_WORDS": " ".join(words), "COMP_CWORD": str(len(words) - 1)}
    call = (sys.executable, "-c", code) if code else COMMAND
    done = subprocess.run(call, env={**os.environ, **told}, capture_output=True, text=True, check=False)
    assert not done.stderr
    return [tuple(line.split(",", 1)) for line in done.stdout.splitlines()]


@pytest.mark.parametrize("shell", SHELLS)
def test_the_script_of_each_shell_is_printed(solve, shell):
    for words in (("--completion", shell), (f"--completion={shell}",)):
        done = solve(*words)
        assert done.code == 0
        assert f"{shell}_complete" in done.out
        assert "_SOLVE_COMPLETE" in done.out
    assert "'cmd'" in solve("--completion", "cmd").err


@pytest.mark.parametrize(
    ("words", "proposed"),
    [
        (["solve", "var"], [("plain", "variants"), ("file", "var")]),
        (["solve", "new", "pole_pl"], [("plain", "pole_placement")]),
        (["solve", "new", "exa"], [("plain", "exam")]),
        (["solve", "tasks", "kalman_f"], [("plain", "kalman_filter")]),
        (["solve", "models", "inverted"], [("plain", each) for each in model_names() if each.startswith("inverted")]),
        (["solve", "problem.ya"], [("file", "problem.ya")]),
        (["solve", "problem.yaml", "--detai"], [("plain", "--detail")]),
        (["solve", "problem.yaml", "--detail", "tu"], [("plain", "tutor")]),
        (["solve", "problem.yaml", "-f", "html,js"], [("plain", "html,json")]),
        (["solve", "check", "a.yaml", "b"], [("file", "b")]),
        (["solve", "exam", "exam.yaml", "-o", "bu"], [("dir", "bu")]),
        (["solve", "variants", "fam"], [("file", "fam")]),
    ],
)
def test_words_are_completed(words, proposed):
    assert completed(words) == proposed


def test_all_tasks_are_proposed_without_algebra():
    code = (
        "import sys; from solver.cli import main\ntry: main()\nfinally: print('plain,' + str('sympy' in sys.modules))"
    )
    *found, (_, loaded) = completed(["solve", "new", ""], code=code)
    assert {name for _, name in found} == {*catalogue(), *BEGINNINGS}
    assert loaded == "False"


ASKED = {
    "bash": (
        "--norc", "-c",
        'eval "$SCRIPT"; COMP_WORDS=(solve new pole_pl); COMP_CWORD=2; _solve_completion solve; echo "${COMPREPLY[@]}"',
    ),
    "zsh": (
        "-f", "-c",
        "compdef() { :; }; compadd() { eval \"print -l \\${$argv[-1]}\"; }; "
        'eval "$SCRIPT"; words=(solve new pole_pl); CURRENT=3; _solve_completion',
    ),
    "fish": ("--no-config", "-c", 'echo $SCRIPT | source; complete -C "solve new pole_pl"'),
}  # fmt: skip
"""How each shell is asked, in a word, what it would complete; zsh without the line that a person types into."""


@pytest.mark.parametrize(
    "shell",
    [each if shutil.which(each) else pytest.param(each, marks=pytest.mark.skip("there is none")) for each in SHELLS],
)
def test_a_real_shell_completes(tmp_path, shell):
    script = subprocess.run((*COMMAND, "--completion", shell), capture_output=True, text=True, check=True).stdout
    (tmp_path / "solve").write_text(f'#!/bin/sh\nexec "{sys.executable}" -m solver "$@"\n', encoding="utf-8")
    (tmp_path / "solve").chmod(0o755)
    path = f"{tmp_path}{os.pathsep}{os.environ['PATH']}"
    environment = {**os.environ, "PATH": path, "SCRIPT": script, "HOME": str(tmp_path)}
    done = subprocess.run((shell, *ASKED[shell]), env=environment, capture_output=True, text=True, check=False)
    assert done.stdout.split() == ["pole_placement"], done.stderr


def test_the_names_of_tasks_are_those_of_the_catalogue():
    assert sorted(_tasks()) == sorted(catalogue())


@pytest.mark.parametrize("name", BEGINNINGS)
def test_a_file_to_start_from_runs_as_it_stands(solve, tmp_path, name):
    done = solve("new", name, "-o", "mine.yaml")
    assert done.code == 0
    assert "wrote mine.yaml; " in done.out
    assert (tmp_path / "mine.yaml").read_text(encoding="utf-8") == solve("new", name).out
    command = {"exam": ("exam", "mine.yaml"), "family": ("variants", "mine.yaml", "--count", 2)}[name]
    assert solve(*command, "--jobs", 1).code == 0
    assert "exists already" in solve("new", name, "-o", "mine.yaml").err


def test_a_name_near_to_an_exam_is_told(solve):
    assert "Did you mean 'exam'?" in solve("new", "exm").err
