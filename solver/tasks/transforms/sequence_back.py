"""Lemma: rational functions of z transformed back by the partial fractions of F/z; poles at zero give unit pulses."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from solver.arithmetic.transformed import term_by_term
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, total
from solver.stated.calculus import value_at
from solver.tasks.linear_algebra.resolvent import completed_squares_of
from solver.tasks.transforms.back_transform import (
    denominator_in_factors,
    multiple_of_earlier,
    partial_fractions_of,
    put_together,
    split_by_delays,
)

if TYPE_CHECKING:
    from sympy import Expr

    from solver.tasks.transforms.back_transform import Names

    Way = Callable[[exact.SequenceImage, Names], Derivation[tuple[Expr, Expr]]]


@lemma("sequence_back")
def of_image(F: Expr, way: Way, names: Names) -> Derivation[tuple[Expr, Expr]]:
    """What belongs to each delay of an image transformed back by itself, shifted and added; with F as fractions."""
    terms = exact.read_sequence_image(F, names.s)
    if len(terms) == 1 and terms[0].delay == 0:
        yield from in_powers_of_z(F, terms[0].image, names)
        return (yield from way(terms[0].image, names))
    return (yield from _by_delays(terms, F, way, names))


@lemma("sequence_back")
def _by_delays(
    terms: tuple[exact.DelayedSequenceImage, ...], F: Expr, way: Way, names: Names
) -> Derivation[tuple[Expr, Expr]]:
    yield from split_by_delays(terms, F, names)
    found: list[tuple[Expr, Expr]] = []
    for number, each in enumerate(terms, 1):
        earlier = ((exact.ratio_of_images(each.image.fraction, terms[i].image.fraction), i) for i in range(number - 1))
        factor, before = next((pair for pair in earlier if pair[0] is not None), (None, 0))
        if factor is None:
            found.append((yield from way(each.image, names.part(number))))
            continue
        function = sp.expand(factor * found[before][0])
        yield from multiple_of_earlier(number, factor, before + 1, function, names)
        found.append((function, sp.expand(factor * found[before][1])))
    f = yield from put_together(terms, [each for each, _ in found], names)
    moved = (names.delayed(each.delay) * own for each, (_, own) in zip(terms, found, strict=True))
    return f, sp.Add(*moved)


@lemma("sequence_back")
def in_powers_of_z(F: Expr, image: exact.SequenceImage, names: Names) -> Derivation[None]:
    """F with positive powers of z, where it is given in 1/z or with a common factor."""
    inverse = exact.is_in_inverse_powers(F, names.s)
    if inverse or image.fraction.cancels:
        claim = Claim(F, image.whole, "in positive powers, and lowest terms")
        yield Step("positive_powers", claims={"F": claim}, inverse=inverse, cancels=image.fraction.cancels,
                   **names.told)  # fmt: skip


@lemma("sequence_back")
def by_fractions_over_z(image: exact.SequenceImage, names: Names) -> Derivation[tuple[Expr, Expr]]:
    """The sequence of a rational image; returns it with F as a sum of fractions."""
    z, k, divided = names.s, names.t, image.divided
    proper: Any = divided.proper
    pulses = _only_pulses(image, z)
    if pulses:
        yield Step("only_pulses", unclaimed="unit pulses, by definition", function=image.function(k),
                   **names.told)  # fmt: skip
        return image.function(k), sp.expand(image.whole)
    if _in_the_table(image, z):
        (term,) = [z * exact.fraction_of_term(each) for each in proper.partial_fractions(z)]
        yield Step("in_the_table", claims={"F": Claim(image.whole, term, "a fraction of the table")}, **names.told)
        return (yield from _from_the_table(image, [term / z], names)), term
    own = names.divided
    rest = divided.rest(z)
    shown = total(*([divided.polynomial(z)] if image.advanced else []), rest)
    claim = Claim(image.whole / z, shown, "the image divided by z")
    yield Step("divide_by_z", claims={"F": claim}, whole=image.whole, advanced=image.advanced,
               at_zero=_order_at_zero(divided, z), **names.told)  # fmt: skip
    yield from denominator_in_factors(_proper_part(divided, z).as_shown, own)
    terms = yield from partial_fractions_of(proper, rest, own)
    polynomial = [z * divided.polynomial(z)] if image.advanced else []
    fractions = sp.Add(*polynomial, *(z * term for term in terms))
    claim = Claim(image.whole, total(*polynomial, *(z * term for term in terms)), "each fraction gets back its z")
    yield Step("times_z", claims={"F": claim}, **names.told)
    return (yield from _from_the_table(image, terms, names)), fractions


@lemma("sequence_back")
def _from_the_table(image: exact.SequenceImage, terms: Sequence[Expr], names: Names) -> Derivation[Expr]:
    """The pairs of the partial fractions, and the sequence."""
    proper: Any = image.divided.proper
    yield from completed_squares_of(proper, names.s)
    yield from polar_forms(proper, names)
    yield _pairs(proper, names)
    yield _back(image, terms, names)
    return image.function(names.t)


def _in_the_table(image: exact.SequenceImage, z: Any) -> bool:
    """Whether F/z is one partial fraction already, with a denominator that is given in factors."""
    divided = image.divided
    if divided.direct or divided.proper is None or len(divided.proper.partial_fractions(z)) > 1:
        return False
    factors = divided.proper.factors
    return len(factors) == 1 and factors[0].degree == 1


def _only_pulses(image: exact.SequenceImage, z: Any) -> bool:
    """Whether all poles are at zero: the image is a polynomial in 1/z (and z)."""
    return len(sp.Poly(image.fraction.denominator, z).monoms()) == 1


def _order_at_zero(divided: exact.RationalImage, z: Any) -> int:
    """The order of the pole of F/z at zero."""
    return int(min(n for (n,) in sp.Poly(divided.denominator, z).monoms()))


def _proper_part(divided: exact.RationalImage, z: Any) -> exact.RationalImage:
    return divided if not divided.direct else exact.rational_image(divided.rest(z), z)


@lemma("sequence_back")
def polar_forms(proper: exact.RationalMatrix, names: Names) -> Derivation[None]:
    """σ ± jω = r e^{±jθ} of the pairs of poles, for the table."""
    found = exact.polar_pairs(proper)
    if found:
        claims = {}
        for i, (root, r, theta) in enumerate(found, 1):
            claims[f"real{i}"] = Claim(product(r, sp.cos(theta)), root.sigma, "real part")
            claims[f"imaginary{i}"] = Claim(product(r, sp.sin(theta)), root.shift, "imaginary part")
        rows = [(root.value, r, theta) for root, r, theta in found]
        yield Step("polar", claims=claims, rows=rows, detail="full", **names.told)


def _pairs(proper: exact.RationalMatrix, names: Names) -> Step:
    pairs = exact.pairs_for(proper, names.s, names.t, discrete=True)
    claims = {
        f"pair{i}": Claim(names.inverse(left), right, "transform pair") for i, (left, right) in enumerate(pairs, 1)
    }
    waves = any(right.has(sp.cos, sp.sin) for _, right in pairs)
    binomial = any(each[1] > 1 for each in proper.poles)
    return Step("pairs", claims=claims, detail="full", waves=waves, binomial=binomial, **names.told)


def _back(image: exact.SequenceImage, terms: Sequence[Expr], names: Names) -> Step:
    z, k = names.s, names.t
    proper: Any = image.divided.proper
    column = proper.function(k, discrete=True).matrix
    claim = Claim(names.inverse(total(*(z * term for term in terms))), column[0], "transformed back, term by term")
    steps = term_by_term(proper, z, k, column, discrete=True)
    pulses = column[0].has(sp.KroneckerDelta)
    return Step("back", claims={"f": claim}, steps=steps, function=image.function(k), pulses=pulses,
                advanced=image.advanced, **names.told)  # fmt: skip


@lemma("sequence_back")
def first_terms(f: Expr, values: Sequence[Expr], names: Names, *, recursion: bool = False) -> Derivation[None]:
    """The first values in a table, as a check: the closed form at k = 0, 1, …."""
    claims = {
        f"value{i}": Claim(value_at(f, names.t, sp.Integer(i)), value, "a value of the closed form")
        for i, value in enumerate(values)
    }
    yield Step("first_terms", claims=claims, values=list(values), detail="brief", recursion=recursion,
               **names.told)  # fmt: skip
