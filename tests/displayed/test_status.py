"""The status that is told includes what the page displays; the engine's says what the mathematics is worth."""

import json

import pytest

from solver.derivation import Status
from solver.document.model import Presentation
from solver.document.works import document_of
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue

PROBLEM = {"title": "T", "system": {"A": [[0, 1], [-2, -3]]}, "find": {"a": "characteristic_polynomial"}}
WRONG = """{% macro pencil(v, c) %}
### Pencil
{{ eq(v.x|tex ~ " I + A", v.pencil) }}
{% endmacro %}
{% macro expansion(v, c) %}
### Expansion
{{ claim(c.value) }}
{% endmacro %}
{% macro factors(v, c) %}
### Factors
{{ claim(c.factors) }}
{% endmacro %}
"""


@pytest.mark.parametrize("detail", ["key", "brief", "full", "tutor"])
def test_a_false_display_fails_the_part_at_every_level(detail, tmp_path):
    (tmp_path / "lemmas").mkdir()
    (tmp_path / "lemmas" / "determinant.md.jinja").write_text(WRONG, encoding="utf-8")
    solution = solve_problem(read_problem(Source("q.yaml", json.dumps(PROBLEM)), catalogue()))
    assert solution.status is Status.VERIFIED
    assert document_of(solution, Presentation(detail)).status is Status.VERIFIED
    part = document_of(solution, Presentation(detail, tmp_path)).parts[0]
    assert part.status is Status.FAILED
    assert "1 of " in part.reason
