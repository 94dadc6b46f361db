"""A plant behind a controller, the loop closed or not, is a transfer function: C G/(1 + C G H), or C G."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.derivation.conversion import composition, conversion, converted_to
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, quotient, total
from solver.stated.matrices import inverse
from solver.systems import DeadTime, OutputFeedback, System, TransferFunction

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol


@composition("controller", "feedback", order=2)
def closed(system: System, options: Mapping[str, Any]) -> OutputFeedback:
    """With the options `controller` and `feedback` the question is about what is made of the plant."""
    controller = options["controller"]
    return OutputFeedback(system, sp.Integer(1) if controller is None else controller, options["feedback"])


@conversion(OutputFeedback, TransferFunction, gives=lambda _: ("transfer_function", "motion"))
@lemma("loop")
def transfer_function_of_loop(loop: OutputFeedback) -> Derivation[TransferFunction]:
    """L = C G (1 + C G H)⁻¹ on polynomials, nothing cancelled between C, G and H: what is hidden stays a root.

    Raises Unsolved where 1 + C G H vanishes, and where the result is improper.
    """
    if isinstance(loop.plant, DeadTime):
        raise Unsolved("conversions/dead_time_in_a_loop", closed=loop.feedback is not None)
    G: TransferFunction = yield from converted_to(loop.plant, TransferFunction)
    if G.matrix.shape != (1, 1):
        return (yield from _of_matrices(loop, G))
    x, C, H = G.variable, loop.controller, loop.feedback
    (p, q), (c, d) = (G.numerators[0][0], G.denominators[0][0]), _polynomials(C)
    top, bottom = _by_powers(c * p, x), _by_powers(d * q, x)
    path = quotient(top, bottom)
    yield Step(
        "forward",
        claims={"forward": Claim(product(C, quotient(p, q)), path, "forward path $C G$")},
        x=x,
        C=C,
        G=quotient(p, q),
        open=H is None,
    )
    if H is not None:
        h, k = _polynomials(H)
        N, D = _by_powers(top * k, x), _by_powers(bottom * k + top * h, x)
        if D == 0:
            raise Unsolved("conversions/ill_posed_loop")
        claims = {
            "substituted": Claim(quotient(path, total(1, product(path, H))), quotient(N, D), "closed loop $T$"),
            "denominator": Claim(total(product(bottom, k), product(top, h)), D, "denominator of the closed loop"),
        }
        yield Step("closed", claims=claims, x=x, H=H, unity=H == 1)
        top, bottom = N, D
    if sp.degree(top, x) > sp.degree(bottom, x):
        raise Unsolved("conversions/improper_loop")
    return _system(G, sp.ImmutableMatrix([[sp.cancel(top / bottom)]]), ((top,),), ((bottom,),))


def _by_powers(polynomial: Expr, x: Symbol) -> Expr:
    """Multiplied out and sorted by powers of x."""
    sorted_by_powers: Expr = sp.Poly(polynomial, x).as_expr()
    return sorted_by_powers


def _polynomials(element: Expr) -> tuple[Expr, Expr]:
    """Numerator and denominator of a quotient of polynomials in lowest terms."""
    top, bottom = sp.fraction(sp.together(element))
    return sp.expand(top), sp.expand(bottom)


@lemma("loop")
def _of_matrices(loop: OutputFeedback, G: TransferFunction) -> Derivation[TransferFunction]:
    """C G (I + H C G)⁻¹ of several inputs or outputs, in this order."""
    x, C, H, size = G.variable, loop.controller, loop.feedback, int(G.matrix.cols)
    L = _in_lowest_terms(C * G.matrix)
    claims = {"forward": Claim(product(C, G.matrix), L, "forward path $C G$")}
    yield Step("forward", claims=claims, x=x, C=C, G=G.matrix, open=H is None)
    T = L
    if H is not None:
        if G.matrix.rows != size:
            raise Unsolved("conversions/loop_not_square", rows=G.matrix.rows, columns=size)
        returned = _in_lowest_terms(sp.eye(size) + H * L)
        if exact.determinant(returned) == 0:
            raise Unsolved("conversions/ill_posed_loop")
        T = _in_lowest_terms(L * exact.inverse(returned))
        stated = product(L, inverse(total(sp.ImmutableMatrix(sp.eye(size)), product(H, L))))
        yield Step("closed_matrix", claims={"substituted": Claim(stated, T, "closed loop $T$")}, x=x, H=H)
    fractions = [[sp.fraction(entry) for entry in row] for row in T.tolist()]
    if any(sp.degree(p, x) > sp.degree(q, x) for row in fractions for p, q in row if p != 0):
        raise Unsolved("conversions/improper_loop")
    numerators, denominators = (tuple(tuple(pair[i] for pair in row) for row in fractions) for i in (0, 1))
    return _system(G, T, numerators, denominators)


def _in_lowest_terms(M: Any) -> ImmutableMatrix:
    return sp.ImmutableMatrix(M.applyfunc(sp.cancel))


def _system(
    G: TransferFunction,
    matrix: ImmutableMatrix,
    numerators: tuple[tuple[Expr, ...], ...],
    denominators: tuple[tuple[Expr, ...], ...],
) -> TransferFunction:
    """The result with time, names and variable of the plant."""
    x: Symbol = G.variable
    return TransferFunction(
        matrix, numerators, denominators, x, G.discrete, G.sample_time, G.input_names, G.output_names
    )
