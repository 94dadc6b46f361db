"""Lemma: the point that a system is linearized at, and what must hold for it to be an equilibrium."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.calculus import value_at
from solver.tasks.modelling.first_order import FirstOrder
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.jets import Jet
    from solver.systems import Equations


LONG = 10**9
"""Denominators that only decimals with many digits have."""
ROUNDING = 1e-10
"""What decimals of 15 digits leave of terms that add up to zero."""


@dataclass(frozen=True, slots=True)
class OperatingPoint:
    """A value for every state and input, its own name where none is given, and `conditions` for an equilibrium.

    `free` are the states and inputs that stand for their own values.
    """

    values: dict[Symbol, Expr]
    conditions: tuple[Any, ...] = ()
    free: tuple[Symbol, ...] = ()


@lemma("operating_point")
def operating_point_of(found: FirstOrder, at: Mapping[Any, Any]) -> Derivation[OperatingPoint]:
    """The point with the names that are not given, and the conditions under which it is at rest. Raises Unsolved."""
    model = found.model
    given = _given(model, found.states, at)
    point = _whole(model, found.states, given)
    conditions = _conditions(found, point)
    forced = {c.lhs: c.rhs for c in conditions if c.lhs.is_Symbol and c.rhs.is_number}
    if forced:
        point = _whole(model, found.states, {**given, **forced})
        rest = _conditions(found, point)
        conditions = (*(c for c in conditions if c.lhs in forced), *rest)
    values = point.values
    kept = list(values.items())
    claims = {}
    residuals = list(found.f) if not model.discrete else [f - x for f, x in zip(found.f, found.X, strict=True)]
    if not conditions:
        for i, residual in enumerate(residuals, 1):
            claims[f"rest{i}"] = _at_rest(residual, values, Phrase("row {i} at the point", i=i))
    yield Step("point", claims=claims, unclaimed="" if claims else "conditions, which the verification judges",
               values=kept, conditions=conditions, free=point.free, discrete=model.discrete)  # fmt: skip
    return OperatingPoint(values, conditions, point.free)


def _at_rest(residual: Expr, values: Mapping[Symbol, Expr], says: Phrase) -> Claim:
    """A row is zero at the point; in decimals its largest term is what the others add up to."""
    sums: list[Any] = [each for each in sp.Mul.make_args(sp.fraction(residual)[0]) if each.is_Add]
    if sums and any(map(_is_long, values.values())):
        sizes = {term: sp.N(term.xreplace(dict(values))) for term in sums[0].args}
        if all(size.is_number and size.is_finite for size in sizes.values()):
            largest = max(sums[0].args, key=lambda term: abs(sizes[term]))
            return Claim(_put_in(largest, values), _put_in(largest - sums[0], values), says)
    return Claim(_put_in(residual, values), sp.S.Zero, says)


def point_of(model: Equations, states: Sequence[Jet], at: Mapping[Any, Any]) -> OperatingPoint:
    """Return the point as it is given, whether it is one of rest or not. Raises Unsolved for an unknown name."""
    return _whole(model, states, _given(model, states, at))


def _given(model: Equations, states: Sequence[Jet], at: Mapping[Any, Any]) -> dict[Symbol, Expr]:
    """The values that are given, by the symbols of the model; those in terms of others put in."""
    symbols = [model.symbol(jet) for jet in [*states, *((name, 0) for name in model.inputs)]]
    names = {str(symbol): symbol for symbol in symbols}
    names |= {name: model.symbol((name, 0)) for name in (*(name for name, _ in states), *model.inputs)}
    wrong = [str(name) for name in at if str(name) not in names and not _is_derivative(model, str(name))]
    if wrong:
        raise Unsolved("linearization/unknown_name", name=wrong[0], names=symbols)
    own = {name: symbol for name, symbol in names.items() if str(symbol) == name or model.discrete}
    values = {names[str(name)]: _renamed(value, own) for name, value in at.items() if str(name) in names}
    for _ in values:
        values = {symbol: value.xreplace({s: v for s, v in values.items() if s != symbol}) for symbol, value in
                  values.items()}  # fmt: skip
    return values


def _is_derivative(model: Equations, name: str) -> bool:
    """Whether a name is that of a derivative of an unknown, which need not be a state."""
    return any(name == str(model.symbol((each, k))) for each in model.unknowns for k in range(13))


def _renamed(value: Expr, own: Mapping[str, Symbol]) -> Expr:
    """The value with the symbols of the model for its names."""
    symbols: Any = value.free_symbols
    renamed: Expr = value.xreplace({s: own[s.name] for s in symbols if s.name in own})
    return renamed


def _whole(model: Equations, states: Sequence[Jet], given: Mapping[Symbol, Expr]) -> OperatingPoint:
    """Every state and input: as given, a derivative (discrete: a later sample) as at rest, else its own name."""
    values, free = {}, []
    for name, order in [*states, *((name, 0) for name in model.inputs)]:
        symbol, first = model.symbol((name, order)), model.symbol((name, 0))
        usual = (given.get(first, first) if model.discrete else sp.S.Zero) if order else first
        values[symbol] = given.get(symbol, usual)
        if values[symbol] == symbol:
            free.append(symbol)
    return OperatingPoint(values, (), tuple(free))


def _conditions(found: FirstOrder, point: OperatingPoint) -> tuple[Any, ...]:
    """What names and parameters must satisfy for f (discrete: f − x) to vanish. Raises Unsolved where they cannot."""
    model, values = found.model, point.values
    inputs = [symbol for symbol in found.U if symbol in point.free]
    names = [*inputs, *(symbol for symbol in point.free if symbol not in inputs)]
    conditions: dict[Any, None] = {}
    for residual in _residuals(found, values):
        try:
            left = exact.put_in(residual, values)
            condition = sp.true if _is_rounding(left, residual, values) else exact.condition_of(left, names)
        except exact.NotDifferentiable:
            raise Unsolved("linearization/undefined", values=list(values.items())) from None
        if condition is sp.false:
            raise Unsolved("linearization/no_equilibrium", values=list(values.items()), residual=_f_at(found, values),
                           discrete=model.discrete)  # fmt: skip
        if condition is not sp.true:
            conditions[condition] = None
    return tuple(conditions)


def _is_rounding(left: Expr, residual: Expr, values: Mapping[Symbol, Expr]) -> bool:
    """Whether a residual is what a point in decimals leaves, which an earlier part found: small beside its terms."""
    if left.free_symbols or left == 0 or not any(map(_is_long, values.values())):
        return False
    terms = [abs(sp.N(term.xreplace(dict(values)))) for term in sp.Add.make_args(residual)]
    return bool(abs(sp.N(left)) < ROUNDING * max(terms))


def _is_long(value: Expr) -> bool:
    """Whether a value is a fraction that stands for a decimal with many digits."""
    return bool(value.is_Rational and sp.fraction(value)[1] > LONG)


def _residuals(found: FirstOrder, values: Mapping[Symbol, Expr]) -> Sequence[Expr]:
    """What must vanish: the equations themselves with nothing in motion, or f where more was eliminated from them."""
    model = found.model
    inside = set().union(*(side.free_symbols for pair in model.sides for side in pair))
    unknown = {model.symbol((name, k)) for name in model.unknowns for k in range(13)} & inside
    moving = {model.symbol((name, k)) for name, k in model.jets.values() if name in model.unknowns and k} - set(found.X)
    if model.discrete or unknown - moving - set(found.X):
        return [f - x for f, x in zip(found.f, found.X, strict=True)] if model.discrete else found.f
    still = dict.fromkeys(moving, sp.S.Zero)
    derivatives = [symbol for symbol, (_, k) in zip(found.X, found.states, strict=True) if k and values[symbol] != 0]
    return [*derivatives, *((left - right).xreplace(still) for left, right in model.sides)]


def _f_at(found: FirstOrder, values: Mapping[Symbol, Expr]) -> Any:
    """F at the point (discrete: f − x), the residual."""
    rows = [exact.put_in(f - x if found.model.discrete else f, values) for f, x in zip(found.f, found.X, strict=True)]
    return sp.ImmutableMatrix(rows)


def _put_in(expression: Expr, values: Mapping[Symbol, Expr]) -> Any:
    stated: Any = expression
    for symbol, value in values.items():
        if symbol != value and expression.has(symbol):
            stated = value_at(stated, symbol, value)
    return stated
