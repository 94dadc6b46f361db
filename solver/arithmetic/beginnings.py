"""A state transition matrix tested by its beginning: Φ(0) = I, and how it goes on from there."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.arithmetic.exactness import where_exact
from solver.arithmetic.values import put_in
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.calculus import derivative, value_at

if TYPE_CHECKING:
    from sympy import ImmutableMatrix, Symbol

LARGE = 9
"""The derivative of a matrix with more entries, or with parameters, would fill the page."""


@where_exact
def begun_right(Phi: ImmutableMatrix, A: ImmutableMatrix, time: Symbol, *, discrete: bool) -> tuple[Step, ...]:
    """Φ(0) = I, and Φ′(0) = A, in discrete time Φ(1) = A, with the numbers put in."""
    return tuple(_begun_right(Phi, A, time, discrete=discrete))


@lemma("arithmetic/beginnings")
def _begun_right(Phi: ImmutableMatrix, A: ImmutableMatrix, time: Symbol, *, discrete: bool) -> Derivation[None]:
    identity = sp.ImmutableMatrix(sp.eye(A.rows))
    claims = _at("start", Phi, time, sp.S.Zero, identity)
    small = len(Phi) <= LARGE and not Phi.free_symbols - {time}
    if small and discrete:
        claims |= _at("first", Phi, time, sp.S.One, A)
    elif small:
        slope = sp.ImmutableMatrix(Phi.applyfunc(lambda entry: sp.expand(exact.derivative_of(entry, time))))
        claims["slope"] = Claim(derivative(Phi, time), slope, "derivative")
        claims |= _at("first", slope, time, sp.S.Zero, A)
    yield Step("test", detail="tutor", claims=claims, Phi=Phi, time=time, discrete=discrete)


def _at(name: str, function: ImmutableMatrix, time: Symbol, value: Any, found: ImmutableMatrix) -> dict[str, Claim]:
    numbers = put_in(function, time, value)
    return {
        name: Claim(value_at(function, time, value), numbers, "value put in"),
        f"{name}_found": Claim(numbers, found, "worked out"),
    }
