"""A transfer function is realized for questions about states."""

from __future__ import annotations

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.derivation.conversion import conversion
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product, total
from solver.stated.matrices import inverse
from solver.systems import StateSpace, TransferFunction


@conversion(TransferFunction, StateSpace, gives=lambda _: ("A", "B", "C", "D", "transfer_function"))
@lemma("realized")
def realized(G: TransferFunction) -> Derivation[StateSpace]:
    """Controllable canonical form, nothing cancelled. Raises Unsolved for a constant, which has no state."""
    form = exact.controllable_realization(exact.transfer_matrix_of_fractions(G.numerators, G.denominators, G.variable))
    A, B, C, D = form.A, form.B, form.C, form.D
    if A.rows == 0:
        raise Unsolved("conversions/constant_plant")
    resolvent = inverse(difference(product(G.variable, sp.ImmutableMatrix(sp.eye(A.rows))), A))
    terms = [product(C, resolvent, B), *([] if D.is_zero_matrix else [D])]
    yield Step(
        "realized",
        claims={"same": Claim(total(*terms), G.matrix, "the realization has the transfer function")},
        A=A,
        B=B,
        C=C,
        D=D,
        G=G,
        siso=G.matrix.shape == (1, 1),
    )
    return StateSpace(A, B, C, D, None, G.discrete, G.sample_time, (), G.input_names, G.output_names)
