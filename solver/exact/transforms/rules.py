"""Laplace transforms by a short table and rules: powers of t, damping, delays. Functions are read as `signals` does."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import factorial
from typing import Any

import sympy as sp

from solver.exact.time_response.input_generators import read_inputs
from solver.exact.time_response.signals import Signal, read_signal, written

WAVES: dict[str, Any] = {"cos": sp.cos, "sin": sp.sin, "cosh": sp.cosh, "sinh": sp.sinh}


@dataclass(frozen=True)
class Pair:
    """A function of time and its image; `rule` is the one that gave it from the pair before ("table": none)."""

    rule: str
    function: sp.Expr
    image: sp.Expr


@dataclass(frozen=True)
class TransformedTerm:
    """A term `factor` · tⁿ e^{σt} w(ωt), w one of `WAVES` or none ("")."""

    factor: sp.Expr
    power: int
    growth: sp.Expr
    angle: sp.Expr
    wave: str

    def function(self, t: sp.Symbol) -> sp.Expr:
        """The function without its factor."""
        return t**self.power * sp.exp(self.growth * t) * self._wave(t)

    def _wave(self, t: sp.Symbol) -> sp.Expr:
        return WAVES[self.wave](self.angle * t) if self.wave else sp.S.One

    @property
    def entry(self) -> str:
        """The line of the table that the term begins with."""
        if self.wave:
            return self.wave
        return "power" if self.power else "exponential" if self.growth != 0 else "constant"

    def pairs(self, t: sp.Symbol, s: sp.Symbol) -> tuple[Pair, ...]:
        """The pair of the table, and what each rule makes of it: derivatives for tⁿ, then the shift for e^{σt}."""
        if not self.wave:
            if not self.power:
                return (Pair("table", self.function(t), 1 / (s - self.growth)),)
            found = [Pair("table", t**self.power, factorial(self.power) / s ** (self.power + 1))]
        else:
            sign = 1 if self.wave in ("cos", "sin") else -1
            above = s if self.wave in ("cos", "cosh") else self.angle
            below = s**2 + sign * self.angle**2
            found = [Pair("table", self._wave(t), above / below)]
            if self.power:
                image = _derived(above, below, self.power, s)
                found.append(Pair("derivative", t**self.power * self._wave(t), image))
        if self.growth != 0:
            found.append(Pair("damping", self.function(t), found[-1].image.xreplace({s: s - self.growth})))
        return tuple(found)

    def abscissa(self) -> sp.Expr:
        """The real part that s must exceed for the integral to converge."""
        return self.growth + (sp.Abs(self.angle) if self.wave in ("cosh", "sinh") else 0)


def _derived(above: sp.Expr, below: sp.Expr, order: int, s: sp.Symbol) -> sp.Expr:
    """(−1)ⁿ dⁿ/dsⁿ of N/q, over one power of q."""
    N, q = sp.expand(above), below
    for k in range(1, order + 1):
        N = sp.expand(k * N * sp.diff(q, s) - sp.diff(N, s) * q)
    found: sp.Expr = sp.factor(N) / q ** (order + 1)
    return found


@dataclass(frozen=True)
class TransformPiece:
    """What begins at one time T: `function` in t, `moved` the same in the time since T, an impulse, and the terms.

    The function is Σ factor · term in the time since T.
    """

    delay: sp.Expr
    function: sp.Expr
    moved: sp.Expr
    impulse: sp.Expr
    terms: tuple[TransformedTerm, ...]

    def image(self, t: sp.Symbol, s: sp.Symbol) -> sp.Expr:
        """The transform in the time since T, a term each."""
        return sp.Add(self.impulse, *(each.factor * each.pairs(t, s)[-1].image for each in self.terms))


def transform_pieces(f: sp.Expr, t: sp.Symbol) -> tuple[TransformPiece, ...]:
    """The pieces of a function, the earliest first; raises NotExact for one whose transform is not rational."""
    hyperbolic, rest = [], []
    for term in sp.Add.make_args(sp.expand(f)):
        found = _hyperbolic(term, t)
        if found is None:
            rest.append(term)
        else:
            hyperbolic.append(found)
    other = sp.Add(*rest)
    signal = read_signal(other, t, discrete=False)
    pieces = [_piece(piece.delay, piece.inputs[0], piece.impulses[0], signal, t)
              for piece in read_inputs([other], t, discrete=False)]  # fmt: skip
    if hyperbolic:
        first = next((each for each in pieces if each.delay == 0), None)
        own = tuple(hyperbolic)
        function = sp.Add(*(each.factor * each.function(t) for each in own))
        joined = TransformPiece(sp.S.Zero, function, function, sp.S.Zero, own)
        if first is not None:
            sums = (first.function + function, first.moved + function)
            joined = TransformPiece(sp.S.Zero, *sums, first.impulse, (*first.terms, *own))
        pieces = [joined, *(each for each in pieces if each.delay != 0)]
    return tuple(each for each in pieces if each.terms or each.impulse != 0)


def _piece(delay: sp.Expr, local: sp.Expr, impulse: sp.Expr, signal: Signal, t: sp.Symbol) -> TransformPiece:
    here = [c * written(term, t, discrete=False) for (begin, term), c in signal.terms.items() if begin == delay]
    terms = []
    for (_, (n, growth, angle, sine)), c in read_signal(local, t, discrete=False).terms.items():
        wave = "" if angle == 0 else "sin" if sine else "cos"
        terms.append(TransformedTerm(c, n, growth, angle, wave))
    return TransformPiece(delay, sp.Add(*here), local, impulse, tuple(terms))


def _hyperbolic(term: sp.Expr, t: sp.Symbol) -> TransformedTerm | None:
    """A term c tⁿ e^{σt} sinh ωt or cosh ωt from t = 0 on; None for any other."""
    waves = term.atoms(sp.sinh, sp.cosh)
    if len(waves) != 1 or term.has(sp.sin, sp.cos, sp.Heaviside, sp.DiracDelta):
        return None
    (wave,) = waves
    angle = wave.args[0].coeff(t, 1)
    factors: Sequence[Any] = sp.Mul.make_args(term)
    if wave.args[0] != angle * t or angle.has(t) or wave not in factors:
        return None
    signal = read_signal(sp.Mul(*(each for each in factors if each != wave)), t, discrete=False)
    if len(signal.terms) != 1 or signal.impulses:
        return None
    ((_, (n, growth, other, _)), c) = next(iter(signal.terms.items()))
    name = "sinh" if wave.func is sp.sinh else "cosh"
    return TransformedTerm(c, n, growth, angle, name) if other == 0 else None


def transform_of_pieces(pieces: Sequence[TransformPiece], t: sp.Symbol, s: sp.Symbol) -> sp.Expr:
    """Σ e^{−Ts} times the image of each piece."""
    return sp.Add(*(late_image(each.delay, each.image(t, s), s) for each in pieces))


def late_image(delay: sp.Expr, image: sp.Expr, s: sp.Symbol) -> sp.Expr:
    """The image times e^{−Ts}, a minus that all its terms have in front."""
    if delay == 0:
        return image
    minus = all(term.could_extract_minus_sign() for term in sp.Add.make_args(image))
    return -sp.exp(-delay * s) * -image if minus else sp.exp(-delay * s) * image


def abscissa_of(pieces: Sequence[TransformPiece]) -> sp.Expr | None:
    """The real part beyond which the integral converges; None where it does everywhere."""
    found = [term.abscissa() for piece in pieces for term in piece.terms]
    return sp.Max(*found) if found else None
