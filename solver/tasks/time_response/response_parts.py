"""Responses as lemmas: the transforms, the convolution, and what the sum of both parts shows."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Claim, Derivation, Given, Step, lemma
from solver.derivation.figures import Curve, Mark, Plot
from solver.derivation.stated import (
    derivative,
    integral,
    inverse,
    inverse_laplace,
    inverse_z,
    product,
    quotient,
    summation,
    total,
    value_at,
)
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.tasks.linear_algebra.resolvent import (
    completed_squares_of,
    inverse_of_pencil,
    partial_fractions_of,
    transform_pairs_of,
)

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

    from solver.systems import StateSpace

ZERO_INPUT, ZERO_STATE = r"\text{zi}", r"\text{zs}"


@dataclass(frozen=True)
class Question:
    """What is asked: the response of a system to an initial state (None: zero) and to inputs (none: no input)."""

    system: StateSpace
    x0: ImmutableMatrix | None
    inputs: tuple[Expr, ...]
    kind: str

    @staticmethod
    def of(given: Given) -> Question:
        """The question of a part: the initial state is the option, or else the system's."""
        x0 = given.initial_state if given.initial_state is not None else given.system.x0
        if given.kind == "zero_state" or (x0 is not None and x0.is_zero_matrix and given.kind != "zero_input"):
            x0 = None
        inputs = () if given.kind == "zero_input" else tuple(given.input)
        return Question(given.system, x0, inputs, given.kind)

    @property
    def discrete(self) -> bool:
        """Whether time is discrete."""
        return self.system.discrete

    @cached_property
    def time(self) -> Symbol:
        """The symbol t, or k."""
        return sp.Symbol("k" if self.discrete else "t")

    @cached_property
    def variable(self) -> Symbol:
        """The symbol s, or z."""
        return sp.Symbol("z" if self.discrete else "s")

    @cached_property
    def pieces(self) -> tuple[exact.Piece, ...]:
        """What begins in the inputs, time by time."""
        return exact.read_inputs(self.inputs, self.time, discrete=self.discrete) if self.inputs else ()

    @cached_property
    def answer(self) -> exact.ClosedForm:
        """The response in closed form."""
        return exact.response(self.system, self.x0, self.inputs, self.time)

    @cached_property
    def zero_input(self) -> exact.RationalMatrix:
        """The transform of the zero-input response of the states (in discrete time divided by z)."""
        return exact.piece_response(self.system, self.x0, None).x

    def zero_state(self, piece: exact.Piece) -> exact.RationalMatrix:
        """The transform of what a piece of the inputs adds to the states, from the start of the piece."""
        return exact.piece_response(self.system, None, piece).x

    def function(self, image: exact.RationalMatrix) -> ImmutableMatrix:
        """The function of time that has an image."""
        f: ImmutableMatrix = image.function(self.time, discrete=self.discrete).matrix
        return f

    def pencil(self) -> ImmutableMatrix:
        """The matrix sI − A (zI − A)."""
        return sp.ImmutableMatrix(self.variable * sp.eye(self.system.order) - self.system.A)


@lemma("response")
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


@lemma("response")
def zero_input_by_transform(asked: Question) -> Derivation[None]:
    """(sI − A)⁻¹ x(0), transformed back."""
    image = asked.zero_input
    column = image.expression(asked.variable)
    yield Step(
        "zero_input_transform",
        claims={"image": Claim(product(inverse(asked.pencil()), asked.x0), column, "transform of the free motion")},
        discrete=asked.discrete,
        shown=product(exact.resolvent(asked.system.A, asked.variable), asked.x0),
    )
    yield from _transformed_back(asked, image, column, ZERO_INPUT)


@lemma("response")
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
        shown=product(exact.resolvent(asked.system.A, s), asked.system.B, _unwrapped(sp.ImmutableMatrix(U / carried))),
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
        shifted=exact.shifted(function, t, delay),
        **names,
    )


@lemma("response")
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


@lemma("response")
def transition_matrix_of(asked: Question) -> Derivation[ImmutableMatrix]:
    """Φ by the transform of the resolvent; returns it (n×n)."""
    A, s, t, discrete = asked.system.A, asked.variable, asked.time, asked.discrete
    yield from inverse_of_pencil(A, s)
    expansion = yield from partial_fractions_of(A, s)
    yield from transform_pairs_of(A, s, t, discrete=discrete)
    Phi = (exact.power if discrete else exact.exponential)(A, t).matrix
    stated = inverse_z(product(s, expansion), s, t) if discrete else inverse_laplace(expansion, s, t)
    yield Step("transition", claims={"Phi": Claim(stated, Phi, "state transition matrix")}, discrete=discrete)
    return Phi


@lemma("response")
def zero_input_by_convolution(asked: Question, Phi: ImmutableMatrix) -> Derivation[None]:
    """Φ(t) x(0)."""
    x = asked.function(asked.zero_input)
    yield Step(
        "free_motion",
        claims={"x": Claim(product(Phi, asked.x0), x, "free motion")},
        discrete=asked.discrete,
    )


@lemma("response")
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
        yield Step("convolution_sum", claims={"x": Claim(stated, x, "convolution sum")}, B=B, u=u, **names)
        return
    tau = sp.Symbol("tau")
    u = piece.inputs.xreplace({t: tau})
    shifted = Phi.xreplace({t: t - tau})
    integrand = sp.ImmutableMatrix((shifted * B * u).applyfunc(sp.expand_mul))
    terms: list[Any] = [integral(integrand, tau, sp.Integer(0), t)] if any(u.flat()) else []
    if any(piece.impulses.flat()):
        terms.append(product(Phi, B, piece.impulses))
    claims = {"x": Claim(total(*terms), x, "convolution")}
    if any(u.flat()):
        claims = {"integrand": Claim(product(shifted, B, u), integrand, "what is integrated"), **claims}
    yield Step("convolution", claims=claims, B=B, x=exact.shifted(x, t, piece.delay), **names)


