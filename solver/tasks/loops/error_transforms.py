"""Lemmas: the transform of the error of a loop, part by part, and what remains of it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, power, product, quotient, total
from solver.stated.limits import Side, limit
from solver.stated.transforms import inverse_laplace, inverse_z
from solver.tasks.loops.late_loops import image_of, long_run_of, rational_of, with_dead_time
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import OpenLoop
    from solver.tasks.loops.loop_stability import Inside


@dataclass(frozen=True, slots=True)
class Share:
    """What a signal, the reference r or the disturbance d, adds to the error: its transform E, in factors."""

    name: str
    signal: Expr
    E: Expr


@lemma("error_transforms")
def shares_of(loop: OpenLoop, r: Expr, d: Expr) -> Derivation[tuple[Share, ...]]:
    """E = (1 − T) R − T_d D with T = CG/(1 + L) and T_d = G/(1 + L); without a loop T = CG and T_d = G."""
    signals = [(name, signal) for name, signal in (("r", r), ("d", d)) if signal != 0]
    images = yield from _images(signals, discrete=loop.discrete)
    shares, alone = [], len(signals) == 1
    for (name, signal), R in zip(signals, images, strict=True):
        E = yield from (_of_reference if name == "r" else _of_disturbance)(loop, R, alone=alone)
        shares.append(Share(name, signal, E))
    return tuple(shares)


@lemma("error_transforms")
def _images(signals: Sequence[tuple[str, Expr]], *, discrete: bool) -> Derivation[list[Expr]]:
    """R(s), D(s) of what the signals are in the long run; in discrete time R(z), D(z)."""
    s, t = sp.symbols("z k" if discrete else "s t")
    back = inverse_z if discrete else inverse_laplace
    rows, claims = [], {}
    for name, signal in signals:
        lasting = exact.lasting(signal, t, discrete=discrete)
        image = exact.transform_of(lasting, t, s, discrete=discrete)
        if image != 0:
            claims[name] = Claim(back(image, s, t), lasting, Phrase("transform of ${name}$", name=name))
        rows.append((name, signal, lasting, image))
    yield Step("signals", claims=claims, unclaimed="" if claims else "there are no signals that last", rows=rows, t=t,
               s=s, cut=[signal.has(sp.Heaviside, sp.DiracDelta) for _, signal, _, _ in rows])  # fmt: skip
    return [image for *_, image in rows]


def _below(loop: OpenLoop) -> Any:
    """1 + L as it is written."""
    return total(1, with_dead_time(loop, quotient(loop.numerator, loop.denominator)))


def _of_reference(loop: OpenLoop, R: Expr, *, alone: bool) -> Derivation[Expr]:
    """With unity feedback (1 − T) R is R/(1 + L)."""
    s, CG = loop.variable, loop.C * loop.G * loop.factor
    if loop.closed and loop.H == 1:
        N, D = loop.numerator * loop.factor, loop.denominator
        E = image_of(loop, D / (D + N), R)
        left = product(quotient(1, _below(loop)), R)
        step = product(quotient(D, sp.Poly(D + N, s).as_expr() if loop.delay == 0 else D + N), R)
        claims = {"stated": Claim(left, step, "transform of the error"), "E": Claim(step, E, "in lowest terms")}
        yield Step("unity", claims=claims, s=s, alone=alone)
        return E
    if loop.closed:
        T = rational_of(loop, CG / (1 + CG * loop.H))
        of_loop = Claim(quotient(rational_of(loop, CG), _below(loop)), T, "closed loop $T$")
        yield Step("closed", claims={"T": of_loop}, s=s, direct=loop.C == 1)
    else:
        T = rational_of(loop, CG)
        path = with_dead_time(loop, product(loop.C, loop.G))
        yield Step("opened", claims={"T": Claim(path, T, "path $CG$")}, s=s, direct=loop.C == 1)
    E = image_of(loop, 1 - T, R)
    claim = Claim(product(difference(1, T), R), E, "transform of the error")
    yield Step("reference", claims={"E": claim}, s=s, alone=alone)
    return E


def _of_disturbance(loop: OpenLoop, R: Expr, *, alone: bool) -> Derivation[Expr]:
    """The disturbance adds −T_d D."""
    s, G = loop.variable, rational_of(loop, loop.G * loop.factor)
    T = rational_of(loop, G / (1 + loop.C * G * loop.H)) if loop.closed else G
    stated = quotient(G, _below(loop)) if loop.closed else G
    E = image_of(loop, -T, R)
    claims = {
        "T": Claim(stated, T, "from the disturbance to the output"),
        "E": Claim(product(-1, T, R), E, "its part of the error"),
    }
    yield Step("disturbance", claims=claims, s=s, closed=loop.closed, alone=alone)
    return E


@lemma("error_transforms")
def limit_of(loop: OpenLoop, shares: Sequence[Share], inside: Inside) -> Derivation[Expr]:
    """The limit of s E(s), of (1 − z⁻¹) E(z); raises Unsolved where e has none, or where parameters decide."""
    s, discrete = loop.variable, loop.discrete
    factor, goal = (difference(1, power(s, -1)), sp.S.One) if discrete else (s, sp.S.Zero)
    found = [long_run_of(loop, share.E, inside) for share in shares]
    for share, each in zip(shares, found, strict=True):
        if not each.settles:
            values = {"name": share.name, "signal": share.signal, "others": each.others, "discrete": discrete}
            undecided = each.settles is None
            raise Unsolved("steady_state_error/undecided" if undecided else "steady_state_error/no_limit", **values)
    whole = found[0]
    if any(each.order > 1 for each in found) and len(found) > 1:
        E = sp.Add(*(share.E for share in shares))
        whole = long_run_of(loop, E, inside)
    rows, claims = [], {}
    for share, each in zip(shares, found, strict=True):
        if each.order == 1 and each.lead != each.quotient[0]:
            claims[f"{share.name}_at_zero"] = Claim(quotient(*each.quotient), each.lead, "put in")
        if each.value is not None and (each.order < 2 or not each.value.free_symbols):
            side: Side = "+" if each.order > 1 else ""
            if each.order < 2 or not share.E.free_symbols - {s}:
                claims[share.name] = Claim(limit(product(factor, share.E), s, goal, side), each.value, "final value")
        rows.append((share.name, share.E, each))
    if all(each.order < 2 for each in found):
        e: Any = sp.Add(*(each.lead for each in found))
        if len(found) > 1:
            claims["sum"] = Claim(total(*(each.lead for each in found)), e, "sum of both parts")
    elif whole.value is None:
        raise Unsolved("steady_state_error/sign", lead=whole.lead, order=whole.order)
    else:
        e = whole.value
    yield Step("final_value", claims=claims, unclaimed="" if claims else "an order of growth has no value", rows=rows,
               e=e, order=whole.order, lead=whole.lead, s=s, discrete=discrete)  # fmt: skip
    return e
