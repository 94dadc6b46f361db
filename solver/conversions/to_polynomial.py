"""The characteristic polynomial of a plant or of a loop."""

from __future__ import annotations

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.derivation.conversion import conversion, converted_to
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product
from solver.stated.matrices import determinant
from solver.systems import Polynomial, StateSpace, TransferFunction


@conversion(TransferFunction, Polynomial, gives=lambda _: ("polynomial",))
@lemma("characteristic")
def denominator_of(G: TransferFunction) -> Derivation[Polynomial]:
    """The denominator as given, nothing cancelled; of several channels that of a realization."""
    x = G.variable
    if G.matrix.shape != (1, 1):
        plant = yield from converted_to(G, StateSpace)
        return (yield from characteristic_polynomial_of(plant))
    q = G.denominators[0][0]
    coefficients = tuple(sp.Poly(q, x).all_coeffs())
    if len(coefficients) == 1:
        raise Unsolved("conversions/constant_plant")
    yield Step("denominator", unclaimed="it is read off", x=x, p=q)
    return Polynomial(coefficients, x, G.discrete, G.sample_time)


@conversion(StateSpace, Polynomial, gives=lambda has: ("polynomial",) if "A" in has else ())
@lemma("characteristic")
def characteristic_polynomial_of(plant: StateSpace) -> Derivation[Polynomial]:
    """det(xI − A)."""
    A, x = plant.A, sp.Symbol("z" if plant.discrete else "s")
    chi = A.charpoly(x)
    stated = determinant(difference(product(x, sp.ImmutableMatrix(sp.eye(A.rows))), A))
    claim = Claim(stated, chi.as_expr(), "characteristic polynomial")
    yield Step("determinant", claims={"determinant": claim}, x=x)
    return Polynomial(tuple(chi.all_coeffs()), x, plant.discrete, plant.sample_time)
