"""The oracles' view of a response: nothing of the derivation takes part."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any

from solver.derivation import Check, Claim, Given
from solver.lazy import numeric, systems
from solver.lazy import sympy as sp
from solver.numeric.judges import time_response as judges
from solver.stated.algebra import product, total
from solver.stated.calculus import derivative, value_at
from solver.tasks.meanings import difference_at, difference_of
from solver.tasks.told import shortened
from solver.words import Phrase, Reason, formula

if TYPE_CHECKING:
    from sympy import Symbol

    from solver.systems import StateSpace
    from solver.tasks.time_response.question import Moving
    from solver.tasks.time_response.response import ResponseOptions


SAMPLES = 21
"""Samples at which a discrete response is compared, counted from the last jump of the input."""


@dataclass(frozen=True)
class Truth:
    """What is given, as numbers see it: system, initial state, inputs (a column, or None) and the symbol of time."""

    system: StateSpace
    x0: Any
    inputs: Any
    time: Symbol

    @staticmethod
    def of(given: Given[Moving, ResponseOptions]) -> Truth:
        """The question of a part; what a dead time holds back comes later, a transfer function begins at rest."""
        system: Any = given.system
        kind, delay = given.options.kind, sp.S.Zero
        if isinstance(system, systems.LateInput):
            system, delay = system.plant, system.delay
        elif isinstance(system, systems.DeadTime):
            system, delay = system.rational, system.delay
        if isinstance(system, systems.TransferFunction):
            A, B, C, D = judges.realized(system.matrix, system.variable)
            system = systems.StateSpace(A, B, C, D, discrete=system.discrete, sample_time=system.sample_time)
        x0 = given.options.initial_state if given.options.initial_state is not None else system.x0
        if x0 is None or kind == "zero_state":
            x0 = sp.ImmutableMatrix(sp.zeros(system.order, 1))
        t = sp.Symbol("k" if system.discrete else "t")
        late = [judges.delayed(u, t, delay) for u in given.options.input or ()]
        return Truth(system, x0, None if kind == "zero_input" else sp.ImmutableMatrix(late), t)

    def output(self, x: Any, u: Any) -> Any:
        """C x + D u as stated."""
        system = self.system
        passes = u is not None and system.D is not None and any(system.D.flat())
        return total(product(system.C, x), product(system.D, u)) if passes else product(system.C, x)


def checks_of(given: Given[Moving, ResponseOptions], value: Any, answer: str) -> Iterable[Check]:
    """The checks of x or of y, each for itself."""
    truth = Truth.of(given)
    column = _column(value)
    if not truth.system.order:
        yield numeric.check_claim(Claim(product(truth.system.D, truth.inputs), column), "$y = D u$", answer=answer)
        return
    judge = _sample_by_sample if given.system.discrete else _interval_by_interval
    try:
        yield from judge(truth, column, answer)
    except numeric.NotEvaluable as refusal:
        yield Check.skipped("the response at several times", "scipy.linalg.expm", refusal.reason, answer=answer)


def _interval_by_interval(truth: Truth, column: Any, answer: str) -> Iterable[Check]:
    """The differential equation and the convolution formula on every interval without jumps."""
    t, system = truth.time, truth.system
    u = truth.inputs
    spans = judges.intervals(t, column, *([u] if u is not None else []))
    scale = judges.time_scale(system.A)
    for number, span in enumerate(spans):
        here = span.smooth(column, t)
        u_here = span.smooth(u, t) if u is not None else None
        convolution = judges.convolution_formula(system.A, system.B, truth.x0, u, t, span, spans[:number])
        wanted = convolution if answer == "x" else truth.output(convolution, u_here)
        after = Phrase(" after $t = {at}$", at=formula(span.start)) if number else ""
        for index, time in enumerate(span.times(t, scale)):
            if answer != "x" or index == 0:  # for x the differential equation says the same at the others
                claim = Claim(value_at(here, t, time), value_at(wanted, t, time))
                yield numeric.check_claim(claim, Phrase("convolution formula{after}", after=after), answer=answer)
            if answer == "x":
                change = product(system.A, here)
                if u_here is not None:
                    change = total(change, product(system.B, u_here))
                claim = Claim(value_at(derivative(here, t), t, time), value_at(change, t, time))
                yield numeric.check_claim(claim, Phrase(r"$\dot{{x}} = A x + B u${after}", after=after), answer=answer)
    if answer == "x":
        start = total(truth.x0, *(product(system.B, w) for at, w in _impulses(truth) if at == 0))
        first = spans[0].smooth(column, t)
        yield numeric.check_claim(Claim(value_at(first, t, sp.S.Zero), start), "initial state", answer=answer)
    else:
        yield from _impulses_in_y(truth, column)


def _impulses(truth: Truth) -> list[tuple[Any, Any]]:
    return judges.impulses(truth.inputs, truth.time) if truth.inputs is not None else []


def _impulses_in_y(truth: Truth, y: Any) -> Iterable[Check]:
    """The impulses of the input come through D into y, and no others."""
    stated = dict(judges.impulses(y, truth.time))
    passing = dict(_impulses(truth)) if truth.system.D is not None else {}
    for at in dict.fromkeys([*stated, *passing]):
        zero = sp.ImmutableMatrix(sp.zeros(y.rows, 1))
        expected = product(truth.system.D, passing[at]) if at in passing else zero
        label = Phrase("impulse in $y$ at $t = {at}$", at=formula(at))
        yield numeric.check_claim(Claim(stated.get(at, zero), expected), label, answer="y")


def _sample_by_sample(truth: Truth, column: Any, answer: str) -> Iterable[Check]:
    """The recursion from x(0), sample by sample."""
    k, system = truth.time, truth.system
    value = judges.sampled(column, k)
    last = SAMPLES + max([int(at) for at in judges.beginnings(truth.inputs, k)], default=0)
    wanted = judges.samples(system.A, system.B, truth.x0, truth.inputs, k, last)
    # decimals are put in where their rounding is watched: what cancels then is known to be zero
    at = partial(value_at, value, k) if numeric.holds_decimals(value) else lambda i: value.xreplace({k: i})
    pairs = [(at(sp.Integer(i)), x if answer == "x" else truth.output(x, u)) for i, x, u in wanted]
    yield numeric.check_residual(
        Phrase("the recursion $x(k + 1) = A x(k) + B u(k)$ for $k = 0, \\ldots, {last}$", last=last - 1),
        "recursion",
        lambda: judges.residual_of_pairs(pairs),
        answer=answer,
    )


def final_value_checks(given: Given[Moving, ResponseOptions], value: Any) -> Iterable[Check]:
    """The limit of y against the equilibrium that a stable system reaches."""
    truth, column = Truth.of(given), _column(value)

    def residual() -> float:
        return judges.limit_residual(
            judges.simulations(truth.system, truth.x0, truth.inputs, truth.time, late=True),
            column,
            discrete=truth.system.discrete,
        )

    yield numeric.check_residual(r"limit of $y$", "numpy.linalg.solve", residual, answer="y_final")


def peak_checks(given: Given[Moving, ResponseOptions], peak: Any, time: Any) -> Iterable[Check]:
    """The peak of y and its time (either may be missing) against a simulation."""
    truth, start = _from_the_beginning(Truth.of(given))
    out_of_it = numeric.free_symbols(start) - numeric.free_symbols([truth.system.A, truth.system.C, truth.inputs])
    if time is not None:
        time = sp.expand(time - start)
    for name, value, which in (("t_peak", time, 0), ("y_peak", peak, 1)):
        if value is not None:
            label = "time of the largest $|y|$" if which == 0 else "largest $|y|$"
            if numeric.free_symbols(value) & out_of_it:  # nothing of it depends on when it began
                yield Check.that(label, "mpmath simulation", False, answer=name)
                continue
            residual = partial(_peak_residual, truth, value, which)
            yield numeric.check_residual(label, "mpmath simulation", residual, answer=name)


def _from_the_beginning(truth: Truth) -> tuple[Truth, Any]:
    """What is at rest before its input begins, in the time since then, and when that is."""
    t, u = truth.time, truth.inputs
    if truth.system.discrete or u is None or any(truth.x0):
        return truth, sp.S.Zero
    spans = judges.intervals(t, u)
    if len(spans) != 2 or any(spans[0].smooth(u, t)):
        return truth, sp.S.Zero
    start = spans[1].start
    if any(at != start for at, _ in judges.impulses(u, t)):
        return truth, sp.S.Zero
    begun = spans[1].smooth(u, t).xreplace({t: t + start})
    for _, weights in judges.impulses(u, t):
        begun += weights * sp.DiracDelta(t)
    return replace(truth, inputs=sp.ImmutableMatrix(begun)), start


def _peak_residual(truth: Truth, submitted: Any, which: int) -> float:
    """How far the time (0) or the value (1) of the peak is off."""
    found = judges.simulations(truth.system, truth.x0, truth.inputs, truth.time)
    return judges.peak_residual(found, _column(submitted), which, discrete=truth.system.discrete)


def _column(value: Any) -> Any:
    return value if hasattr(value, "rows") else sp.ImmutableMatrix([value])


def what_x_would_mean(given: Given[Moving, ResponseOptions], value: Any) -> Reason | None:
    """Return the state that x begins with where it is another one, or where x leaves its equation."""
    truth, x = Truth.of(given), _column(value)
    t, system, u = truth.time, truth.system, truth.inputs
    if x.shape != truth.x0.shape or (x.free_symbols | truth.x0.free_symbols | system.A.free_symbols) - {t}:
        return None
    jumps = x.has(sp.Heaviside, sp.DiracDelta) or (u is not None and u.has(sp.Heaviside, sp.DiracDelta))
    start, wanted = (shortened(each) for each in (x.xreplace({t: sp.S.Zero}), truth.x0))
    if not jumps and start != wanted:
        return Reason("meanings/initial", {"x": t, "value": start, "wanted": wanted})
    right = product(system.A, x) if u is None else total(product(system.A, x), product(system.B, u))
    later = x.xreplace({t: t + 1}) if system.discrete else derivative(x, t)
    claim = "$x(k + 1) = A x(k) + B u(k)$" if system.discrete else r"$\dot{x} = A x + B u$"
    found = difference_of(later, right)
    return None if jumps or found is None else Reason("meanings/equality", {"claim": claim, **found})


def what_y_would_mean(given: Given[Moving, ResponseOptions], value: Any) -> Reason | None:
    """Return the output that y begins with where it is another one than that of the initial state, without D."""
    truth, y = Truth.of(given), _column(value)
    t, system = truth.time, truth.system
    passes = system.D is not None and not system.D.is_zero_matrix
    if passes or system.C is None or y.has(sp.Heaviside, sp.DiracDelta) or _impulses(truth):
        return None
    return difference_at(y, product(system.C, truth.x0), t, 0)
