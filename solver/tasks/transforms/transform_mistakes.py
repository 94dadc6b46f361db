"""Usual mistakes with transforms and differential equations, as the values that they lead to."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from math import factorial
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt, Slip, Task
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.tasks.transforms.back_transform import moved_by
from solver.tasks.transforms.equation_question import Question

if TYPE_CHECKING:
    from sympy import Expr

    Change = Callable[[exact.TransformedTerm], exact.TransformedTerm]
    Pieces = tuple[exact.TransformPiece, ...]

SHIFT_SIGN = Slip("shift_sign", "a shift of $s$ has the wrong sign: $e^{at}$ goes with $s - a$")
FACTORIAL = Slip("factorial", "the factorial of a power of $t$ is forgotten: $t^n$ goes with $n!/s^{n+1}$")
SIN_COS = Slip("sin_cos", "sine and cosine are exchanged")
FREQUENCY = Slip("frequency", r"$\omega$ of a sine is forgotten: $\sin\omega t$ goes with $\omega/(s^2 + \omega^2)$")
WITHOUT_DELAY = Slip("without_delay", "a delay is forgotten")
DELAY_SIGN = Slip("delay_sign", "a delay has the wrong sign: what begins later has a factor with a negative exponent")
NOT_MOVED = Slip("not_moved", "what stands behind a step is not written in the time since the step")
WITHOUT_STEP = Slip("not_moved", "the function is not shifted, it only begins later")
WITHOUT_VALUES = Slip("without_initial_values", "the values at the start are forgotten")
VALUES_REVERSED = Slip("initial_sign", "the values at the start have the wrong sign")
JUMP_IGNORED = Slip("jump_ignored", "the values given are those before the input acts; it makes them jump")


def _reversed(term: exact.TransformedTerm) -> exact.TransformedTerm:
    return replace(term, growth=-term.growth)


def _exchanged(term: exact.TransformedTerm) -> exact.TransformedTerm:
    other = {"sin": "cos", "cos": "sin", "sinh": "cosh", "cosh": "sinh"}
    return replace(term, wave=other.get(term.wave, term.wave))


def _scaled(by: Callable[[exact.TransformedTerm], Any]) -> Change:
    return lambda term: replace(term, factor=term.factor * by(term))


def _changed(pieces: Pieces, change: Change) -> Pieces:
    return tuple(replace(each, terms=tuple(map(change, each.terms))) for each in pieces)


def _frequency(term: exact.TransformedTerm) -> Expr:
    return term.angle if term.wave in ("sin", "sinh") else sp.S.One


def name_mistakes_of_images(task: Task[Any, Any]) -> None:
    """Register what goes wrong with a transform F of a function f."""
    changes: list[tuple[Slip, Change]] = [
        (SHIFT_SIGN, _reversed), (SIN_COS, _exchanged),
        (FACTORIAL, _scaled(lambda term: sp.Rational(1, factorial(term.power)))),
        (FREQUENCY, _scaled(lambda term: 1 / _frequency(term))),
    ]  # fmt: skip
    for slip, change in changes:
        task.mistake(slip, "F")(_images_with(change))

    @task.mistake(WITHOUT_DELAY, "F")
    def without_delay(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        """No factor e^{−Ts}."""
        t, s = sp.symbols("t s")
        yield sp.Add(*(each.image(t, s) for each in exact.transform_pieces(attempt.given.options.f, t)))

    @task.mistake(DELAY_SIGN, "F")
    def delay_reversed(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        """e^{Ts} for e^{−Ts}."""
        t, s = sp.symbols("t s")
        pieces = exact.transform_pieces(attempt.given.options.f, t)
        yield sp.Add(*(sp.exp(each.delay * s) * each.image(t, s) for each in pieces))

    @task.mistake(NOT_MOVED, "F")
    def not_moved(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        """e^{−Ts} times the transform of g(t) where g(t) stands behind step(t − T)."""
        t, s = sp.symbols("t s")
        total = sp.S.Zero
        for each in exact.transform_pieces(attempt.given.options.f, t):
            inner = exact.transform_pieces(each.function, t)
            total += sp.exp(-each.delay * s) * (exact.transform_of_pieces(inner, t, s) + each.impulse)
        yield total


def _images_with(change: Change) -> Callable[[Attempt[Any, Any]], Iterable[Any]]:
    def wrong(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        t, s = sp.symbols("t s")
        yield exact.transform_of_pieces(_changed(exact.transform_pieces(attempt.given.options.f, t), change), t, s)

    return wrong


def name_mistakes_of_functions(task: Task[Any, Any]) -> None:
    """Register what goes wrong with the function f of a transform F."""
    changes: list[tuple[Slip, Change]] = [
        (SHIFT_SIGN, _reversed), (SIN_COS, _exchanged), (FREQUENCY, _scaled(_frequency)),
        (FACTORIAL, _scaled(lambda term: sp.Integer(factorial(term.power)))),
    ]  # fmt: skip
    for slip, change in changes:
        task.mistake(slip, "f")(_functions_with(change))

    @task.mistake(WITHOUT_DELAY, "f")
    def without_delay(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        """All begins at zero."""
        t = sp.Symbol("t")
        yield sp.Add(*(_in_time(each, t) for each in _pieces_of(attempt.ours)))

    @task.mistake(WITHOUT_STEP, "f")
    def not_shifted(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        """f(t) step(t − T) for f(t − T) step(t − T)."""
        t = sp.Symbol("t")
        terms = ((each.delay, _in_time(each, t)) for each in _pieces_of(attempt.ours))
        yield sp.Add(*(f if delay == 0 else f * sp.Heaviside(t - delay) for delay, f in terms))


def _functions_with(change: Change) -> Callable[[Attempt[Any, Any]], Iterable[Any]]:
    def wrong(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        t = sp.Symbol("t")
        pieces = _changed(_pieces_of(attempt.ours), change)
        if pieces:
            yield sp.Add(*(moved_by(each.delay, _in_time(each, t), t) for each in pieces))

    return wrong


def _pieces_of(f: Expr) -> Pieces:
    """The pieces of a solution; none where it holds what is no sum of terms of the table."""
    try:
        found: Pieces = exact.transform_pieces(f, sp.Symbol("t"))
    except exact.NotExact:
        return ()
    return found


def _in_time(piece: exact.TransformPiece, t: Any) -> Expr:
    terms = (term.factor * term.function(t) for term in piece.terms)
    return sp.Add(*terms, *([piece.impulse * sp.DiracDelta(t)] if piece.impulse != 0 else []))


def name_mistakes_of_equations(task: Task[Any, Any]) -> None:
    """Register what goes wrong with differential equations."""

    @task.mistaken_question(WITHOUT_VALUES)
    def without_values(system: Any, options: Any) -> tuple[Any, Any] | None:
        """Zero for all values at the start."""
        initial = system.initial if options.initial is None else options.initial
        return (system, replace(options, initial={})) if any(initial.values()) else None

    @task.mistaken_question(VALUES_REVERSED)
    def values_reversed(system: Any, options: Any) -> tuple[Any, Any] | None:
        """The values at the start with the other sign."""
        initial = system.initial if options.initial is None else options.initial
        reversed_ = {jet: -value for jet, value in initial.items()}
        return (system, replace(options, initial=reversed_)) if any(initial.values()) else None

    @task.mistake(JUMP_IGNORED, "solution")
    def jump_ignored(attempt: Attempt[Any, Any]) -> Iterator[Any]:
        """The values at 0− taken for those at 0+: derivatives of inputs without their jumps."""
        asked = Question.of(attempt.given)
        images = [each.image for terms in asked.terms.values() for each in terms]
        if len(asked.model.unknowns) > 1 or any(image.direct for image in images):
            return
        right = asked.right[0] - exact.jumps_of_inputs(asked.operators, asked.pieces, asked.t)
        whole, (part,) = exact.images_of_unknowns(asked.operators, sp.ImmutableMatrix([right]))
        terms = exact.read_image(part / whole, asked.s)
        found = sp.Add(*(moved_by(each.delay, each.image.function(asked.t), asked.t) for each in terms))
        yield {asked.model.symbol((asked.model.unknowns[0], 0)): found}
