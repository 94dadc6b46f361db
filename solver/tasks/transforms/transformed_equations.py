"""Lemma: linear differential equations by the Laplace transform: transformed line by line, solved, and back."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, quotient, total
from solver.stated.matrices import determinant
from solver.stated.transforms import laplace
from solver.tasks.transforms.back_transform import (
    by_partial_fractions,
    denominator_in_factors,
    multiple_of_earlier,
    put_together,
    split_by_delays,
)
from solver.tasks.transforms.forward import transformed

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.tasks.transforms.back_transform import Names
    from solver.tasks.transforms.equation_question import Question


@lemma("transformed_equations")
def by_laplace(asked: Question) -> Derivation[dict[str, Expr]]:
    """The functions by the names of the unknowns."""
    yield _derivatives(asked)
    for name in asked.model.inputs:
        own = asked.names(name)
        pieces, image = asked.pieces[name], asked.images[asked.model.inputs.index(name)]
        at_once = _is_in_the_table(asked, name)
        if pieces and not at_once:
            yield from transformed(asked.inputs[name], pieces, own)
        claims = {"U": Claim(laplace(pieces[0].function, asked.t, asked.s), image, "from the table")} if at_once else {}
        yield Step("input", claims=claims, unclaimed="" if claims else "the terms added", image=image,
                   function=asked.inputs[name], at_once=at_once, **own.told)  # fmt: skip
    yield _equations(asked)
    yield from _solved(asked)
    found = {}
    for name in asked.model.unknowns:
        found[name] = yield from function_of(asked, name)
    return found


def _is_in_the_table(asked: Question, name: str) -> bool:
    """Whether an input begins at zero and is in the table as it stands."""
    pieces = asked.pieces[name]
    if len(pieces) != 1 or pieces[0].delay != 0 or pieces[0].impulse != 0:
        return False
    return all(len(each.pairs(asked.t, asked.s)) == 1 for each in pieces[0].terms)


def _derivatives(asked: Question) -> Step:
    """The transform of each derivative that occurs, with the values at 0− put in."""
    s, rows = asked.s, []
    for symbol, (name, k) in sorted(asked.model.jets.items(), key=lambda each: (each[1][0], -each[1][1])):
        if not any(equation.has(symbol) for equation in asked.equations):
            continue
        X, is_input = asked.capital(name), name in asked.model.inputs
        values = [] if is_input else [asked.initial.get((name, m), sp.S.Zero) for m in range(k)]
        image = total(product(s**k, X), *(-v * s ** (k - 1 - m) for m, v in enumerate(values) if v != 0))
        if k:
            rows.append((symbol, asked.model.symbol((name, 0)), X, k, is_input, image))
    constants = not asked.operators.constants.is_zero_matrix
    return Step("derivatives", unclaimed="the rule for derivatives", rows=rows, s=s, constants=constants,
                inputs=any(each[4] for each in rows))  # fmt: skip


def _equations(asked: Question) -> Step:
    """P(s) X = Q(s) U + c/s + I(s), row by row."""
    operators, s = asked.operators, asked.s
    X = [asked.capital(name) for name in asked.model.unknowns]
    values = {x: asked.image(name) for x, name in zip(X, asked.model.unknowns, strict=True)}
    start = operators.initial_part(asked.initial)
    claims, lines = {}, []
    for i in range(operators.P.rows):
        left = [(operators.P[i, j], x) for j, x in enumerate(X) if operators.P[i, j] != 0]
        forced = [_scaled(q, U) for q, U in zip(operators.Q.row(i), asked.images, strict=True) if q != 0 and U != 0]
        constant = [operators.constants[i] / s] if operators.constants[i] != 0 else []
        given = [*forced, *constant, *([start[i]] if start[i] != 0 else [])]
        right: Any = total(*given) if given else sp.S.Zero
        lines.append((total(*(_scaled(p, x) for p, x in left)), right))
        claims[f"row{i + 1}"] = Claim(total(*(product(p, values[x]) for p, x in left)), right, "transformed equation")
    return Step("equations", claims=claims, lines=lines, unknowns=list(values.items()))


def _scaled(factor: Expr, what: Any) -> Any:
    return what if factor == 1 else product(factor, what)


@lemma("transformed_equations")
def _solved(asked: Question) -> Derivation[None]:
    """The transforms of the unknowns: divided by P, of several equations by Cramer's rule."""
    whole, _ = asked.solved
    operators, unknowns = asked.operators, asked.model.unknowns
    several = len(unknowns) > 1
    claims: dict[str, Claim] = {}
    if several:
        claims["determinant"] = Claim(determinant(operators.P), whole, "the determinant")
    lines: list[tuple[Any, ...]] = []
    for j, name in enumerate(unknowns):
        image = asked.image(name)
        if several:
            changed = operators.P.as_mutable()
            changed[:, j] = asked.right
            stated = quotient(determinant(sp.ImmutableMatrix(changed)), whole)
        else:
            stated = quotient(asked.right[0], whole)
        claims[f"X{j + 1}"] = Claim(stated, image, "solved")
        lines.append((asked.names(name).image, stated, image))
    yield Step("solved", claims=claims, lines=lines, several=several, P=operators.P, determinant=whole, s=asked.s)
    if sp.degree(whole, asked.s) > 0:
        found = exact.rational_image(1 / whole, asked.s)
        yield from denominator_in_factors(found, asked.names(unknowns[0]))


