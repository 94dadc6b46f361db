"""What is asked, read apart from the program: a question of a problem file, and its numbers at a point.

A point gives each symbol of a question a value that `assume` and `conditions` allow. The reader of expressions is
sympy's own, so that a mistake in the program's reader is seen too.
"""

import itertools
import random
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
import sympy as sp
import yaml
from sympy.parsing.sympy_parser import implicit_multiplication, parse_expr, rationalize, standard_transformations

NAMES = re.compile(r"[A-Za-z_]\w*")
PRIMES = re.compile(r"([A-Za-z_]\w*)('+)")
COMPARED = re.compile(r"<=|>=|!=|<|>")
TRANSFORMATIONS = (*standard_transformations, implicit_multiplication, rationalize)
delta = sp.Function("delta")
MEANINGS = {
    **{name: getattr(sp, name) for name in "sqrt exp log sin cos tan asin acos atan sinh cosh tanh pi".split()},
    **{"abs": sp.Abs, "step": lambda x: sp.Heaviside(x, 1), "delta": delta, "j": sp.I, "e": sp.E},
    "inv": sp.Function("inv"),
}
CONTINUOUS, DISCRETE = {"s", "t"}, {"z", "k"}


@dataclass(frozen=True)
class Question:
    """One part of a problem file, as its author wrote it."""

    id: str
    task: str
    system: Mapping[str, Any]
    options: Mapping[str, Any]
    assume: Mapping[str, str] = field(default_factory=dict)
    conditions: tuple[str, ...] = ()

    @property
    def discrete(self) -> bool:
        """Whether time is discrete."""
        return self.system.get("time") == "discrete"

    @property
    def symbols(self) -> list[str]:
        """The names of the question that stand for numbers."""
        used = set(_names([self.system, self.options]))
        return sorted(used - (DISCRETE if self.discrete else CONTINUOUS) - set(MEANINGS) - _unknowns(self.system))


SAID = {"method", "form", "convention", "part", "kind", "property", "parameter", "parameters", "function", "measured"}
SAID_OF_SYSTEMS = {"time", "inputs", "outputs", "algebraic"}
OF_THE_PART = {"task", "system", "assume", "conditions"}


def questions_in(path: Path) -> list[Question]:
    """The questions of a problem file each part of which has all it is about."""
    return [read(name, asked) for name, asked in yaml.safe_load(path.read_text(encoding="utf-8"))["find"].items()]


def read(name: str, asked: Mapping[str, Any]) -> Question:
    """A question from its lines in a file."""
    options = {key: value for key, value in asked.items() if key not in OF_THE_PART}
    conditions = tuple(asked.get("conditions", ()))
    return Question(name, asked["task"], asked.get("system", {}), options, asked.get("assume", {}), conditions)


def parsed(raw: Any, evaluate: bool = True) -> sp.Expr:
    """An expression as sympy reads it, exactly; as it was written if it is not to be evaluated."""
    return _parsed(raw, evaluate) if isinstance(raw, str) else sp.Rational(str(raw))


@lru_cache(maxsize=4096)
def _parsed(raw: str, evaluate: bool) -> sp.Expr:
    text = raw.replace("^", "**")
    known = {name: sp.Symbol(name) for name in NAMES.findall(text)} | MEANINGS
    return parse_expr(text, known, TRANSFORMATIONS, evaluate=evaluate)


def poles_in(raw: list[Any]) -> list[sp.Expr]:
    """Poles as expressions, a pair as two."""
    written = itertools.chain.from_iterable(
        (str(pole).replace("±", "+"), str(pole).replace("±", "-")) if "±" in str(pole) else (pole,) for pole in raw
    )
    return [parsed(pole) for pole in written]


def _names(raw: Any) -> Iterator[str]:
    if isinstance(raw, str):
        yield from NAMES.findall(re.sub(r"\b[\d.]+e-?\d+", "", raw))
    elif isinstance(raw, Mapping):
        for key, value in raw.items():
            if key not in SAID | SAID_OF_SYSTEMS:
                yield from _names(value)
    elif isinstance(raw, list):
        for each in raw:
            yield from _names(each)


def _unknowns(system: Mapping[str, Any]) -> set[str]:
    """The names in differential equations that stand for functions of time."""
    text = " ".join(system.get("equations", ()))
    moving = {name for name, _ in PRIMES.findall(text)} | set(re.findall(r"([A-Za-z_]\w*)\(k", text))
    return moving | set(system.get("inputs", ())) | set(system.get("algebraic", ()))


class Point:
    """A question with a value for each of its symbols."""

    def __init__(self, question: Question, values: Mapping[str, sp.Expr], seed: str = "") -> None:
        self.question = question
        self.values = {sp.Symbol(name): value for name, value in values.items()}
        self.random = random.Random(seed)
        self.discrete = question.discrete

    def exactly(self, raw: Any, **more: Any) -> sp.Expr:
        """A value of the question at this point; what else is named keeps its letter."""
        expression = raw if isinstance(raw, sp.Basic) else parsed(raw)
        return expression.subs(self.values | {sp.Symbol(name): value for name, value in more.items()})

    def number(self, raw: Any, **more: Any) -> complex:
        """A number of the question."""
        return complex(self.exactly(raw, **more).evalf(30))

    def option(self, name: str, default: Any = None) -> Any:
        """An option as it was written."""
        return self.question.options.get(name, default)

    def matrix(self, raw: Any, column: bool = False) -> np.ndarray:
        """A matrix of numbers; a flat list is a row, or a column if so asked."""
        rows = raw if isinstance(raw, list) else [[raw]]
        if not rows or not isinstance(rows[0], list):
            rows = [[each] for each in rows] if column else [rows]
        return real(np.array([[self.number(each) for each in row] for row in rows], dtype=complex))

    def roots(self, raw: list[Any]) -> np.ndarray:
        """Poles of the question."""
        return np.array([complex(self.exactly(pole).evalf(30)) for pole in poles_in(raw)])


def real(M: np.ndarray) -> np.ndarray:
    """The matrix without imaginary parts that are zero."""
    return M.real if not np.any(M.imag) else M


def points(question: Question, count: int = 2, widely: bool = False) -> Iterator[Point]:
    """So many points that the question allows; without symbols there is one."""
    dice = random.Random(question.id)
    made = 0
    for trial in range(4000):
        if made == (count if question.symbols else 1):
            return
        values = {name: _value(dice, question.assume.get(name, ""), widely) for name in question.symbols}
        point = Point(question, values, f"{question.id} {trial}")
        if all(holds(condition, point) for condition in question.conditions):
            made += 1
            yield point
    raise AssertionError(f"{question.id}: no point meets the conditions")


def _value(dice: random.Random, assumed: str, widely: bool) -> sp.Rational:
    size = sp.Rational(str(round(10 ** dice.uniform(-1.5, 3.5), 4) if widely else round(dice.uniform(0.3, 2.9), 3)))
    if "positive" in assumed:
        return size
    return -size if "negative" in assumed or dice.random() < (0.35 if not widely else 0.5) else size


def holds(condition: str, point: Point) -> bool:
    """Whether a chain of relations holds at a point."""
    sides = [point.exactly(side) for side in COMPARED.split(condition)]
    signs = COMPARED.findall(condition)
    relations = {"<": sp.Lt, ">": sp.Gt, "<=": sp.Le, ">=": sp.Ge, "!=": sp.Ne}
    return all(relations[sign](left, right) == True for left, sign, right in zip(sides, signs, sides[1:], strict=False))  # noqa: E712
