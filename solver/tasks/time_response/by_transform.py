"""Responses by transforms, as lemmas: the transformed equation, partial fractions, and back."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, quotient, total
from solver.stated.matrices import inverse
from solver.stated.transforms import inverse_laplace, inverse_z
from solver.tasks.linear_algebra.resolvent import completed_squares_of
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
    )
    yield from _transformed_back(asked, image, column, ZERO_INPUT)


@lemma("response_transform")
def zero_state_by_transform(asked: Question, piece: exact.Piece) -> Derivation[None]:
    """(sI − A)⁻¹ B U(s), transformed back; of a piece that comes later, measured from its start."""
    s, image = asked.variable, asked.zero_state(piece)
    U, column = piece.image(s, discrete=asked.discrete), image.expression(s)
    yield _input_transform(asked, piece, U)
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
    )
    yield from _transformed_back(asked, image, column, ZERO_STATE, piece.delay)


def _input_transform(asked: Question, piece: exact.Piece, U: ImmutableMatrix) -> Step:
    """U(s), entry by entry; an impulse has the transform one."""
    s, t = asked.variable, asked.time
    invert = inverse_z if asked.discrete else inverse_laplace
    smooth = sp.ImmutableMatrix(U - piece.impulses)
    claims = {
        f"u{i}": Claim(invert(smooth[i - 1], s, t), u, "transform of the input")
        for i, u in enumerate(piece.inputs.flat(), 1)
        if u != 0
    }
    return Step(
        "input_transform",
        claims=claims,
        unclaimed="" if claims else "the transform of an impulse is one, by definition",
        discrete=asked.discrete,
        inputs=list(zip(piece.inputs.flat(), piece.impulses.flat(), U.flat(), strict=True)),
        delay=piece.delay,
        single=len(U) == 1,
    )


def _transformed_back(
    asked: Question, image: exact.RationalMatrix, column: ImmutableMatrix, part: str, delay: Any = 0
) -> Derivation[None]:
    """Partial fractions of a column of transforms, the pairs they need, and the function of time."""
    s, t, discrete = asked.variable, asked.time, asked.discrete
    terms = image.partial_fractions(s)
    if not terms:
        yield Step("nothing", unclaimed="zero in the transform is zero in time", part=part, discrete=discrete, x=column)
        return
    expansion = total(*terms)
    names: dict[str, Any] = {"part": part, "discrete": discrete, "delay": delay}
    yield Step(
        "partial_fractions",
        claims={"expansion": Claim(column, expansion, "partial fractions")},
        cancelled=[each.factor for each in image.residues if each not in [pole for pole, _ in image.poles]],
        **names,
        **exact.Denominators.of(image, s).named,
    )
    yield from completed_squares_of(image, s)
    invert = inverse_z if discrete else inverse_laplace
    pairs = exact.pairs_for(image, s, t, discrete=discrete)
    yield Step(
        "pairs",
        claims={
            f"pair{i}": Claim(invert(left, s, t), right, "transform pair") for i, (left, right) in enumerate(pairs, 1)
        },
        detail="full",
        **names,
    )
    function = asked.function(image)
    carried = product(s, expansion) if discrete else expansion
    yield Step(
        "transformed_back",
        claims={"x": Claim(invert(carried, s, t), function, "transformed back, term by term")},
        resonant=any(order > 1 and each.factor.multiplicity > 1 for each, order in image.poles),
        shifted=asked.begun(function, delay),
        **names,
    )
