"""Names as formulas: Greek letters, subscripts, upright words."""

from __future__ import annotations

import re
from functools import lru_cache

from solver.formula import read
from solver.formula.building import row, separated
from solver.formula.nodes import Accent, Node, Number, Operator, Row, Scripts, Styled, Symbol

_SPELLED = (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa mu nu xi pi rho sigma tau upsilon phi chi psi omega "
    "Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega varphi vartheta varepsilon"
)

GREEK = {
    **{name: f"\\{name}" for name in _SPELLED.split()},
    "lamda": r"\lambda",
    "lambda": r"\lambda",
    "Lamda": r"\Lambda",
    "omicron": "o",
}
"""Words that stand for a Greek letter. `lamda` is the spelling that is no keyword of Python."""

_WITH_DIGITS = re.compile(r"([A-Za-z]+?)(\d+)\Z")
_DERIVED = re.compile(r"(\w+?)_(dot|ddot|dddot|d[4-9]|d1[0-2])")
"""Names of derivatives: x_dot, x_ddot, x_dddot, x_d4."""
VARIED = re.compile(rf"d((?!t\b)([a-z]|{'|'.join(GREEK)})(\d*)(_\w+)?)")
"""Names of variations: dx, dx1, dtheta_dot; dH is a difference, and stays as it is written."""
_SAMPLE = re.compile(r"(\w+)\((k(?:[+-]\d+)?)\)")
"""Names of samples: y(k+1)."""
_CHUNKS = re.compile(r"(\d+)")


@lru_cache(maxsize=2048)
def named(name: str) -> Row:
    r"""Return a name as it is written: `x10` x_{10}, `omega_n` \omega_n, `K_co` K_{\mathrm{co}}, `dx` \delta x."""
    if varied := VARIED.fullmatch(name):
        return row(Symbol(r"\delta"), *named(varied[1]).items)
    sample, derived = _SAMPLE.fullmatch(name), _DERIVED.fullmatch(name)
    if sample:
        return row(*named(sample[1]).items, *read(f"({sample[2]})").items)
    if derived and derived[2] in ("dot", "ddot", "dddot"):
        return _under(f"\\{derived[2]}", named(derived[1]))
    if derived:
        return row(Scripts(named(derived[1]), above=read(f"({derived[2][1:]})")))
    base, *subscripts = [part for part in name.split("_") if part] or [name]
    digits = _WITH_DIGITS.match(base)
    if digits and (len(digits[1]) == 1 or digits[1] in GREEK):
        base, subscripts = digits[1], [digits[2], *subscripts]
    if not subscripts:
        return row(_word(base))
    below = separated([row(_word(part)) for part in subscripts], Operator(","))
    short = len(subscripts) == 1 and (len(subscripts[0]) == 1 or subscripts[0] in GREEK)
    return row(Scripts(_word(base), below.items[0] if short else below))


def _under(dots: str, name: Row) -> Row:
    """Put dots over a name; its index stands beside them."""
    (item,) = name.items
    if isinstance(item, Scripts) and item.above is None:
        return row(Scripts(Accent(dots, row(item.base)), item.below))
    return row(Accent(dots, name))


def _word(word: str) -> Node:
    if word in GREEK:
        return Symbol(GREEK[word])
    if word.isdigit() and word.isascii():
        return Number(word)
    if len(word) == 1 or not word.isascii() or not word.isalnum():
        return Symbol(_escaped(word))
    return Styled(r"\mathrm", read(word))


def _escaped(word: str) -> str:
    r"""Return a name that came from elsewhere than a problem file (`t'`, `\beta`), without what TeX would act on."""
    return "".join(letter for letter in word if letter.isalnum() or letter in "'.,*") or "?"


@lru_cache(maxsize=2048)
def natural(name: str) -> tuple[tuple[int, int, str], ...]:
    """Return a key that sorts names as people do: k_2 before k_10."""
    chunks = (chunk for chunk in _CHUNKS.split(name) if chunk)
    return tuple((0, int(chunk), "") if chunk.isdigit() else (1, 0, chunk) for chunk in chunks)
