"""Worked, verified solutions of control-engineering problems: `solver.solve(path_or_text)`, `check`, `variants`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

__version__ = "0.1.0"

if TYPE_CHECKING:
    from solver.api import Document, check, solve
    from solver.papers.interface import variants

__all__ = ["Document", "__version__", "check", "solve", "variants"]


def __getattr__(name: str) -> Any:
    """Import the interface, and with it sympy, when it is first used."""
    if name in {"check", "solve", "Document"}:
        from solver import api  # noqa: PLC0415 - see above

        return getattr(api, name)
    if name == "variants":
        from solver.papers import interface  # noqa: PLC0415 - see above

        return interface.variants
    raise AttributeError(f"module 'solver' has no attribute {name!r}")
