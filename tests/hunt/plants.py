"""The plants of questions as numbers: polynomials, transfer functions at points, state equations."""

import re
from collections.abc import Callable
from typing import Any

import numpy as np
import sympy as sp

from tests.hunt.asked import PRIMES, Point, parsed, real

POWER = sp.Symbol("power_of_time")
HIGHER = re.compile(r"([A-Za-z_]\w*)\^\((\d+)\)")
SAMPLES = re.compile(r"([A-Za-z_]\w*)\(k\s*([+-]\s*\d+)?\)")

Fraction = tuple[np.ndarray, np.ndarray]
"""Numerator and denominator, highest power first; nothing is cancelled."""


def fraction(point: Point, raw: Any) -> Fraction:
    """A rational function in s or z as it was written."""
    if isinstance(raw, dict):
        if "poles" in raw:
            top, bottom = np.poly(point.roots(raw.get("zeros", []))), np.poly(point.roots(raw["poles"]))
            return point.number(raw.get("gain", 1)) * np.atleast_1d(top), np.atleast_1d(bottom)
        return tuple(np.array([point.number(c) for c in raw[name]]) for name in ("numerator", "denominator"))
    return tidy(_of_tree(point, parsed(raw, evaluate=False)))


def tidy(found: Fraction) -> Fraction:
    """The same without leading zeros and with a monic denominator."""
    top, bottom = (np.trim_zeros(np.where(abs(p) < 1e-13, 0, p), "f") for p in found)
    return real(np.atleast_1d(top if len(top) else [0]) / bottom[0]), real(bottom / bottom[0])


def _of_tree(point: Point, tree: sp.Expr) -> Fraction:
    if tree in (sp.Symbol("s"), sp.Symbol("z")):
        return np.array([1, 0]), np.array([1])
    if tree.is_Add:
        total = (np.array([0]), np.array([1]))
        for each in tree.args:
            total = _sum(total, _of_tree(point, each))
        return total
    if tree.is_Mul:
        top, bottom = np.array([1]), np.array([1])
        for each in tree.args:
            more = _of_tree(point, each)
            top, bottom = np.polymul(top, more[0]), np.polymul(bottom, more[1])
        return top, bottom
    if tree.is_Pow and tree.has(sp.Symbol("s"), sp.Symbol("z")):
        power = int(tree.exp.doit())
        top, bottom = _of_tree(point, tree.base)
        whole = (np.array([1]), np.array([1]))
        for _ in range(abs(power)):
            whole = np.polymul(whole[0], top), np.polymul(whole[1], bottom)
        return whole if power > 0 else whole[::-1]
    return np.array([point.number(tree.doit())]), np.array([1])


def _sum(a: Fraction, b: Fraction) -> Fraction:
    if len(a[1]) == len(b[1]) and np.allclose(a[1], b[1]):
        return np.polyadd(a[0], b[0]), a[1]
    return np.polyadd(np.polymul(a[0], b[1]), np.polymul(b[0], a[1])), np.polymul(a[1], b[1])


def loop(point: Point) -> Fraction:
    """The transfer function of a system with one, with the controller and the feedback that are asked for."""
    top, bottom = fraction(point, point.question.system["transfer_function"])
    if point.option("controller") is not None:
        more = fraction(point, point.option("controller"))
        top, bottom = np.polymul(top, more[0]), np.polymul(bottom, more[1])
    feedback = point.option("feedback", "none")
    if feedback != "none":
        back = ([1], [1]) if feedback == "unity" else fraction(point, feedback)
        bottom = np.polyadd(np.polymul(bottom, back[1]), np.polymul(top, back[0]))
        top = np.polymul(top, back[1])
    return tidy((np.asarray(top), np.asarray(bottom)))


