"""A signal-flow graph is a transfer function: its equations are linear in the signals of the nodes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.conversions.forward_path import by_powers, polynomials_of
from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.derivation.conversion import conversion
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import quotient
from solver.stated.matrices import determinant
from solver.systems import SignalFlow, TransferFunction

if TYPE_CHECKING:
    from sympy import ImmutableMatrix


@conversion(
    SignalFlow,
    TransferFunction,
    gives=lambda has: ("transfer_function", "motion") if "signal_flow" in has else (),
)
@lemma("signal_flow")
def transfer_function_of_graph(graph: SignalFlow) -> Derivation[TransferFunction]:
    """Cramer's rule for M x = b r; what is below is det M times the denominators of all gains, nothing cancelled.

    Raises Unsolved where M is singular, and where the result is improper.
    """
    s = graph.variable
    M, b, names = _equations(graph)
    i = names.index(graph.output)
    replaced = sp.ImmutableMatrix(M.rows, M.cols, lambda j, k: b[j] if k == i else M[j, k])
    above, below = (sp.cancel(sp.together(exact.determinant(each))) for each in (replaced, M))
    if below == 0:
        raise Unsolved("loops/ill_posed_graph")
    D = sp.Mul(*(polynomials_of(each.gain)[1] for each in graph.branches))
    top, bottom = (by_powers(sp.cancel(sp.together(each * D)), s) for each in (above, below))
    x = sp.ImmutableMatrix([graph.symbol(name) for name in names])
    yield Step(
        "equations",
        unclaimed="each row is the sum at a node",
        M=M,
        b=b,
        x=x,
        r=graph.symbol(graph.input),
        y=graph.symbol(graph.output),
    )
    claims = {
        "below": Claim(determinant(M), below, "determinant of the equations"),
        "above": Claim(determinant(replaced), above, "determinant with the column of the output replaced"),
        "G": Claim(quotient(above, below), quotient(top, bottom), "Cramer's rule"),
    }
    yield Step("transfer", claims=claims, s=s, r=graph.symbol(graph.input), y=graph.symbol(graph.output))
    if sp.degree(top, s) > sp.degree(bottom, s):
        raise Unsolved("conversions/improper_loop")
    return TransferFunction(
        matrix=sp.ImmutableMatrix([[sp.cancel(top / bottom)]]),
        numerators=((top,),),
        denominators=((bottom,),),
        variable=s,
        discrete=graph.discrete,
        sample_time=graph.sample_time,
        input_names=(graph.input,),
        output_names=(graph.output,),
    )


def _equations(graph: SignalFlow) -> tuple[ImmutableMatrix, ImmutableMatrix, list[str]]:
    """M and b of M x = b r, x the signals of all nodes but the input."""
    names = [name for name in graph.nodes if name != graph.input]
    rows: Any = {name: dict.fromkeys(graph.nodes, sp.S.Zero) for name in names}
    for each in graph.branches:
        rows[each.target][each.source] += each.gain
    M = sp.ImmutableMatrix([[int(i == j) - rows[i][j] for j in names] for i in names])
    b = sp.ImmutableMatrix([rows[i][graph.input] for i in names])
    return M, b, names
