"""Images in s: sums of rational functions times e^{−Ts}, each split into a polynomial and a strictly proper rest."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.functions.rational import RationalMatrix
from solver.exact.linear_algebra.fields import NotExact, domain_matrix, in_powers
from solver.exact.linear_algebra.signs import possible_signs
from solver.exact.linear_algebra.spectrum import Spectrum, spectrum_of_polynomial
from solver.exact.time_response.signals import in_order


@dataclass(frozen=True)
class RationalImage:
    """F = Σ `direct`[i] sⁱ + `proper` (1×1, zero: None); `given` is F as it was, `whole` in lowest terms.

    `denominator` is monic, multiplied out; `exceptions` are conditions on parameters under which poles meet.
    """

    given: sp.Expr
    whole: sp.Expr
    numerator: sp.Expr
    denominator: sp.Expr
    direct: tuple[sp.Expr, ...]
    proper: RationalMatrix | None
    exceptions: tuple[sp.Basic, ...]
    cancels: bool

    def polynomial(self, s: sp.Symbol) -> sp.Expr:
        """The polynomial Σ cᵢ sⁱ that is divided out; zero where F is strictly proper."""
        return sp.Add(*(c * s**i for i, c in enumerate(self.direct)))

    def rest(self, s: sp.Symbol) -> sp.Expr:
        """The strictly proper rest in lowest terms, its denominator in irreducible factors."""
        return self.proper.expression(s)[0] if self.proper is not None else sp.S.Zero

    @property
    def as_shown(self) -> RationalImage:
        """The same, given in lowest terms with its denominator in factors."""
        return replace(self, given=self.whole, cancels=False)

    def function(self, t: sp.Symbol) -> sp.Expr:
        """The function of t ≥ 0 with this image, impulses and their derivatives included."""
        impulses = [c * sp.DiracDelta(t, i) if i else c * sp.DiracDelta(t) for i, c in enumerate(self.direct) if c != 0]
        smooth = self.proper.function(t, discrete=False).matrix[0] if self.proper is not None else sp.S.Zero
        return sp.Add(smooth, *impulses)


@dataclass(frozen=True)
class DelayedImage:
    """A term F(s) e^{−Ts} of an image."""

    delay: sp.Expr
    image: RationalImage


def rational_image(F: sp.Expr, s: sp.Symbol) -> RationalImage:
    """F = N/D over the smallest field of its coefficients; raises NotExact where it is no quotient of polynomials."""
    N, D, cancels = lowest_terms(F, s)
    return split_image(F, N, D, s, cancels=cancels)


def lowest_terms(F: sp.Expr, s: sp.Symbol) -> tuple[sp.Poly, sp.Poly, bool]:
    """N and a monic D over the smallest field, and whether factors cancelled; raises NotExact as `rational_image`."""
    above, below = sp.fraction(sp.together(F))
    if not (above.is_polynomial(s) and below.is_polynomial(s)):
        raise NotExact("transforms/not_rational", part=F)
    rows = [sp.Poly(side, s).all_coeffs() for side in (above, below)]
    both = domain_matrix(sp.ImmutableMatrix([[*rows[0], *rows[1]]]))
    K, listed = both.domain, both.to_list_flat()
    N, D = (sp.Poly(each, s, domain=K) for each in (listed[: len(rows[0])], listed[len(rows[0]) :]))
    shared = N.gcd(D)
    N, D = N.quo(shared), D.quo(shared)
    lead = D.LC()
    N, D = (sp.Poly([c / _element(K, lead) for c in each.rep.to_list()], s, domain=K) for each in (N, D))
    return N, D, shared.degree() > 0


def _element(K: Any, c: sp.Expr) -> Any:
    return K.from_sympy(c)


def split_image(
    F: sp.Expr, N: sp.Poly, D: sp.Poly, s: sp.Symbol, *, cancels: bool = False, roots: Spectrum | None = None
) -> RationalImage:
    """F = N/D in lowest terms as a polynomial and a strictly proper rest; `roots` are those of D, where known."""
    K = D.domain
    direct, rest = N.div(D)
    found = roots or spectrum_of_polynomial(D)
    proper = None
    if not rest.is_zero:
        chi = tuple(reversed(D.rep.to_list()))
        numerator = tuple(DomainMatrix([[c]], (1, 1), K) for c in reversed(rest.rep.to_list()))
        proper = RationalMatrix((1, 1), numerator, chi, found.factors)
    over, under = (in_powers(each.rep.to_list(), K, s) for each in (N, D))
    coefficients = [] if direct.is_zero else [in_powers([c], K, s) for c in reversed(direct.rep.to_list())]
    factors = [(factor.polynomial(s), factor.multiplicity) for factor in found.factors]
    return RationalImage(
        F, _quotient(over, factors, s), over, under, tuple(coefficients), proper, found.exceptions, cancels
    )


def _quotient(over: sp.Expr, factors: Sequence[tuple[sp.Expr, int]], s: sp.Symbol) -> sp.Expr:
    """N over the factors, with T s + 1 in place of T (s + 1/T); a minus that all terms of N have is put in front."""
    symbolic = any((p.free_symbols - {s}) for p, _ in factors) or bool(over.free_symbols - {s})
    if not symbolic or any(p.has(sp.exp) for p, _ in factors):  # z - e^{-T} is written so, and not z e^{T} - 1
        minus = all(term.could_extract_minus_sign() for term in sp.Add.make_args(over))
        found: sp.Expr = sp.Mul(-over if minus else over, *(p**-m for p, m in factors))
        return -found if minus else found
    cleared = [(*sp.fraction(sp.together(p)), m) for p, m in factors]
    above, below = sp.fraction(sp.together(over))
    constant = sp.cancel(sp.Mul(1 / below, *(q**m for _, q, m in cleared)))
    return constant * sp.factor(above) * sp.Mul(*(sp.collect(sp.expand(p), s) ** -m for p, _, m in cleared))


def read_image(F: sp.Expr, s: sp.Symbol) -> tuple[DelayedImage, ...]:
    """The terms of F, a dead time each, the earliest first; raises NotExact for any other F, naming the part.

    Of dead times that are given by symbols the order in which they come is told by their size, where it is known.
    """
    marks: dict[sp.Expr, sp.Expr] = {}
    marked = F
    for each in sorted(F.atoms(sp.exp), key=str):
        if each.has(s):
            delay, factor = _dead_time(each, s)
            marks[delay] = marks.get(delay, sp.Dummy(positive=True))
            marked = marked.xreplace({each: factor * marks[delay]})
    symbols = list(marks.values())
    terms: dict[sp.Expr, sp.Expr] = {}
    for term in sp.Add.make_args(marked):
        above, below = sp.fraction(sp.together(term))
        if below.has(*symbols) if symbols else False:
            raise NotExact("transforms/delay_below", part=F)
        for exponents, c in sp.Poly(above, *symbols).terms() if symbols else [((), above)]:
            delay = sp.expand(sp.Add(*(n * T for n, T in zip(exponents, marks, strict=True))))
            terms[delay] = terms.get(delay, sp.S.Zero) + c / below
    delays = in_order(terms) or sorted(terms, key=lambda T: (T != 0, str(T)))
    found = [DelayedImage(delay, rational_image(terms[delay], s)) for delay in delays]
    return tuple(each for each in found if each.image.numerator != 0) or tuple(found[:1])


def ratio_of_images(image: RationalImage, other: RationalImage) -> sp.Expr | None:
    """The constant c ≠ 0 with F = c G; None where there is none."""
    if image.denominator != other.denominator:
        return None
    ratio: sp.Expr = sp.cancel(image.numerator / other.numerator)
    symbols = (image.denominator.free_symbols | image.numerator.free_symbols) & set(sp.symbols("s z"))
    return None if ratio.has(*symbols) and symbols else ratio


def _dead_time(factor: sp.Expr, s: sp.Symbol) -> tuple[sp.Expr, sp.Expr]:
    """(T, c) of c e^{−Ts}."""
    exponent = sp.expand(factor.args[0])
    slope, offset = exponent.coeff(s, 1), exponent.coeff(s, 0)
    if sp.expand(exponent - slope * s - offset) != 0 or slope.has(s) or slope.has(sp.I):
        raise NotExact("transforms/not_rational", part=factor)
    signs = possible_signs(-slope)
    if signs <= {-1}:
        raise NotExact("transforms/ahead_of_time", part=factor)
    if -1 in signs:
        raise NotExact("transforms/sign_of_delay", delay=-slope)
    return -slope, sp.exp(offset)
