"""What macros display: equations of values and of LaTeX, noted as values while they are laid out."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from typing import Any

import sympy as sp

from solver.derivation import Claim
from solver.derivation.displayed import FIRST_MARK, STANDS, Displayed, Written
from solver.formula import latex, read
from solver.formula.building import row
from solver.formula.nodes import Operator, Row, Text
from solver.formula.width import LINE, width
from solver.matrices import entry_alone
from solver.render.displays import EQUALS, NOTHING, READABLE, aligned, chain, display, entries
from solver.render.recording import MARK, Recorder
from solver.render.row_operations import row_operation
from solver.stated import Stated

_STATES = re.compile(r"[=<>]|\\(le|ge|ne|approx)\b")
"""What a note must have in it to state something."""

NEARLY = r"\approx"
"""What a note begins with that tells a value in decimals."""

GAP = row(r",\qquad")
"""Between two equations on one line."""


class Displaying:
    """The functions `eq`, `claim`, `align` … of templates; `show` makes formulas of values."""

    def __init__(self, recorder: Recorder, show: Callable[[Any], Row]) -> None:
        self.recorder = recorder
        self.show = show

    def tex(self, value: Any) -> str:
        """Print for the filter `tex`: the mark of the value."""
        return self.recorder.value(value, latex(self.show(value)))

    def laid_out(
        self,
        sides: Sequence[Any],
        show: Callable[[Any], Row],
        relation: str = "=",
        note: str = "",
        *,
        narrow: bool = False,
    ) -> Row:
        """Return `a = b = ...`, broken over lines where it is long; a very wide matrix at its end entry by entry."""
        shown = [self._side(side, show) for side in sides]
        matrix = sides[-1]
        listed = isinstance(matrix, sp.MatrixBase) and 0 not in matrix.shape
        too_wide = listed and (narrow or width(shown[-1]) > READABLE * LINE)
        if not (too_wide and shown[0].items and isinstance(sides[0], str)):
            return chain(shown, Operator(relation) if relation else NOTHING, self._side(note, show))
        cells = [[show(entry) for entry in line] for line in matrix.tolist()]
        return entries(shown[0], shown[1:-1], cells)

    def _side(self, side: Any, show: Callable[[Any], Row]) -> Row:
        """Return a side of a display: a text is LaTeX with marks for values, a matrix of one entry is a number."""
        if not isinstance(side, str):
            return show(as_numbers(side))
        text = self.recorder.expanded(side)
        return read(text) if text.strip() else NOTHING

    def eq(self, *sides: Any, note: str = "", relation: str = "=", holds: bool = True) -> str:
        """Display a = b = ...; `note` stands behind the last side. Unless it `holds`, nothing is claimed.

        A value in decimals is not told again as what it is nearly.
        """
        if (
            note.startswith(NEARLY)
            and self.recorder.expanded(note) == f"{NEARLY} {latex(self._side(sides[-1], self.show))}"
        ):
            note = ""
        shown = [side for side in sides if holds and (not isinstance(side, str) or side)]
        if shown and _STATES.search(note):  # it goes on with the last side, or explains a name in it
            last = shown[-1] if isinstance(shown[-1], str) else self.recorder.value(shown[-1], "")
            shown[-1] = f"{last} {note}"
        return self._displayed([(shown, relation)], self.laid_out(sides, self.show, relation, note))

    def again(self, displayed: Displayed) -> Row:
        """Return a display a = b = ... as it was laid out."""
        self.recorder.begin()
        return self.laid_out([self._text(side) for side in displayed.sides], self.show, displayed.relation)

    def _text(self, side: Any) -> Any:
        """Return LaTeX with marks for its values; what is a value stays one."""
        if not isinstance(side, Written):
            return side
        return MARK.sub(lambda mark: self.tex(side.values[ord(mark[0]) - FIRST_MARK]), side.latex)

    def claim(self, claim: Claim, prefix: str = "", note: str = "") -> str:
        """Display both sides of a claim."""
        return self.eq(prefix, claim.left, claim.right, note=note)

    def supposed(self, unknown: Any, value: Any) -> str:
        """Return x = value for a line of text: a case, which is supposed and not claimed; a text is LaTeX."""
        return self.recorder.display([], f"${latex(row(self._side(unknown, self.show), EQUALS, self.show(value)))}$")

    def stands(self, name: str, value: Any = None) -> str:
        """Note that a name stands for another value from here on; show nothing."""
        return self.recorder.display([Displayed((self.recorder.written(name), value), STANDS)], "")

    def align(self, rows: Iterable[Iterable[Any]], *, holds: bool = True) -> str:
        """Display equations under each other, each given by its sides. Unless they hold, nothing is claimed.

        All their signs of equality stand under each other where all have as many sides, else the first ones.
        """
        chains = [list(row) for row in rows]
        ragged = len({len(sides) for sides in chains}) > 1
        lines = []
        for first, *others in chains:
            cells = [row(EQUALS, self._side(side, self.show)) for side in others]
            lines.append((self._side(first, self.show), *([row(*cells)] if ragged else cells)))
        return self._displayed([(sides, "=") for sides in chains if holds], aligned(lines))

    def _displayed(self, chains: Iterable[tuple[list[Any], str]], formula: Row) -> str:
        return self._noted(chains, display(latex(formula)))

    def _noted(self, chains: Iterable[tuple[list[Any], str]], text: str) -> str:
        """Note the chains of a display (each with its relation); return the mark of the display."""
        recorder = self.recorder
        noted = [
            Displayed(tuple(recorder.written(side) if isinstance(side, str) else side for side in sides), relation)
            for sides, relation in chains
            if sides
        ]
        return recorder.display(noted, text)

    def pieces(self, named: Iterable[tuple[str, Any]]) -> str:
        """Return `name = value` for each value that is given, as many on a line as fit; T = T is left out."""
        lines: list[Row] = []
        known = [(name, value) for name, value in named if value is not None and str(value) != name]
        for name, value in known:
            piece = row(name, EQUALS, self.show(entry_alone(value)))
            longer = row(lines[-1], GAP, piece) if lines else piece
            if lines and width(longer) <= LINE:
                lines[-1] = longer
            else:
                lines.append(piece)
        text = "".join(display(latex(line)) for line in lines)
        return self._noted([([name, value], "=") for name, value in known], text)

    def operation(self, operation: Any) -> str:
        """Return a row operation as LaTeX."""
        return latex(row_operation(operation, self.show))


ARITHMETIC = frozenset({"product", "total", "difference", "quotient", "power"})


def is_of_numbers(value: Any) -> bool:
    """Whether a formula is arithmetic with matrices of one entry each: [2] − [3][1] is 2 − 3·1."""
    if not isinstance(value, Stated) or value.operation not in ARITHMETIC:
        return False
    inner = [each for each in value.operands if isinstance(each, Stated)]
    matrices = [each for each in value.operands if isinstance(each, sp.MatrixBase)]
    return bool(matrices or inner) and all(M.shape == (1, 1) for M in matrices) and all(map(is_of_numbers, inner))


def as_numbers(value: Any) -> Any:
    """Return a formula with the entries in place of matrices of one entry that are factors or terms in it."""
    if not isinstance(value, Stated):
        return entry_alone(value)
    if value.operation in ARITHMETIC or (value.operation == "inverse" and is_of_numbers(*value.operands)):
        return Stated(value.operation, tuple(map(as_numbers, value.operands)))
    return value


def word_of(symbol: str) -> str:
    """Return the word that an answer has in place of a symbol, or "": whether the system is stable equals nothing."""
    only = read(symbol).items if symbol else ()
    return only[0].words if len(only) == 1 and isinstance(only[0], Text) else ""
