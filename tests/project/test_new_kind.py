"""A new kind of system is one file, its wording and its conversions: no other file of the project is touched."""

import json

import pytest

from tests.helpers.copies import COPIES, WHOLE, complaints_of_lint, copy_of_the_project, run
from tests.helpers.shares import one_of

pytestmark = [
    *one_of(COPIES.index("kind"), len(COPIES)),
    pytest.mark.xdist_group("new_kind"),
]  # one copy of the project serves all

KIND = '''"""A system without coupling, by its modes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from solver.lazy import sympy as sp
from solver.systems.kind import Key, Kind, Reader, Values

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol


@dataclass(frozen=True)
class Modes:
    """`row` holds the eigenvalues (1×n), each the rate of a state of its own."""

    row: ImmutableMatrix
    discrete: bool = False
    sample_time: Expr | None = None

    @property
    def kind(self) -> str:
        """The name of the kind that words it."""
        return "modes"

    @property
    def parameters(self) -> tuple[Symbol, ...]:
        """The free symbols, sorted by name."""
        return tuple(sorted(self.row.free_symbols, key=str))

    @property
    def provides(self) -> frozenset[str]:
        """A task can ask for the modes."""
        return frozenset({"modes"})

    @property
    def described(self) -> str:
        """What it is given by, in words."""
        return "the system is given by its modes"

    def size(self, of: str) -> int | None:
        """Return the number of states "n"."""
        return self.row.cols if of == "n" else None

    def names(self, of: str) -> tuple[str, ...]:  # noqa: ARG002 - there are none
        """Return no names."""
        return ()


def _read(reader: Reader) -> Modes:
    """Return the modes."""
    row = reader.matrix("modes", flat="row")
    reader.conclude()
    return Modes(row if row is not None else sp.ImmutableMatrix([[0]]), reader.discrete, reader.sample_time)


MODES = Kind(
    "modes",
    doc="A system without coupling, by its modes.",
    keys=(Key("modes", Values(), "the eigenvalues", required=True),),
    read=_read,
    example=(("modes: [-1, -2]", "one a state"),),
)
'''

CONVERSION = '''"""Modes as a diagonal matrix, for questions about A."""

from __future__ import annotations

from solver.derivation import Claim, Derivation, Step, lemma
from solver.derivation.conversion import conversion
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product
from solver.stated.matrices import determinant
from solver.systems import StateSpace
from solver.systems.modes import Modes


@conversion(Modes, StateSpace, gives=lambda _: ("A",))
@lemma("modes")
def diagonal(modes: Modes) -> Derivation[StateSpace]:
    """The modes on the diagonal."""
    row = modes.row.tolist()[0]
    A, x = sp.ImmutableMatrix(sp.diag(*row)), sp.Symbol("lamda")
    stated = determinant(difference(product(x, sp.ImmutableMatrix(sp.eye(len(row)))), A))
    claim = Claim(stated, sp.Mul(*(x - mode for mode in row)), "the modes are the eigenvalues")
    yield Step("diagonal", claims={"same": claim}, A=A)
    return StateSpace(A, discrete=modes.discrete, sample_time=modes.sample_time)
'''

FILES = {
    "solver/systems/modes.py": KIND,
    "solver/conversions/modes_to_state_space.py": CONVERSION,
    "templates/wording/systems/modes.md.jinja": (
        "{% macro given(system) %}\n{{ pieces([['modes', system.row]]) }}\n{% endmacro %}\n"
    ),
    "templates/wording/lemmas/modes.md.jinja": (
        '{% macro diagonal(v, c) %}\n### Each mode a state\n{{ eq("A", v.A) }}\n{{ claim(c.same) }}\n{% endmacro %}\n'
    ),
    "problems/examples/modes.yaml": (
        "# A system without coupling.\ntitle: Modes\nsystem: {modes: [-1, a, -3]}\nassume: {a: negative}\n"
        "find: {a: stability, b: {task: state_transition_matrix, method: laplace}}\n"
    ),
}


@pytest.fixture(scope="module")
def copy(tmp_path_factory):
    """A copy of the project with a kind of system more."""
    found = copy_of_the_project(tmp_path_factory.mktemp("kind"))
    for name, text in FILES.items():
        assert not (found / name).exists()
        (found / name).write_text(text, encoding="utf-8")
    assert run(found, "tools.tables").returncode == 0
    return found


def test_a_problem_of_the_new_kind_is_solved_and_verified(copy):
    done = run(copy, "solver", "problems/examples/modes.yaml", "-f", "json", "-o", "-")
    data = json.loads(done.stdout)
    assert data["status"] == "verified", done.stderr
    assert data["parts"][0]["system"] == {"row": "Matrix([[-1, a, -3]])"}
    assert [part["steps"][0]["kind"] for part in data["parts"]] == ["diagonal", "diagonal"]


def test_what_is_wrong_with_it_is_told_at_its_place(copy):
    (copy / "wrong.yaml").write_text("system: {modes: [-1, 1/0]}\nfind: {a: lqr}\n", encoding="utf-8")
    done = run(copy, "solver", "wrong.yaml")
    assert done.returncode == 2
    assert "wrong.yaml:1:24: error: division by zero" in done.stderr


def test_the_schema_knows_it(copy):
    schema = run(copy, "solver", "schema").stdout
    assert '"modes"' in schema


def test_lint_and_the_meta_tests_pass(copy):
    assert not complaints_of_lint(copy, [name for name in FILES if name.endswith(".py")])
    done = run(copy, "pytest", "-q", "-p", "no:cacheprovider", "-n", "0", *WHOLE, "tests/problem/test_schema.py")
    assert done.returncode == 0, done.stdout[-4000:]
