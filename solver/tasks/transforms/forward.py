"""Lemma: a function of time transformed by the table and rules, one line for each."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from solver.arithmetic.values import put_in
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, total
from solver.stated.calculus import derivative
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.tasks.transforms.back_transform import Names


@lemma("transform_rules")
def transformed(f: Expr, pieces: Sequence[exact.TransformPiece], names: Names) -> Derivation[set[str]]:
    """The terms of each piece and its shift; returns which rules were used."""
    used: set[str] = set()
    shown: set[Expr] = set()
    t, sifted = names.t, _is_sifted(f, names.t)
    yield from _taken_apart(f, pieces, names)
    for number, piece in enumerate(pieces, 1):
        part = str(number) if len(pieces) > 1 else ""
        if piece.delay != 0 and piece.function.has(t):
            yield _moved(piece, part, names)
        yield from terms_of(piece.terms, names, used, shown)
        if piece.impulse != 0:
            used |= {"impulse"} | ({"sifting"} if sifted else set())
            yield Step("impulse", unclaimed="the transform of an impulse, by definition", weight=piece.impulse,
                       delay=piece.delay, sifted=sifted, part=part,
                       image=piece.impulse * names.delayed(piece.delay), **names.told)  # fmt: skip
        if piece.delay != 0 and piece.terms:
            used.add("delay")
            yield _late(piece, part, names)
    if sum(len(piece.terms) + (piece.impulse != 0) for piece in pieces) > 1 or any(
        term.factor != 1 for piece in pieces for term in piece.terms
    ):
        used.add("linearity")
    return used


def _is_sifted(f: Expr, t: Symbol) -> bool:
    """Whether an impulse has a factor that changes with time."""
    terms: tuple[Any, ...] = sp.Add.make_args(sp.expand(f))
    with_impulse = [term for term in terms if term.has(sp.DiracDelta)]
    return any(sp.Mul(*(x for x in sp.Mul.make_args(term) if not x.has(sp.DiracDelta))).has(t) for term in with_impulse)


def _taken_apart(f: Expr, pieces: Sequence[exact.TransformPiece], names: Names) -> Derivation[None]:
    """The function as a sum of what the table has, where it is not given so; what begins later by itself."""
    t = names.t
    smooth = next((each for each in pieces if each.delay == 0 and each.terms), None)
    f = _steps_up(f, names)
    started = f.xreplace({each: sp.S.One for each in f.atoms(sp.Heaviside) if each.args[0] == t})
    given = sp.Add(*(term for term in sp.Add.make_args(started) if not term.has(sp.Heaviside, sp.DiracDelta)))
    late = any(each.delay != 0 for each in pieces)
    if smooth is not None and given != smooth.function and not (late and given == 0):
        claim = Claim(given, smooth.function, "the function as a sum")
        yield Step("rewritten", claims={"f": claim}, late=late or started.has(sp.DiracDelta),
                   waves=given.has(sp.sin, sp.cos), hyperbolic=given.has(sp.sinh, sp.cosh), **names.told)  # fmt: skip
    if len(pieces) > 1:
        parts = [(each.delay, each.function, each.impulse) for each in pieces]
        yield Step("pieces", unclaimed="what begins at each time", parts=parts, **names.told)


def _steps_up(f: Expr, names: Names) -> Expr:
    """The function with 1 − step(t − T) for a step down, step(T − t); samples at T still see it."""
    t, after = names.t, int(names.discrete)
    down = [each for each in f.atoms(sp.Heaviside) if sp.expand(each.args[0]).coeff(t, 1).is_negative]
    if not down:
        return f
    lines = {each: sp.expand(each.args[0]) for each in down}
    begins = {each: -line.coeff(t, 0) / line.coeff(t, 1) + after for each, line in lines.items()}
    return sp.expand(f.xreplace({each: 1 - sp.Heaviside(t - at) for each, at in begins.items()}))


def _moved(piece: exact.TransformPiece, part: str, names: Names) -> Step:
    t, tau = names.t, sp.Symbol("i" if names.discrete else "tau")
    written, local = put_in(piece.function, t, tau + piece.delay), piece.moved.xreplace({t: tau})
    claim = Claim(written, local, "written in the time since the step")
    return Step("moved", claims={"f": claim}, delay=piece.delay, function=piece.function, tau=tau,
                at_once=written == local, part=part, **names.told)  # fmt: skip


@lemma("transform_rules")
def terms_of(
    terms: Sequence[exact.TransformedTerm], names: Names, used: set[str], shown: set[Expr]
) -> Derivation[None]:
    """The pairs that are in the table at once, and the others line by line; each function is `shown` once."""
    t, s = names.t, names.s
    used |= {each.entry for each in terms}
    pairs = [(each, each.pairs(t, s)) for each in terms if each.function(t) not in shown]
    at_once = [(each, found) for each, found in pairs if len(found) == 1]
    shown |= {each.function(t) for each in terms}
    if at_once:
        claims = {
            f"pair{i}": Claim(names.transform(found[0].function), found[0].image, "pair of the table")
            for i, (_, found) in enumerate(at_once, 1)
        }
        yield Step("table", claims=claims, entries={each.entry for each, _ in at_once}, **names.told)
    for each, found in pairs:
        if len(found) > 1:
            used |= {pair.rule for pair in found[1:]}
            yield _by_rules(each, found, names)


def _by_rules(term: exact.TransformedTerm, pairs: Sequence[Any], names: Names) -> Step:
    claims: dict[str, Claim] = {}
    lines: list[tuple[str, str, Any]] = []
    for i, pair in enumerate(pairs):
        name = f"{pair.rule}{i}" if pair.rule != "table" else "pair"
        told = Phrase("the rule of {rule}", rule=pair.rule) if pair.rule != "table" else "pair of the table"
        claims[name] = Claim(names.transform(pair.function), pair.image, told)
        slope = _slope(pairs[i - 1].image, term.power, names) if pair.rule == "derivative" else None
        if slope is not None:
            claims[f"slope{i}" if names.discrete else "slope"] = Claim(slope, pair.image, "derivative of the image")
        lines.append((pair.rule, name, slope))
    return Step("by_rules", claims=claims, term=term.function(names.t), power=term.power, growth=term.growth,
                lines=lines, again=sum(each.rule == "derivative" for each in pairs), **names.told)  # fmt: skip


def _slope(before: Expr, power: int, names: Names) -> Any:
    """(−1)ⁿ dⁿG/dsⁿ of tⁿ g(t); in discrete time −z dG/dz of k g(k)."""
    if names.discrete:
        return product(-names.s, derivative(before, names.s))
    stated = derivative(before, names.s, power)
    return stated if power % 2 == 0 else product(sp.Integer(-1), stated)


def _late(piece: exact.TransformPiece, part: str, names: Names) -> Step:
    t, s = names.t, names.s
    images = [product(each.factor, each.pairs(t, s)[-1].image) for each in piece.terms]
    inner = sp.Add(*(each.factor * each.pairs(t, s)[-1].image for each in piece.terms))
    late = exact.moved_image if names.discrete else exact.late_image
    image, factor = late(piece.delay, inner, s), names.delayed(piece.delay)
    claims = {
        "inner": Claim(names.transform(piece.moved), total(*images), "the transform in the time since the step"),
        "image": Claim(product(factor, names.transform(piece.moved)), image, "the transform of what is delayed"),
    }
    return Step("late", claims=claims, delay=piece.delay, part=part, image=image, **names.told)
