"""The time constants of a system: 1/|Re p| of each pole whose mode decays, in discrete time −T/ln|p|."""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial
from typing import TYPE_CHECKING, Any

from solver.derivation import (
    AnswerName,
    Answers,
    Attempt,
    Check,
    Claim,
    Derivation,
    Given,
    Slip,
    Step,
    Task,
    Unsolved,
)
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import classical as judges
from solver.stated.algebra import quotient
from solver.stated.complex_numbers import absolute, real_part
from solver.tasks.classical.paths import numbers_of, path_of, poles_of, quietly
from solver.tasks.mistakes import OPEN_LOOP, not_closed
from solver.tasks.plant_options import LoopOptions
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr

    from solver.tasks.classical.paths import Plant

time_constants: Task[Plant, LoopOptions] = Task(
    "time_constants",
    title="Time constants",
    doc="1/|Re p| of each stable pole p of a transfer function, in discrete time −T/ln|p|, the slowest first.",
    needs=("path",),
    options=LoopOptions,
    answers=[
        AnswerName(
            "time_constants",
            r"\tau_i",
            "the time constants, each as often as its pole, the largest first",
            unit="s",
            earned=("poles", "constants"),
        )
    ],
)


@time_constants.method(source="Franklin, Powell and Emami-Naeini, section 3.3; Digital Control, section 4.3")
def by_the_poles(given: Given[Plant, LoopOptions]) -> Derivation[Answers]:
    """A mode of a pole −1/τ ± jω decays by the factor e in the time τ, that of p with |p| = e^{−T/τ} in τ/T samples."""
    path = yield from path_of(given)
    poles = yield from poles_of(path)
    found = exact.decay(poles, _period(given))
    open_ = [mode for mode in found.modes if mode.sign is None]
    if open_:
        raise Unsolved("time_constants/sign_open", rates=[mode.rate for mode in open_])
    stable = [mode for mode in found.modes if mode.sign == 1]
    if not stable:
        raise Unsolved("time_constants/no_decay", poles=poles, discrete=path.discrete)
    claims = {
        f"constant{i}": Claim(_stated(mode, _period(given)), mode.time_constant, Phrase("time constant {i}", i=i))
        for i, mode in enumerate(stable, 1)
        if mode.square != 0
    }
    sizes = [sp.Abs(mode.poles[0]) if mode.square is None else _size(mode) for mode in stable]
    yield Step("constants", claims=claims, unclaimed="" if claims else "all die out at once", x=path.variable,
               modes=stable, in_order=found.in_order, discrete=path.discrete, sizes=sizes,
               T=path.given.sample_time)  # fmt: skip
    yield Step("slowest", detail="full", unclaimed="a rule of thumb", modes=stable, in_order=found.in_order,
               discrete=path.discrete, slowest=stable[0].time_constant,
               others=[mode.poles[0] for mode in found.modes if mode.sign != 1],
               pairs=any(len(mode.poles) > 1 for mode in stable), numbers=not path.parameters)  # fmt: skip
    return Answers(time_constants=[mode.time_constant for mode in stable for _ in range(mode.count)])


def _period(given: Given[Plant, LoopOptions]) -> Expr | None:
    """The sampling period of a discrete system, 1 where times are counted in samples; None in continuous time."""
    if not given.system.discrete:
        return None
    return sp.Integer(1) if given.system.sample_time is None else given.system.sample_time


def _size(mode: exact.DecayMode) -> Expr:
    """|p| as it is shown."""
    pole = mode.poles[0]
    return sp.Abs(pole) if pole.free_symbols or mode.square is None else sp.sqrt(mode.square)


def _stated(mode: exact.DecayMode, period: Expr | None) -> Any:
    """1/|Re p|; T over −ln|p|."""
    if period is None:
        return quotient(1, absolute(real_part(mode.poles[0])))
    return quotient(period, -sp.log(_size(mode)))


@time_constants.verification("time_constants")
def are_the_real_parts_of_the_poles(given: Given[Plant, LoopOptions], answers: Answers) -> Iterable[Check]:
    """The eigenvalues of the minimal part with negative real parts."""
    plant, found = numbers_of(given.system), list(answers["time_constants"])
    check = partial(judges.time_constants_residual, plant, found, _period(given))
    label = "the time constants are those of the eigenvalues of the minimal part"
    yield numeric.check_residual(label, "mpmath.eig (50 digits)", check, answer="time_constants")


RATES = Slip("rates", "these are the decay rates $|\\operatorname{Re} p|$; the time constants are their reciprocals")
SIZES = Slip("modulus", "it is $1/|p|$; the decay of a pair is told by its real part alone, $1/|\\operatorname{Re} p|$")
ONCE = Slip("once", "each pole has a time constant: a pair, or a double pole, counts twice")
AS_IN_S = Slip("as_in_s", "$1/|\\operatorname{Re} p|$ is of poles in $s$; one in $z$ has $-T/\\ln|p|$")
NO_PERIOD = Slip("no_period", "it is counted in samples; a time constant is that many sampling periods")
UNSTABLE = Slip("unstable", "a pole that is not in the left half plane has no time constant: its mode does not decay")


@time_constants.mistake(RATES, "time_constants")
def decay_rates(wrong: Attempt[Plant, LoopOptions]) -> Iterable[list[Expr]]:
    """|Re p|."""
    yield [1 / each for each in wrong.ours]


@time_constants.mistake(SIZES, "time_constants")
def by_the_modulus(wrong: Attempt[Plant, LoopOptions]) -> Iterable[list[Expr]]:
    """1/|p|."""
    if wrong.given.system.discrete:
        return
    stable = [mode for mode in _modes(wrong.given) if mode.sign == 1]
    yield [1 / sp.sqrt(sp.expand(pole * sp.conjugate(pole))) for mode in stable for pole in mode.every]


@time_constants.mistake(ONCE, "time_constants")
def each_once(wrong: Attempt[Plant, LoopOptions]) -> Iterable[list[Expr]]:
    """One for a pair, or for a multiple pole."""
    yield list(dict.fromkeys(wrong.ours))


@time_constants.mistake(UNSTABLE, "time_constants")
def of_growing_modes_too(wrong: Attempt[Plant, LoopOptions]) -> Iterable[list[Expr]]:
    """1/|Re p| of the unstable poles, too."""
    if wrong.given.system.discrete:
        return
    moving = [mode for mode in _modes(wrong.given) if mode.sign]
    yield [sp.radsimp(1 / sp.Abs(mode.rate)) for mode in moving for _ in mode.every]


@time_constants.mistake(AS_IN_S, "time_constants")
def by_the_real_part(wrong: Attempt[Plant, LoopOptions]) -> Iterable[list[Expr]]:
    """1/|Re p| of poles in z, as if they were in s."""
    if wrong.given.system.discrete:
        poles = [pole for mode in _modes(wrong.given) if mode.sign == 1 for pole in mode.every]
        yield [sp.radsimp(1 / sp.Abs(sp.re(pole))) for pole in poles if sp.re(pole) != 0]


@time_constants.mistake(NO_PERIOD, "time_constants")
def in_samples(wrong: Attempt[Plant, LoopOptions]) -> Iterable[list[Expr]]:
    """−1/ln|p|."""
    T = wrong.given.system.sample_time
    if wrong.given.system.discrete and T is not None:
        yield [each / T for each in wrong.ours]


def _modes(given: Given[Plant, LoopOptions]) -> Iterable[exact.DecayMode]:
    return exact.decay(quietly(poles_of(quietly(path_of(given)))), _period(given)).modes


time_constants.mistaken_question(OPEN_LOOP)(not_closed)
