"""Templates that are compiled once: what is kept is used, and only what belongs to the template as it stands."""

import sys
from pathlib import Path

import jinja2
import pytest

from solver import compiled, resources


@pytest.fixture
def installed(tmp_path, monkeypatch):
    """An installation with one template, in which compiled templates may be kept."""
    monkeypatch.setattr(resources, "root", lambda kind: tmp_path)
    monkeypatch.setattr(sys, "dont_write_bytecode", False)
    (tmp_path / "page.jinja").write_text("{{ 1 + 1 }}", encoding="utf-8")
    return tmp_path


def rendered(folder: Path) -> str:
    """The page, as a process that has just started makes it."""
    loader = jinja2.FileSystemLoader(folder)
    return (
        jinja2.Environment(loader=loader, autoescape=True, bytecode_cache=compiled.kept(None))
        .get_template("page.jinja")
        .render()
    )


def test_a_template_is_compiled_once(installed, monkeypatch):
    assert rendered(installed) == "2"
    assert len(list((installed / "__pycache__").iterdir())) == 1

    def never(*_: object, **__: object) -> None:
        raise AssertionError("compiled again")

    monkeypatch.setattr(jinja2.Environment, "compile", never)
    assert rendered(installed) == "2"


def test_a_template_that_changed_is_compiled_anew(installed):
    rendered(installed)
    (installed / "page.jinja").write_text("{{ 1 + 2 }}", encoding="utf-8")
    assert rendered(installed) == "3"


def test_what_was_kept_and_is_broken_is_compiled_anew(installed):
    rendered(installed)
    for file in (installed / "__pycache__").iterdir():
        file.write_bytes(file.read_bytes()[:-5])
    assert rendered(installed) == "2"


def test_nothing_is_kept_where_python_keeps_nothing(installed, monkeypatch):
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    assert rendered(installed) == "2"
    assert not (installed / "__pycache__").exists()


def test_nothing_is_kept_where_nothing_can_be_written(installed):
    (installed / "__pycache__").write_text("a file in the place of the folder", encoding="utf-8")
    assert rendered(installed) == "2"


def test_templates_of_a_user_are_not_kept(installed):
    assert compiled.kept(installed) is None