def companion(found: Fraction) -> tuple[np.ndarray, ...]:
    """The controllable canonical form, coefficients in the last row."""
    top, bottom = found
    n = len(bottom) - 1
    a = bottom[:0:-1]
    b = np.concatenate([np.zeros(n + 1 - len(top)), top])[::-1]
    A = np.vstack([np.eye(n, k=1)[:-1], -a[None, :]]) if n else np.zeros((0, 0))
    return A, np.eye(n)[:, -1:], (b[:-1] - a * b[-1])[None, :], np.array([[b[-1]]])


def matrices(point: Point) -> tuple[np.ndarray, ...]:
    """A, B, C, D as far as the question gives them, with the state feedback that is asked for."""
    system = point.question.system
    if "transfer_function" in system:
        return companion(loop(point))
    A = point.matrix(system["A"] if "A" in system else system["matrix"])
    n = len(A)
    B = point.matrix(system["B"], column=True) if "B" in system else np.zeros((n, 0))
    C = point.matrix(system["C"]) if "C" in system else np.zeros((0, n))
    D = point.matrix(system["D"]) if "D" in system else np.zeros((len(C), B.shape[1]))
    own = ("reference_tracking", "optimal_tracking", "observer_feedback")
    if point.option("gain") is not None and point.question.task not in own:
        K = point.matrix(point.option("gain"))
        A, C = A - B @ K, C - D @ K
    return A, B, C, D


def transfer(point: Point) -> Callable[[complex], np.ndarray]:
    """The transfer matrix of the question as a function of s or z."""
    system = point.question.system
    if "transfer_function" in system:
        top, bottom = loop(point)
        return lambda s: np.array([[np.polyval(top, s) / np.polyval(bottom, s)]])
    if "transfer_matrix" in system:
        entries = [[fraction(point, each) for each in row] for row in system["transfer_matrix"]]
        return lambda s: np.array([[np.polyval(a, s) / np.polyval(b, s) for a, b in row] for row in entries])
    if "equations" in system:
        return lambda s: _by_equations(point, s)
    A, B, C, D = matrices(point)
    return lambda s: C @ np.linalg.solve(s * np.eye(len(A)) - A, B) + D


def _by_equations(point: Point, s: complex) -> np.ndarray:
    """The outputs for unit inputs e^{st}: each derivative is a factor s, each step of time a factor z."""
    system = point.question.system
    values = point.values | {POWER: sp.sympify(complex(s))}
    sides = [map(parsed, map(_transformed, text.split("="))) for text in system["equations"]]
    expressions = [(left - right).subs(values) for left, right in sides]
    inputs = [sp.Symbol(name) for name in system["inputs"]]
    unknown = sorted(set().union(*(each.free_symbols for each in expressions)) - set(inputs), key=str)
    outputs = [parsed(_transformed(str(text))).subs(values) for text in system.get("outputs", [_first(system)])]
    columns = []
    for chosen in inputs:
        u = {each: int(each == chosen) for each in inputs}
        M, b = sp.linear_eq_to_matrix([each.subs(u) for each in expressions], unknown)
        solved = np.linalg.lstsq(np.array(M, dtype=complex), np.array(b, dtype=complex).ravel(), rcond=None)[0]
        now = u | dict(zip(unknown, map(sp.sympify, solved), strict=True))
        columns.append([complex(y.subs(now)) for y in outputs])
    return np.array(columns).T


def _transformed(text: str) -> str:
    """The equation with a power of s for each derivative, of z for each step of time."""
    text = HIGHER.sub(lambda found: f"({POWER}^{found[2]}*{found[1]})", text)
    text = PRIMES.sub(lambda found: f"({POWER}^{len(found[2])}*{found[1]})", text)
    return SAMPLES.sub(lambda found: f"({POWER}^({found[2] or 0})*{found[1]})", text)


def _first(system: dict[str, Any]) -> str:
    text = " ".join(system["equations"])
    names = [name for name, _ in PRIMES.findall(text)] or [name for name, _ in SAMPLES.findall(text)]
    return next(name for name in names if name not in system["inputs"])
