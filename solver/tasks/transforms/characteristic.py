"""Lemma: linear differential equations by the characteristic equation: free motion, particular solution, constants.

Several equations are brought to one for each unknown, det P(D) xⱼ = rⱼ, by Cramer's rule for operators. What begins
later is solved from rest in the time since then, and shifted.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, total
from solver.stated.calculus import derivative, value_at
from solver.stated.matrices import determinant
from solver.tasks.transforms.back_transform import moved_by
from solver.tasks.variations.constant_coefficients import by_characteristic_equation
from solver.tasks.variations.unknowns import Constants, unknown_of

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.tasks.transforms.equation_question import Question


@lemma("characteristic_solution")
def by_characteristic(asked: Question) -> Derivation[dict[str, Expr]]:
    """The functions by the names of the unknowns. Raises Unsolved where a solution holds impulses."""
    operators, t = asked.operators, asked.t
    whole = exact.images_of_unknowns(operators, asked.right)[0]
    names = asked.model.unknowns
    if len(names) > 1:
        yield _one_for_each(asked, whole)
    constants = Constants.beside((), [*asked.equations, *asked.inputs.values()])
    listed = exact.acting_pieces([asked.pieces[name] for name in asked.model.inputs], t, asked.s)
    pieces = [each for each in listed if _acts(asked, each)] or listed[:1]
    found: dict[str, list[Expr]] = {name: [] for name in names}
    for number, piece in enumerate(pieces, 1):
        part = number if len(pieces) > 1 or not piece.first else 0
        if part or not piece.first:
            yield Step("piece", unclaimed="what begins at that time", number=part, delay=piece.delay,
                       first=piece.first, functions=_acting(asked, piece), t=t)  # fmt: skip
        functions = yield from _solved_from(asked, piece, whole, (part, constants))
        for name in names:
            found[name].append(moved_by(piece.delay, functions[name], t))
    if len(pieces) > 1 or not pieces[0].first:
        rows = [(asked.model.symbol((name, 0)), sp.Add(*terms)) for name, terms in found.items()]
        yield Step("together", unclaimed="each at its place", rows=rows, count=len(pieces), t=t)
    return {name: sp.Add(*terms) for name, terms in found.items()}


def _acts(asked: Question, piece: exact.ActingPiece) -> bool:
    """Whether anything acts or begins with a piece."""
    begins = piece.first and (any(asked.initial.values()) or not asked.operators.constants.is_zero_matrix)
    return begins or any(piece.functions) or any(piece.impulses)


def _acting(asked: Question, piece: exact.ActingPiece) -> list[tuple[Symbol, Expr, Expr]]:
    symbols = [asked.model.symbol((name, 0)) for name in asked.model.inputs]
    each = zip(symbols, piece.functions, piece.impulses, strict=True)
    return [(u, f, w) for u, f, w in each if f != 0 or w != 0]


def _one_for_each(asked: Question, whole: Expr) -> Step:
    D = sp.Symbol("D")
    P = asked.operators.P.xreplace({asked.s: D})
    claim = Claim(determinant(P), whole.xreplace({asked.s: D}), "the determinant of the operators")
    unknowns = [asked.model.symbol((name, 0)) for name in asked.model.unknowns]
    return Step("one_for_each", claims={"determinant": claim}, P=P, D=D, unknowns=unknowns)


@lemma("characteristic_solution")
def _solved_from(
    asked: Question, piece: exact.ActingPiece, whole: Expr, place: tuple[int, Constants]
) -> Derivation[dict[str, Expr]]:
    """The functions in the time since a piece began."""
    operators, t, s = asked.operators, asked.t, asked.s
    initial = asked.initial if piece.first else {}
    right = exact.right_sides(operators, piece, t)
    images = _images(asked, piece)
    N = int(sp.degree(whole, s))
    lead = sp.LC(whole, s)
    coefficients = tuple(sp.cancel(whole.coeff(s, k) / lead) for k in range(N + 1))
    found: dict[str, Expr] = {}
    for j, name in enumerate(asked.model.unknowns):
        regular, values = exact.values_after(images[j], N, s)
        if not regular:
            raise Unsolved("differential_equation/impulse", name=asked.model.symbol((name, 0)))
        form = exact.LinearForm(coefficients, sp.expand(right[j] / lead))
        found[name] = yield from _one_unknown(asked, name, form, values, (piece, initial, *place))
    return found


def _images(asked: Question, piece: exact.ActingPiece) -> list[Expr]:
    """The transforms of the unknowns in the time since a piece began."""
    operators = asked.operators
    right = sp.Matrix(operators.Q * sp.Matrix(list(piece.images))) if piece.images else sp.zeros(operators.P.rows, 1)
    if piece.first:
        right += operators.constants / asked.s + operators.initial_part(asked.initial)
    whole, parts = exact.images_of_unknowns(operators, sp.ImmutableMatrix(right))
    return [sp.cancel(part / whole) for part in parts]


@lemma("characteristic_solution")
def _one_unknown(
    asked: Question, name: str, form: Any, values: Sequence[Expr], place: tuple[Any, Any, int, Constants]
) -> Derivation[Expr]:
    """The general solution of the equation of one unknown, and its constants from the values at 0+."""
    t = asked.t
    piece, initial, part, constants = place
    jets = [asked.model.symbol((name, k)) for k in range(form.order + 1)]
    single = len(asked.model.unknowns) == 1
    given = form.of(jets) - form.right
    yield Step("equation", unclaimed="the equation with what acts put in", left=form.of(jets),
               right=form.right, x=jets[0], single=single, part=part, first=piece.first,
               driven=any(f != 0 for f in piece.functions))  # fmt: skip
    if form.order == 0:
        return form.right
    if form.right == 0 and not any(values):
        yield Step("stays_zero", unclaimed="nothing acts on it", x=jets[0])
        return sp.S.Zero
    unknown = unknown_of(f"{name}_{part}" if part else name, [given])
    known = len(constants.found)
    general = yield from by_characteristic_equation(form, unknown, t, constants)
    yield _start(asked, unknown.jets[: form.order], name, values, (piece, initial))
    fitted = exact.fitted_constants(general, constants.found[known:], values, t)
    function = exact.in_time(general.xreplace(dict(fitted)), t)
    sides = [sp.expand(sp.diff(general, t, k).xreplace({t: sp.S.Zero})) for k in range(len(values))]
    claims = {
        f"value{k}": Claim(_stated(side, fitted), value, "the constants put into a value at the start")
        for k, (side, value) in enumerate(zip(sides, values, strict=True))
    }
    claims |= {
        f"start{k}": Claim(value_at(derivative(function, t, k), t, sp.S.Zero), value, "a value at the start")
        for k, value in enumerate(values)
    }
    yield Step("constants", claims=claims, x=unknown.symbol, jets=unknown.jets[: form.order], sides=sides,
               values=list(values), constants=list(fitted.items()), function=function, t=t)  # fmt: skip
    return function


def _stated(side: Expr, fitted: Mapping[Symbol, Expr]) -> Any:
    """A linear expression in constants with their values, not added up: what is left of a sum of decimals is judged."""
    rest = side.xreplace(dict.fromkeys(fitted, sp.S.Zero))
    return total(rest, *(product(side.coeff(C, 1), value) for C, value in fitted.items()))


def _start(asked: Question, jets: Sequence[Symbol], name: str, values: Sequence[Expr], place: tuple[Any, Any]) -> Step:
    """The values at 0+: those at 0− and the jumps that impulses on the right side bring, or what the equations give."""
    model, s = asked.model, asked.s
    piece, initial = place
    before = [initial.get((name, k), sp.S.Zero) for k in range(len(values))]
    single = len(model.unknowns) == 1
    claims: dict[str, Claim] = {}
    balances: tuple[exact.ImpulseBalance, ...] = ()
    if single and len(model.inputs) == 1 and before != list(values):
        operators = asked.operators
        u = [sp.diff(piece.functions[0], asked.t, k).xreplace({asked.t: sp.S.Zero}) for k in range(len(values) + 1)]
        balances = exact.impulse_balance(operators.P[0], operators.Q[0], u, piece.impulses[0], s)
        jumps = [after - early for after, early in zip(values, before, strict=True)]
        for i, each in enumerate(balances):
            left = sp.Add(*(a * jumps[k] for a, k in each.left))
            claims[f"balance{i}"] = Claim(left, each.right, "impulses of one order on both sides")
    return Step("start", claims=claims, unclaimed="" if claims else "values at the start", jets=list(jets),
                before=before, after=list(values), single=single,
                balances=[(each.left, each.right) for each in balances],
                same=before == list(values), later=not piece.first)  # fmt: skip
