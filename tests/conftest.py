"""Shared by all tests: hypothesis keeps no clock, and what TeX reads is skipped where there is none."""

import os
import shutil

import pytest
from hypothesis import HealthCheck, settings

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # tiny matrices are slowed down a hundredfold by threads

settings.register_profile("default", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.register_profile("ci", deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("ci" if os.environ.get("CI") == "true" else "default")


@pytest.fixture
def tex() -> None:
    """TeX is installed: where it is missing the test is skipped, and fails in CI."""
    if shutil.which("pdflatex") is None:
        (pytest.fail if os.environ.get("CI") == "true" else pytest.skip)("pdflatex is not installed")
