"""Lemma: crossovers and margins of a loop, found on the imaginary axis."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from solver.arithmetic.exactness import where_exact
from solver.arithmetic.frequencies import size_and_angle
from solver.arithmetic.quadratics import both_roots
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import power, product, quotient, total
from solver.stated.calculus import value_at
from solver.stated.complex_numbers import absolute, arctangent, conjugate, phase
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr


LONG = 9999
"""Whole coefficients that are larger are not shown, in a polynomial in cos ωT."""


def formula_of(L: exact.OnAxis) -> Expr:
    """L(s) with its dead time."""
    s = L.variable
    rational: Expr = L.N.as_expr() / L.D.as_expr()
    return rational * sp.exp(-L.delay * s) if L.late else rational


@lemma("crossovers")
def crossovers_of(L: exact.OnAxis) -> Derivation[exact.Margins]:
    """Where |L| = 1 with the phases there, where L is negative, and the margins of those nearest to −1."""
    yield from on_axis_of(L)
    found = exact.margins_of(L)
    yield _gain_crossovers(L, found)
    several = len(found.gains.found) > 1
    for number, each in enumerate(found.gains.found, 1):
        yield _phase(L, each, number if several else 0)
    yield _late_crossovers(L, found.phases) if L.late else _phase_crossovers(L, found.phases)
    yield _gain_margin(found)
    return found


@lemma("crossovers")
def on_axis_of(L: exact.OnAxis, name: str = "L") -> Derivation[None]:
    """Put s = jω: real and imaginary part of numerator and denominator, and the squares of their sizes."""
    yield _on_axis(L, name)


@lemma("crossovers")
def real_axis_of(L: exact.OnAxis) -> Derivation[exact.PhaseCrossovers]:
    """Where L(jω) is real, and its values there."""
    found = exact.phase_crossovers(L)
    yield _late_crossovers(L, found, every=True) if L.late else _phase_crossovers(L, found, every=True)
    return found


@lemma("crossovers")
def negative_axis_of(L: exact.OnAxis) -> Derivation[exact.PhaseCrossovers]:
    """Where L(jω) is negative, and its values there."""
    found = exact.phase_crossovers(L)
    yield _late_crossovers(L, found) if L.late else _phase_crossovers(L, found)
    return found


def _even_odd(L: exact.OnAxis) -> dict[str, tuple[Expr, Expr]]:
    """Real and imaginary part of N(jω) and D(jω), in ω; discrete: of N and D at e^{jωT}."""
    omega, parts = sp.Symbol("omega"), L.parts
    place, unit = L.place(omega), L.unit(omega)
    found = {"N": (parts.E, parts.O), "D": (parts.e, parts.o)}
    return {
        name: (even.as_expr().subs(parts.w, place), sp.expand(unit * odd.as_expr().subs(parts.w, place)))
        for name, (even, odd) in found.items()
    }


def _on_axis(L: exact.OnAxis, name_of_L: str) -> Step:
    """N(jω) and D(jω) with their real and imaginary parts, and the squares of their sizes."""
    s, omega, claims = L.variable, sp.Symbol("omega"), {}
    for name, (real, imaginary) in _even_odd(L).items():
        p = (L.N if name == "N" else L.D).as_expr()
        size = (L.parts.above if name == "N" else L.parts.below).as_expr().subs(L.parts.w, L.place(omega))
        if p.has(s):
            says = Phrase("${name}(j\\omega)$", name=name)
            claims[name] = Claim(value_at(p, s, L.point(omega)), real + sp.I * imaginary, says)
            squares = [power(part, 2) for part in (real, imaginary) if part != 0]
            stated = total(*squares) if len(squares) > 1 else squares[0]
            claims[f"{name}_size"] = Claim(stated, size, Phrase("$|{name}(j\\omega)|^2$", name=name))
    return Step("on_axis", claims=claims, unclaimed="" if claims else "L is a constant", L=formula_of(L), s=s,
                N=L.N.as_expr(), D=L.D.as_expr(), delay=L.delay, name=name_of_L, discrete=L.discrete,
                powers=max(L.N.degree(), L.D.degree()), point=L.point(omega))  # fmt: skip


def _gain_crossovers(L: exact.OnAxis, found: exact.Margins) -> Step:
    """|N|² = |D|² as a polynomial in w = ω², and its positive roots."""
    w, omega, gains = L.parts.w, sp.Symbol("omega"), found.gains
    p = shown_polynomial(gains.polynomial)
    claims = {}
    for i, each in enumerate(gains.found, 1):
        says = "a root in $\\cos\\omega T$" if L.discrete else "a root in $w = \\omega^2$"
        claims[f"root{i}"] = Claim(value_at(p, w, each.square), sp.S.Zero, says)
        at = value_at(formula_of(L), L.variable, L.point(each.omega))
        claims[f"size{i}"] = Claim(absolute(at), each.magnitude, Phrase("the size of $L$ at a gain crossover"))
    sample = None
    if not gains.found:
        sample = next(omega for omega in _sample_frequencies(L) if L.parts.below(L.place(omega)) != 0)
        at = value_at(formula_of(L), L.variable, L.point(sample))
        claims["sample"] = Claim(absolute(at), L.magnitude(sample), "the size of $L$ at one frequency")
    roots = [{"square": each.square, "omega": each.omega, "near": approximation(each.omega)} for each in gains.found]
    sizes = [each.as_expr().subs(w, L.place(omega)) for each in (L.parts.above, L.parts.below)]
    return Step("gain_crossovers", claims=claims, steps=both_roots(w, p), p=p, w=w, sizes=sizes, roots=roots,
                sample=sample, discrete=L.discrete, T=L.sample_time, constant=not p.has(w),
                numerically=bool(sp.degree(p, w) > 2),
                below=sample is not None and bool(L.magnitude(sample) < 1))  # fmt: skip


def _sample_frequencies(L: exact.OnAxis) -> Iterator[Expr]:
    """Frequencies that a person may take to see how large L is."""
    if L.end is not None:
        yield from (L.end.omega, L.end.omega / 2, L.end.omega / 3)
    yield from map(sp.Integer, range(1, 99))


def shown_polynomial(p: Any) -> Expr:
    """The polynomial up to a factor: whole coefficients without a common divisor, the first one positive.

    Those that would be long stay as they are.
    """
    if p.domain.is_QQ:
        whole = p.clear_denoms(convert=True)[1].primitive()[1]
        p = p if max(map(abs, whole.all_coeffs()), default=0) > LONG and p.gen.name == "c" else whole
    found: Expr = (-p if p.LC().is_negative else p).as_expr()
    return found


def _phase(L: exact.OnAxis, at: exact.Crossover, number: int) -> Step:
    """The angles of the factors at a gain crossover, their sum, and the phase margin."""
    claims, rows = {}, list(angle_rows(L, at.omega))
    for i, row in enumerate(rows, 1):
        claims[f"angle{i}"] = Claim(phase(row["value"]), row["stated"], Phrase("the angle of a factor"))
    terms = [_signed(row["degrees"], row["power"]) for row in rows]
    if L.late:
        late = sp.expand(180 * at.omega * L.delay / sp.pi)
        terms.append(product(sp.Integer(-1), late))
    whole = sp.Add(*(row["degrees"] * row["power"] for row in rows)) - (late if L.late else 0)
    turns = sp.Integer(round(float((at.phase - whole) / 360)))
    if len(terms) > 1:
        claims["sum"] = Claim(total(*terms), whole, "the sum of the angles")
    if turns:
        claims["turned"] = Claim(total(whole, 360 * turns), at.phase, "the phase between −180° and 180°")
    claims["phase"] = Claim(
        phase(value_at(formula_of(L), L.variable, L.point(at.omega))), at.phase, "the phase at a gain crossover"
    )
    margin = exact.phase_margin_of(at.phase)
    claims["margin"] = Claim(total(sp.Integer(180), at.phase), at.phase + 180, "the phase margin")
    return Step("phase", claims=claims, rows=rows, at=at, number=number, whole=whole, turns=turns, margin=margin,
                late=L.late, wrapped=margin != at.phase + 180, L=formula_of(L), discrete=L.discrete,
                point=L.point(at.omega))  # fmt: skip


def angle_rows(L: exact.OnAxis, omega: Expr) -> Iterator[dict[str, Any]]:
    """Each factor at jω as a + jb, and its angle: an arctangent in degrees, a number."""
    for each in L.angles(omega):
        a, b, degrees = each.real, each.imaginary, each.degrees
        stated: Any = degrees
        if not degrees.is_Rational and a != 0:
            turn = 0 if a > 0 else 180 if b >= 0 else -180
            stated = arctangent(b / a)
            stated = total(sp.Integer(turn), stated) if turn else stated
        yield {"factor": each.factor, "power": each.power, "value": a + sp.I * b, "stated": stated, "degrees": degrees}


def _signed(degrees: Expr, power_of: int) -> Any:
    return degrees if power_of == 1 else product(sp.Integer(power_of), degrees)


def _phase_crossovers(L: exact.OnAxis, found: exact.PhaseCrossovers, *, every: bool = False) -> Step:
    """Im(N D̄) = u I = 0, u = ω or sin ωT, and the value of L at each root; `every` crossing may be asked for."""
    omega, w, s = sp.Symbol("omega"), L.parts.w, L.variable
    parts = {name: real + sp.I * imaginary for name, (real, imaginary) in _even_odd(L).items()}
    real, slope = (p.as_expr().subs(w, L.place(omega)) for p in (L.parts.real, L.parts.imaginary))
    imaginary = sp.expand(L.unit(omega) * slope)
    whole = real + sp.I * imaginary
    claims = {
        "product": Claim(product(parts["N"], conjugate(parts["D"])), whole, "$N(j\\omega)\\overline{D(j\\omega)}$")
    }
    p, roots = L.parts.imaginary, []
    for i, (at, value) in enumerate(found.real_axis, 1):
        end = L.end is not None and at == L.end.omega
        if not end:
            says = "a root in $\\cos\\omega T$" if L.discrete else "a root in $w = \\omega^2$"
            claims[f"root{i}"] = Claim(value_at(shown_polynomial(p), w, L.place(at)), sp.S.Zero, says)
        claims[f"value{i}"] = Claim(value_at(formula_of(L), s, L.point(at)), value, "the value of $L$ on the real axis")
        roots.append(_row(at, value) | {"place": L.place(at), "end": end})
    start = next((each for each in found.found if each.omega == 0), None)
    if start is not None:
        claims["start"] = Claim(value_at(formula_of(L), s, L.point(sp.S.Zero)), -start.magnitude, "$L(0)$")
    kind = "real_axis" if every else "phase_crossovers"
    shown = shown_polynomial(p) if not p.is_zero else sp.S.Zero
    return Step(kind, claims=claims, steps=both_roots(w, shown) + _values(L, found), roots=roots, p=shown, w=w,
                imaginary=imaginary, everywhere=found.everywhere, start=start, crossing=list(found.found),
                moves=bool(p.degree() > 0), discrete=L.discrete, T=L.sample_time, above=parts["N"],
                conjugate=parts["D"].subs(sp.I, -sp.I),
                inner=sum(not row["end"] for row in roots))  # fmt: skip


@where_exact
def _values(L: exact.OnAxis, found: exact.PhaseCrossovers) -> tuple[Step, ...]:
    """The size of L where it is real, factor by factor."""
    lines: tuple[Step, ...] = ()
    for at, value in found.real_axis:
        if not at.free_symbols and value != 0:
            lines += size_and_angle(formula_of(L), L.variable, L.point(at), abs(value))
    return lines


def _late_crossovers(L: exact.OnAxis, found: exact.PhaseCrossovers, *, every: bool = False) -> Step:
    """With a dead time: ∠L₀ − ωT passes −180° − 360° k, an equation that is solved numerically."""
    s, claims = L.variable, {}
    pairs = found.real_axis if every else [(each.omega, -each.magnitude) for each in found.found]
    for i, (omega, value) in enumerate(pairs, 1):
        at = value_at(formula_of(L), s, sp.I * omega)
        claims[f"value{i}"] = Claim(at, value, "the value of $L$ on the real axis")
    crossing = [_row(omega, value) for omega, value in pairs]
    kind = "late_axis" if every else "late_crossovers"
    return Step(kind, claims=claims, crossing=crossing, delay=L.delay, steady=not L.roots, discrete=False)


def _row(at: Expr, value: Expr) -> dict[str, Any]:
    """A frequency on the real axis with the value of L there, both in decimals too."""
    return {"at": at, "near_at": approximation(at), "value": value, "near_value": approximation(value),
            "negative": bool(value < 0)}  # fmt: skip


def approximation(value: Expr) -> Expr | None:
    """A number in decimals, where it is neither rational nor written in decimals already."""
    return None if value.is_Rational or value.has(sp.Float) or not value.is_finite else sp.N(value, 30)


def _gain_margin(found: exact.Margins) -> Step:
    """1/|L| at the crossover that is nearest to −1, as a ratio and in decibels."""
    at, claims = found.at_phase, {}
    if at is not None:
        claims["ratio"] = Claim(quotient(sp.S.One, at.magnitude), found.gain_margin, "the gain margin")
        if found.gain_margin_db.is_Float:
            stated = product(sp.Integer(20), sp.log(found.gain_margin) / sp.log(10))
            claims["decibels"] = Claim(stated, found.gain_margin_db, "the gain margin in decibels")
    listed = [(each.omega, exact.phase_margin_of(each.phase)) for each in found.gains.found]
    return Step(
        "gain_margin",
        claims=claims,
        unclaimed="" if claims else "there is none",
        found=found,
        near=approximation(found.gain_margin),
        gains=listed,
        phases=[(each.omega, each.magnitude) for each in found.phases.found],
        late=found.phases.polynomial is None,
    )


__all__ = [
    "angle_rows",
    "approximation",
    "crossovers_of",
    "formula_of",
    "negative_axis_of",
    "on_axis_of",
    "real_axis_of",
    "shown_polynomial",
]
