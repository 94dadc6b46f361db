r"""Values within words: messages say `$\lambda = {formula(mode)}$`.

Pages print values with `solver.render`, in the display their problem asks for. A message is a text from the start, so
its values are printed here, by sympy, in the spelling of the pages: j for the imaginary unit, decimals of five digits.
"""

from __future__ import annotations

from typing import Any

DIGITS = 5


def formula(value: Any) -> str:
    """Return an expression or matrix as LaTeX, without dollars."""
    import sympy as sp  # noqa: PLC0415 - the declarations of tasks, which import this file, do not wait for sympy

    rounded = {number: sp.Float(number, DIGITS) for number in value.atoms(sp.Float)}
    return str(sp.latex(value.xreplace(rounded), imaginary_unit="j", ln_notation=True, mat_str="bmatrix", mat_delim=""))
