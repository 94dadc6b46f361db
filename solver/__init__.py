"""Worked, verified solutions of control-engineering problems: `solver.solve(path_or_text)`, `check`, `exam`.

What there is for programs is in `docs/python.md`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

__version__ = "0.1.0"

if TYPE_CHECKING:
    from solver.api import Document, check, solve
    from solver.papers.interface import check_exam, exam, exam_bank, variants

__all__ = ["Document", "__version__", "check", "check_exam", "exam", "exam_bank", "solve", "variants"]


def __getattr__(name: str) -> Any:
    """Import the interface, and with it sympy, when it is first used."""
    if name in {"check", "solve", "Document"}:
        from solver import api  # noqa: PLC0415 - see above

        return getattr(api, name)
    if name in {"check_exam", "exam", "exam_bank", "variants"}:
        from solver.papers import interface  # noqa: PLC0415 - see above

        return getattr(interface, name)
    raise AttributeError(f"module 'solver' has no attribute {name!r}")
