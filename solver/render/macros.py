"""The macros of `templates/wording/` as they are loaded, and the filters that they can use."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from functools import lru_cache
from pathlib import Path
from typing import Any

from jinja2 import pass_context
from jinja2.runtime import Context
from jinja2.sandbox import ImmutableSandboxedEnvironment

from solver.formula import latex
from solver.matrices import entry_alone
from solver.messages import environment
from solver.render.prose import plain
from solver.render.recording import Recorder
from solver.render.symbols import named


class Macros:
    """The macros that equal wordings have loaded, by file, and what notes their displays."""

    def __init__(self) -> None:
        self.modules: dict[str, Any] = {}
        self.recorder = Recorder()


@lru_cache(maxsize=8)
def macros_of(_wording: Hashable) -> Macros:
    """Return the macros that this wording shares with its equals."""
    return Macros()


@lru_cache(maxsize=8)
def environment_of(templates: Path | None) -> ImmutableSandboxedEnvironment:
    """Return the environment that finds wording files; compiled templates are shared by all wordings."""
    found = environment(templates)
    found.filters.update({name: _named(name) for name in ("tex", "latex", "operation", "say")})
    found.filters.update(plain=plain, alone=entry_alone, symbol=_symbol)
    return found


def _symbol(name: str) -> str:
    r"""Return the name of a variable as LaTeX: `x_dot` is \dot{x}."""
    return str(latex(named(name)))


def _named(name: str) -> Callable[[Context, Any], str]:
    """Return a filter that is the wording's function of that name."""

    @pass_context
    def call(context: Context, value: Any) -> str:
        return str(context[name](value))

    return call
