"""What is to be said, as data: a reason by its kind and values, an exception that carries one.

Kernels and derivations hold no prose. A reason is worded by the macro of its kind in `templates/wording/reasons/`, in
the language that is asked for (`solver.messages`).
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

from solver import resources

ENGLISH = "en"
"""The language of the templates."""

_DERIVED = re.compile(r"(\w+?)_(dot|ddot|dddot|d\d+)")
"""Names of derivatives: x_dot, x_d4."""

PHRASES = "phrases.yaml"
"""What makes a folder of `templates/wording/` a language: its translations of short texts."""

DIGITS = 5


def folders(templates: Path | None = None) -> list[Path]:
    """Return where files of macros are looked for: in the user's folder, if there is one, then in the installed one."""
    own = [templates / "wording", templates] if templates else []
    return [*own, resources.root("templates") / "wording"]


def languages(templates: Path | None = None) -> list[str]:
    """Return the languages that can be asked for: English, and every folder that has phrases."""
    found = set().union(*(_languages_in(folder) for folder in folders(templates)[:-1]), _installed_languages())
    return [ENGLISH, *sorted(found)]


def _languages_in(folder: Path) -> set[str]:
    return {each.parent.name for each in folder.glob(f"*/{PHRASES}")}


@cache
def _installed_languages() -> set[str]:
    """Return those of the installed templates: every problem that is read asks for them."""
    return _languages_in(folders()[-1])


def formula(value: Any) -> str:
    """Return an expression or matrix as LaTeX, without dollars."""
    import sympy as sp  # noqa: PLC0415 - the declarations of tasks, which import this file, do not wait for sympy

    rounded = {number: sp.Float(number, DIGITS) for number in value.atoms(sp.Float)}
    dotted = {symbol: _dotted(symbol.name) for symbol in value.free_symbols if _DERIVED.fullmatch(symbol.name)}
    shown = value.xreplace(rounded)
    matrices = {"mat_str": "bmatrix", "mat_delim": ""}
    return str(sp.latex(shown, imaginary_unit="j", ln_notation=True, symbol_names=dotted, **matrices))


def _dotted(name: str) -> str:
    r"""Return the LaTeX of a derivative: of x1_dot \dot{x_{1}}, of x_d4 x^{(4)}."""
    import sympy as sp  # noqa: PLC0415 - as above

    of, dots = _DERIVED.fullmatch(name).groups()  # type: ignore[union-attr]
    base = sp.latex(sp.Symbol(of))
    return rf"\{dots}{{{base}}}" if dots.endswith("dot") else f"{{{base}}}^{{({dots[1:]})}}"


@dataclass(frozen=True, slots=True)
class Reason:
    """Why something has no answer or is refused: `kind` is "file/macro" within `templates/wording/reasons/`.

    As a text it is worded in English (Markdown with $math$).
    """

    kind: str
    values: Mapping[str, Any] = field(default_factory=dict)

    def __str__(self) -> str:
        from solver.messages import Messages  # noqa: PLC0415 - templates are loaded where something is said

        return Messages().reason(self)


class Phrase(str):
    """A short English text with values in it, which other languages word by its pattern: `Phrase("row {i}", i=2)`."""

    pattern: str
    values: Mapping[str, Any]

    def __new__(cls, pattern: str, /, **values: Any) -> Phrase:
        """Return the English text; the pattern is that of `str.format`."""
        phrase = super().__new__(cls, pattern.format(**values))
        phrase.pattern, phrase.values = pattern, values
        return phrase

    def __reduce__(self) -> tuple[Any, ...]:
        return _phrase, (self.pattern, dict(self.values))


def _phrase(pattern: str, values: Mapping[str, Any]) -> Phrase:
    return Phrase(pattern, **values)


class Told(Exception):  # noqa: N818 - not an error of the program
    """Something has no answer; `reason` says why. Raised with a reason, or with its kind and values."""

    def __init__(self, reason: Reason | str, /, **values: Any) -> None:
        super().__init__(reason)
        self.reason = reason if isinstance(reason, Reason) else Reason(reason, values)

    def __str__(self) -> str:
        return str(self.reason)
