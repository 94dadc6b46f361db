"""`solve models`: the library, and all about one model."""

import pytest

from solver.problem.library import library_model, model_names


def test_every_model_is_listed_with_its_title_and_parameters(solve):
    done = solve("models")
    assert done.code == 0
    first = [line.split()[0] for line in done.out.splitlines() if line.startswith("  ") and not line.startswith("   ")]
    assert sorted(first) == list(model_names())
    assert "m_c (kg)" in done.out
    assert max(map(len, done.out.splitlines())) <= 100


@pytest.mark.parametrize("name", model_names())
def test_all_about_a_model_is_told(solve, name):
    done = solve("models", name)
    model = library_model(name)
    assert done.code == 0
    assert done.out.startswith(f"{name}\n  {model.title}.\n")
    assert set(model.meanings("assume")) <= set(done.out.split())
    assert done.out.rstrip().endswith(f"{name}.yaml")
    assert max(len(line) for line in done.out.splitlines() if not line.startswith("File")) <= 100


def test_a_mistyped_name_gets_a_suggestion(solve):
    done = solve("models", "quarter-caar")
    assert done.code == 2
    assert "Did you mean 'quarter-car'?" in done.err
    assert "`solve models` lists them." in solve("models", "zzz").err
