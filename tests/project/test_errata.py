"""docs/errata.md is what marking the printed answers gives now."""

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


@pytest.mark.slow
def test_the_errata_are_up_to_date():
    command = [sys.executable, ROOT / "tools" / "errata.py", "--check"]
    done = subprocess.run(command, check=False, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
