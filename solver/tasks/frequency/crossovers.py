"""Lemma: crossovers and margins of a loop, found on the imaginary axis."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import power, product, quotient, total
from solver.stated.calculus import value_at
from solver.stated.complex_numbers import absolute, conjugate, phase
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr


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


def _even_odd(L: exact.OnAxis) -> dict[str, tuple[Expr, Expr]]:
    """Real and imaginary part of N(jω) and D(jω), in ω."""
    omega, parts = sp.Symbol("omega"), L.parts
    found = {"N": (parts.E, parts.O), "D": (parts.e, parts.o)}
    return {
        name: (even.as_expr().subs(parts.w, omega**2), sp.expand(omega * odd.as_expr().subs(parts.w, omega**2)))
        for name, (even, odd) in found.items()
    }


def _on_axis(L: exact.OnAxis, name_of_L: str) -> Step:
    """N(jω) and D(jω) with their real and imaginary parts, and the squares of their sizes."""
    s, omega, claims = L.variable, sp.Symbol("omega"), {}
    for name, (real, imaginary) in _even_odd(L).items():
        p = (L.N if name == "N" else L.D).as_expr()
        size = (L.parts.above if name == "N" else L.parts.below).as_expr().subs(L.parts.w, omega**2)
        if p.has(s):
            says = Phrase("${name}(j\\omega)$", name=name)
            claims[name] = Claim(value_at(p, s, sp.I * omega), real + sp.I * imaginary, says)
            squares = [power(part, 2) for part in (real, imaginary) if part != 0]
            stated = total(*squares) if len(squares) > 1 else squares[0]
            claims[f"{name}_size"] = Claim(stated, size, Phrase("$|{name}(j\\omega)|^2$", name=name))
    return Step("on_axis", claims=claims, unclaimed="" if claims else "L is a constant", L=formula_of(L), s=s,
                N=L.N.as_expr(), D=L.D.as_expr(), delay=L.delay, name=name_of_L)  # fmt: skip


def _gain_crossovers(L: exact.OnAxis, found: exact.Margins) -> Step:
    """|N|² = |D|² as a polynomial in w = ω², and its positive roots."""
    w, omega, gains = L.parts.w, sp.Symbol("omega"), found.gains
    p = _positive(gains.polynomial)
    claims = {}
    for i, each in enumerate(gains.found, 1):
        claims[f"root{i}"] = Claim(value_at(p, w, each.square), sp.S.Zero, Phrase("a root in $w = \\omega^2$"))
        at = value_at(formula_of(L), L.variable, sp.I * each.omega)
        claims[f"size{i}"] = Claim(absolute(at), each.magnitude, Phrase("the size of $L$ at a gain crossover"))
    sample = None
    if not gains.found:
        sample = next(sp.Integer(k) for k in range(1, 99) if L.parts.below(k**2) != 0)
        at = value_at(formula_of(L), L.variable, sp.I * sample)
        claims["sample"] = Claim(absolute(at), L.magnitude(sample), "the size of $L$ at one frequency")
    roots = [{"square": each.square, "omega": each.omega, "near": approximation(each.omega)} for each in gains.found]
    sizes = [each.as_expr().subs(w, omega**2) for each in (L.parts.above, L.parts.below)]
    return Step("gain_crossovers", claims=claims, p=p, w=w, sizes=sizes, roots=roots, sample=sample,
                below=sample is not None and bool(L.magnitude(sample) < 1))  # fmt: skip


def _positive(p: Any) -> Expr:
    """The polynomial up to a factor: whole coefficients without a common divisor, the first one positive."""
    if p.domain.is_QQ:
        p = p.clear_denoms(convert=True)[1].primitive()[1]
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
        phase(value_at(formula_of(L), L.variable, sp.I * at.omega)), at.phase, "the phase at a gain crossover"
    )
    margin = exact.phase_margin_of(at.phase)
    claims["margin"] = Claim(total(sp.Integer(180), at.phase), at.phase + 180, "the phase margin")
    return Step("phase", claims=claims, rows=rows, at=at, number=number, whole=whole, turns=turns, margin=margin,
                late=L.late, wrapped=margin != at.phase + 180, L=formula_of(L))  # fmt: skip


def angle_rows(L: exact.OnAxis, omega: Expr) -> Iterator[dict[str, Any]]:
    """Each factor at jω as a + jb, and its angle: an arctangent in degrees, a number."""
    for each in L.angles(omega):
        a, b, degrees = each.real, each.imaginary, each.degrees
        stated: Any = degrees
        if not degrees.is_Rational and a != 0:
            turn = 0 if a > 0 else 180 if b >= 0 else -180
            stated = product(quotient(sp.Integer(180), sp.pi), sp.atan(b / a, evaluate=False))
            stated = total(sp.Integer(turn), stated) if turn else stated
        yield {"factor": each.factor, "power": each.power, "value": a + sp.I * b, "stated": stated, "degrees": degrees}


def _signed(degrees: Expr, power_of: int) -> Any:
    return degrees if power_of == 1 else product(sp.Integer(power_of), degrees)


def _phase_crossovers(L: exact.OnAxis, found: exact.PhaseCrossovers, *, every: bool = False) -> Step:
    """Im(N D̄) = ω I(ω²) = 0, and the value of L at each root; `every` crossing of the real axis may be asked for."""
    omega, w, s = sp.Symbol("omega"), L.parts.w, L.variable
    parts = {name: real + sp.I * imaginary for name, (real, imaginary) in _even_odd(L).items()}
    real, slope = (p.as_expr().subs(w, omega**2) for p in (L.parts.real, L.parts.imaginary))
    whole = real + sp.I * sp.expand(omega * slope)
    claims = {
        "product": Claim(product(parts["N"], conjugate(parts["D"])), whole, "$N(j\\omega)\\overline{D(j\\omega)}$")
    }
    p, roots = L.parts.imaginary, []
    for i, (at, value) in enumerate(found.real_axis, 1):
        claims[f"root{i}"] = Claim(value_at(_positive(p), w, sp.expand(at**2)), sp.S.Zero, "a root in $w = \\omega^2$")
        claims[f"value{i}"] = Claim(value_at(formula_of(L), s, sp.I * at), value, "the value of $L$ on the real axis")
        roots.append(_row(at, value))
    start = next((each for each in found.found if each.omega == 0), None)
    if start is not None:
        claims["start"] = Claim(value_at(formula_of(L), s, sp.S.Zero), -start.magnitude, "$L(0)$")
    kind = "real_axis" if every else "phase_crossovers"
    return Step(kind, claims=claims, roots=roots, p=_positive(p) if not p.is_zero else sp.S.Zero, w=w,
                imaginary=sp.expand(omega * slope), everywhere=found.everywhere, start=start,
                crossing=list(found.found), moves=bool(p.degree() > 0))  # fmt: skip


def _late_crossovers(L: exact.OnAxis, found: exact.PhaseCrossovers, *, every: bool = False) -> Step:
    """With a dead time: ∠L₀ − ωT passes −180° − 360° k, an equation that is solved numerically."""
    s, claims = L.variable, {}
    pairs = found.real_axis if every else [(each.omega, -each.magnitude) for each in found.found]
    for i, (omega, value) in enumerate(pairs, 1):
        at = value_at(formula_of(L), s, sp.I * omega)
        claims[f"value{i}"] = Claim(at, value, "the value of $L$ on the real axis")
    crossing = [_row(omega, value) for omega, value in pairs]
    kind = "late_axis" if every else "late_crossovers"
    return Step(kind, claims=claims, crossing=crossing, delay=L.delay, steady=not L.roots)


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


__all__ = ["angle_rows", "approximation", "crossovers_of", "formula_of", "on_axis_of", "real_axis_of"]
