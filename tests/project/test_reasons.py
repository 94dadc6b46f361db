"""Reasons are data: every kind has a macro that words it, every macro a kind, and the kernels hold no prose."""

import ast
import re
from pathlib import Path

import pytest
import sympy as sp

from solver.messages import Messages
from solver.words import Reason, Told

ROOT = Path(__file__).parents[2]
TEMPLATES = ROOT / "templates" / "wording" / "reasons"
CARRIERS = {"Unsolved", "NotExact", "Inconsistent", "Reason"}
SENTENCE = re.compile(r"\w+ \w+ \w+")


def named(call):
    return call.func.attr if isinstance(call.func, ast.Attribute) else getattr(call.func, "id", "")


def kinds_raised():
    """Yield the kinds that the code names, with their places."""
    for path in sorted((ROOT / "solver").rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and named(node) in CARRIERS and node.args:
                for text in ast.walk(node.args[0]):
                    if isinstance(text, ast.Constant) and isinstance(text.value, str):
                        yield text.value, f"{path.relative_to(ROOT)}:{node.lineno}"


def kinds_worded():
    for path in sorted(TEMPLATES.glob("*.md.jinja")):
        for macro in re.findall(r"{%-? macro (\w+)\(v\)", path.read_text(encoding="utf-8")):
            yield f"{path.name.removesuffix('.md.jinja')}/{macro}"


def test_every_kind_of_reason_has_a_macro_and_every_macro_a_kind():
    raised, worded = dict(kinds_raised()), set(kinds_worded())
    assert not {kind: place for kind, place in raised.items() if kind not in worded}
    assert set(raised) >= worded


def for_programmers(tree):
    """Yield the docstrings, and the messages of errors that only a programmer meets (ValueError, KeyError)."""
    for node in ast.walk(tree):
        body = getattr(node, "body", None)
        for each in body if isinstance(body, list) else ():
            if isinstance(each, ast.Expr) and isinstance(each.value, ast.Constant):
                yield each.value
        if isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call) and named(node.exc).endswith("Error"):
            yield from ast.walk(node.exc)


@pytest.mark.parametrize("path", sorted((ROOT / "solver" / "exact").rglob("*.py")), ids=lambda path: path.stem)
def test_a_kernel_holds_no_prose(path):
    tree = ast.parse(path.read_text(encoding="utf-8"))
    unheard = {id(each) for each in for_programmers(tree)}
    texts = [each for each in ast.walk(tree) if isinstance(each, ast.Constant) and isinstance(each.value, str)]
    assert not [each.value for each in texts if id(each) not in unheard and SENTENCE.search(each.value)]


def test_a_reason_is_worded_by_the_macro_of_its_kind_in_one_line():
    mode = sp.Rational(-1, 2) + 3 * sp.I
    reason = Reason("placement/fixed_mode", {"mode": mode, "dual": True, "all_needed": False})
    assert str(reason) == (
        "The mode $- \\frac{1}{2} + 3 j$ is unobservable: no gain moves it, so it must be among the poles asked for "
        "(as often as it is unobservable), or only the poles of the observable part are to be given."
    )
    assert str(Told(reason)) == str(Told("placement/fixed_mode", mode=mode, dual=True, all_needed=False)) == str(reason)


def test_a_reason_may_hold_a_reason():
    why = Reason("second_order/contradiction", {"pair": ("peak_time", "overshoot"), "name": "rise_time"} | {
        "value": 1, "asked": 2,
    })  # fmt: skip
    assert str(Reason("second_order/cannot_be_met", {"why": why})) == (
        "The specifications cannot be met: peak time and overshoot give the rise time 1, not 2."
    )


@pytest.mark.parametrize(
    ("kind", "values", "words"),
    [
        ("stability/depends_on_parameters", {"conditions": (sp.Symbol("k") > 0, sp.Symbol("a") < 2)},
         "exactly for $k > 0$ and $a < 2$. Give the parameters"),
        ("gramian/grows_without_bound", {"outside": [sp.Integer(1), sp.Integer(2)], "discrete": False},
         "lie in the open left half plane; here $1$, $2$ do not, so the integral up to infinity grows"),
        ("observers/not_shown", {"modes": [sp.Integer(1)], "matrix": "A"},
         "The eigenvalue $1$ of $A$ cannot be moved by any gain, since the output does not show it. The poles"),
        ("observers/error_grows", {"pair": ("A", "C"), "mode": sp.Integer(1), "discrete": True},
         "The pair $(A, C)$ is not detectable: the eigenvalue $\\lambda = 1$ is unobservable, so no gain moves it, and "
         "it does not have $|\\lambda| < 1$. The"),
        ("observers/error_grows", {"pair": (), "mode": sp.Integer(1), "discrete": False},
         "The plant is not detectable: its eigenvalue $\\lambda = 1$ is unobservable, so no gain moves it, and it does "
         "not have $\\operatorname{Re}\\lambda < 0$."),
        ("regulators/not_stabilizable", {"dual": True, "modes": [sp.Integer(1), sp.Integer(2)]},
         "the modes $\\lambda = 1$, $\\lambda = 2$ are not asymptotically stable, and the output does not show them."),
        ("second_order/too_few", {"name": "peak_time"},
         "two specifications fix a pair of poles; only the peak time is given"),
        ("engine/unchecked", {"answers": ["K", "L"]}, "no check could be made of the answers K, L"),
        ("functions/division_by_zero", {"factor": sp.Symbol("lamda")}, "of the matrix ($\\lambda = 0$), so it"),
    ],
)  # fmt: skip
def test_values_stand_within_the_sentence(kind, values, words):
    said = Messages().reason(Reason(kind, values))
    assert words in said
    assert "  " not in said
