"""Lemma: rational functions of s transformed back by partial fractions, with a polynomial and with dead times."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.arithmetic.exactness import at_full
from solver.arithmetic.fractions import expanded
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import power, product, quotient, total
from solver.stated.transforms import inverse_laplace, inverse_z, laplace, z_transform
from solver.tasks.linear_algebra.resolvent import completed_squares_of
from solver.tasks.linear_algebra.table_form import table_form_of
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.stated import Stated


@dataclass(frozen=True)
class Names:
    """What an image and its function of time are called (LaTeX), and the variables that they are functions of.

    Of a sequence they are z and k.
    """

    image: str
    function: str
    s: Symbol
    t: Symbol

    @property
    def discrete(self) -> bool:
        """Whether they are those of the z-transform."""
        return self.s.name == "z"

    @property
    def divided(self) -> Names:
        """The names of the image divided by z."""
        return Names(rf"\frac{{{self.image}(z)}}{{z}}", self.function, self.s, self.t)

    def transform(self, function: Any) -> Stated:
        """The transform of a function of time, as it is stated."""
        return z_transform(function, self.t, self.s) if self.discrete else laplace(function, self.t, self.s)

    def inverse(self, image: Any) -> Stated:
        """The function of time with an image, as it is stated."""
        return inverse_z(image, self.s, self.t) if self.discrete else inverse_laplace(image, self.s, self.t)

    def delayed(self, delay: Expr) -> Expr:
        """The factor of what comes a delay later."""
        found: Expr = self.s**-delay if self.discrete else sp.exp(-delay * self.s)
        return found

    def part(self, number: int) -> Names:
        """The names of a part of the image."""
        return Names(f"{self.image}_{{{number}}}", f"{self.function}_{{{number}}}", self.s, self.t)

    @property
    def rest(self) -> Names:
        """The names of what is left of the image when a polynomial is divided out."""
        apart = self.image.removeprefix(self.image.split("_")[0])
        return Names(f"R{apart}", self.function, self.s, self.t)

    def moved(self, delay: Expr, function: Expr) -> Expr:
        """The function from its delay on."""
        if not self.discrete:
            return moved_by(delay, function, self.t)
        found: Expr = exact.shifted(sp.ImmutableMatrix([function]), self.t, delay, discrete=True)[0]
        return found

    @property
    def told(self) -> dict[str, Any]:
        """The names as the wording takes them."""
        return {"F": self.image, "f": self.function, "s": self.s, "t": self.t, "discrete": self.discrete}


@lemma("back_transform")
def denominator_in_factors(image: exact.RationalImage, names: Names) -> Derivation[None]:
    """The polynomial divided out, and the denominator in its irreducible factors, where it is not given so."""
    s = names.s
    if image.cancels:
        claim = Claim(image.given, image.whole, "common factors cancelled")
        yield Step("cancelled", claims={"F": claim}, **names.told)
    if image.direct:
        rest = image.rest(s)
        claim = Claim(image.whole, total(image.polynomial(s), rest) if rest != 0 else image.polynomial(s), "divided")
        yield Step("divided", claims={"F": claim}, rest=rest, polynomial=image.polynomial(s),
                   R=names.rest.image, **names.told)  # fmt: skip
    if image.proper is None:
        return
    factors = image.proper.factors
    shown = product(*(power(each.polynomial(s), each.multiplicity) for each in factors))
    if not _shows_its_factors(image, s):
        decimals = [each.degree for each in factors if each.roots[0].kind == "decimal"]
        roots = [root for each in factors for root in each.roots]
        claims = {"factors": Claim(image.denominator, shown, "the denominator in factors")}
        split = len(factors) > 1 or factors[0].multiplicity > 1
        yield Step("denominator", claims=claims, split=split, decimals=decimals, roots=roots,
                   denominator=image.denominator, exceptions=image.exceptions, **names.told)  # fmt: skip
    elif image.exceptions:
        yield Step("exceptions", unclaimed="when poles meet", exceptions=image.exceptions, detail="brief",
                   **names.told)  # fmt: skip


def _shows_its_factors(image: exact.RationalImage, s: Symbol) -> bool:
    """Whether the denominator is given as a product of the irreducible factors, with rational roots or quadratics."""
    if image.proper is None or any(each.roots[0].kind == "decimal" for each in image.proper.factors):
        return False
    _, below = sp.fraction(image.given)
    parts: tuple[Any, ...] = sp.Mul.make_args(below)
    powers = [each.as_base_exp() for each in parts if each.has(s)]
    given = {(sp.Poly(base, s).monic().as_expr(), exponent) for base, exponent in powers if base.is_polynomial(s)}
    own = {(each.polynomial(s), sp.Integer(each.multiplicity)) for each in image.proper.factors}
    surds = any(root.kind == "surd" for each in image.proper.factors for root in each.roots)
    return given == own and not surds


@lemma("back_transform")
def partial_fractions_of(image: exact.RationalMatrix, whole: Expr, names: Names) -> Derivation[list[Expr]]:
    """The coefficients one by one, and the sum of partial fractions; returns its terms."""
    s = names.s
    terms = [exact.fraction_of_term(term) for term in image.partial_fractions(s)]
    if len(terms) == 1 and (exact.is_found_otherwise(image, s) or not exact.divided_again(image, s)):
        yield Step("in_the_table", claims={"F": Claim(whole, terms[0], "a fraction of the table")}, **names.told)
        return terms
    formed = yield from coefficients_of(image, whole, names)
    claim = Claim(whole, total(*terms), "partial fractions")
    yield Step("partial_fractions", claims={"expansion": claim}, formed=formed, **names.told,
               **exact.Denominators.of(image, s).named)  # fmt: skip
    return terms


@lemma("back_transform")
def coefficients_of(image: exact.RationalMatrix, whole: Expr, names: Names) -> Derivation[bool]:
    """Poles covered up, derivatives for repeated ones, numerators over quadratics compared or divided.

    Returns whether the form of the sum was told before.
    """
    s, otherwise = names.s, exact.is_found_otherwise(image, names.s)
    steps = at_full(expanded, image, s)
    formed = any(step.kind == "form" for step in steps)
    for step in steps:
        if otherwise or step.kind != "put_together":
            yield step
    if otherwise:
        return formed
    divided = exact.divided_again(image, s)
    if divided is not None:
        yield _divided_again(divided, whole, names)
    else:
        yield _compared(exact.compared_at_all(image, s), names)
    return formed


def _divided_again(found: exact.Divided, whole: Expr, names: Names) -> Step:
    claims = {}
    if found.known:
        left = quotient(found.left, power(found.base, found.power))
        claims["left"] = Claim(total(whole, *(-each for each in found.known)), left, "what is left")
    for i, each in enumerate(found.divisions, 1):
        claims[f"divided{i}"] = Claim(
            each.dividend, total(product(each.quotient, found.base), each.remainder), "divided by the quadratic"
        )
    return Step("divided_again", claims=claims, detail="full", p=found.base, power=found.power,
                known=bool(found.known), left=found.left, count=len(found.divisions), **names.told)  # fmt: skip


def _compared(found: exact.AllCompared, names: Names) -> Step:
    values = dict(zip(found.letters, found.values, strict=True))
    claims = {
        f"power{k}": Claim(right.xreplace(values), left, Phrase("coefficients of $s^{{{k}}}$ compared", k=k))
        for k, left, right in found.equations
    }
    sides = total(*([found.known] if found.known != 0 else []), *(product(N, below) for N, below in found.terms))
    return Step("compared_at_all", claims=claims, detail="full", numerator=found.numerator, sides=sides,
                equations=found.equations, values=list(values.items()), **names.told)  # fmt: skip


@lemma("back_transform")
def by_partial_fractions(image: exact.RationalImage, names: Names) -> Derivation[tuple[Expr, Expr]]:
    """The function of time of a rational image; returns it with the sum of partial fractions."""
    s, t = names.s, names.t
    yield from denominator_in_factors(image, names)
    smooth: Expr = sp.S.Zero
    fractions: Expr = sp.S.Zero
    if image.proper is not None:
        proper = image.proper
        terms = yield from partial_fractions_of(proper, image.rest(s), names.rest if image.direct else names)
        fractions = sp.Add(*terms)
        column = proper.function(t, discrete=False).matrix
        yield from completed_squares_of(proper, s)
        yield from table_form_of(proper, terms, s, t, column, discrete=False)
        yield _pairs(proper, names)
        smooth = column[0]
    function = image.function(t)
    claims = {}
    if image.proper is not None:
        claims["f"] = Claim(inverse_laplace(total(*terms), s, t), smooth, "transformed back, term by term")
    yield Step("back", claims=claims, unclaimed="" if claims else "impulses, by definition",
               function=function, smooth=smooth, direct=image.direct,
               repeated=image.proper is not None and any(m > 1 for _, m in image.proper.poles),
               **names.told)  # fmt: skip
    return function, sp.Add(image.polynomial(s), fractions)


def _pairs(proper: exact.RationalMatrix, names: Names) -> Step:
    pairs = exact.pairs_for(proper, names.s, names.t, discrete=False)
    claims = {
        f"pair{i}": Claim(inverse_laplace(left, names.s, names.t), right, "transform pair")
        for i, (left, right) in enumerate(pairs, 1)
    }
    powers = any(order > 1 and exact.keeps_quadratic(each.factor) for each, order in proper.poles)
    undecided = any(
        root.kind == "symbolic" and root.shift != 0 for each, _ in proper.poles for root in each.factor.roots
    )
    return Step("pairs", claims=claims, detail="full", powers=powers, undecided=undecided, **names.told)


@lemma("back_transform")
def split_by_delays(
    terms: Sequence[exact.DelayedImage | exact.DelayedSequenceImage], F: Expr, names: Names
) -> Derivation[None]:
    """F = F₀ + F₁ e^{−T₁s} + …, of which each term is transformed back by itself; in discrete time z⁻ⁿ for e^{−Ts}."""
    factors = [names.delayed(each.delay) for each in terms]
    images = [each.image.whole for each in terms]
    shown = total(*(product(image, factor) for image, factor in zip(images, factors, strict=True)))
    claim = Claim(F, shown, "the terms of each dead time")
    yield Step("delays", claims={"F": claim}, delays=[each.delay for each in terms], factors=factors,
               images=images, **names.told)  # fmt: skip


@lemma("back_transform")
def multiple_of_earlier(number: int, factor: Expr, before: int, function: Expr, names: Names) -> Derivation[None]:
    """A part that is a multiple of an earlier one: its function is that multiple."""
    yield Step("multiple", unclaimed="a multiple of what was found", number=number, before=before, factor=factor,
               function=function, whole=names.image, of=names.function, s=names.s, t=names.t)  # fmt: skip


@lemma("back_transform")
def put_together(
    terms: Sequence[exact.DelayedImage | exact.DelayedSequenceImage], functions: Sequence[Expr], names: Names
) -> Derivation[Expr]:
    """Each function shifted to its place, and the sum of them; returns it."""
    moved = [names.moved(each.delay, f) for each, f in zip(terms, functions, strict=True)]
    whole = sp.Add(*moved)
    yield Step("shifted", unclaimed="each function at its place", delays=[each.delay for each in terms],
               functions=list(functions), moved=moved, whole=whole, **names.told)  # fmt: skip
    return whole


def moved_by(delay: Expr, function: Expr, t: Symbol) -> Expr:
    """f(t − T) from t = T on, zero before; impulses need no step."""
    if delay == 0:
        return function
    if not function.has(sp.DiracDelta):
        return exact.shifted(sp.ImmutableMatrix([function]), t, delay)[0] if function != 0 else function
    pulses, others = sp.sift(sp.Add.make_args(sp.expand(function)), lambda term: term.has(sp.DiracDelta), binary=True)
    late = [exact.shifted(sp.ImmutableMatrix([sp.Add(*others)]), t, delay)[0]] if others else []
    return sp.Add(*late, *(term.xreplace({t: t - delay}) for term in pulses))
