"""What only lists or explains imports no algebra; the same input gives the same bytes."""

import pytest

from solver.resources import root
from tests.helpers.small_problems import GOOD

HEAVY = ("sympy", "numpy", "scipy", "rich", "jinja2", "latex2mathml", "matplotlib", "yaml", "markdown_it")
TOLD = """
import sys
from solver.cli import main
code = main({words!r})
print(sorted({heavy!r} & sys.modules.keys()), code, file=sys.stderr)
"""


@pytest.mark.parametrize(
    "words",
    [
        ["--help"],
        ["run", "--help"],
        ["--version"],
        ["tasks"],
        ["tasks", "state_transition_matrix"],
        ["chekc"],
        ["check"],
    ],
)
def test_what_only_explains_imports_nothing_heavy(process, words):
    done = process(code=TOLD.format(words=words, heavy={*HEAVY, "pydantic"}))
    assert done.err.splitlines()[-1].startswith("[] ")


def test_a_template_and_the_schema_need_no_algebra(process):
    for words in (["schema"], ["new", "state_transition_matrix"]):
        done = process(code=TOLD.format(words=words, heavy={"sympy", "numpy", "scipy", "rich", "matplotlib"}))
        assert done.err.splitlines()[-1] == "[] 0"


def test_solving_does_not_import_what_only_figures_or_other_tasks_need(process, good):
    heavy = {"matplotlib", "control", "pandas", "IPython", "solver.exact.optimal.riccati"}
    done = process(code=TOLD.format(words=["good.yaml"], heavy=heavy))
    assert done.err.splitlines()[-1] == "[] 0"


@pytest.mark.slow
def test_the_same_file_gives_the_same_bytes_in_another_process(process, good):
    every = ("-f", "html,latex,md,json,text", "--detail", "tutor")
    codes = [process("good.yaml", *every, "-o", f"{seed}/", PYTHONHASHSEED=seed).code for seed in ("1", "2")]
    assert codes == [0, 0]
    for suffix in ("html", "tex", "md", "json", "txt"):
        first, second = ((good.parent / seed / f"good.{suffix}").read_bytes() for seed in ("1", "2"))
        assert len(first) > len(GOOD)
        assert first == second, suffix


@pytest.mark.slow
@pytest.mark.parametrize("name", ["equations", "stability-by-conditions"])
def test_points_are_drawn_in_the_same_order_in_another_process(process, name):
    file = str(root("problems") / f"examples/{name}.yaml")
    first, second = (process(file, "-f", "json", "-o", "-", PYTHONHASHSEED=seed).out for seed in ("0", "1"))
    assert first.startswith("{")
    assert first == second


def test_python_dash_m_is_the_command(process):
    assert process("--version").out.startswith("solve, version ")
