"""The weights of a regulator: given, from the outputs or from tolerances; and the factor before the cost."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Given, Refusal, Step, lemma, option
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.options.matrix import MatrixOf
from solver.options.number import Number
from solver.stated import Stated
from solver.stated.algebra import difference, product
from solver.stated.matrices import inverse, transpose
from solver.tasks.design.regulator import (
    Regulator,
    definiteness_word,
    faulty_weights,
    given_or_identity,
    is_semidefinite,
)
from solver.tasks.plant_options import PlantOptions
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

    from solver.systems import System
    from solver.tasks.needed import WithInput


@dataclass(frozen=True, kw_only=True)
class WeightOptions(PlantOptions):
    """What is weighed, and how."""

    Q: ImmutableMatrix | None = option(
        MatrixOf("n", "n"), "weight of the state, n×n, symmetric and positive semidefinite (default I)"
    )
    R: ImmutableMatrix | None = option(
        MatrixOf("m", "m"), "weight of the input, m×m, symmetric and positive definite (default I)"
    )
    N: ImmutableMatrix | None = option(
        MatrixOf("n", "m", flat="column"), "cross weight, n×m: the cost has 2xᵀNu too (default 0)"
    )
    output_weight: ImmutableMatrix | None = option(MatrixOf(), "w for Q = w CᵀC, or a matrix W (p×p) for Q = CᵀWC")
    tolerances: ImmutableMatrix | None = option(
        MatrixOf("n", 1, flat="column"), "tolerable deviations x̃ of the states: Q = diag(1/x̃²)"
    )
    cost_factor: Expr | None = option(
        Number(), "factor before the integral of the cost, 1/2 (the default) or 1", conventions=("1",)
    )


def faulty_state_weight(system: System, options: WeightOptions) -> Iterable[Refusal]:
    """Faults of the weight of the state: given twice or not at all, of the wrong size or sign."""
    ways = [name for name in ("Q", "output_weight", "tolerances") if options.has(name)]
    if not ways and not options.has("R"):
        yield "", Reason("regulators/nothing_weighed")
    for other in ways[1:]:
        yield other, Reason("regulators/weighed_twice", {"ways": (ways[0], other)})
    W: Any = options.output_weight
    C: Any = getattr(system, "C", None)
    if W is not None and C is None:
        yield "output_weight", Reason("regulators/no_outputs")
    elif W is not None:
        p = C.rows
        if W.shape not in {(1, 1), (p, p)}:
            yield "output_weight", Reason("regulators/size_of_output_weight", {"p": p})
        else:
            yield from faulty_weights(W, None, "output_weight")
    tolerances = options.tolerances
    if tolerances is not None and any(x.is_positive is False for x in tolerances.flat()):
        yield "tolerances", Reason("regulators/not_positive", {"name": "tolerances"})


def faulty_cross_weight(system: System, options: WeightOptions) -> Iterable[Refusal]:
    """A weight N that is too large beside Q and R: Q − N R⁻¹ Nᵀ must be positive semidefinite."""
    N: Any = options.N
    if N is None:
        return
    R = given_or_identity(options.R, N.cols)
    Q = weight_of_state(options, getattr(system, "C", None), N.rows)
    if R.T != R or Q.T != Q or definiteness_word(R) not in {None, "positive definite"}:
        return
    zeros = sp.ImmutableMatrix(sp.zeros(N.rows))
    rest = exact.completed_square(zeros, N, Q, R, N)[1]
    if not is_semidefinite(rest):
        yield "N", Reason("regulators/cross_weight_too_large", {"word": definiteness_word(rest)})


def weights_as_stated(given: Given[WithInput, WeightOptions]) -> tuple[Any, ImmutableMatrix]:
    """Q, as the formula that gives it where there is one, and R."""
    C, W = given.system.C, given.options.output_weight
    R = given_or_identity(given.options.R, given.system.B.cols)
    if W is None:
        return state_weight(given), R
    if W.shape == (1, 1):
        return product(W[0, 0], transpose(C), C), R
    return product(transpose(C), W, C), R


def state_weight(given: Given[WithInput, WeightOptions]) -> ImmutableMatrix:
    """Q (n×n) multiplied out."""
    return weight_of_state(given.options, given.system.C, given.system.order)


def weight_of_state(options: WeightOptions, C: ImmutableMatrix | None, n: int) -> ImmutableMatrix:
    """Q (n×n) as the options give it, for outputs with C (p×n)."""
    W, tolerances = options.output_weight, options.tolerances
    if tolerances is not None:
        return sp.ImmutableMatrix(sp.diag(*(1 / x**2 for x in tolerances.flat())))
    if W is None or C is None:
        return given_or_identity(options.Q, n)
    scale = W[0, 0] * sp.eye(C.rows) if W.shape == (1, 1) else W
    return sp.ImmutableMatrix((C.T * scale * C).expand())


@lemma("weights")
def weights_of(given: Given[WithInput, WeightOptions]) -> Derivation[tuple[ImmutableMatrix, ImmutableMatrix]]:
    """Show Q and R as used."""
    W, Q = given.options.output_weight, state_weight(given)
    stated, R = weights_as_stated(given)
    claims = {"Q": Claim(stated, Q, "weight of the state")} if isinstance(stated, Stated) else {}
    way = "outputs" if W is not None else "tolerances" if given.options.tolerances is not None else "given"
    yield Step(
        "weights",
        claims=claims,
        unclaimed="" if claims else "the weights are given",
        Q=Q,
        R=R,
        N=given.options.N,
        rounded=exact.negative_by_rounding(Q),
        way=way,
        scalar=W is not None and W.shape == (1, 1),
        chosen_Q=way == "given" and given.options.Q is None,
        chosen_R=given.options.R is None,
        tolerances=given.options.tolerances.flat() if given.options.tolerances is not None else [],
        factor=cost_factor(given.options),
        discrete=given.system.discrete,
    )
    return Q, R


@lemma("weights")
def regulator_of(given: Given[WithInput, WeightOptions]) -> Derivation[tuple[Regulator, Regulator]]:
    """Show the weights; return the problem asked about, and the one without products of x and u in its cost."""
    Q, R = yield from weights_of(given)
    asked = Regulator.of(given.system.A, given.system.B, Q, R, N=given.options.N, discrete=given.system.discrete)
    plain = asked.without_products()
    if asked.N is not None:
        A, B, cross = asked.A, asked.B, product(inverse(asked.R), sp.ImmutableMatrix(asked.N.T))
        yield Step(
            "completed_square",
            claims={
                "shift": Claim(cross, exact.weighted_transpose(asked.N, asked.R), "the feedback that takes N away"),
                "A": Claim(difference(A, product(B, cross)), plain.A, "the plant with that feedback"),
                "Q": Claim(difference(asked.Q, product(asked.N, cross)), plain.Q, "the weight that is left"),
            },
        )
    return asked, plain


def cost_factor(options: WeightOptions) -> Expr:
    """The factor before the integral."""
    return options.cost_factor if options.cost_factor is not None else sp.Rational(1, 2)
