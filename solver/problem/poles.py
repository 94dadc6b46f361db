"""Lists of poles and zeros: complex numbers that are closed under conjugation."""

from __future__ import annotations

import sympy as sp

from solver.problem.lexicon import Lexicon
from solver.problem.nodes import Node, ScalarNode, SequenceNode
from solver.problem.source import Report

MAX_POLES = 24


def read_conjugate_list(node: Node, lexicon: Lexicon, noun: str = "pole") -> tuple[sp.Expr, ...]:
    """Return complex numbers in the order given; "-3 ± 2j" stands for two.

    Raises Fault, naming the number, where the conjugate of a number is missing.
    """
    items = node.items if isinstance(node, SequenceNode) else (node,)
    report = Report()
    placed: list[tuple[Node, sp.Expr]] = []
    for item in items:
        with report:
            placed.extend((item, sp.expand(value)) for value in lexicon.alternatives(item))
    report.conclude()
    if len(placed) > MAX_POLES:
        raise node.fault(f"there are {len(placed)} {noun}s; at most {MAX_POLES} can be read")
    _check_pairs(placed, report, noun)
    report.conclude()
    return tuple(value for _, value in placed)


def _check_pairs(placed: list[tuple[Node, sp.Expr]], report: Report, noun: str) -> None:
    """Report every number whose conjugate is missing."""
    left = [(place, value) for place, value in placed if not _same(value, sp.conjugate(value))]
    while left:
        place, value = left.pop(0)
        conjugate = sp.expand(sp.conjugate(value))
        partner = next((i for i, (_, other) in enumerate(left) if _same(other, conjugate) or _pair(value, other)), None)
        if partner is None:
            missing = sp.sstr(conjugate).replace("*I", "j").replace("I", "j")
            written = place.text if isinstance(place, ScalarNode) else noun
            note = f"complex {noun}s come in pairs: {missing} is missing"
            report.diagnostics.append(place.diagnostic(f"the {noun} {written} has no conjugate", note=note))
        else:
            del left[partner]


def _pair(a: sp.Expr, b: sp.Expr) -> bool:
    """Whether two expressions are the roots of a real quadratic, as σ ± jω√(1 − ζ²) are whatever ζ is."""
    if not (a.free_symbols or b.free_symbols):
        return False
    return all(_same(each, sp.conjugate(each)) for each in (sp.expand(a + b), sp.expand(a * b)))


def _same(a: sp.Expr, b: sp.Expr) -> bool:
    """Whether two numbers or expressions are equal; numbers that look different are compared to 30 digits."""
    difference = sp.expand(a - b)
    if difference == 0 or difference.free_symbols:
        return bool(difference == 0)
    scale = 1.0 if a.free_symbols else 1.0 + abs(complex(sp.N(a, 30)))
    return bool(abs(complex(sp.N(difference, 30))) < 1e-20 * scale)
