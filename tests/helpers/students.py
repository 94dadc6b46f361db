"""How a student writes our answers, and how answers go wrong: for tests of marking over all tasks."""

import json
from collections.abc import Iterator
from itertools import pairwise
from typing import Any

import sympy as sp

from solver.patches import Program, data_of
from solver.render.plain import sympy_text


def written(value: Any) -> str:
    """A value as it stands in an answer file (YAML in the flow style, which JSON is a part of)."""
    return json.dumps(_data(value), ensure_ascii=False)


def _data(value: Any) -> Any:
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, str):
        return value
    if isinstance(value, list | tuple):
        return [_data(each) for each in value]
    if isinstance(value, sp.MatrixBase):
        return [[_data(entry) for entry in row] for row in value.tolist()]
    if isinstance(value, Program):
        return data_of(value, sympy_text, sympy_text)
    if value in (sp.true, sp.false):
        return "always" if value else "never"
    if isinstance(value, sp.And | sp.Or):
        return (" and " if isinstance(value, sp.And) else " or ").join(
            f"({_data(each)})" if isinstance(each, sp.And | sp.Or) else _data(each) for each in value.args
        )
    if isinstance(value, sp.Rel):
        return f"{_data(value.lhs)} {'=' if isinstance(value, sp.Eq) else value.rel_op} {_data(value.rhs)}"
    return sympy_text(_with_arctangents(value)).replace("sqrt(-1)", "j")


def _with_arctangents(value: Any) -> Any:
    """An angle as the notation can say it: twice the arctangent of half of it."""
    if not isinstance(value, sp.Basic):
        return value
    return value.replace(sp.atan2, lambda y, x: 2 * sp.atan(y / (x + sp.sqrt(x**2 + y**2))))


def rounded(value: Any, digits: int = 4) -> Any:
    """The value with its irrational numbers rounded to some significant digits; None where it has none."""
    if isinstance(value, list):
        rough = [rounded(each, digits) for each in value]
        return (
            [b if b is not None else a for a, b in zip(value, rough, strict=True)]
            if any(r is not None for r in rough)
            else None
        )
    if isinstance(value, sp.MatrixBase):
        rough = [rounded(each, digits) for each in value.flat()]
        if all(each is None for each in rough):
            return None
        return sp.ImmutableMatrix(
            *value.shape, [b if b is not None else a for a, b in zip(value.flat(), rough, strict=True)]
        )
    if not isinstance(value, sp.Expr) or not value.is_number or value.is_Rational:
        return None
    real, imaginary = value.evalf(30).as_real_imag()
    if real.is_Rational and imaginary.is_Rational:
        return None
    return _decimal(real, digits) + sp.I * _decimal(imaginary, digits)


def _decimal(number: Any, digits: int) -> Any:
    return sp.Symbol(f"{float(number):.{digits}g}") if abs(number) > 1e-12 else sp.Integer(0)


def mutants(value: Any) -> Iterator[tuple[str, Any]]:
    """Changed values, each with what was done to it. Some may still be right."""
    if isinstance(value, bool):
        yield "flipped", not value
    elif isinstance(value, str):
        yield "other word", "unstable" if value != "unstable" else "asymptotically stable"
    elif isinstance(value, list | tuple):
        yield from _of_list(list(value))
    elif isinstance(value, sp.MatrixBase):
        yield from _of_matrix(value)
    elif isinstance(value, sp.Expr):
        yield "plus one", value + 1
        yield "sign reversed", -value
        yield "halved", value / 2
        for symbol in sorted(value.free_symbols, key=str)[:2]:
            yield f"-{symbol}", value.xreplace({symbol: -symbol})
    elif isinstance(value, sp.logic.boolalg.Boolean):
        yield from _of_condition(value)


def _of_list(value: list[Any]) -> Iterator[tuple[str, Any]]:
    for i, item in enumerate(value):
        yield f"item {i + 1} dropped", value[:i] + value[i + 1 :]
        for what, changed in list(mutants(item))[:3]:
            yield f"item {i + 1}: {what}", [*value[:i], changed, *value[i + 1 :]]
    if value:
        yield "an item twice", [*value, value[-1]]
    if value and all(isinstance(item, sp.Expr) for item in value):
        yield "signs reversed", [-item for item in value]


def _of_matrix(M: sp.MatrixBase) -> Iterator[tuple[str, Any]]:
    for i in range(M.rows):
        for j in range(M.cols):
            yield f"entry {i + 1}, {j + 1} plus one", _with(M, {(i, j): M[i, j] + 1})
            yield f"entry {i + 1}, {j + 1} sign reversed", _with(M, {(i, j): -M[i, j]})
    yield "sign reversed", sp.ImmutableMatrix(-M)
    yield "transposed", sp.ImmutableMatrix(M.T)
    if len(M) > 1:
        places = [(i, j) for i in range(M.rows) for j in range(M.cols)]
        for a, b in pairwise(places):
            if M[a] != M[b]:
                yield f"entries {a} and {b} swapped", _with(M, {a: M[b], b: M[a]})
        yield "zero", sp.ImmutableMatrix(sp.zeros(*M.shape))
    if M.cols > 1:
        yield "last column dropped", sp.ImmutableMatrix(M[:, :-1])


def _of_condition(condition: Any) -> Iterator[tuple[str, Any]]:
    yield "always", sp.true if condition is not sp.true else sp.false
    yield "never", sp.false if condition is not sp.false else sp.true
    if isinstance(condition, sp.Rel) and not isinstance(condition, sp.Eq):
        yield "reversed", condition.reversedsign.__class__(condition.rhs, condition.lhs)
    if isinstance(condition, sp.And | sp.Or):
        yield "one dropped", condition.func(*condition.args[1:])
        yield "and for or", (sp.Or if isinstance(condition, sp.And) else sp.And)(*condition.args)
    if isinstance(condition, sp.Eq):
        yield "moved", sp.Eq(condition.lhs, condition.rhs + 1, evaluate=False)


def _with(M: sp.MatrixBase, entries: dict[tuple[int, int], Any]) -> Any:
    changed = M.as_mutable()
    for place, entry in entries.items():
        changed[place] = entry
    return sp.ImmutableMatrix(changed)
