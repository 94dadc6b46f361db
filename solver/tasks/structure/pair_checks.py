"""Verification of controllability and, by duality, of observability: every answer by its own definition."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Check, Claim, Given
from solver.lazy import numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import structure as judges
from solver.stated.algebra import difference, exponential, power, product, total
from solver.stated.calculus import integral
from solver.stated.lists import summation
from solver.stated.matrices import determinant, transpose
from solver.tasks.structure.pairs import Pair
from solver.words import Phrase

if TYPE_CHECKING:
    from solver.systems import StateSpace
    from solver.tasks.structure.pair_methods import PairOptions


def checks_of(pair: Pair, given: Given[StateSpace, PairOptions], answers: Answers) -> Iterator[Check]:
    """The checks of those answers that are present."""
    symbol = r"\sym{observability_matrix}" if pair.dual else r"\sym{controllability_matrix}"
    names = ("observability_matrix", "observable", "unobservable_modes")
    matrix_name, verdict, modes = (
        names if pair.dual else ("controllability_matrix", "controllable", "uncontrollable_modes")
    )
    whole = pair.turned(judges.krylov_matrix(pair.F, pair.G))
    if matrix_name in answers:
        yield from _blocks(pair, answers[matrix_name], matrix_name)
    if "determinant" in answers:
        claim = Claim(determinant(whole), answers["determinant"])
        yield numeric.check_claim(claim, rf"$\det {symbol}$", answer="determinant")
    if "rank" in answers:
        rank = answers["rank"]
        yield that(rf"$\operatorname{{rank}} {symbol} = {rank}$", "rank", lambda: bool(rank == numeric.rank(whole)))
    if verdict in answers:
        holds = answers[verdict]
        label = rf"$\operatorname{{rank}} {symbol} {'=' if holds else '<'} {pair.n}$"
        yield that(label, verdict, lambda: bool(holds) == (numeric.rank(whole) == pair.n))
    if modes in answers:
        yield modes_check(pair, answers[modes], modes)
    if "exceptions" in answers:
        yield from condition_checks(whole, answers["exceptions"], "exceptions")
    if "gramian" in answers:
        yield from _gramian(pair, answers["gramian"], given.options.horizon)


def that(label: str, answer: str, holds: Callable[[], bool], oracle: str = "numpy.linalg.svd") -> Check:
    """The check of what holds or does not; skipped where the oracle cannot tell."""
    return numeric.check_residual(label, oracle, lambda: 0.0 if holds() else float("inf"), answer=answer)


def modes_check(pair: Pair, modes: Any, answer: str) -> Check:
    """Π(x − λᵢ) is the characteristic polynomial of the part that is hidden."""
    return numeric.check_residual(
        r"$\prod_i (x - \lambda_i)$ is the polynomial of the hidden part",
        "orthonormal basis (150 digits), numpy.linalg.det",
        lambda: judges.hidden_modes_residual(pair.F, pair.G, list(modes)),
        answer=answer,
    )


def condition_checks(matrix: Any, conditions: Iterable[Any], answer: str, along: Any = None) -> Iterator[Check]:
    """The rank falls where a condition holds, and nowhere else on random lines of parameters."""
    listed = list(conditions)
    for condition in listed:
        yield that(
            "the rank is lower where a condition holds",
            answer,
            lambda condition=condition: judges.rank_falls_where(matrix, condition),  # type: ignore[misc]
        )
    yield that(
        "the rank is lower nowhere else, on random lines of parameters",
        answer,
        lambda: judges.every_fall_is_named(matrix, listed, along),
    )
    if len(listed) > 1:
        yield that("no condition is listed twice", answer, lambda: judges.all_differ(listed), "random points")


def _blocks(pair: Pair, matrix: Any, answer: str) -> Iterator[Check]:
    """The block number i is AⁱB (dual: CAⁱ); the shape as well."""
    n, width = pair.n, pair.width
    shape = (n * width, n) if pair.dual else (n, n * width)
    if matrix.shape != shape:
        label = Phrase("the matrix is {rows} × {columns}", rows=shape[0], columns=shape[1])
        yield Check.that(label, "shape", False, answer=answer)
        return
    whole = pair.turned(matrix)
    for i, name in enumerate(pair.names):
        block = pair.turned(sp.ImmutableMatrix(whole[:, i * width : (i + 1) * width]))
        stated = product(pair.other, power(pair.A, i)) if pair.dual else product(power(pair.A, i), pair.other)
        yield numeric.check_claim(Claim(stated, block), Phrase("block ${name}$", name=name), answer=answer)


def _gramian(pair: Pair, W: Any, horizon: Any) -> Iterator[Check]:
    """The Lyapunov equation, the integral or the sum that W satisfies."""
    if W.shape != (pair.n, pair.n):
        yield Check.that(Phrase(r"$W$ is {n} × {n}", n=pair.n), "shape", False, answer="gramian")
        return
    F, G = pair.F, pair.G
    Ft, Gt = transpose(F), transpose(G)
    if horizon is None:
        left = difference(product(F, W, Ft), W) if pair.discrete else total(product(F, W), product(W, Ft))
        right = product(sp.Integer(-1), G, Gt)
        yield numeric.check_claim(Claim(left, right), "Lyapunov equation of the Gramian", answer="gramian")
        yield numeric.check_claim(Claim(transpose(W), W), "$W$ is symmetric", answer="gramian")
    elif pair.discrete:
        k = sp.Symbol("k")
        term = product(power(F, k), G, Gt, power(Ft, k))
        claim = Claim(summation(term, k, sp.Integer(0), horizon - 1), W)
        yield numeric.check_claim(claim, "sum of the Gramian", answer="gramian")
    else:
        t = sp.Symbol("t")
        term = product(exponential(product(F, t)), G, Gt, exponential(product(Ft, t)))
        claim = Claim(integral(term, t, sp.Integer(0), horizon), W)
        yield numeric.check_claim(claim, "integral of the Gramian", answer="gramian")
