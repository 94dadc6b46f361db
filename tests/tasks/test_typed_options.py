"""Options are typed: a misspelt one is an error of the type checker, and of the code that runs."""

import subprocess
import sys
from pathlib import Path

import pytest

from solver.systems import StateSpace
from solver.tasks import catalogue

PROJECT = Path(__file__).parents[2]
SNIPPET = '''
from solver.derivation import Given
from solver.tasks.design.pole_placement import PolePlacementOptions, pole_placement
from solver.tasks.needed import WithInput


@pole_placement.verification("K")
def judge(given: Given[WithInput, PolePlacementOptions], answers: object) -> list[object]:
    """Read an option that there is, and one that there is not."""
    return [given.options.poles, given.options.polse]
'''


@pytest.mark.slow
def test_mypy_sees_a_misspelt_option(tmp_path):
    path = tmp_path / "snippet.py"
    path.write_text(SNIPPET, encoding="utf-8")
    done = subprocess.run(
        [sys.executable, "-m", "mypy", str(path)], cwd=PROJECT, capture_output=True, text=True, check=False
    )
    assert 'has no attribute "polse"; maybe "poles"?' in done.stdout
    assert done.stdout.count("[attr-defined]") == 1


def test_options_that_a_task_does_not_have_are_refused():
    plant = StateSpace(A=None)
    with pytest.raises(TypeError, match="polse"):
        catalogue()["pole_placement"].given(plant, {"polse": (-1, -2)})
    with pytest.raises(AttributeError, match="polse"):
        _ = catalogue()["pole_placement"].given(plant, {}).options.polse
