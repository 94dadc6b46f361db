"""Answers as fields: a scalar, a matrix, a list in ascending order, names with values, bounds of a parameter."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp

from solver.formula import latex, read
from solver.papers.export.decimals import complex_parts, exactly
from solver.papers.export.quiz import Field, Fixed
from solver.papers.export.scalars import Cells, Complex, Numbers, Real, Scalar, scalar_of
from solver.render.displays import entry_name
from solver.words import formula

MOST_FIELDS = 60
"""A learning system shows no more on one page that a student can find the way in."""

ASCENDING = "In these fields the values stand in ascending order, each as often as it counts."
COMPLEX_ORDER = "Their order is that of the real parts, of equal ones that of the imaginary parts."
IN_ORDER = "In these fields the values stand in their order."
POINTS = "In these fields the points stand in ascending order of the first value, of equal ones of the next."
BOUNDS = "The fields are the bounds."

_COUNTED = re.compile(r"_(?:[ik]|\{(?:[ik]|1, ?2)\})$")

TIE = 20
"""Digits to which values are ordered: what differs less is the same number computed in two ways."""


@dataclass(frozen=True)
class Shape:
    """How an answer is laid out: scalars, each behind its name (LaTeX) and with words that tell its place.

    `kind` is "scalar", "matrix", "list", "points", "names" or "bounds"; `names` are those of a point or mapping,
    `rows` the number of rows of a matrix. `told` says how it is typed (phrases).
    """

    kind: str
    scalars: tuple[Scalar, ...]
    leads: tuple[str, ...]
    told: tuple[str, ...]
    names: tuple[str, ...] = ()
    rows: int = 1
    ordered: bool = False
    bounds: tuple[str, ...] = ()

    @property
    def is_grid(self) -> bool:
        """Whether it is a matrix with one field an entry."""
        return self.kind == "matrix" and all(isinstance(each, Real) for each in self.scalars)

    @property
    def count(self) -> int:
        """The number of fields."""
        return sum(each.count for each in self.scalars)

    def numbers(self, value: Any) -> Numbers | None:
        """Return the numbers of a value in the order of the fields, None where it does not have this shape."""
        parts = self._parts(value)
        if parts is None or len(parts) != len(self.scalars):
            return None
        found: Numbers = []
        for scalar, part in zip(self.scalars, parts, strict=True):
            numbers = scalar.numbers(part)
            if numbers is None:
                return None
            found += numbers
        return found

    def _parts(self, value: Any) -> list[Any] | None:
        match self.kind:
            case "scalar":
                return [value]
            case "matrix":
                shape = (self.rows, len(self.scalars) // self.rows)
                return list(value.flat()) if getattr(value, "shape", ()) == shape else None
            case "bounds":
                found = bounds_of(value)
                return (
                    [each for _, each in found[1]] if found and tuple(s for s, _ in found[1]) == self.bounds else None
                )
            case "list":
                return in_order(value, self.ordered) if isinstance(value, list | tuple) else None
            case "names":
                return _by_names([value], self.names)
        return _by_names(value, self.names)

    def lines(self, fields: Sequence[Field]) -> tuple[Cells, ...]:
        """Return the fields on their lines."""
        if self.is_grid:
            width = len(fields) // self.rows
            return tuple(tuple(fields[i : i + width]) for i in range(0, len(fields), width))
        if self.kind == "bounds":
            return (self._bounds(fields),)
        found: list[Cells] = []
        left = list(fields)
        for scalar, lead in zip(self.scalars, self.leads, strict=True):
            found += scalar.lines(lead, left[: scalar.count])
            del left[: scalar.count]
        return tuple(found)

    def _bounds(self, fields: Sequence[Field]) -> Cells:
        name = self.leads[0]
        if len(fields) == 1:
            return (Fixed(f"{name} {_RELATIONS[self.bounds[0]]}"), fields[0])
        low, high = (_RELATIONS[sign] for sign in self.bounds)
        return (fields[0], Fixed(f"{_RELATIONS[_TURNED[low]]} {name} {high}"), fields[1])

    def typed(self, texts: Sequence[str]) -> str:
        """Return the whole value as a student types it into an answer file."""
        parts, left = [], list(texts)
        for scalar in self.scalars:
            parts.append(scalar.typed(left[: scalar.count]))
            del left[: scalar.count]
        match self.kind:
            case "scalar":
                return parts[0]
            case "matrix":
                width = len(parts) // self.rows
                rows = [", ".join(parts[i : i + width]) for i in range(0, len(parts), width)]
                return f"[{', '.join(f'[{row}]' for row in rows)}]"
            case "list":
                return f"[{', '.join(parts)}]"
            case "bounds":
                name = self.names[0]
                return " and ".join(f"{name} {sign} {part}" for sign, part in zip(self.bounds, parts, strict=True))
        width = len(self.names)
        points = [", ".join(f'"{name}": "{part}"' for name, part in zip(self.names, parts[i : i + width], strict=True))
                  for i in range(0, len(parts), width)]  # fmt: skip
        return "{" + points[0] + "}" if self.kind == "names" else "[" + ", ".join(f"{{{p}}}" for p in points) + "]"

    @property
    def places(self) -> list[list[tuple[str, dict[str, Any]]]]:
        """For each field the phrases that tell its place in the answer, with their values."""
        found: list[list[tuple[str, dict[str, Any]]]] = []
        width = max(1, len(self.scalars) // self.rows)
        for i, scalar in enumerate(self.scalars):
            place: tuple[str, dict[str, Any]] = ("", {})
            if self.kind == "matrix":
                place = ("row {row}, column {column}", {"row": i // width + 1, "column": i % width + 1})
            elif len(self.scalars) > 1:
                place = ("value {number}", {"number": i + 1})
            found += [[place, part] for part in scalar.parts]
        return found


_RELATIONS = {"<": "<", "<=": r"\le", ">": ">", ">=": r"\ge"}
_TURNED = {">": "<", r"\ge": "<=", "<": ">", r"\le": ">="}


def shape_of(value: Any, symbol: str, *, ordered: bool) -> Shape | None:
    """Return the shape of an answer with this symbol (LaTeX), None where no fields can ask for it."""
    shape = _shape(value, symbol, ordered=ordered)
    if shape is None or not 0 < shape.count <= MOST_FIELDS or shape.numbers(value) is None:
        return None
    extra = dict.fromkeys(words for scalar in shape.scalars for words in scalar.told)
    return replace(shape, told=(*shape.told, *extra))


def _shape(value: Any, symbol: str, *, ordered: bool) -> Shape | None:
    if isinstance(value, sp.MatrixBase):
        return _matrix(value, symbol)
    if isinstance(value, list | tuple) and value and all(isinstance(each, Mapping) for each in value):
        return _points(value)
    if isinstance(value, list | tuple):
        return _list(value, symbol, ordered=ordered)
    if isinstance(value, Mapping):
        names = tuple(map(str, value))
        return _of_scalars("names", list(value.values()), [formula(sp.Symbol(name)) for name in names], names=names)
    if (found := bounds_of(value)) is not None:
        name, limits = found
        shape = _of_scalars("bounds", [each for _, each in limits], [formula(sp.Symbol(name))] * len(limits), (BOUNDS,))
        return shape and replace(shape, names=(name,), bounds=tuple(sign for sign, _ in limits))
    return _of_scalars("scalar", [value], [symbol])


def _of_scalars(
    kind: str, values: Sequence[Any], leads: Sequence[str], told: tuple[str, ...] = (), names: tuple[str, ...] = ()
) -> Shape | None:
    scalars = [scalar_of(each) for each in values]
    if None in scalars:
        return None
    found = tuple(each for each in scalars if each is not None)
    if any(isinstance(each, Complex) for each in found):
        found = tuple(Complex() if isinstance(each, Real) else each for each in found)
    return Shape(kind, found, tuple(leads), told, names)


def _matrix(value: sp.MatrixBase, symbol: str) -> Shape | None:
    if 0 in value.shape:
        return None
    single = 1 in value.shape
    places = [
        f"{max(i, j)}" if single else f"{i}{j}" for i in range(1, value.rows + 1) for j in range(1, value.cols + 1)
    ]
    leads = [_entry(symbol, place) for place in places] if len(places) > 1 else [symbol]
    shape = _of_scalars("matrix", value.flat(), leads)
    return shape and replace(shape, rows=value.rows)


def _list(value: Sequence[Any], symbol: str, *, ordered: bool) -> Shape | None:
    numeric = all(complex_parts(each) is not None for each in value)
    if not value or not (numeric or ordered):
        return None
    told: tuple[str, ...] = (IN_ORDER,) if ordered else (ASCENDING,)
    leads = [_entry(symbol, str(i)) for i in range(1, len(value) + 1)] if len(value) > 1 else [symbol]
    shape = _of_scalars("list", in_order(value, ordered), leads, told if len(value) > 1 else ())
    return shape and replace(shape, ordered=ordered)


def with_parts(shape: Shape) -> Shape:
    """Return a list of numbers with two fields for each: those that it has must not tell that all of them are real."""
    if shape.kind != "list" or shape.ordered or shape.count == 1:
        return shape
    return replace(
        shape, scalars=tuple(Complex() for _ in shape.scalars), told=(ASCENDING, COMPLEX_ORDER, *Complex().told)
    )


def _points(value: Sequence[Mapping[Any, Any]]) -> Shape | None:
    names = tuple(map(str, value[0]))
    values = _by_names(value, names)
    if values is None or any(exactly(each) is None for each in values):
        return None
    leads = [formula(sp.Symbol(name)) for name in names]
    numbered = [f"({i}){lead}" if len(value) > 1 else lead for i in range(1, len(value) + 1) for lead in leads]
    return _of_scalars("points", values, numbered, (POINTS,) if len(value) > 1 else (), names)


def _entry(symbol: str, index: str) -> str:
    r"""Return the name of an entry; an index that counts, as in \lambda_{i} and s_{1,2}, gives way to its number."""
    return latex(entry_name(read(_COUNTED.sub("", symbol)), index))


def in_order(value: Sequence[Any], ordered: bool) -> list[Any]:
    """Return numbers in ascending order of the real parts, then of the imaginary ones; what is `ordered` as it is."""
    parts = [complex_parts(each) for each in value]
    if ordered or None in parts:
        return list(value)
    size = max((abs(x) for pair in parts if pair for x in pair), default=0) or 1
    keys = [tuple(round(x / size * 10**TIE) for x in pair or ()) for pair in parts]
    return [value[i] for i in sorted(range(len(value)), key=keys.__getitem__)]


def _by_names(value: Any, names: tuple[str, ...]) -> list[Any] | None:
    """Return the values of points in ascending order, each by the names in their order."""
    if not isinstance(value, list | tuple) or not all(isinstance(each, Mapping) for each in value):
        return None
    points = [{str(name): each for name, each in point.items()} for point in value]
    if any(set(point) != set(names) for point in points):
        return None
    rows = [[point[name] for name in names] for point in points]
    numbers = [[exactly(each) for each in row] for row in rows]
    if any(None in row for row in numbers):
        return rows[0] if len(rows) == 1 else None
    keys = [[round((each or 0) * 10**TIE) for each in row] for row in numbers]
    return [each for i in sorted(range(len(rows)), key=keys.__getitem__) for each in rows[i]]


def bounds_of(value: Any) -> tuple[str, list[tuple[str, Any]]] | None:
    """Return the parameter of a condition and its bounds with their signs, the lower one first; None for any other."""
    if not isinstance(value, sp.And | sp.core.relational.Relational):
        return None
    lower, upper = list[tuple[str, Any]](), list[tuple[str, Any]]()
    relations: list[Any] = list(sp.And.make_args(value))
    names = {str(symbol) for symbol in value.free_symbols}
    for each in relations:
        if getattr(each, "rel_op", "") not in _RELATIONS:
            return None
        turned: Any = each if isinstance(each.lhs, sp.Symbol) else each.reversed
        if not isinstance(turned.lhs, sp.Symbol) or exactly(turned.rhs) is None:
            return None
        (lower if turned.rel_op in {">", ">="} else upper).append((turned.rel_op, turned.rhs))
    if len(names) != 1 or len(lower) > 1 or len(upper) > 1:
        return None
    return next(iter(names)), [*lower, *upper]
