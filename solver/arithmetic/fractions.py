"""Partial fractions: poles covered up, derivatives for repeated ones, compared coefficients, quadratics split."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from solver.arithmetic.exactness import where_exact
from solver.arithmetic.values import put_in
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.matrices import entries, entry_alone
from solver.stated.algebra import power, product, quotient, total
from solver.stated.calculus import derivative, value_at

if TYPE_CHECKING:
    from sympy import ImmutableMatrix, Symbol

SMALL, LARGE = 4, 9
"""A matrix with more entries is written over their common denominator, if they have the same one; with more than
`LARGE` the numbers put in would fill the page."""


@where_exact
def expanded(image: exact.RationalMatrix, x: Symbol) -> tuple[Step, ...]:
    """How the coefficients of the partial fractions in x are found; none where the image is one fraction already."""
    return tuple(_expanded(image, x))


@lemma("arithmetic/fractions")
def _expanded(image: exact.RationalMatrix, x: Symbol) -> Derivation[None]:
    poles = exact.covered(image, x)
    names = _names(image, poles, x)
    if names:
        yield _form(image, poles, names, x)
    simple = [each for each in poles if each.order == 1 and each.functions[0].has(x)]
    if simple:
        yield _covered_up(simple, x, [names[each.pole][0] for each in simple] if names else [])
    for each in poles:
        if each.order > 1 and each.functions[0].has(x):
            yield _repeated(each, x, names[each.pole] if names else [])
    found, several = exact.compared(image, x), exact.at_upper_roots(image, x)
    if found is not None:
        yield _compared(found, x)
    elif several:
        yield from (_at_the_upper_root(each, x) for each in several)
    elif len(fractions := exact.fractions_of(image, x)) > 1 and any(each.slope is not None for each in fractions):
        yield _put_together(image, x)


def _names(image: exact.RationalMatrix, poles: Sequence[exact.Covered], x: Symbol) -> dict[Any, list[str]]:
    """The letters c₁, c₂, … of the coefficients of each pole, those of the higher powers first.

    None of a matrix, of one fraction alone, and where numerators over several quadratics would need letters too.
    """
    quadratics = {each.base for each in exact.fractions_of(image, x) if each.slope is not None}
    count = sum(each.order for each in poles)
    if image.shape != (1, 1) or len(quadratics) > 1 or not poles or count + len(quadratics) < 2:
        return {}
    if quadratics and exact.compared(image, x) is None:
        return {}
    numbers = iter(range(1, count + 1))
    return {each.pole: [f"c_{{{next(numbers)}}}" for _ in range(each.order)][::-1] for each in poles}


def _form(image: exact.RationalMatrix, poles: Sequence[exact.Covered], names: dict[Any, list[str]], x: Symbol) -> Step:
    """The sum with letters for the coefficients, which are sought."""
    terms = [(name, power(x - each.pole, j)) for each in poles for j, name in enumerate(reversed(names[each.pole]), 1)]
    quadratic = next((each.base for each in exact.fractions_of(image, x) if each.slope is not None), None)
    return Step("form", detail="tutor", unclaimed="its coefficients are found below", terms=terms, quadratic=quadratic,
                x=x, simple=any(each.order == 1 for each in poles),
                repeated=any(each.order > 1 for each in poles))  # fmt: skip


def _put_together(image: exact.RationalMatrix, x: Symbol) -> Step:
    """The partial fractions over their common denominator again, where no way to the coefficients is shown."""
    numerator, fractions = exact.put_together(image, x)
    terms = [product(below, entry_alone(each.numerator)) for below, each in fractions]
    claim = Claim(total(*terms), entry_alone(numerator), "over the common denominator")
    return Step("put_together", detail="tutor", claims={"numerator": claim}, x=x)


def _covered_up(poles: list[exact.Covered], x: Symbol, names: Sequence[str]) -> Step:
    claims: dict[str, Claim] = {}
    for i, each in enumerate(poles, 1):
        at, numbers = _values(each.functions[0], x, each.pole)
        claims |= _worked_out(str(i), at, numbers, each.coefficients[0])
    absent = any(len(each.functions[0]) > 1 and 0 in each.functions[0].flat() for each in poles)
    return Step("covered_up", detail="tutor", claims=claims, count=len(poles), absent=absent, names=names)


def _values(function: ImmutableMatrix, x: Symbol, pole: Any) -> tuple[Any, Any]:
    """G at the pole, as stated and with the pole put in."""
    shown = entry_alone(function)
    apart = _over_one_denominator(shown, x)
    if apart is None:
        return value_at(shown, x, pole), put_in(shown, x, pole)
    above, below = apart
    numbers = product(quotient(sp.S.One, put_in(below, x, pole)), put_in(above, x, pole))
    return value_at(product(quotient(sp.S.One, below), above), x, pole), numbers


def _over_one_denominator(function: Any, x: Symbol) -> tuple[ImmutableMatrix, Any] | None:
    """Numerators and the denominator of a large matrix whose entries have the same one; else none."""
    if not isinstance(function, sp.MatrixBase) or len(function) <= SMALL:
        return None
    below = {_below(entry, x) for entry in entries(function) if entry != 0}
    if len(below) != 1 or below == {1}:
        return None
    (denominator,) = below
    above = [
        sp.Mul(*(each for each in sp.Mul.make_args(entry) if not _is_below(each, x))) for entry in entries(function)
    ]
    return sp.ImmutableMatrix(*function.shape, above), denominator


def _below(entry: Any, x: Symbol) -> Any:
    return sp.Mul(*(1 / each for each in sp.Mul.make_args(entry) if _is_below(each, x)))


def _is_below(factor: Any, x: Symbol) -> bool:
    return bool(factor.is_Pow and factor.exp.is_negative and factor.base.has(x))


def _worked_out(number: str, at: Any, numbers: Any, value: ImmutableMatrix) -> dict[str, Claim]:
    """The value at a pole: with the pole put in, and worked out where that is not the same."""
    found = entry_alone(value)
    if len(value) > LARGE:
        return {f"at{number}": Claim(at, found, "pole put in")}
    claims = {f"at{number}": Claim(at, numbers, "pole put in")}
    return claims if numbers == found else {**claims, f"value{number}": Claim(numbers, found, "worked out")}


def _repeated(found: exact.Covered, x: Symbol, names: Sequence[str]) -> Step:
    claims: dict[str, Claim] = {}
    for i, (function, value) in enumerate(zip(found.functions, found.coefficients, strict=True)):
        if i:
            before = entry_alone(found.functions[i - 1])
            claims[f"slope{i}"] = Claim(derivative(before, x), entry_alone(function), "derivative")
            if not function.has(x) and i == 1:
                continue  # the derivative is the value
        at, numbers = _values(function, x, found.pole)
        if i > 1:
            weight = quotient(sp.S.One, sp.factorial(i))
            at, numbers = product(weight, at), product(weight, numbers)
        claims |= _worked_out(str(i), at, numbers, value)
    return Step(
        "repeated",
        detail="tutor",
        claims=claims,
        x=x,
        pole=found.pole,
        factor=power(x - found.pole, found.order),
        order=found.order,
        names=names,
    )


def _at_the_upper_root(found: exact.AtUpperRoot, x: Symbol) -> Step:
    fraction = found.fraction
    root = fraction.root
    beta, gamma = entry_alone(fraction.slope), entry_alone(fraction.constant)
    at, numbers = _values(found.function, x, root.value)
    real, imaginary = _parts(found.value)
    of_gamma = total(real, product(-root.sigma, beta)) if root.sigma != 0 else real
    of_beta = imaginary if root.shift == 1 else quotient(imaginary, root.shift)
    return Step(
        "at_the_upper_root",
        detail="tutor",
        claims={
            **_worked_out("", at, numbers, found.value),
            "slope": Claim(of_beta, beta, "imaginary parts compared"),
            "constant": Claim(of_gamma, gamma, "real parts compared"),
        },
        x=x,
        p=fraction.base,
        root=root.value,
        sigma=root.sigma,
        omega=root.shift,
        value=entry_alone(found.value),
    )


def _parts(matrix: ImmutableMatrix) -> tuple[Any, Any]:
    """Real and imaginary parts of the entries."""
    parts = [exact.complex_parts(entry) for entry in matrix.flat()]
    real, imaginary = (sp.ImmutableMatrix(*matrix.shape, list(each)) for each in zip(*parts, strict=True))
    return entry_alone(real), entry_alone(imaginary)


def _compared(found: exact.Compared, x: Symbol) -> Step:
    beta, gamma = entry_alone(found.fraction.slope), entry_alone(found.fraction.constant)
    (first, first_shares, _), (second, second_shares, of_beta) = found.equations
    known = [(c, entry_alone(R)) for R, c in found.others]
    return Step(
        "compared",
        detail="tutor",
        claims={
            "slope": Claim(_less(first, first_shares), beta, "coefficients compared"),
            "constant": Claim(_less(second, [*second_shares, (beta, of_beta)]), gamma, "coefficients compared"),
        },
        numerator=entry_alone(found.numerator),
        known=total(*(product(c, R) for c, R in known)),
        equations=[
            (entry_alone(whole), total(*(product(c, entry_alone(R)) for R, c in shares)) if shares else None, taken)
            for whole, shares, taken in found.equations
        ],
        cofactor=found.cofactor,
        degree=found.degree,
        x=x,
    )


def _less(whole: ImmutableMatrix, shares: Sequence[tuple[Any, Any]]) -> Any:
    """A coefficient of the whole less what the known parts give to it."""
    terms = [entry_alone(whole)] if any(entries(whole)) else []
    terms += [_times(-c, entry_alone(R)) for R, c in shares if c != 0]
    return total(*terms) if len(terms) > 1 else terms[0] if terms else entry_alone(whole)


def _times(c: Any, R: Any) -> Any:
    """The product as it stands; of a scalar and one there is none."""
    return c * R if isinstance(R, sp.Expr) and (R == 1 or abs(c) == 1) else product(c, R)
