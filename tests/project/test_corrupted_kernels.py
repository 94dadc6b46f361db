"""No result of a kernel that is a little wrong reaches a page under “verified”."""

from pathlib import Path

import pytest

from solver.document.model import Presentation
from solver.resources import root
from tests.helpers.shares import one_of
from tools.corrupted_kernels.equivalents import RIGHT, equivalents, judged
from tools.corrupted_kernels.runs import CAUGHT, KERNELS, SAME, SURVIVED, Extent, Outcome, outcomes
from tools.corrupted_kernels.samples import covering

COURSE = Presentation("full", notation="course")
SAMPLE = (
    "pole-placement-inputs",
    "minimal-realization",
    "stability-discrete",
    "desired-poles",
    "kalman-filter",
    "ch1-ex02",
)
"""Problems whose kernels are corrupted in the quick tests, each kernel once in a part."""
SHARES = 24
"""Into so many tests the problems that cover all tasks and methods are divided; one of them is in turn."""


def found_in(path: Path, extent: Extent) -> list[Outcome]:
    return [judged(each) for each in outcomes(path, extent, COURSE)]


def no_survivors(found: list[Outcome]) -> None:
    survived = [f"{each.key}: {each.shown}" for each in found if each.became == SURVIVED]
    assert not survived, "\n".join(survived)
    assert {each.became for each in found} <= {*CAUGHT, SAME, RIGHT}


@pytest.mark.parametrize("name", SAMPLE)
def test_a_sample_of_corrupted_kernels_reaches_no_verified_page(name):
    (path,) = root("problems").rglob(f"{name}.yaml")
    found = found_in(path, Extent(changes=1, calls=1))
    no_survivors(found)
    assert any(each.became == "failed" for each in found)


@pytest.mark.parametrize("share", [pytest.param(i, marks=one_of(i, SHARES)) for i in range(SHARES)])
def test_no_corrupted_kernel_reaches_a_verified_page(share):
    paths = covering()[share::SHARES]  # chosen here: it takes seconds, which collecting the quick tests need not
    assert paths
    no_survivors([each for path in paths for each in found_in(path, Extent(changes=1, calls=2))])


def test_what_is_right_nonetheless_is_explained():
    for each in equivalents():
        assert each["kernel"] in KERNELS
        assert len(each["reason"]) > 30
