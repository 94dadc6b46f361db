r"""LaTeX of our dialect read into a tree; what is not of it is refused with its place.

This is the one white list between a user's `$math$` and TeX or a page, and a small grammar: braces and `\left`/`\right`
balance, `&` stands in an environment, every `^`, `_` and `\frac` has its arguments. So a formula that passes cannot
stop TeX either. Blanks between the pieces of a formula are not kept; a typed Greek letter becomes its command.
"""

from __future__ import annotations

from functools import lru_cache

from solver.formula.nodes import Row
from solver.formula.reader import MathProblem, Reader

LONGEST = 50_000
"""Characters of a formula; a 12 × 12 matrix of long entries has about 20,000."""


def read(formula: str) -> Row:
    """Return the tree of a formula; raises MathProblem if it is not of our dialect."""
    found = _read(formula)
    if isinstance(found, Row):
        return found
    raise MathProblem(*found)


def find_problem(formula: str) -> tuple[int, str] | None:
    """Return where a formula leaves our dialect, and how; None if it does not."""
    found = _read(formula)
    return None if isinstance(found, Row) else found


@lru_cache(maxsize=8192)
def _read(formula: str) -> Row | tuple[int, str]:
    if len(formula) > LONGEST:
        return 0, f"a formula of more than {LONGEST} characters"
    if not formula.strip():
        return 0, "an empty formula"
    try:
        return Reader(formula).row("")
    except MathProblem as problem:
        return problem.offset, problem.message
