"""Lemma: all real solutions of equations, one unknown after the other, case by case."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.exact.modelling import Move, Roots


@lemma("solutions")
def solutions_of(
    equations: Sequence[Expr],
    unknowns: Sequence[Symbol],
    between: Mapping[Symbol, Any],
    taken: Sequence[str],
    told: Sequence[Symbol],
    known: Mapping[Symbol, Expr] = MappingProxyType({}),
) -> Derivation[Roots]:
    """Solve expressions that are zero for unknowns; `told` are those that a solution tells, `known` values of some.

    Raises NotExact.
    """
    found = exact.real_solutions(equations, unknowns, between, taken, told, dict(known))
    moves = list(found.moves)
    for move, following in zip(moves, [*moves[1:], None], strict=True):
        if move.kind != "point":
            ends = following is not None and following.kind == "point" and following.case == move.case
            yield _step(move, following.values["point"] if ends and following is not None else None, told)
    yield Step(
        "list",
        unclaimed="what the cases have given",
        points=[[(x, point[x]) for x in told] for point in found.points],
        free=[[x for x in told if point[x] == x] for point in found.points],
        needs=list(found.needs),
        whole=sorted({s for p in found.points for v in p.values() for s in v.free_symbols - set(unknowns)
                      if s.is_integer}, key=str),
        searched=[[(x, a, b) for x, (a, b) in box.items()] for box in found.searched],
        certain=found.certain,
        lost=_lost(moves) if not found.points else [],
    )  # fmt: skip
    return found


def _step(move: Move, point: Mapping[Any, Any] | None, told: Sequence[Symbol]) -> Step:
    """The step of a move; `point` is what its case ends in."""
    values = dict(move.values)
    outcomes = values.pop("outcomes", ())
    shown = [list(outcome.shown) for outcome in outcomes]
    needs = [list(outcome.needs) for outcome in outcomes]
    claims = dict(_claims(move.kind, move.values, outcomes))
    is_told = bool(move.case) or any(point[x] == x for x in told) if point is not None else False
    return STEPS[move.kind](
        claims=claims,
        unclaimed="" if claims else "the equations as they stand, or a case of them",
        case=".".join(map(str, move.case)),
        turns=any(outcome.integer is not None for outcome in outcomes),
        inside=f"{'.'.join(map(str, move.case))}." if move.case else "",
        outcomes=shown,
        needed=needs,
        point=[(x, point[x]) for x in told] if point is not None and is_told else [],
        **{name: list(value.items()) if isinstance(value, Mapping) else value for name, value in values.items()
           if name != "found"},
        found=[list(each.items()) for each in values.get("found", ())],
    )  # fmt: skip


STEPS: Mapping[str, Callable[..., Step]] = {
    "product": lambda **said: Step("product", **said),
    "linear": lambda **said: Step("linear", **said),
    "roots": lambda **said: Step("roots", **said),
    "values_of": lambda **said: Step("values_of", **said),
    "inverse": lambda **said: Step("inverse", **said),
    "tangent": lambda **said: Step("tangent", **said),
    "wave": lambda **said: Step("wave", **said),
    "circle": lambda **said: Step("circle", **said),
    "division": lambda **said: Step("division", **said),
    "triangular": lambda **said: Step("triangular", **said),
    "search": lambda **said: Step("search", **said),
    "contradiction": lambda **said: Step("contradiction", **said),
    "sign": lambda **said: Step("sign", **said),
}
"""The step of each kind of move."""


def _claims(kind: str, values: Mapping[str, Any], outcomes: Sequence[Any]) -> Iterator[tuple[str, Claim]]:
    """What a move says that holds whatever the unknowns are."""
    if kind == "product":
        yield "product", Claim(values["equation"], product(*values["written"]), "the equation as a product")
    if kind in ("linear", "roots", "values_of", "division"):
        for i, outcome in enumerate(outcomes, 1):
            put = {a: b for a, b in outcome.shown if b != 0 or kind != "division"}
            decimals = any(value.has(sp.Float) for value in put.values())
            if not decimals and (kind != "division" or outcome.put):
                yield f"solved{i}", Claim(values["factor"].xreplace(put), sp.Integer(0), "put into the equation")
    if kind == "wave":
        x = sp.Symbol("x", real=True)
        a, b, R, phase = (values[name] for name in ("a", "b", "amplitude", "phase"))
        yield "wave", Claim(a * sp.sin(x) + b * sp.cos(x), R * sp.sin(x + phase), "one sine with a phase")
    if kind == "inverse":
        yield "function", Claim(values["factor"].xreplace({values["of"]: values["value"]}), sp.Integer(0),
                                "the value of the function put into the equation")  # fmt: skip
    if kind in ("inverse", "wave", "tangent", "circle") and not (kind == "inverse" and values["of"].is_Pow):
        for i, outcome in enumerate(outcomes, 1):
            ((argument, value),) = outcome.shown
            if value.has(sp.Float):
                continue
            put = _in_place(values["factor"], argument, value)
            yield f"solved{i}", Claim(put, sp.Integer(0), "put into the equation")


def _in_place(factor: Any, argument: Any, value: Any) -> Any:
    """The factor with the value in place of the argument of its functions."""
    if argument.is_Symbol:
        return factor.xreplace({argument: value})
    put = {f: f.func(value, *f.args[1:]) for f in factor.atoms(sp.Function, sp.Pow) if f.args[0] == argument}
    return factor.xreplace(put)


def _lost(moves: Sequence[Move]) -> list[Any]:
    """What equations would need of the parameters, where there is no solution."""
    needed = [factor for move in moves if move.kind == "contradiction" for factor in move.values["factors"]]
    return list(dict.fromkeys(needed))
