"""What remains of errors, the constants of loops."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import sympy as sp

from solver.derivation import Check, Claim
from solver.lazy import numeric
from solver.numeric.judges import loops as judges
from solver.stated.algebra import difference, power, product, quotient
from solver.stated.limits import limit
from solver.stated.transforms import inverse_laplace, inverse_z


def of_transform_of(found: Any, signal: Any, t: Any, s: Any, *, discrete: bool = False) -> Iterator[Claim]:
    """Transformed back it is the signal."""
    if found != 0:
        yield Claim((inverse_z if discrete else inverse_laplace)(found, s, t), signal)


def of_lasting(found: Any, signal: Any, t: Any, *, discrete: bool = False) -> Iterator[Claim | Check]:
    """It is the signal, late; nothing jumps in it."""
    del discrete
    jumps = found.atoms(sp.Heaviside, sp.DiracDelta)
    yield Check.that("no jumps are left", "compared", not jumps)
    if not signal.free_symbols - {t}:
        late = 1000 + t
        yield Claim(signal.xreplace({t: late}).replace(sp.DiracDelta, lambda *_: sp.S.Zero), found.xreplace({t: late}))


def of_error_transform(found: Any, transfer: Any, image: Any) -> Iterator[Claim]:
    """It is the product."""
    yield Claim(product(transfer, image), found)


def of_rational(found: Any, F: Any) -> Iterator[Claim]:
    """It is the same function."""
    yield Claim(F, found)


def of_usual_parts(found: Any, signal: Any, t: Any, period: Any = sp.S.One) -> Iterator[Claim | Check]:
    """A sum of a step, a ramp and a parabola; of other signals the third derivative is not zero."""
    if found is not None:
        c, b, a = found
        yield Claim(signal, c + b * t * period + a * (t * period) ** 2 / 2)
    else:
        other = numeric.check_claim(Claim(sp.diff(signal, t, 3), sp.S.Zero), "")
        yield Check.that("no sum of a step, a ramp and a parabola", "random points", other.residual != 0)


def of_error_constants(
    found: Any,
    numerator: Any,
    denominator: Any,
    s: Any,
    _positive: Sequence[Any] = (),
    *,
    discrete: bool = False,
    period: Any = None,
) -> Iterator[Claim | Check]:
    """sᵏ L has a limit that is not zero, with k the number of integrators; each limit is that of its power."""
    L, (x, goal) = quotient(numerator, denominator), _at(s, discrete=discrete)
    if found.integrators:
        yield Claim(limit(product(power(x, found.integrators), L), s, goal, "+"), found.lead)
        yield Check.that("the limit is not zero", "compared", found.lead != 0)
    for n, (value, K) in enumerate(zip(found.limits, found.constants, strict=True)):
        if value is not None and value not in (sp.oo, -sp.oo):
            yield Claim(limit(product(power(x, n), L) if n else L, s, goal, "+"), value)
            scaled = discrete and n > 0 and value != 0
            if scaled and period is None:
                yield Check.that("without a sampling period there is none", "compared", K is None)
            else:
                yield Claim(K * period**n if scaled else K, value)
        else:
            yield Check.that("more integrators than powers", "compared", n < found.integrators and value == K)


def _at(s: Any, *, discrete: bool) -> tuple[Any, Any]:
    """What is zero where integrators have their pole, and where that is."""
    return (s - 1, sp.S.One) if discrete else (s, sp.S.Zero)


def of_integrators_apart(found: Any, D: Any, s: Any, *, discrete: bool = False) -> Iterator[Claim | Check]:
    """The product is the polynomial; the rest is not zero there."""
    rest, count = found
    x, goal = _at(s, discrete=discrete)
    yield Claim(x**count * rest, D)
    at = numeric.check_claim(Claim(rest.xreplace({s: goal}), sp.S.Zero), "")
    yield Check.that("no integrator is left", "random points", at.residual != 0)


def of_long_run(
    found: Any, E: Any, s: Any, inside: Any, _positive: Sequence[Any] = (), *, discrete: bool = False
) -> Iterator[Claim | Check]:
    """sᵏ E has the limit said, not zero; what is left of the denominator besides those inside has these roots."""
    x, goal = _at(s, discrete=discrete)
    if found.order:
        yield Claim(limit(product(power(x, found.order), E), s, goal, "+"), found.lead)
        yield Claim(quotient(*found.quotient), found.lead)
        yield Check.that("the limit is not zero", "compared", found.lead != 0)
    else:
        vanishing = difference(1, power(s, -1)) if discrete else s
        yield Claim(limit(product(vanishing, E), s, goal, "+"), sp.S.Zero)
    if found.value is not None and found.order < 2:
        yield Claim(found.value, found.lead)
    if not found.others.free_symbols - {s} and not inside.free_symbols - {s}:
        roots = sp.Poly(found.others, s).nroots(n=30) if found.others.has(s) else []
        left = all(abs(root) < 1 if discrete else sp.re(root) < 0 for root in roots)
        yield Check.that("whether the other poles are inside", "mpmath", bool(found.settles) == left)
        yield Check.that("they are poles", "mpmath", all(_is_pole(E, s, root) for root in roots))


def of_late_transform(found: Any, transfer: Any, image: Any, _s: Any, _delay: Any) -> Iterator[Claim]:
    """It is the product."""
    yield Claim(product(transfer, image), found)


def of_late_quotient(found: Any, F: Any, _s: Any, _delay: Any) -> Iterator[Claim]:
    """It is the same function."""
    yield Claim(F, found)


def of_late_long_run(found: Any, E: Any, s: Any, _delay: Any, _inside: Any = sp.S.One) -> Iterator[Claim | Check]:
    """sᵏ E has the limit said, not zero, and what is left of the denominator has roots there."""
    if found.order:
        yield Claim(limit(product(power(s, found.order), E), s, sp.S.Zero, "+"), found.lead)
        yield Claim(quotient(*found.quotient), found.lead)
        yield Check.that("the limit is not zero", "compared", found.lead != 0)
    else:
        yield Claim(limit(product(s, E), s, sp.S.Zero, "+"), sp.S.Zero)
    if found.value is not None and found.order < 2:
        yield Claim(found.value, found.lead)
    if found.others.has(s) and not found.others.free_symbols - {s}:
        roots = sp.Poly(found.others, s).nroots(n=30)
        left = all(sp.re(root) < 0 for root in roots)
        yield Check.that("whether the other poles are inside", "mpmath", bool(found.settles) == left)


def _is_pole(E: Any, s: Any, root: Any) -> bool:
    """Whether the denominator vanishes there."""
    below = sp.Poly(sp.fraction(sp.together(E))[1], s)
    return bool(abs(below(root)) < sp.Float("1e-12") * (1 + sum(abs(c) for c in below.all_coeffs())))


def of_held_where(found: Any, positive: Sequence[Any]) -> Iterator[Check]:
    """At random points the condition holds exactly where all expressions are positive."""
    right = judges.holds_where_positive(found, positive)
    yield Check.that("where the whole column is positive", "random points", right)