@lemma("transformed_equations")
def function_of(asked: Question, name: str) -> Derivation[Expr]:
    """The function of one unknown from its transform."""
    names, terms = asked.names(name), asked.terms[name]
    if terms[0].image.numerator == 0:
        yield Step("nothing", unclaimed="zero in the transform is zero in time", **names.told)
        return sp.S.Zero
    if len(terms) == 1 and terms[0].delay == 0:
        f, _ = yield from by_partial_fractions(terms[0].image.as_shown, names)
        return f
    yield from split_by_delays(terms, asked.image(name), names)
    found: list[Expr] = []
    for number, each in enumerate(terms, 1):
        found.append((yield from _part(each.image, terms, found, number, names)))
    return (yield from put_together(terms, found, names))


@lemma("transformed_equations")
def _part(
    image: exact.RationalImage,
    terms: tuple[exact.DelayedImage, ...],
    found: list[Expr],
    number: int,
    names: Names,
) -> Derivation[Expr]:
    """The function of one term, which may be a multiple of an earlier one."""
    ratios = ((exact.ratio_of_images(image, terms[i].image), i) for i in range(number - 1))
    factor, before = next((pair for pair in ratios if pair[0] is not None), (None, 0))
    if factor is None:
        f, _ = yield from by_partial_fractions(image.as_shown, names.part(number))
        return f
    function = sp.expand(factor * found[before])
    yield from multiple_of_earlier(number, factor, before + 1, function, names)
    return function


@lemma("transformed_equations")
def told(asked: Question, found: Mapping[str, Expr]) -> Derivation[Answers]:
    """The solution, and where it jumps at zero."""
    model, t = asked.model, asked.t
    symbols = {name: model.symbol((name, 0)) for name in model.unknowns}
    jumps = [each for name, f in found.items() for each in _jumps(asked, name, f)]
    if len(found) > 1 or jumps:
        yield Step("solution", unclaimed="what was found", rows=[(symbols[name], f) for name, f in found.items()],
                   detail="brief" if len(found) > 1 else "full", jumps=jumps, several=len(found) > 1, t=t)  # fmt: skip
    return Answers(solution={symbols[name]: f for name, f in found.items()})


def _jumps(asked: Question, name: str, f: Expr) -> Iterator[tuple[Symbol, Expr, Expr]]:
    """The derivatives below the highest that have another value at 0+ than at 0−, with both."""
    if f.has(sp.DiracDelta):
        return
    smooth = f.xreplace(dict.fromkeys(f.atoms(sp.Heaviside), sp.S.Zero))
    for k in range(asked.operators.orders[name]):
        before = asked.initial.get((name, k), sp.S.Zero)
        after = sp.diff(smooth, asked.t, k).xreplace({asked.t: sp.S.Zero})
        if sp.cancel(sp.expand(after - before)) != 0:
            yield asked.model.symbol((name, k)), before, sp.expand(after)
