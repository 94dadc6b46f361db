"""What a sinusoidal input leaves of the output when everything else has died out: its amplitude and its phase."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from solver.exact.linear_algebra.fields import NotExact
from solver.exact.linear_algebra.signs import is_positive, possible_signs
from solver.exact.time_response.signals import Signal, read_signal, written


@dataclass(frozen=True)
class SteadyState:
    """The frequency ω, G(jω) (in discrete time G(e^{jω})) as a + jb, its absolute value and argument.

    `input` is the input as one cosine where it has a sine too (else None); `output` is what is left of the output,
    `forced` the same in cosines and sines, `transient` the rest of y. `settles`: the rest dies out.
    """

    omega: sp.Expr
    value: sp.Expr
    magnitude: sp.Expr
    argument: sp.Expr
    output: sp.Expr
    input: sp.Expr | None
    forced: sp.Expr
    transient: sp.Expr
    settles: bool


def steady_state(G: sp.Expr, u: sp.Expr, y: sp.Expr, t: sp.Symbol, *, discrete: bool) -> SteadyState | None:
    """The steady state for a sinusoidal input of a system from u to y; None for other inputs, or at a pole of G.

    y is the whole response, with what an initial state adds. None too where parameters leave the quadrant open.
    """
    try:
        wave, response = read_signal(u, t, discrete=discrete), read_signal(y, t, discrete=discrete)
    except NotExact:
        return None
    found = wave_of(wave, discrete=discrete)
    if found is None:
        return None
    omega, cosine, sine = found
    x = sp.Symbol("z" if discrete else "s")
    at = (sp.cos(omega), sp.sin(omega)) if discrete else (sp.S.Zero, omega)
    parts = _value(G, x, at)
    argument = _argument(*parts) if parts is not None else None
    if parts is None or argument is None:
        return None
    a, b = parts
    magnitude = sp.sqrt(sp.factor(sp.radsimp(sp.expand(a**2 + b**2))))
    forced = cosine * (a * sp.cos(omega * t) - b * sp.sin(omega * t))
    forced += sine * (a * sp.sin(omega * t) + b * sp.cos(omega * t))
    rest = {term: c for (begin, term), c in response.terms.items() if not _at(term, omega, discrete=discrete)}
    transient = sp.Add(*(c * written(term, t, discrete=discrete) for term, c in rest.items()))
    output = _one_wave(cosine, sine, magnitude, omega * t, argument)
    both = cosine != 0 and sine != 0
    given = _one_wave(cosine, sine, sp.S.One, omega * t, sp.S.Zero) if both else None
    settles = all(_dies_out(growth, discrete=discrete) for _, growth, _, _ in rest)
    return SteadyState(omega, a + sp.I * b, magnitude, argument, output, given, sp.expand(forced), transient, settles)


def wave_of(u: Signal, *, discrete: bool) -> tuple[sp.Expr, sp.Expr, sp.Expr] | None:
    """Return ω, α and β of u = α cos ωt + β sin ωt, t ≥ 0; None for other signals."""
    steady = int(discrete)
    if u.impulses or not u.terms:
        return None
    if any(begin != 0 or n or growth != steady or angle == 0 for begin, (n, growth, angle, _) in u.terms):
        return None
    angles = {angle for _, (_, _, angle, _) in u.terms}
    if len(angles) > 1 or not is_positive(next(iter(angles))):
        return None
    parts = {sine: c for (_, (_, _, _, sine)), c in u.terms.items()}
    return angles.pop(), parts.get(False, sp.S.Zero), parts.get(True, sp.S.Zero)


def _value(G: sp.Expr, x: sp.Symbol, at: tuple[sp.Expr, sp.Expr]) -> tuple[sp.Expr, sp.Expr] | None:
    """The real and the imaginary part of G at a complex number; None at a pole."""
    (a, b), (c, d) = (_polynomial_at(p, x, at) for p in sp.fraction(sp.cancel(G)))
    square = sp.expand(c**2 + d**2)
    if square == 0:
        return None
    return _tidied(sp.expand(a * c + b * d), square), _tidied(sp.expand(b * c - a * d), square)


def _tidied(above: sp.Expr, below: sp.Expr) -> sp.Expr:
    whole = above / below
    return sp.radsimp(whole) if whole.is_number else sp.cancel(whole)


def _polynomial_at(p: sp.Expr, x: sp.Symbol, at: tuple[sp.Expr, sp.Expr]) -> tuple[sp.Expr, sp.Expr]:
    """The real and the imaginary part of a polynomial at a complex number, by Horner's scheme."""
    u, v = at
    a, b = sp.S.Zero, sp.S.Zero
    for c in sp.Poly(p, x).all_coeffs():
        a, b = sp.expand(a * u - b * v + c), sp.expand(a * v + b * u)
    return a, b


def _argument(a: sp.Expr, b: sp.Expr) -> sp.Expr | None:
    """The argument of a + jb in (−π, π]; None where its quadrant is not decided."""
    of_a, of_b = possible_signs(a), possible_signs(b)
    if len(of_a) > 1 or (len(of_b) > 1 and of_a != {1}):
        return None
    if of_a == {0}:
        return None if of_b == {0} else sp.pi / 2 * next(iter(of_b))
    angle = sp.atan(sp.cancel(b / a) if (b / a).free_symbols else sp.radsimp(b / a))
    if of_a == {1}:
        return angle
    return angle + (sp.pi if next(iter(of_b)) >= 0 else -sp.pi)


def _one_wave(cosine: sp.Expr, sine: sp.Expr, magnitude: sp.Expr, t: sp.Expr, argument: sp.Expr) -> sp.Expr:
    """α |G| cos, β |G| sin, or of both one cosine, with the angle kept as it is."""
    if sine == 0:
        return cosine * magnitude * sp.cos(t + argument, evaluate=False)
    if cosine == 0:
        return sine * magnitude * sp.sin(t + argument, evaluate=False)
    size = sp.sqrt(sp.expand(cosine**2 + sine**2))
    angle = argument - sp.atan2(sine, cosine)
    return sp.radsimp(size * magnitude) * sp.cos(t + angle, evaluate=False)


def _at(term: tuple[int, sp.Expr, sp.Expr, bool], omega: sp.Expr, *, discrete: bool) -> bool:
    n, growth, angle, _ = term
    return n == 0 and growth == int(discrete) and sp.expand(angle - omega) == 0


def _dies_out(growth: sp.Expr, *, discrete: bool) -> bool:
    return is_positive(1 - sp.Abs(growth) if discrete else -growth)
