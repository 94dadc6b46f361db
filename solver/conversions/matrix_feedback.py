"""Loops of several inputs or outputs: C G (I + H C G)⁻¹ in this order, as a transfer matrix or with all its states."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.conversions.forward_path import forward_path_of
from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.derivation.conversion import conversion, converted_to
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, total
from solver.stated.matrices import determinant, inverse
from solver.systems import DeadTime, MatrixFeedback, StateSpace, TransferFunction
from solver.tasks.representation.minimal_parts import least_realization_of
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

    from solver.stated import Stated

Fractions = tuple[tuple["Expr", ...], ...]


@conversion(MatrixFeedback, TransferFunction, gives=lambda _: ("transfer_function", "motion", "path"))
@lemma("matrix_loop")
def transfer_matrix_of_loop(loop: MatrixFeedback) -> Derivation[TransferFunction]:
    """C G (I + H C G)⁻¹ on rational functions, or C G.

    Raises Unsolved where I + H C G has no inverse for any s, where sizes do not fit, and where the result is improper.
    """
    if isinstance(loop.plant, DeadTime):
        raise Unsolved("conversions/dead_time_in_a_loop", closed=loop.feedback is not None)
    G: TransferFunction = yield from converted_to(loop.plant, TransferFunction)
    _expect_sizes(loop, *G.matrix.shape)
    x, C, H = G.variable, loop.controller, loop.feedback
    L = _multiplied(C, G.matrix)
    yield from forward_path_of(C, G.matrix, L, x, open_loop=H is None, several=True)
    T = L if H is None else (yield from _closed(L, H, x, alone=C == 1))
    fractions = [[sp.fraction(entry) for entry in row] for row in T.tolist()]
    if any(sp.degree(p, x) > sp.degree(q, x) for row in fractions for p, q in row if p != 0):
        raise Unsolved("conversions/improper_loop")
    numerators, denominators = (tuple(tuple(pair[i] for pair in row) for row in fractions) for i in (0, 1))
    return transfer_system(G, T, numerators, denominators)


@lemma("matrix_loop")
def _closed(L: ImmutableMatrix, H: Any, x: Symbol, *, alone: bool) -> Derivation[ImmutableMatrix]:
    """L (I + H L)⁻¹: the matrix, its determinant, its inverse, the product. `alone`: there is no controller in L."""
    identity = sp.ImmutableMatrix(sp.eye(L.cols))
    returned = sp.ImmutableMatrix((_multiplied(H, L) + identity).applyfunc(sp.cancel))
    det = sp.factor(exact.determinant(returned))
    stated = total(identity, L if H == 1 else product(H, L))
    claims = {
        "returned": Claim(stated, returned, "$I + H C G$"),
        "determinant": Claim(determinant(returned), det, "determinant of $I + H C G$"),
    }
    yield Step("returned", claims=claims, x=x, H=H, unity=H == 1, alone=alone, ill_posed=det == 0)
    if det == 0:
        raise Unsolved("conversions/ill_posed_matrix_loop")
    inverted = _cancelled(exact.inverse(returned))
    T = _multiplied(L, inverted)
    claims = {
        "inverse": Claim(inverse(returned), inverted, "inverse of $I + H C G$"),
        "multiplied": Claim(product(L, inverted), T, "closed loop $T$"),
        "substituted": Claim(product(L, inverse(stated)), T, "closed loop $T$"),
    }
    yield Step("closed_matrix", claims=claims, x=x, unity=H == 1, alone=alone)
    return T


def _expect_sizes(loop: MatrixFeedback, p: int, m: int) -> None:
    """Raise Unsolved where the matrices cannot be multiplied; what the file shows was refused before."""
    C, H = loop.controller, loop.feedback
    if hasattr(C, "shape") and C.shape[1] != p:
        raise Unsolved("conversions/controller_size", columns=C.shape[1], p=p, fits=C.shape[0] == p)
    outputs = C.shape[0] if hasattr(C, "shape") else p
    if H is None:
        return
    if not hasattr(H, "shape"):
        if outputs != m:
            raise Unsolved("conversions/feedback_not_square", rows=outputs, columns=m)
    elif H.shape != (m, outputs):
        fits = (H.shape[1], H.shape[0]) == (m, outputs)
        raise Unsolved(
            "conversions/feedback_size", rows=H.shape[0], columns=H.shape[1], m=m, outputs=outputs, fits=fits
        )


def _multiplied(left: Any, right: ImmutableMatrix) -> ImmutableMatrix:
    """The product in lowest terms; an expression multiplies every entry."""
    if left == 1:
        return _cancelled(right)
    return _cancelled(exact.multiply(left, right) if hasattr(left, "shape") else left * right)


def _cancelled(M: Any) -> ImmutableMatrix:
    return sp.ImmutableMatrix(M.applyfunc(sp.cancel))


@conversion(MatrixFeedback, StateSpace, gives=lambda _: ("matrix", "A", "B", "C", "D", "transfer_function"))
@lemma("matrix_loop")
def states_of_loop(loop: MatrixFeedback) -> Derivation[StateSpace]:
    """The states of G, then those of C, then those of H, each realized with as few as possible where it is none yet.

    Raises Unsolved where an element is improper, or I + D_H D_C D_G has no inverse.
    """
    if isinstance(loop.plant, DeadTime):
        raise Unsolved("conversions/dead_time_in_a_loop", closed=loop.feedback is not None)
    G = yield from _states_of_plant(loop)
    assert G.B is not None and G.C is not None and G.D is not None  # noqa: S101, PT018 - it has a transfer function
    _expect_sizes(loop, G.C.rows, G.B.cols)
    x: Symbol = sp.Symbol("z" if loop.discrete else "s")
    L, stated = exact.Realization(G.A, G.B, G.C, G.D), _transfer(exact.Realization(G.A, G.B, G.C, G.D), x)
    if loop.controller != 1:
        C = yield from _element(loop.controller, "C", G.C.rows, x, discrete=loop.discrete)
        L = exact.in_series(L, C)
        stated = product(loop.controller, stated)
        yield Step("series", claims=_as_stated(L, stated, x), **_blocks(L), own=C.A.rows)
    if loop.feedback is not None:
        H = yield from _element(loop.feedback, "H", L.C.rows, x, discrete=loop.discrete)
        T = exact.fed_back(L, H)
        if T is None:
            raise Unsolved("conversions/ill_posed_direct_path")
        identity = sp.ImmutableMatrix(sp.eye(L.B.cols))
        back = stated if loop.feedback == 1 else product(loop.feedback, stated)
        stated = product(stated, inverse(total(identity, back)))
        told = {"direct": not L.D.is_zero_matrix, "unity": loop.feedback == 1}
        yield Step("fed_back", claims=_as_stated(T, stated, x), **_blocks(T), own=H.A.rows, **told)
        L = T
    if L.A.rows == 0:
        raise Unsolved("conversions/constant_plant")
    own = L.A.rows == G.order  # no states but those of the plant
    names, start = (G.state_names, G.x0) if own else ((), None)
    return StateSpace(L.A, L.B, L.C, L.D, start, loop.discrete, loop.sample_time, names, G.input_names)


def _as_stated(found: exact.Realization, stated: Stated, x: Symbol) -> dict[str, Claim]:
    """That states have the transfer matrix stated."""
    return {"transfer": Claim(stated, _transfer(found, x), Phrase("the states have the transfer matrix"))}


def _blocks(found: exact.Realization) -> dict[str, Any]:
    """The matrices of a realization, by the names that the wording has for them."""
    return {"A": found.A, "B": found.B, "C": found.C, "D": found.D}


@lemma("matrix_loop")
def _states_of_plant(loop: MatrixFeedback) -> Derivation[StateSpace]:
    """The plant with its own states; a transfer matrix is realized with as few as possible."""
    if not isinstance(loop.plant, TransferFunction):
        plant: StateSpace = yield from converted_to(loop.plant, StateSpace)
        return plant
    found = yield from _realized(loop.plant.matrix, "G", loop.plant.variable, discrete=loop.discrete)
    return StateSpace(found.A, found.B, found.C, found.D, input_names=loop.plant.input_names)


@lemma("matrix_loop")
def _element(value: Any, name: str, size: int, x: Symbol, *, discrete: bool) -> Derivation[exact.Realization]:
    """A controller, or what is in the feedback path, with states."""
    matrix = value if hasattr(value, "shape") else sp.ImmutableMatrix(value * sp.eye(size))
    if not matrix.has(x):
        return exact.constant_realization(matrix)
    return (yield from _realized(matrix, name, x, discrete=discrete))


@lemma("matrix_loop")
def _realized(M: ImmutableMatrix, name: str, x: Symbol, *, discrete: bool) -> Derivation[exact.Realization]:
    """As few states as possible for a transfer matrix; raises Unsolved where it is improper."""
    if not M.has(x):
        return exact.constant_realization(M)
    pairs = [[sp.fraction(sp.cancel(entry)) for entry in row] for row in M.tolist()]
    if any(sp.degree(p, x) > sp.degree(q, x) for row in pairs for p, q in row if p != 0):
        raise Unsolved("conversions/improper_element", name=name)
    tops, bottoms = ([[pair[i] for pair in row] for row in pairs] for i in (0, 1))
    least = least_realization_of(exact.transfer_matrix_of_fractions(tops, bottoms, x), discrete=discrete)
    found: exact.Realization = _result(least)
    claim = Claim(_transfer(found, x), M, Phrase("the states have the transfer matrix"))
    yield Step("element", claims={"transfer": claim}, name=name, M=M, x=x, found=found)
    return found


def _result(derivation: Derivation[Any]) -> Any:
    """What a derivation finds, whose steps would lead away from the question."""
    while True:
        try:
            next(derivation)
        except StopIteration as end:
            return end.value


def _transfer(found: exact.Realization, x: Symbol) -> Stated:
    """C (xI − A)⁻¹ B + D as stated."""
    if found.A.rows == 0:
        return total(found.D)
    strictly = product(found.C, inverse(exact.pencil(found.A, x)), found.B)
    return strictly if found.D.is_zero_matrix else total(strictly, found.D)


def transfer_system(
    G: TransferFunction, matrix: ImmutableMatrix, numerators: Fractions, denominators: Fractions
) -> TransferFunction:
    """A result with time, names and variable of the plant."""
    outputs = G.output_names if matrix.rows == G.matrix.rows else ()
    x = G.variable
    return TransferFunction(matrix, numerators, denominators, x, G.discrete, G.sample_time, G.input_names, outputs)
