r"""LaTeX of our dialect read into a tree; what is not of it is refused with its place.

This is the one white list between a user's `$math$` and TeX or a page, and a small grammar: braces and `\left`/`\right`
balance, `&` stands in an environment, every `^`, `_` and `\frac` has its arguments. So a formula that passes cannot
stop TeX either. Blanks between the pieces of a formula are not kept; a typed Greek letter becomes its command.
"""

from __future__ import annotations

from array import array
from functools import lru_cache
from itertools import accumulate

from solver.formula.nodes import Row
from solver.formula.reader import DEEPEST, MathProblem, Reader

LONGEST = 50_000
"""Characters of a formula; a 12 × 12 matrix of long entries has about 20,000."""

MOST = 1024
"""Formulas that are remembered: a page has some hundreds, and most of them are of no other page."""

_WRITTEN: dict[str, Row] = {}
"""Trees that were written and not read yet, the latest last."""

_STEPS = bytes.maketrans(b"{([})]", b"\x01\x01\x01\xff\xff\xff")
_OTHERS = bytes(set(range(128)) - set(b"{([})]"))
"""Brackets as signed bytes, and what is none."""


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


def note_written(formula: str, tree: Row) -> None:
    """Remember the tree of what was just written: it need not be read, since reading gives an equal one.

    Not one that is so long or deep that it may be refused.
    """
    if formula not in _WRITTEN and 0 < len(formula) <= LONGEST and not _is_deep(formula):
        if len(_WRITTEN) >= MOST:
            _WRITTEN.pop(next(iter(_WRITTEN)), None)
        _WRITTEN[formula] = tree


def _is_deep(formula: str) -> bool:
    """Whether brackets are nested half as deep as the reader allows; tables and bars, which it counts too, are not."""
    steps = array("b", formula.encode("ascii", "ignore").translate(_STEPS, _OTHERS))  # 1 down, -1 up
    return max(accumulate(steps), default=0) >= DEEPEST // 2


@lru_cache(maxsize=MOST)
def _read(formula: str) -> Row | tuple[int, str]:
    if (written := _WRITTEN.pop(formula, None)) is not None:
        return written
    if len(formula) > LONGEST:
        return 0, f"a formula of more than {LONGEST} characters"
    if not formula.strip():
        return 0, "an empty formula"
    try:
        return Reader(formula).row("")
    except MathProblem as problem:
        return problem.offset, problem.message
