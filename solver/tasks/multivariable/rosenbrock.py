"""Lemmas: Rosenbrock's matrix, invariant zeros, the modes that are hidden from the input, the output or both."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.arithmetic.determinants import worked_out
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, quotient
from solver.stated.matrices import determinant, rank
from solver.tasks.multivariable.poles_zeros import roots_of
from solver.tasks.representation.lowest_terms import from_roots
from solver.tasks.representation.plants import matrices_of, variable_of
from solver.tasks.structure.hidden_part import hidden_modes_of
from solver.tasks.structure.pairs import Pair, controllability_pair, observability_pair
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.systems import StateSpace

Quadruple = tuple[Any, Any, Any, Any]


@lemma("rosenbrock")
def zeros_of_system_matrix(matrices: Quadruple, x: Symbol, *, minimal: bool = False) -> Derivation[exact.SystemMatrix]:
    """P, its normal rank, and the greatest common divisor of its minors of that order."""
    A, B, C, D = matrices
    found = exact.system_matrix(A, B, C, D, x)
    n, (p, m) = A.rows, D.shape
    yield Step(
        "system_matrix",
        claims={"rank": Claim(rank(found.matrix), sp.Integer(found.rank), "normal rank of P")},
        P=found.matrix,
        n=n,
        p=p,
        m=m,
        x=x,
        rank=found.rank,
        minimal=minimal,
        direct=not D.is_zero_matrix,
    )
    if found.square:
        value = exact.in_factors(found.determinant)
        yield Step(
            "determinant",
            claims={"determinant": Claim(determinant(found.matrix), value, r"$\det P$")},
            steps=worked_out("", found.matrix, found.determinant.as_expr(), x),
            x=x,
            n=n,
            value=value,
            zeros=exact.in_factors(found.zero_polynomial),
            minimal=minimal,
        )
    elif found.rank:
        yield _minors(found, minimal=minimal)
    return found


def _minors(found: exact.SystemMatrix, *, minimal: bool) -> Step:
    """Minors of normal rank that have no more in common than all of them."""
    listed = found.deciding
    return Step(
        "minors",
        claims={
            f"minor{i}": Claim(
                determinant(sp.ImmutableMatrix(found.matrix.extract(list(each.rows), list(each.columns)))),
                each.factored,
                Phrase("a minor of order {order} of $P$", order=found.rank),
            )
            for i, each in enumerate(listed, 1)
        },
        unclaimed="" if listed else "the invariant factors are found by elimination",
        places=[
            ([i + 1 for i in range(len(found.rows)) if i not in each.rows], _left_out(found, each)) for each in listed
        ],
        values=[each.factored for each in listed],
        count=found.count,
        rank=found.rank,
        x=found.variable,
        zeros=exact.in_factors(found.zero_polynomial),
        minimal=minimal,
    )


def _left_out(found: exact.SystemMatrix, minor: exact.PolynomialMinor) -> list[int]:
    """The columns that a minor does not have, counted from 1."""
    return [j + 1 for j in range(len(found.rows[0])) if j not in minor.columns]


@lemma("rosenbrock")
def hidden_zeros_of(plant: StateSpace, poles: Expr) -> Derivation[dict[str, Any]]:
    """The decoupling zeros: modes that the input does not reach, that the output does not show, that are both."""
    x, A = variable_of(plant), plant.A
    answers: dict[str, Any] = {}
    hidden: dict[str, Any] = {}
    for name, pair in (("input", controllability_pair(plant)), ("output", observability_pair(plant))):
        part = exact.hidden_part(pair.F, pair.G)
        hidden[name] = sp.Integer(1) if part is None else exact.factored(part.H, x)
        yield _test_of(pair, name, 0 if part is None else part.N.rows)
        modes = yield from hidden_modes_of(pair, pair.matrix)
        if modes is not None:
            answers[f"{name}_decoupling_zeros"] = modes
    both = exact.common_decoupling_polynomial(A, hidden["input"], hidden["output"], poles, x)
    chi = exact.factored(A, x)
    yield Step(
        "decoupling_zeros",
        claims={
            "both": Claim(quotient(product(hidden["input"], hidden["output"], poles), chi), both, "hidden from both")
        },
        x=x,
        input=answers.get("input_decoupling_zeros"),
        output=answers.get("output_decoupling_zeros"),
        input_polynomial=hidden["input"],
        output_polynomial=hidden["output"],
        both_polynomial=both,
        both=roots_of(sp.Poly(both, x).monic()),
        chi=chi,
        poles=poles,
    )
    return answers


def _test_of(pair: Pair, name: str, hidden: int) -> Step:
    """The rank of the controllability (observability) matrix."""
    return Step(
        "test",
        claims={"rank": Claim(rank(pair.matrix), sp.Integer(pair.n - hidden), "its rank")},
        name=name,
        matrix=pair.matrix,
        n=pair.n,
        rank=pair.n - hidden,
        x=sp.Symbol("z" if pair.discrete else "s"),
    )


@lemma("rosenbrock")
def invariant_zeros_of(found: exact.SystemMatrix, *, transmission: bool) -> Derivation[list[Any] | None]:
    """The roots of the zero polynomial of P; `transmission`: nothing is hidden, so that they are those of G."""
    x, p = found.variable, exact.in_factors(found.zero_polynomial)
    zeros = roots_of(found.zero_polynomial)
    yield Step(
        "invariant_zeros",
        claims={"zeros": Claim(p, from_roots(x, zeros), "invariant zeros")} if zeros else {},
        unclaimed="" if zeros else "there are no roots to put into a product",
        x=x,
        zeros=zeros,
        polynomial=p,
        transmission=transmission,
    )
    return zeros


@lemma("rosenbrock")
def system_zeros_of(
    plant: StateSpace, poles: Expr, degree: int, transmission: list[Any] | None
) -> Derivation[dict[str, Any]]:
    """All that the states add to what G shows: decoupling zeros and invariant zeros, named."""
    x, n = variable_of(plant), plant.order
    if degree == n:
        yield Step("nothing_hidden", unclaimed="as many poles as states", n=n, x=x)
        none: dict[str, Any] = {"input_decoupling_zeros": [], "output_decoupling_zeros": []}
        return none if transmission is None else {**none, "invariant_zeros": transmission}
    answers = yield from hidden_zeros_of(plant, poles)
    found = yield from zeros_of_system_matrix(matrices_of(plant), x)
    zeros = yield from invariant_zeros_of(found, transmission=False)
    return answers if zeros is None else {**answers, "invariant_zeros": zeros}
