"""Lemma: what is left of the output for a sinusoid, or for several and a constant, each of which passes by itself."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.calculus import value_at

if TYPE_CHECKING:
    from sympy import Expr


@dataclass(frozen=True)
class Passed:
    """A sinusoid that came through: |T|, the phase in degrees and in radians."""

    magnitude: Expr
    angle: Expr
    radians: Expr


@dataclass(frozen=True)
class Input:
    """A sum of sinusoids and a constant, over t, or over k with `period`; `in_samples`: written in k."""

    u: Expr
    found: exact.Oscillations
    time: Expr
    period: Expr | None = None
    in_samples: bool = False

    @property
    def several(self) -> bool:
        """Whether there are parts to be added."""
        return len(self.found.sinusoids) > 1 or self.found.constant != 0

    def frequency(self, omega: Expr) -> Expr:
        """The frequency in rad/s of a sinusoid whose angle grows by ω for each unit of what u is written in."""
        return omega / self.period if self.in_samples and self.period is not None else omega

    def grows(self, omega: Expr) -> Expr:
        """By what the angle grows with each unit of `time`."""
        return omega if self.in_samples or self.period is None else omega * self.period

    def part(self, wave: exact.Sinusoid) -> Expr:
        """The part of one frequency, as it is written in u where its terms have one frequency each."""
        if not self.several:
            return self.u
        t = sp.Symbol("k" if self.in_samples else "t")
        own = []
        for term in sp.Add.make_args(self.u):
            read = exact.oscillations(term, t)
            if read is not None and not (len(read.sinusoids) == 1 and read.constant == 0):
                return wave.cosine * sp.cos(wave.omega * t) + wave.sine * sp.sin(wave.omega * t)
            own += [term] if read is not None and read.sinusoids[0].omega == wave.omega else []
        return sp.Add(*own)


def input_of(u: Expr, *, discrete: bool = False, period: Expr | None = None) -> Input:
    """Read an input. Raises Unsolved where it is no sum of sinusoids and a constant."""
    in_samples = discrete and not u.has(sp.Symbol("t"))
    found = exact.oscillations(u, sp.Symbol("k" if in_samples else "t"))
    if found is None:
        raise Unsolved("frequency/no_sinusoid", u=u)
    return Input(u, found, sp.Symbol("k" if discrete else "t"), period, in_samples)


@lemma("steady_response")
def dies_out(
    p: Expr, *, closed: bool, discrete: bool, several: bool, sampled: bool = False, theta: Expr | None = None
) -> Derivation[None]:
    """The step that says that the roots of p are stable; `theta` is what an angle grows by a sample."""
    yield Step("stable", unclaimed="counted by a Routh array; the answer has a check of its own", p=p, closed=closed,
               discrete=discrete, sampled=sampled, several=several, theta=theta)  # fmt: skip


@lemma("steady_response")
def steady_answers(
    given: Input, value: Callable[[Expr], Derivation[Passed]], at_rest: Callable[[], Derivation[Expr]]
) -> Derivation[Answers]:
    """The sum of what comes through; of one sinusoid magnitude and phase too."""
    if given.several:
        yield Step("apart", unclaimed="read off the input", constant=given.found.constant,
                   frequencies=[given.frequency(wave.omega) for wave in given.found.sinusoids])  # fmt: skip
    terms: list[Any] = []
    if given.found.constant != 0:
        terms.append(given.found.constant * (yield from at_rest()))
    rows = []
    for wave in given.found.sinusoids:
        omega = given.frequency(wave.omega)
        passed = yield from value(omega)
        rows.append({"omega": omega, "magnitude": passed.magnitude, "radians": passed.radians})
        turned = given.grows(wave.omega) * given.time + passed.radians
        terms += [sp.expand(size * passed.magnitude) * f(angle_of(turned), evaluate=False)
                  for size, f, angle_of in waves_of(given.part(wave), wave) if passed.magnitude != 0]  # fmt: skip
    y = sp.Add(*terms)
    yield Step("steady_state", unclaimed="the answer, which has a check of its own", y=y, u=given.u, rows=rows,
               several=given.several, radians=passed.radians, discrete=given.period is not None,
               letter=sp.Symbol("omega"))  # fmt: skip
    if given.several:
        return Answers(y_steady_state=y)
    return Answers(magnitude=passed.magnitude, phase=passed.angle, y_steady_state=y)


def axis_of(omega: Expr) -> Expr:
    """What s is put as at a frequency: jω, or j."""
    return sp.I if omega == 1 else sp.I * sp.Symbol("omega")


@lemma("steady_response")
def constant_through(formula: Expr, s: Expr, at: Expr, value: Expr) -> Derivation[Expr]:
    """The step for a constant input, which is multiplied by the value at rest, T(0) or T(1)."""
    yield Step("rest", claims={"rest": Claim(value_at(formula, s, at), value, "the value at rest")}, s=s, at=at)
    return value


def waves_of(u: Expr, wave: exact.Sinusoid) -> list[tuple[Expr, Any, Callable[[Any], Any]]]:
    """The input as size, sin or cos, and how its angle grows by the phase: one wave where it was written as one."""
    size, alone = u.as_independent(*(x for x in u.free_symbols if str(x) in ("t", "k")), as_Add=False)
    if isinstance(alone, sp.sin | sp.cos):
        start = alone.args[0].as_independent(sp.Symbol("t"), sp.Symbol("k"), as_Add=True)[0]
        if not (alone.args[0] - start).could_extract_minus_sign():
            return [(size, alone.func, lambda turned: turned + (sp.N(start, 30) if turned.has(sp.Float) else start))]
    return [(part, f, lambda turned: turned) for part, f in ((wave.cosine, sp.cos), (wave.sine, sp.sin)) if part != 0]


__all__ = ["Passed", "axis_of", "constant_through", "dies_out", "input_of", "steady_answers"]
