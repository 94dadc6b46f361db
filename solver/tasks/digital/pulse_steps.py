"""Lemma: the pulse transfer function of a plant, by partial fractions and the table of z-transforms."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING, Any

from solver.arithmetic.denominators import brought_together
from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact, systems
from solver.lazy import sympy as sp
from solver.matrices import entry_alone
from solver.stated.algebra import power, product, quotient, total
from solver.stated.transforms import inverse_laplace, z_transform
from solver.tasks.linear_algebra.resolvent import completed_squares_of
from solver.tasks.transforms.back_transform import Names, denominator_in_factors, partial_fractions_of
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, Symbol


def pulse_of(plant: Any, T: Expr, *, held: bool, delay: Any = 0) -> Derivation[Any]:
    """G(z) of a transfer function (with a dead time), entry by entry; returns it, of one channel as an expression."""
    if isinstance(plant, systems.DeadTime):
        plant, delay = plant.rational, plant.delay + delay
    p, m = plant.matrix.shape
    several = p * m > 1
    entries = []
    for i in range(p):
        for j in range(m):
            place = f"{i + 1}{j + 1}" if several else ""
            found = yield from pulse_of_entry(plant.matrix[i, j], T, held=held, delay=delay, place=place)
            entries.append(found.result.expression(sp.Symbol("z")))
    return entry_alone(sp.ImmutableMatrix(p, m, entries))


def periods_of(delay: Expr, T: Expr) -> tuple[int, Expr]:
    """(l, μ) of a dead time (l − μ)T; raises Unsolved where parameters leave open how many periods it takes."""
    found = exact.dead_time_in_periods(sp.S.Zero + delay, T)
    if found is None:
        raise Unsolved("pulses/delay_not_in_periods", delay=delay, T=T)
    return found


@lemma("pulse_steps")
def pulse_of_entry(
    G: Expr,
    T: Expr,
    *,
    held: bool,
    delay: Any = 0,
    place: str = "",
    name: str = "G",
    of: str = "G",
    known: Collection[Expr] = (),
) -> Derivation[exact.Pulse]:
    """(1 − z⁻¹) 𝒵{G(s)/s}, or 𝒵{G(s)} without a hold; returns what was found on the way too.

    `known` are the transforms that were told before.
    """
    s, z, t = sp.symbols("s z t")
    late, ahead = periods_of(delay, T)
    if G == 0:
        raise Unsolved("pulses/zero")
    if not held and sp.degree(sp.fraction(sp.together(G))[0], s) >= sp.degree(sp.fraction(sp.together(G))[1], s):
        raise Unsolved("pulses/impulses_pass")
    found = exact.pulse(G, s, T, held=held, late=late, ahead=ahead)
    letter = "F" if held else of
    sub = f"_{{{place}}}" if place else ""
    names = Names(f"{letter}{sub}", f"f{sub}", s, t)
    shown = {"held": held, "name": f"{name}{sub}", "of": f"{of}{sub}", "letter": letter, "T": T, "z": z, "place": place}
    claims = {"F": Claim(quotient(G, s), found.image.whole, "what is sampled")} if held else {}
    yield Step("hold", claims=claims, unclaimed="" if claims else "the definition", G=G, F=found.image.whole,
               delay=delay, late=late, ahead=ahead, **shown)  # fmt: skip
    yield from denominator_in_factors(found.image.as_shown, names)
    proper = found.image.proper
    assert proper is not None  # noqa: S101 - it is not zero, and strictly proper
    yield from partial_fractions_of(proper, found.image.whole, names)
    yield from completed_squares_of(proper, s)
    yield _sampled(found, T, {**shown, "known": known}, ahead)
    yield _result(found, shown, late)
    return found


def _sampled(found: exact.Pulse, T: Expr, shown: dict[str, Any], ahead: Expr) -> Step:
    """Each fraction, its function of time, the transform of its samples."""
    s, z, t, k = sp.symbols("s z t k")
    claims, rows = {}, []
    for i, each in enumerate(found.terms, 1):
        says = Phrase("fraction {i}", i=i)
        at = sp.expand((k + ahead) * T)
        claims[f"function{i}"] = Claim(inverse_laplace(each.fraction, s, t), each.function, says)
        image = each.image(z)
        claims[f"image{i}"] = Claim(z_transform(each.function.xreplace({t: at}), k, z), image, says)
        rows.append((each.fraction, each.function, image, image in shown["known"]))
    return Step("sampled", claims=claims, rows=rows, at=sp.expand((k + ahead) * T), ahead=ahead, **shown)


def _result(found: exact.Pulse, shown: dict[str, Any], late: int) -> Step:
    """The sum, times what hold and dead time make of it."""
    z = shown["z"]
    images = [image for each in found.terms if (image := each.image(z)) != 0]
    whole = found.result.expression(z)
    factors = [*([quotient(z - 1, z)] if shown["held"] else []), *([power(z, -late)] if late else [])]
    stated = product(*factors, total(*images)) if images else sp.S.Zero
    lines = brought_together([_less_the_hold(image, z) for image in images], z) if shown["held"] else ()
    claims = {"G": Claim(stated, whole, "the pulse transfer function")}
    return Step("result", claims=claims, steps=lines, whole=whole, late=late,
                seen=bool(images), **shown)  # fmt: skip


def _less_the_hold(image: Expr, z: Symbol) -> Expr:
    """(z − 1)/z times a fraction, what cancels cancelled."""
    above, below = sp.fraction(image)
    factors = list(sp.Mul.make_args(below))
    held = next((each for each in factors if each.as_base_exp()[0] == z - 1), None)
    if held is not None:
        factors[factors.index(held)] = held / (z - 1)
    else:
        above *= z - 1
    return sp.expand(above / z) / sp.Mul(*factors)


@lemma("pulse_steps")
def factors_sampled_apart(G: Expr, T: Expr, *, held: bool, whole: Expr) -> Derivation[None]:
    """What a sampler (with a hold) between two factors of G would make of it: another transfer function."""
    s, z = sp.symbols("s z")
    split = exact.two_factors(G, s)
    if split is None:
        return
    first, second = (exact.pulse(each, s, T, held=held).result.expression(z) for each in split)
    claim = Claim(product(first, second), sp.Mul(first, second), "the factors sampled one by one")
    yield Step("sampled_apart", claims={"apart": claim}, detail="full", factors=split, images=(first, second),
               held=held, whole=whole, z=z)  # fmt: skip
