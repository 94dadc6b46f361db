"""Responses by transforms, as lemmas: the transformed equation, partial fractions, and back."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.arithmetic.fractions import expanded
from solver.arithmetic.transformed import term_by_term
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, quotient, total
from solver.stated.matrices import inverse
from solver.stated.transforms import inverse_laplace, inverse_z
from solver.tasks.linear_algebra.resolvent import completed_squares_of
from solver.tasks.linear_algebra.table_form import table_form_of
from solver.tasks.time_response.question import Question, entry_or_column

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

ZERO_INPUT, ZERO_STATE = r"\text{zi}", r"\text{zs}"


@lemma("response_transform")
def equation_of_transforms(asked: Question) -> Derivation[None]:
    """The transformed state equation, solved for X."""
    yield Step(
        "transformed_equation",
        unclaimed="the general formula, derived in the text",
        detail="full",
        discrete=asked.discrete,
        initial=asked.x0 is not None,
        forced=bool(asked.inputs),
    )


@lemma("response_transform")
def zero_input_by_transform(asked: Question) -> Derivation[None]:
    """(sI − A)⁻¹ x(0), transformed back."""
    image = asked.zero_input
    column = image.expression(asked.variable)
    yield Step(
        "zero_input_transform",
        claims={"image": Claim(product(inverse(asked.pencil()), asked.x0), column, "transform of the free motion")},
        discrete=asked.discrete,
        shown=product(exact.resolvent(asked.system.A, asked.variable), asked.x0),
        x0=asked.x0,
        whole=sp.ImmutableMatrix(asked.variable * column),
    )
    yield from transformed_back(asked, image, column, ZERO_INPUT)


@lemma("response_transform")
def zero_state_by_transform(asked: Question, piece: exact.Piece) -> Derivation[None]:
    """(sI − A)⁻¹ B U(s), transformed back; of a piece that comes later, measured from its start."""
    s, image = asked.variable, asked.zero_state(piece)
    U, column = piece.image(s, discrete=asked.discrete), image.expression(s)
    yield from input_transform(asked, piece, U)
    carried = s if asked.discrete else sp.Integer(1)
    divided = quotient(U, s) if asked.discrete else U
    stated = product(inverse(asked.pencil()), asked.system.B, divided)
    yield Step(
        "zero_state_transform",
        claims={"image": Claim(stated, column, "transform of the forced motion")},
        discrete=asked.discrete,
        shown=product(
            exact.resolvent(asked.system.A, s), asked.system.B, entry_or_column(sp.ImmutableMatrix(U / carried))
        ),
        delay=piece.delay,
        U=entry_or_column(sp.ImmutableMatrix(U)),
        whole=sp.ImmutableMatrix(s * column),
    )
    yield from transformed_back(asked, image, column, ZERO_STATE, piece.delay)


@lemma("response_transform")
def input_transform(asked: Question, piece: exact.Piece, U: ImmutableMatrix) -> Derivation[None]:
    """U(s), entry by entry; an impulse has the transform one."""
    s, t = asked.variable, asked.time
    invert = inverse_z if asked.discrete else inverse_laplace
    smooth = sp.ImmutableMatrix(U - piece.impulses)
    claims = {
        f"u{i}": Claim(invert(smooth[i - 1], s, t), u, "transform of the input")
        for i, u in enumerate(piece.inputs.flat(), 1)
        if u != 0
    }
    yield Step(
        "input_transform",
        claims=claims,
        unclaimed="" if claims else "the transform of an impulse is one, by definition",
        discrete=asked.discrete,
        inputs=list(zip(piece.inputs.flat(), piece.impulses.flat(), U.flat(), strict=True)),
        delay=piece.delay,
        single=len(U) == 1,
    )


@lemma("response_transform")
def transformed_back(
    asked: Question,
    image: exact.RationalMatrix,
    column: ImmutableMatrix,
    part: str,
    delay: Any = 0,
    letter: str = "x",
) -> Derivation[None]:
    """Partial fractions of a column of transforms, the pairs they need, and the function of time.

    `column` is the whole of which `image` is the strictly proper part; `letter` and `part` name them.
    """
    s, t, discrete = asked.variable, asked.time, asked.discrete
    names: dict[str, Any] = {"letter": letter, "part": part, "discrete": discrete, "delay": delay}
    terms = image.partial_fractions(s)
    if not terms:
        yield Step("nothing", unclaimed="zero in the transform is zero in time", x=column, **names)
        return
    single = len(column) == 1
    shown: list[Any] = [exact.fraction_of_term(term) for term in terms] if single else [*terms]
    expansion = total(*shown)
    direct = sp.ImmutableMatrix((column - image.expression(s)).applyfunc(sp.cancel))
    whole = expansion if direct.is_zero_matrix else total(entry_or_column(direct), *shown)
    yield Step(
        "partial_fractions",
        claims={"expansion": Claim(entry_or_column(column), whole, "partial fractions")},
        steps=expanded(image, s),
        cancelled=[each.factor for each in image.residues if each not in [pole for pole, _ in image.poles]],
        single=single,
        **names,
        **exact.Denominators.of(image, s).named,
    )
    function = asked.function(image)
    yield from completed_squares_of(image, s)
    if single and not discrete:
        yield from table_form_of(image, shown, s, t, function, discrete=False)
    yield _pairs(asked, image, names)
    invert = inverse_z if discrete else inverse_laplace
    carried = product(s, expansion) if discrete else expansion
    yield Step(
        "transformed_back",
        claims={"x": Claim(invert(carried, s, t), entry_or_column(function), "transformed back, term by term")},
        steps=() if single and not discrete else term_by_term(image, s, t, function, discrete=discrete),
        resonant=any(order > 1 and each.factor.multiplicity > 1 for each, order in image.poles),
        direct=None if direct.is_zero_matrix else direct,
        shifted=asked.begun(function, delay),
        earlier=entry_or_column(sp.ImmutableMatrix(function.xreplace({t: t - 1}))),
        single=single,
        **names,
    )


def _pairs(asked: Question, image: exact.RationalMatrix, names: dict[str, Any]) -> Step:
    """The transform pairs of the partial fractions."""
    s, t, discrete = asked.variable, asked.time, asked.discrete
    invert = inverse_z if discrete else inverse_laplace
    pairs = exact.pairs_for(image, s, t, discrete=discrete)
    claims = {
        f"pair{i}": Claim(invert(left, s, t), right, "transform pair") for i, (left, right) in enumerate(pairs, 1)
    }
    return Step("pairs", claims=claims, detail="full", **names)
