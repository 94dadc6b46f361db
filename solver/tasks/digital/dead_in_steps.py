"""Deadbeat control, step by step: a gain that makes A − BK nilpotent, in the fewest steps that the inputs allow."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, Any

from solver.arithmetic.inverses import inverted
from solver.arithmetic.products import multiplied
from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, power, product
from solver.stated.matrices import inverse
from solver.tasks import figures
from solver.tasks.design.frames import Frame, Placement
from solver.tasks.design.placement import closed_loop_of, place
from solver.tasks.representation.multivariable_forms import chains_of
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

    from solver.tasks.needed import WithInput


@lemma("deadbeat")
def deadbeat_gain_of(plant: WithInput) -> Derivation[tuple[ImmutableMatrix, int]]:
    """K (m×n) with (A − BK)^ν = 0, and the least such ν. Raises Unsolved where a mode that is not 0 cannot be moved."""
    A, B, n = plant.A, plant.B, plant.order
    reached = exact.reachable_order(A, B)
    yield Step("idea", unclaimed="what is wanted", n=n, several=B.cols > 1, reached=reached == n)
    if reached < n:
        return (yield from _by_stages(plant))
    if B.cols > 1:
        return (yield from _by_chains(plant))
    found: Placement = yield from place(A, B, [sp.Integer(0)] * n, "ackermann", x=sp.Symbol("z"))
    return found.K, n


@lemma("deadbeat")
def _by_chains(plant: WithInput) -> Derivation[tuple[ImmutableMatrix, int]]:
    """Several inputs that reach every state: K = (Q B)⁻¹ Q A with the ends qᵢ A^{μᵢ−1} of the chains as rows of Q."""
    A, B, n = plant.A, plant.B, plant.order
    nothing = sp.ImmutableMatrix(sp.zeros(1, n)), sp.ImmutableMatrix(sp.zeros(1, B.cols))
    coordinates: Any = exact.controllable_coordinates(A, B, *nothing)  # every state is reached, so there are some
    indices, P = coordinates.indices, coordinates.P
    yield from chains_of(A, B, P, indices)
    used = [i for i, length in enumerate(indices) if length]
    last = [sum(indices[: i + 1]) - 1 for i in used]
    P_inverse = exact.inverse(P)
    q, ends = P_inverse.extract(last, list(range(n))), coordinates.T_inverse.extract(last, list(range(n)))
    claims = {"inverse": Claim(inverse(P), P_inverse, "$P^{-1}$")}
    for row, i in enumerate(used):
        factors = [q[row, :], *[A] * (indices[i] - 1)]
        claims[f"end{i + 1}"] = Claim(product(*factors), ends[row, :], Phrase("end of chain {i}", i=i + 1))
    rows = [sp.ImmutableMatrix(q[i, :]) for i in range(q.rows)]
    yield Step("ends", claims=claims, rows=rows, indices=indices, used=used, steps=inverted("P", P, P_inverse))
    acted, moved = exact.multiply(ends, B.extract(list(range(n)), used)), exact.multiply(ends, A)
    part: ImmutableMatrix = exact.multiply(exact.inverse(acted), moved)
    K = sp.ImmutableMatrix(B.cols, n, lambda i, j: part[used.index(i), j] if i in used else sp.Integer(0))
    yield Step(
        "ends_gain",
        claims={
            "acted": Claim(product(ends, B.extract(list(range(n)), used)), acted, "what the inputs do"),
            "moved": Claim(product(ends, A), moved, "what the states do"),
            "gain": Claim(product(inverse(acted), moved), part, "gain"),
        },
        ends=ends,
        K=K,
        idle=[i + 1 for i, length in enumerate(indices) if not length],
        steps=multiplied(ends, B.extract(list(range(n)), used), acted) + multiplied(ends, A, moved),
    )
    x = sp.Symbol("z")
    yield from closed_loop_of(Frame(several=True), A, B, K, x**n, x)
    return K, max(indices)


@lemma("deadbeat")
def _by_stages(plant: WithInput) -> Derivation[tuple[ImmutableMatrix, int]]:
    """States that no input reaches: a basis of those that can be brought to rest in one step, in two, and so on."""
    A, B, n = plant.A, plant.B, plant.order
    yield Step("not_reached", unclaimed="the rank is judged by itself", order=exact.reachable_order(A, B), n=n)
    stages = exact.stages_to_rest(A, B)
    if sum(stage.V.cols for stage in stages) < n:
        raise Unsolved("deadbeat/fixed_mode", modes=_lasting(A, B))
    claims = {}
    for k, stage in enumerate(stages, 1):
        stated = difference(product(A, stage.V), product(B, stage.W))
        claims[f"stage{k}"] = Claim(stated, stage.image, Phrase("stage {k}", k=k))
    yield Step("stages", claims=claims, stages=stages)
    V = sp.ImmutableMatrix.hstack(*(stage.V for stage in stages))
    W = sp.ImmutableMatrix.hstack(*(stage.W for stage in stages))
    V_inverse = exact.inverse(V)
    K: ImmutableMatrix = exact.multiply(W, V_inverse)
    yield Step(
        "stages_gain",
        claims={
            "inverse": Claim(inverse(V), V_inverse, "$V^{-1}$"),
            "gain": Claim(product(W, inverse(V)), K, "gain"),
        },
        V=V,
        W=W,
        steps=inverted("V", V, V_inverse) + multiplied(W, V_inverse, K),
    )
    x = sp.Symbol("z")
    yield from closed_loop_of(Frame(several=B.cols > 1), A, B, K, x**n, x)
    return K, len(stages)


def _lasting(A: ImmutableMatrix, B: ImmutableMatrix) -> list[Expr]:
    """The eigenvalues that no input moves, without zero."""
    fixed = A if B.is_zero_matrix else exact.controllable_part(A, B).block(1, 1)
    return [mode for mode in dict.fromkeys(exact.spectrum(sp.ImmutableMatrix(fixed)).eigenvalues) if mode != 0]


@lemma("deadbeat")
def dead_after(plant: WithInput, K: ImmutableMatrix, steps: int) -> Derivation[ImmutableMatrix]:
    """The powers of A − BK up to the one that is zero, and how a motion ends; returns A − BK."""
    loop = sp.ImmutableMatrix((plant.A - exact.multiply(plant.B, K)).applyfunc(exact.tidy))
    powers = [loop]
    for _ in range(steps - 1):
        powers.append(sp.ImmutableMatrix(exact.multiply(loop, powers[-1]).applyfunc(exact.tidy)))
    yield Step(
        "powers",
        claims={f"power{i}": Claim(power(loop, i), M, Phrase("power {i}", i=i)) for i, M in enumerate(powers[1:], 2)},
        unclaimed="" if steps > 1 else "the closed loop itself is zero",
        loop=loop,
        count=steps,
        n=plant.order,
        controllable=exact.reachable_order(plant.A, plant.B) == plant.order,
        several=plant.B.cols > 1,
        steps=tuple(line for M, after in pairwise(powers) for line in multiplied(loop, M, after)),
    )
    if not loop.free_symbols and plant.order <= figures.LARGEST:
        yield from _motion(plant, loop, K, powers)
    return loop


@lemma("deadbeat")
def _motion(
    plant: WithInput, loop: ImmutableMatrix, K: ImmutableMatrix, powers: list[ImmutableMatrix]
) -> Derivation[None]:
    """x(0), x(1), … until nothing is left, from the initial state (ones where none is given)."""
    n = plant.order
    x0 = figures.start_of(None if plant.x0 is None or plant.x0.free_symbols else plant.x0, n)
    states = [sp.ImmutableMatrix(exact.multiply(M, x0)) for M in powers]
    yield Step(
        "motion",
        claims={
            f"x{i}": Claim(product(loop, before), x, Phrase("state after {i} steps", i=i))
            for i, (before, x) in enumerate(pairwise([x0, *states]), 1)
        },
        detail="full",
        x0=x0,
        given=plant.x0 is not None,
        figures=figures.motion(
            "The closed loop from its initial state",
            loop,
            x0,
            figures.states(n),
            figures.inputs(sp.ImmutableMatrix(-K)),
            discrete=True,
        ),
    )
