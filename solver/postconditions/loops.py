"""What remains of errors, the constants of loops."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import sympy as sp

from solver.derivation import Check, Claim
from solver.lazy import numeric
from solver.numeric.judges import loops as judges
from solver.stated.algebra import power, product, quotient
from solver.stated.limits import limit
from solver.stated.transforms import inverse_laplace


def of_transform_of(found: Any, signal: Any, t: Any, s: Any) -> Iterator[Claim]:
    """Transformed back it is the signal."""
    if found != 0:
        yield Claim(inverse_laplace(found, s, t), signal)


def of_lasting(found: Any, signal: Any, t: Any) -> Iterator[Claim | Check]:
    """It is the signal, late; nothing jumps in it."""
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


def of_usual_parts(found: Any, signal: Any, t: Any) -> Iterator[Claim | Check]:
    """A sum of a step, a ramp and a parabola; of other signals the third derivative is not zero."""
    if found is not None:
        c, b, a = found
        yield Claim(signal, c + b * t + a * t**2 / 2)
    else:
        other = numeric.check_claim(Claim(sp.diff(signal, t, 3), sp.S.Zero), "")
        yield Check.that("no sum of a step, a ramp and a parabola", "random points", other.residual != 0)


def of_error_constants(
    found: Any, numerator: Any, denominator: Any, s: Any, _positive: Sequence[Any] = ()
) -> Iterator[Claim | Check]:
    """sᵏ L has a limit that is not zero, with k the number of integrators; each limit is that of its power."""
    L = quotient(numerator, denominator)
    if found.integrators:
        yield Claim(limit(product(power(s, found.integrators), L), s, sp.S.Zero, "+"), found.lead)
        yield Check.that("the limit is not zero", "compared", found.lead != 0)
    for n, value in enumerate(found.limits):
        if value is not None and value not in (sp.oo, -sp.oo):
            yield Claim(limit(product(power(s, n), L) if n else L, s, sp.S.Zero, "+"), value)
        else:
            yield Check.that("more integrators than powers", "compared", n < found.integrators)


def of_long_run(found: Any, E: Any, s: Any, inside: Any, _positive: Sequence[Any] = ()) -> Iterator[Claim | Check]:
    """sᵏ E has the limit said, not zero; what is left of the denominator besides those inside has these roots."""
    if found.order:
        yield Claim(limit(product(power(s, found.order), E), s, sp.S.Zero, "+"), found.lead)
        yield Claim(quotient(*found.quotient), found.lead)
        yield Check.that("the limit is not zero", "compared", found.lead != 0)
    else:
        yield Claim(limit(product(s, E), s, sp.S.Zero, "+"), sp.S.Zero)
    if found.value is not None and found.order < 2:
        yield Claim(found.value, found.lead)
    if not found.others.free_symbols - {s} and not inside.free_symbols - {s}:
        roots = sp.Poly(found.others, s).nroots(n=30) if found.others.has(s) else []
        left = all(root < 0 for root in (sp.re(root) for root in roots))
        yield Check.that("whether the other poles are inside", "mpmath", bool(found.settles) == left)
        yield Check.that("they are poles", "mpmath", all(_is_pole(E, s, root) for root in roots))


def _is_pole(E: Any, s: Any, root: Any) -> bool:
    """Whether the denominator vanishes there."""
    below = sp.Poly(sp.fraction(sp.together(E))[1], s)
    return bool(abs(below(root)) < sp.Float("1e-12") * (1 + sum(abs(c) for c in below.all_coeffs())))


def of_held_where(found: Any, positive: Sequence[Any]) -> Iterator[Check]:
    """At random points the condition holds exactly where all expressions are positive."""
    right = judges.holds_where_positive(found, positive)
    yield Check.that("where the whole column is positive", "random points", right)