@lemma("response")
def put_together(asked: Question) -> Derivation[Answers]:
    """The parts added up, and the output; returns the answers."""
    found = asked.answer
    parts = [asked.function(asked.zero_input)] if asked.x0 is not None else []
    parts += [exact.shifted(asked.function(asked.zero_state(piece)), asked.time, piece.delay) for piece in asked.pieces]
    if len(parts) > 1:
        yield Step(
            "sum",
            claims={"x": Claim(total(*parts), found.x, "sum of the parts")},
            discrete=asked.discrete,
            initial=asked.x0 is not None,
        )
    answers = Answers(x=found.x)
    if found.y is None:
        return answers
    yield _output(asked)
    answers["y"] = _unwrapped(found.y)
    if found.y_final is not None:
        answers["y_final"] = _unwrapped(found.y_final)
    if found.y_peak is not None:
        answers |= {"y_peak": found.y_peak.value, "t_peak": found.y_peak.time}
    yield behaviour(asked)
    return answers


def _unwrapped(column: ImmutableMatrix) -> Any:
    return column[0] if len(column) == 1 else column


def _output(asked: Question) -> Step:
    """The output equation y = C x + D u; what impulses the input passes on through D is added beside the claim."""
    found, system, t = asked.answer, asked.system, asked.time
    terms: list[Any] = [product(system.C, found.x)]
    through = system.D is not None and any(system.D.flat()) and bool(asked.inputs)
    if through:
        u = sp.zeros(len(asked.inputs), 1)
        for piece in asked.pieces:
            u += exact.shifted(piece.inputs, t, piece.delay)
        terms.append(product(system.D, sp.ImmutableMatrix(u)))
    y: Any = found.y
    smooth = y - found.impulse if found.impulse is not None else y
    return Step(
        "output",
        claims={"y": Claim(total(*terms), sp.ImmutableMatrix(smooth), "output equation")},
        discrete=asked.discrete,
        through=through,
        y=y,
        impulse=found.impulse,
        single=len(y) == 1,
    )


def behaviour(asked: Question) -> Step:
    """The limit and the peak of y, the modes that it does not show, and a plot."""
    found, t, s = asked.answer, asked.time, asked.variable
    claims: dict[str, Claim] = {}
    image = found.pieces[0][1].y
    if found.y_final is not None and image is not None and len(found.pieces) == 1:
        at = sp.Integer(1 if asked.discrete else 0)
        carried = image.expression(s).applyfunc(lambda entry: (s - at) * entry)
        claims["final"] = Claim(value_at(carried, s, at), found.y_final, "final value theorem")
    peak = found.y_peak
    if peak is not None:
        y: Any = found.y
        if not asked.discrete:
            claims["slope"] = Claim(value_at(derivative(y[0], t), t, peak.time), sp.Integer(0), "slope at the peak")
        claims["peak"] = Claim(value_at(y[0], t, peak.time), peak.value, "value at the peak")
    figure = _plot(asked)
    return Step(
        "behaviour",
        claims=claims,
        unclaimed="" if claims else "a description of the answer",
        figures=(figure,) if figure else (),
        discrete=asked.discrete,
        peak=peak,
        final=None if found.y_final is None else _unwrapped(found.y_final),
        hidden=_hidden_modes(asked),
        lasting=[] if found.y_final is not None else _lasting_poles(asked),
        variable=s,
        plotted=figure is not None,
        single=image is not None and image.shape == (1, 1),
    )


def _lasting_poles(asked: Question) -> list[tuple[Any, int]]:
    """The poles of Y, and how often, that keep y from a limit: neither do they die out nor are they one constant."""
    poles = [pole for _, each in asked.answer.pieces if each.y is not None for pole in each.y.poles]
    found: dict[Any, int] = {}
    for each, order in poles:
        constant = exact.constant_root(each.factor, discrete=asked.discrete) and order == 1
        if not constant and not exact.decays(each.factor, discrete=asked.discrete):
            found |= {root.value: max(order, found.get(root.value, 0)) for root in each.factor.roots}
    return list(found.items())


def _hidden_modes(asked: Question) -> list[Any]:
    """The eigenvalues of A whose modes are missing in y."""
    images = [each.y for _, each in asked.answer.pieces if each.y is not None]
    seen = {root.value for image in images for each, _ in image.poles for root in each.factor.roots}
    return [root.value for root in exact.spectrum(asked.system.A).roots if root.value not in seen]


def _plot(asked: Question) -> Plot | None:
    """States and output over time; None where symbols other than time are left."""
    found, t = asked.answer, asked.time
    y: Any = found.y
    smooth = y - found.impulse if found.impulse is not None else y
    if (found.x.free_symbols | smooth.free_symbols) - {t}:
        return None
    stop = exact.horizon([each.x for _, each in found.pieces], discrete=asked.discrete)
    if stop is None:
        return None
    stop += max((delay for delay, _ in found.pieces), default=0)
    style = "samples" if asked.discrete else "line"
    states = [Curve(x, f"x_{{{i}}}", style=style) for i, x in enumerate(found.x.flat(), 1)]
    several = len(y) > 1
    outputs = [Curve(each, f"y_{{{i}}}" if several else "y", style=style) for i, each in enumerate(smooth.flat(), 1)]
    marks = (Mark(found.y_peak.time, found.y_peak.value, r"y_{\text{peak}}"),) if found.y_peak else ()
    caption = "States and output" + ("s" if several else "")
    letter = "k" if asked.discrete else "t"
    return Plot(caption, letter, "", t, sp.Integer(0), stop, (*states, *outputs), marks)
