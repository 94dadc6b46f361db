"""Shared by all tests: hypothesis keeps no clock, and what TeX reads is skipped where there is none.

Profiles of hypothesis, chosen by `--hypothesis-profile`: `fast` tries a sixth of the examples, `third` a third,
`all` tries them all.
"""

import gc
import os
import shutil
import signal
from importlib.util import find_spec

import pytest
from hypothesis import HealthCheck, Phase, settings

from tests.helpers.tried import ALL

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # tiny matrices are slowed down a hundredfold by threads

# In the background of a shell SIGINT is ignored, and would be by all that tests start.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)  # the many processes that tests start would each compile all files

gc.set_threshold(100_000, 20, 20)  # collecting tests makes many objects and no garbage: a third faster

IN_CI = os.environ.get("CI") == "true"

UNTRACED = [each for each in Phase if each is not Phase.explain]
"""To explain a failure every line is traced: a smaller example is then sought for minutes."""

every = settings(
    deadline=None,
    derandomize=IN_CI,
    suppress_health_check=[HealthCheck.too_slow],
    max_examples=ALL,
    phases=UNTRACED,
)
fast = settings(every, max_examples=ALL // 6)
settings.register_profile("all", every)
settings.register_profile("third", settings(every, max_examples=ALL // 3))
settings.register_profile("fast", fast)
settings.register_profile(
    "mutants", every, max_examples=ALL // 4, derandomize=True, database=None, phases=(Phase.explicit, Phase.generate)
)
settings.load_profile("fast")


def pytest_collection_finish(session: pytest.Session) -> None:
    """Refuse to run where xdist has lost its groups: every worker would solve every problem again."""
    grouped = [item for item in session.items if item.get_closest_marker("xdist_group")]
    if getattr(session.config.option, "loadgroup", False) and not all("@" in item.nodeid for item in grouped):
        raise pytest.UsageError("this version of pytest-xdist does not group tests with this version of pytest")
    gc.freeze()


@pytest.fixture
def tex() -> None:
    """TeX is installed: where it is missing the test is skipped, and fails in CI."""
    if shutil.which("pdflatex") is None:
        (pytest.fail if IN_CI else pytest.skip)("pdflatex is not installed")


@pytest.fixture
def typst() -> None:
    """Typst is installed: where it is missing the test is skipped, and fails in CI."""
    if find_spec("typst") is None:
        (pytest.fail if IN_CI else pytest.skip)("typst is not installed")
