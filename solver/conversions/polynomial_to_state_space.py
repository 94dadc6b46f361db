"""A polynomial as the characteristic polynomial of a matrix, for questions about A."""

from __future__ import annotations

from solver.derivation import Claim, Derivation, Step, lemma
from solver.derivation.conversion import conversion
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product, quotient
from solver.stated.matrices import determinant
from solver.systems import Polynomial, StateSpace


@conversion(Polynomial, StateSpace, gives=lambda _: ("A",))
@lemma("companion")
def companion(p: Polynomial) -> Derivation[StateSpace]:
    """The companion matrix: the coefficients, made monic, with changed signs in the last row."""
    n, x, lead = p.degree, p.variable, p.coefficients[0]
    last = [sp.cancel(-c / lead) for c in reversed(p.coefficients[1:])]
    A = sp.ImmutableMatrix([[int(j == i + 1) for j in range(n)] for i in range(n - 1)] + [last])
    stated = determinant(difference(product(x, sp.ImmutableMatrix(sp.eye(n))), A))
    right = p.expression if lead == 1 else quotient(p.expression, lead)
    claim = Claim(stated, right, "the characteristic polynomial of the companion matrix")
    yield Step("companion", claims={"same": claim}, A=A, x=x, lead=lead)
    return StateSpace(A, discrete=p.discrete, sample_time=p.sample_time)
