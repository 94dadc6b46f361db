"""Responses by convolution, as lemmas: the solution formula, the transition matrix, the integral or sum."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.arithmetic.integrals import integrated
from solver.arithmetic.sums import added_up
from solver.arithmetic.transformed import term_by_term
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, total
from solver.stated.calculus import integral
from solver.stated.lists import summation
from solver.stated.transforms import inverse_laplace, inverse_z
from solver.tasks.linear_algebra.resolvent import inverse_of_pencil, partial_fractions_of, transform_pairs_of
from solver.tasks.time_response.question import Question

if TYPE_CHECKING:
    from sympy import ImmutableMatrix


@lemma("response_convolution")
def formula_of_convolution(asked: Question) -> Derivation[None]:
    """The solution of the state equation as a formula."""
    yield Step(
        "convolution_formula",
        unclaimed="the general formula, derived in the text",
        detail="full",
        discrete=asked.discrete,
        initial=asked.x0 is not None,
        forced=bool(asked.inputs),
    )


@lemma("response_convolution")
def transition_matrix_of(asked: Question) -> Derivation[ImmutableMatrix]:
    """Φ by the transform of the resolvent; returns it (n×n)."""
    A, s, t, discrete = asked.system.A, asked.variable, asked.time, asked.discrete
    yield from inverse_of_pencil(A, s)
    expansion = yield from partial_fractions_of(A, s)
    yield from transform_pairs_of(A, s, t, discrete=discrete)
    Phi = (exact.power if discrete else exact.exponential)(A, t).matrix
    stated = inverse_z(product(s, expansion), s, t) if discrete else inverse_laplace(expansion, s, t)
    worked_out = term_by_term(exact.resolvent_matrix(A), s, t, Phi, discrete=discrete)
    claim = Claim(stated, Phi, "state transition matrix")
    yield Step("transition", claims={"Phi": claim}, steps=worked_out, discrete=discrete)
    return Phi


@lemma("response_convolution")
def zero_input_by_convolution(asked: Question, Phi: ImmutableMatrix) -> Derivation[None]:
    """Φ(t) x(0)."""
    x = asked.function(asked.zero_input)
    yield Step(
        "free_motion",
        claims={"x": Claim(product(Phi, asked.x0), x, "free motion")},
        discrete=asked.discrete,
        x0=asked.x0,
    )


@lemma("response_convolution")
def zero_state_by_convolution(asked: Question, piece: exact.Piece, Phi: ImmutableMatrix) -> Derivation[None]:
    """The integral of Φ(t − τ) B u(τ), in discrete time the sum of Φ(k − 1 − i) B u(i)."""
    t, B = asked.time, asked.system.B
    x = asked.function(asked.zero_state(piece))
    names: dict[str, Any] = {
        "discrete": asked.discrete,
        "delay": piece.delay,
        "impulses": piece.impulses,
        "inputs": piece.inputs,
    }
    if asked.discrete:
        i = sp.Symbol("i")
        u = piece.inputs.xreplace({t: i})
        stated = summation(product(Phi.xreplace({t: t - 1 - i}), B, u), i, sp.Integer(0), t - 1)
        yield Step(
            "convolution_sum",
            claims={"x": Claim(stated, x, "convolution sum")},
            steps=added_up(sp.ImmutableMatrix(Phi.xreplace({t: t - 1 - i}) * B * u), i, t, x),
            B=B,
            u=u,
            x=asked.begun(x, piece.delay),
            **names,
        )
        return
    tau = sp.Symbol("tau")
    u = piece.inputs.xreplace({t: tau})
    shifted = Phi.xreplace({t: t - tau})
    force = B * u
    acting = [j for j, each in enumerate(force) if each != 0] or [0]  # sympy takes long over products with zeros
    integrand = shifted.extract(list(range(shifted.rows)), acting) * force.extract(acting, [0])
    integrand = sp.ImmutableMatrix(integrand.applyfunc(sp.expand_mul))
    terms: list[Any] = [integral(integrand, tau, sp.Integer(0), t)] if any(u.flat()) or not piece else []
    if any(piece.impulses.flat()):
        terms.append(product(Phi, B, piece.impulses))
    claims = {"x": Claim(total(*terms), x, "convolution")}
    if any(u.flat()) or not piece:
        claims = {"integrand": Claim(product(shifted, B, u), integrand, "what is integrated"), **claims}
    worked_out = integrated(integrand, tau, sp.Integer(0), t, x) if any(u.flat()) and len(terms) == 1 else ()
    yield Step(
        "convolution", claims=claims, steps=worked_out, B=B, tau=tau, u=u, x=asked.begun(x, piece.delay), **names
    )
