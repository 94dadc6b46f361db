"""Usual mistakes with z-transforms and difference equations, as the values that they lead to."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt, Slip, Task
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.tasks.sample_times import sample_time_of
from solver.tasks.transforms.difference_question import Question
from solver.tasks.transforms.sampled_image import terms_to_sample
from solver.tasks.transforms.transform_mistakes import VALUES_REVERSED, WITHOUT_VALUES

if TYPE_CHECKING:
    from sympy import Expr

    Change = Callable[[exact.TransformedTerm], exact.TransformedTerm]
    Pieces = tuple[exact.TransformPiece, ...]

BASE_INVERTED = Slip("base_inverted", "the base is inverted: $a^{k}$ goes with $z - a$")
SIN_COS = Slip("sin_cos", "sine and cosine are exchanged")
WITHOUT_Z = Slip("without_z", "the factor $z$ in the numerators is forgotten: $a^{k}$ goes with $z/(z - a)$")
WITHOUT_DELAY = Slip("without_delay", "a delay is forgotten")
DELAY_SIGN = Slip("delay_sign", "a delay has the wrong sign: what begins later has a factor $z^{-n}$")
NOT_MOVED = Slip("not_moved", "what stands behind a step is not written in the time since the step")
PRODUCT = Slip("product_of_images", "the transform of a product is not the product of the transforms")
WITHOUT_PERIOD = Slip("without_period", "the period $T$ is missing: a pole $p$ in $s$ becomes $e^{pT}$ in $z$")
Z_FOR_S = Slip(
    "z_for_s", "$z$ in place of $s$ does not give the z-transform: the samples of the function are transformed"
)
NOT_DIVIDED = Slip(
    "not_divided",
    r"$F$ is expanded and not $F/z$: $\frac{1}{z - a}$ is not the transform of $a^{k}$, $\frac{z}{z - a}$ is; "
    "the sequence is one sample early",
)
LATE = Slip("one_sample_late", "the sequence is one sample late: this is $f(k-1)$")
EARLY = Slip("one_sample_early", "the sequence is one sample early: this is $f(k+1)$")
WITHOUT_PULSES = Slip("without_pulses", r"the unit pulses of the pole at $z = 0$ are forgotten")
WITHOUT_STEP = Slip("without_step", "what begins later is not zero before: the step is forgotten")
AS_IN_TIME = Slip("poles_of_s", "the poles are treated as those of a Laplace transform: $p$ in $z$ goes with $p^{k}$")
AS_DERIVATIVES = Slip(
    "as_derivatives",
    "the rule is that of derivatives: a sample ahead is $zY - z\\,y(0)$, with a factor $z$ beside $y(0)$",
)


def _inverted(term: exact.TransformedTerm) -> exact.TransformedTerm:
    return replace(term, growth=1 / term.growth)


def _exchanged(term: exact.TransformedTerm) -> exact.TransformedTerm:
    other = {"sin": "cos", "cos": "sin", "sinh": "cosh", "cosh": "sinh"}
    return replace(term, wave=other.get(term.wave, term.wave))


def _changed(pieces: Pieces, change: Change) -> Pieces:
    return tuple(replace(each, terms=tuple(map(change, each.terms))) for each in pieces)


def name_mistakes_of_z_images(task: Task[Any, Any]) -> None:
    """Register what goes wrong with the transform F of a sequence or of a sampled function."""
    for slip, change in ((BASE_INVERTED, _inverted), (SIN_COS, _exchanged)):
        task.mistake(slip, "F")(_images_with(change))

    @task.mistake(WITHOUT_Z, "F")
    def without_z(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        """1/(z − a) for z/(z − a)."""
        yield sp.expand(attempt.ours / sp.Symbol("z"))

    @task.mistake(WITHOUT_DELAY, "F")
    def without_delay(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        """No factor z⁻ⁿ."""
        k, z = sp.symbols("k z")
        yield sp.Add(*(each.image(k, z) for each in _of_question(attempt)))

    @task.mistake(DELAY_SIGN, "F")
    def delay_reversed(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        """zⁿ for z⁻ⁿ."""
        k, z = sp.symbols("k z")
        yield sp.Add(*(z**each.delay * each.image(k, z) for each in _of_question(attempt)))

    @task.mistake(NOT_MOVED, "F")
    def not_moved(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        """z⁻ⁿ times the transform of g(k) where g(k) stands behind step(k − n)."""
        k, z = sp.symbols("k z")
        whole = sp.S.Zero
        for each in _of_question(attempt):
            inner = exact.sequence_pieces(each.function, k)
            whole += z**-each.delay * (exact.sequence_transform(inner, k, z) + each.impulse)
        yield whole

    _name_mistakes_of_samples(task)


def _name_mistakes_of_samples(task: Task[Any, Any]) -> None:
    """Those of products, and of a function that is sampled."""

    @task.mistake(PRODUCT, "F")
    def product_of_images(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        """𝒵{g} 𝒵{h} for 𝒵{g h}; of a sampled function with the image F₁ F₂ likewise."""
        k, z = sp.symbols("k z")
        pieces = _of_question(attempt)
        yield sp.Add(*(z**-each.delay * (each.impulse + _products(each, k, z)) for each in pieces))
        yield from _sampled_factors(attempt)

    @task.mistake(WITHOUT_PERIOD, "F")
    def without_period(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        """The function sampled with the period one."""
        F = attempt.given.options.F
        if F is not None:
            yield _sampled(F, sp.S.One)

    @task.mistake(Z_FOR_S, "F")
    def z_for_s(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        """F(z)."""
        F = attempt.given.options.F
        if F is not None:
            yield F.xreplace({sp.Symbol("s"): sp.Symbol("z")})


def _of_question(attempt: Attempt[Any, Any]) -> Pieces:
    """The pieces of the sequence; none of a sampled function."""
    f = attempt.given.options.f
    found: Pieces = exact.sequence_pieces(f, sp.Symbol("k")) if f is not None else ()
    return found


def _images_with(change: Change) -> Callable[[Attempt[Any, Any]], Iterable[Any]]:
    def wrong(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        k, z = sp.symbols("k z")
        pieces = _of_question(attempt)
        if pieces:
            yield exact.sequence_transform(_changed(pieces, change), k, z)

    return wrong


def _products(piece: exact.TransformPiece, k: Any, z: Any) -> Expr:
    """Each term with the transforms of its factors multiplied."""
    total = sp.S.Zero
    for term in piece.terms:
        parts = [replace(term, factor=sp.S.One, growth=sp.S.One, wave="", angle=sp.S.Zero)] if term.power else []
        parts += [replace(term, power=0, wave="", angle=sp.S.Zero)] if term.growth != 1 else []
        parts += [replace(term, power=0, growth=sp.S.One)] if term.wave else []
        total += term.factor * sp.Mul(*(each.pairs(k, z)[-1].image for each in parts or [term]))
    return total


def _sampled_factors(attempt: Attempt[Any, Any]) -> Iterator[Expr]:
    F, s = attempt.given.options.F, sp.Symbol("s")
    if F is None or F.has(sp.exp):
        return
    factors = exact.factors_for_convolution(exact.rational_image(F, s), s)
    if factors:
        yield sp.Mul(*(_sampled(each, sample_time_of(attempt.given)) for each in factors))


def _sampled(F: Expr, T: Expr) -> Expr:
    """The transform of the samples; a zero where the dead time is not in periods."""
    t, z = sp.symbols("t z")
    try:
        terms = terms_to_sample(F, T)
    except exact.NotExact:
        return sp.S.Zero
    return sp.Add(
        *(
            z**-each.n * term
            for each in terms
            for term in exact.sampled_image(each.image.function(t), t, T, each.ahead).terms(z)
        )
    )


def name_mistakes_of_sequences(task: Task[Any, Any]) -> None:
    """Register what goes wrong with the sequence f of an image F, and with its first values."""

    @task.mistake(NOT_DIVIDED, "f")
    def not_divided(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        """A aᵏ for A/(z − a)."""
        k, z = sp.symbols("k z")
        image = exact.sequence_image(attempt.given.options.F, z).fraction
        if len(image.direct) < 2 and image.proper is not None:
            constant = sp.Add(*image.direct) * sp.KroneckerDelta(k, 0) if image.direct else sp.S.Zero
            yield image.proper.function(k, discrete=True).matrix[0] + constant

    for slip, change in ((BASE_INVERTED, _inverted), (SIN_COS, _exchanged), (AS_IN_TIME, _as_in_time)):
        task.mistake(slip, "f")(_sequences_with(change))
    _shifted(task, "f")

    @task.mistake(WITHOUT_PULSES, "f")
    def without_pulses(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        """No δ(k − n)."""
        yield attempt.ours.replace(sp.KroneckerDelta, lambda *_: sp.S.Zero)

    @task.mistake(WITHOUT_STEP, "f")
    def without_step(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        """What is delayed without its step."""
        yield attempt.ours.replace(sp.Heaviside, lambda *_: sp.S.One)

    for slip, by in ((EARLY, 1), (LATE, -1)):
        task.mistake(slip, "values")(_other_values(by))


def _as_in_time(term: exact.TransformedTerm) -> exact.TransformedTerm:
    return replace(term, growth=sp.exp(term.growth))


def _sequences_with(change: Change) -> Callable[[Attempt[Any, Any]], Iterable[Any]]:
    def wrong(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        k = sp.Symbol("k")
        smooth = attempt.ours.replace(sp.KroneckerDelta, lambda *_: sp.S.Zero)
        if smooth.has(sp.Heaviside):
            return
        try:
            pieces = _changed(exact.sequence_pieces(smooth, k), change)
        except exact.NotExact:
            return
        terms = [term.factor * term.function(k) for each in pieces for term in each.terms]
        yield sp.Add(*terms, attempt.ours - smooth)

    return wrong


def _shifted(task: Task[Any, Any], answer: str) -> None:
    """Register a sequence that is one sample late or early."""

    @task.mistake(LATE, answer)
    def late(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        """f(k − 1), zero at k = 0 or not."""
        k = sp.Symbol("k")
        yield attempt.ours.xreplace({k: k - 1})
        yield attempt.ours.xreplace({k: k - 1}) * sp.Heaviside(k - 1, 1)

    @task.mistake(EARLY, answer)
    def early(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        """f(k + 1)."""
        k = sp.Symbol("k")
        yield attempt.ours.xreplace({k: k + 1})


def _other_values(by: int) -> Callable[[Attempt[Any, Any]], Iterable[Any]]:
    def wrong(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        z, count = sp.Symbol("z"), len(attempt.ours)
        image = exact.sequence_image(attempt.given.options.F, z).fraction
        values = list(exact.long_division(image, z, count + 1).values)
        yield values[1:] if by > 0 else [sp.S.Zero, *values[: count - 1]]

    return wrong


def name_mistakes_of_differences(task: Task[Any, Any]) -> None:
    """Register what goes wrong with difference equations."""

    @task.mistaken_question(WITHOUT_VALUES)
    def without_values(system: Any, options: Any) -> tuple[Any, Any] | None:
        """From rest."""
        initial = system.initial if options.initial is None else options.initial
        return (replace(system, initial={}), replace(options, initial={})) if any(initial.values()) else None

    @task.mistaken_question(VALUES_REVERSED)
    def values_reversed(system: Any, options: Any) -> tuple[Any, Any] | None:
        """The values at the start with the other sign."""
        initial = system.initial if options.initial is None else options.initial
        reversed_ = {jet: -value for jet, value in initial.items()}
        return (system, replace(options, initial=reversed_)) if any(initial.values()) else None

    @task.mistake(AS_DERIVATIVES, "solution")
    def as_derivatives(attempt: Attempt[Any, Any]) -> Iterator[Any]:
        """zY − y(0) for zY − z y(0)."""
        asked = Question.of(attempt.given)
        if asked.at_rest or len(asked.model.unknowns) > 1 or not any(asked.started):
            return
        _, whole, (power,) = asked.cleared
        part = asked.started[0] * (1 / asked.z - 1) * asked.z**power / whole
        (name,) = asked.model.unknowns
        terms = exact.read_sequence_image(sp.together(asked.images[name] + part), asked.z)
        if len(terms) == 1 and terms[0].delay == 0:
            yield {sp.Symbol(name, real=True): terms[0].image.function(asked.k)}

    for slip, by in ((EARLY, 1), (LATE, -1)):
        task.mistake(slip, "solution")(_moved_solution(by))


def _moved_solution(by: int) -> Callable[[Attempt[Any, Any]], Iterable[Any]]:
    def wrong(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        k = sp.Symbol("k")
        yield {name: f.xreplace({k: k + by}) for name, f in attempt.ours.items()}

    return wrong
