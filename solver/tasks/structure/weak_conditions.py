"""Stabilizability and detectability: whether what is hidden decays by itself, or for which parameters it does."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Check, Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.numeric.judges import stability as regions
from solver.numeric.judges import structure as judges
from solver.stated.algebra import product, total
from solver.stated.calculus import value_at
from solver.tasks.structure.hidden_part import hidden_modes_of
from solver.tasks.structure.pair_checks import modes_check, that
from solver.tasks.structure.pairs import Pair
from solver.tasks.structure.rank_test import rank_of
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import ImmutableMatrix, Symbol


@lemma("weak_conditions")
def decay_of_hidden_modes(pair: Pair) -> Derivation[Answers]:
    """All hidden modes inside the region of stability, its boundary not included, or for which parameters they are."""
    verdict = "detectable" if pair.dual else "stabilizable"
    found = yield from rank_of(pair)
    modes = yield from hidden_modes_of(pair, found.matrix)
    if modes is None:
        raise Unsolved("hidden_modes/parameters")
    hidden = exact.hidden_part(pair.F, pair.G)
    placed = exact.location(hidden.H, discrete=pair.discrete).placed if hidden else ()
    holds = _verdict([each.position for each in placed])
    yield Step(
        "decay",
        unclaimed="the hidden modes are checked above",
        placed=[(each.root.value, each.position, _where(each.measure, pair)) for each in placed],
        holds=holds,
        dual=pair.dual,
        discrete=pair.discrete,
    )
    if hidden and holds is None:
        condition = yield from _condition_on_parameters(pair, hidden.H)
        if condition not in (sp.true, sp.false):
            return Answers(hidden_modes=modes, condition=condition)
        holds = condition is sp.true
    if pair.discrete and modes:
        yield Step(
            "in_finite_time",
            detail="full",
            unclaimed="the hidden modes are checked above",
            modes=modes,
            dual=pair.dual,
        )
    return Answers(**{verdict: holds, "hidden_modes": modes})


def _where(measure: Any, pair: Pair) -> Any:
    """The condition that Re λ < 0 (discrete: |λ| < 1), solved where it has one parameter; None if λ has no form."""
    if measure is None:
        return None
    if pair.discrete or len(measure.free_symbols) > 1:
        return sp.Lt(measure, 1 if pair.discrete else 0)
    return exact.all_positive([-measure])


def _verdict(positions: Sequence[int | None]) -> bool | None:
    """False where a hidden mode does not decay, None where the parameters leave it open."""
    known = [position for position in positions if position is not None]
    if any(position >= 0 for position in known):
        return False
    return True if len(known) == len(positions) else None


@lemma("weak_conditions")
def _condition_on_parameters(pair: Pair, H: ImmutableMatrix) -> Derivation[Any]:
    """Where all eigenvalues of H are stable: what must be positive for each factor of its polynomial, together."""
    lamda = sp.Symbol("lamda")
    listed: list[Any] = []
    pairs: list[Any] = []
    claims: dict[str, Claim] = {}
    for factor in exact.spectrum(H).factors:
        found = exact.root_conditions(factor.coefficients, discrete=pair.discrete)
        listed += found
        if factor.degree == 2 and any(root.kind == "symbolic" for root in factor.roots):
            pairs.append((factor.polynomial(lamda), [each for each in found if exact.sign_of(each) != 1]))
            says = (f"{each}{len(pairs)}" for each in "abc")
            claims |= dict(zip(says, _of_pair(factor, lamda, discrete=pair.discrete), strict=False))
    condition = exact.all_positive(listed)
    yield Step(
        "condition",
        claims=claims,
        unclaimed="" if claims else "the answer, which has a check of its own",
        pairs=pairs,
        condition=condition,
        truth="always" if condition is sp.true else "never" if condition is sp.false else "",
        dual=pair.dual,
        discrete=pair.discrete,
    )
    return condition


def _of_pair(factor: exact.Factor, x: Symbol, *, discrete: bool) -> Iterator[Claim]:
    """The sum and the product of both roots; in discrete time the values of the polynomial at 1 and −1 for the sum."""
    p, (_, b, c) = factor.polynomial(x), factor.coefficients
    roots = [root.value for root in factor.roots]
    if discrete:
        yield Claim(value_at(p, x, sp.Integer(1)), 1 + b + c, "the value at 1")
        yield Claim(value_at(p, x, sp.Integer(-1)), 1 - b + c, "the value at −1")
    else:
        yield Claim(total(*roots), -b, "sum of the two modes")
    yield Claim(product(*roots), c, "product of the two modes")


def weak_checks(pair: Pair, answers: Answers) -> Iterator[Check]:
    """The polynomial of the hidden part, where its roots lie, and for which parameters."""
    verdict = "detectable" if pair.dual else "stabilizable"
    if verdict in answers:
        holds: Any = answers[verdict]
        yield that(
            "every hidden mode decays" if holds else "a hidden mode does not decay",
            verdict,
            lambda: bool(holds) == judges.hidden_modes_decay(pair.F, pair.G, discrete=pair.discrete),
            "orthonormal basis (150 digits), mpmath.eig",
        )
    if "hidden_modes" in answers:
        yield modes_check(pair, answers["hidden_modes"], "hidden_modes")
    if "condition" in answers:
        yield _condition_check(pair, answers["condition"])


def _condition_check(pair: Pair, condition: Any) -> Check:
    """At points on both sides of every edge the condition holds if and only if all that is hidden decays."""
    words = ("detectable", "not detectable") if pair.dual else ("stabilizable", "not stabilizable")
    part = regions.StablePart(words, pair.parameters, judges.HiddenPart(pair.F, pair.G))
    fault = regions.counterexample(pair.F, condition, discrete=pair.discrete, part=part)
    says = "the condition holds exactly where every hidden mode decays"
    check = Check.that(
        Phrase("{claim} ({fault})", claim=says, fault=fault) if fault else says,
        "sympy.nullspace, numpy.linalg.eigvals, beside the edges mpmath.eig",
        not fault,
    )
    return replace(check, reason=fault)
