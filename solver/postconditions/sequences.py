"""z-transforms taken apart: what begins at which sample, images by delays, long division, recursions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import sympy as sp

from solver.derivation import Check, Claim
from solver.postconditions.transforms import _of_image


def of_sequence_image(found: Any, F: Any, z: Any) -> Iterator[Claim | Check]:
    """F, and F/z; whether the sequence begins before k = 0."""
    yield Claim(found.whole, F)
    yield Claim(found.divided.whole, F / z)
    for each in (found.fraction, found.divided):
        yield from _of_image(each, z)
    above, below = sp.fraction(sp.together(found.whole))
    early = sp.degree(sp.expand(above), z) > sp.degree(sp.expand(below), z)
    yield Check.that("where the sequence begins", "counted", found.advanced == bool(early))


def of_read_sequence_image(found: Sequence[Any], F: Any, z: Any) -> Iterator[Claim | Check]:
    """The terms with their delays add up to F, the earliest first."""
    yield Claim(sp.Add(*(each.image.whole * z**-each.delay for each in found)), F)
    delays = [each.delay for each in found]
    yield Check.that("delays in order", "compared", delays == sorted(set(delays)))
    for each in found:
        yield from of_sequence_image(each.image, each.image.whole, z)


def of_is_in_inverse_powers(found: bool, F: Any, z: Any) -> Iterator[Check]:
    """Whether a denominator that is a sum holds a power of 1/z."""
    below = [each.base for each in F.atoms(sp.Pow) if each.exp.is_negative and each.base.is_Add]
    told = any(not sp.expand(each).is_polynomial(z) for each in below)
    yield Check.that("powers of 1/z", "compared", bool(found) == told)


def of_long_division(found: Any, image: Any, z: Any, terms: int) -> Iterator[Claim | Check]:
    """The quotient and the last remainder over the divisor are the image; each row is what the one before leaves."""
    divisor = _in_powers(found.divisor, z)
    left = _in_powers(found.dividend, z)
    yield Claim(left / divisor, image.whole)
    yield Check.that("as many values as asked for", "counted", len(found.values) == terms)
    read = [sp.S.Zero] * terms
    for row in found.rows:
        yield Claim(row.coefficient * z**-row.step * divisor, _in_powers(row.taken, z))
        yield Claim(left - _in_powers(row.taken, z), _in_powers(row.rest, z))
        left = _in_powers(row.rest, z)
        if 0 <= row.step < terms:
            read[row.step] = row.coefficient
    yield from (Claim(value, told) for value, told in zip(found.values, read, strict=False))


def _in_powers(coefficients: Mapping[int, Any], z: Any) -> Any:
    return sp.Add(*(c * z**n for n, c in coefficients.items()))


def of_polar_pairs(found: Sequence[Any], image: Any) -> Iterator[Claim | Check]:
    """r e^{jθ} of each pair of poles, the upper one."""
    roots = [root for each, _ in image.poles for root in each.factor.roots]
    unreal = [each for each in roots if each.kind in ("complex", "decimal") and each.shift != 0]
    yield Check.that("a polar form for each pair", "counted", 2 * len(found) == len(unreal))
    for root, r, theta in found:
        yield Claim(r * sp.cos(theta), root.sigma)
        yield Claim(r * sp.sin(theta), root.shift)


def of_sequence_pieces(found: Sequence[Any], f: Any, k: Any) -> Iterator[Claim]:
    """What has begun by a sample adds up to its value; the same in the time since the start; its terms."""
    last = int(max((each.delay for each in found), default=sp.S.Zero))
    for at in range(last + 3):
        yield Claim(_begun(found, k, at), _value(f, k, at))
    for each in found:
        terms = sp.Add(*(term.factor * term.function(k) for term in each.terms))
        yield Claim(terms, each.moved)
        for at in range(3):
            yield Claim(each.moved.subs(k, at), each.function.subs(k, each.delay + at))


def _begun(pieces: Sequence[Any], k: Any, at: int) -> Any:
    smooth = [each.function.subs(k, at) for each in pieces if each.delay <= at]
    return sp.Add(*smooth, *(each.impulse for each in pieces if each.delay == at))


def _value(f: Any, k: Any, at: int) -> Any:
    """The value of a sequence, steps being one at their start."""
    steps = f.replace(sp.Heaviside, lambda x, *_: sp.Integer(int(bool(x.subs(k, at) >= 0))))
    return steps.replace(sp.DiracDelta, lambda x: sp.Integer(int(bool(x.subs(k, at) == 0)))).subs(k, at)


def of_value_of_pieces(found: Any, pieces: Sequence[Any], k: Any, at: int) -> Iterator[Claim]:
    """The pieces that have begun, added."""
    yield Claim(found, _begun(pieces, k, at))


def of_sequence_transform(found: Any, pieces: Sequence[Any], k: Any, z: Any) -> Iterator[Claim]:
    """The images of the pieces with their delays, added."""
    yield Claim(found, sp.Add(*(each.image(k, z) * z**-each.delay for each in pieces)))


def of_moved_image(found: Any, delay: Any, image: Any, z: Any) -> Iterator[Claim]:
    """The image times z⁻ⁿ."""
    yield Claim(found, image * z**-delay)


def of_radius_of(found: Any, pieces: Sequence[Any]) -> Iterator[Check]:
    """No term grows faster, and one as fast."""
    sizes = [sp.Abs(term.growth) for each in pieces for term in each.terms]
    yield Check.that("where the series converges", "compared", (found is None) == (not sizes))
    if sizes:
        yield Check.that("where the series converges", "compared", found == sp.Max(*sizes))


def of_finite_values(found: Any, f: Any, k: Any) -> Iterator[Claim | Check]:
    """The values, after which there are zeros only."""
    if found is not None:
        yield from (Claim(value, _value(f, k, at)) for at, value in enumerate(found))
        rest = [sp.expand(_value(f, k, len(found) + at)) for at in range(4)]
        yield Check.that("a sequence that ends", "compared", not any(rest))


def of_terms_of_samples(found: Sequence[Any], image: Any) -> Iterator[Claim]:
    """Their sum is the sequence of the samples."""
    k = sp.Symbol("k")
    yield Claim(sp.Add(*(each.factor * each.function(k) for each in found)), image.sequence(k))


def of_sample_operators_of(
    found: Any, equations: Sequence[Any], jets: Mapping[Any, Any], unknowns: Any, inputs: Any, k: Any
) -> Iterator[Claim | Check]:
    """Each row is its equation."""
    told = found.unknowns == tuple(unknowns) and found.inputs == tuple(inputs)
    yield Check.that("unknowns and inputs", "compared", told)
    symbols = {jet: symbol for symbol, jet in jets.items()}
    for row, equation in zip(found.rows, equations, strict=True):
        left = sp.Add(*(c * symbols[jet] for jet, c in row.unknowns.items()))
        right = sp.Add(*(c * symbols[jet] for jet, c in row.inputs.items()), row.rest)
        yield Claim(left - right, equation.xreplace({x: k for x in equation.free_symbols if str(x) == str(k)}))


def of_cleared_adjugate(found: Any, operators: Any, z: Any) -> Iterator[Claim]:
    """adj P times P is det P times the identity."""
    adjugate, whole, powers = found
    P = operators.matrix(z)
    cleared = sp.Matrix(P.rows, P.cols, lambda i, j: sp.expand(P[i, j] * z ** powers[i]))
    yield Claim(sp.ImmutableMatrix(adjugate * cleared), sp.ImmutableMatrix(whole * sp.eye(P.rows)))


def of_start_of_sample(found: Any, jet: Any, values: Mapping[Any, Any], z: Any) -> Iterator[Claim]:
    """By the series: zᵠ Σ y(m) z⁻ᵐ from k = 0 on against the one that begins at the sample q."""
    name, q = jet
    lost = (-values.get((name, m), 0) * z ** (q - m) for m in range(q))
    won = (values.get((name, m), 0) * z ** (q - m) for m in range(q, 0))
    yield Claim(found, sp.Add(*lost, *won))


def of_start_of(
    found: Any, operators: Any, z: Any, initial: Mapping[Any, Any], first: Mapping[Any, Any]
) -> Iterator[Claim]:
    """The same for each row, with its coefficients."""
    for side, row in zip(found, operators.rows, strict=True):
        terms = [-c * value for jet, c in row.unknowns.items() for value in _beside(jet, initial, z)]
        terms += [c * value for jet, c in row.inputs.items() if jet[1] > 0 for value in _beside(jet, first, z)]
        yield Claim(side, sp.Add(*terms))


def _beside(jet: Any, values: Mapping[Any, Any], z: Any) -> Iterator[Any]:
    name, q = jet
    for m in range(min(q, 0), max(q, 0)):
        yield (-1 if m >= 0 else 1) * values.get((name, m), sp.S.Zero) * z ** (q - m)


def of_window_of(found: Any, operators: Any, given: Mapping[Any, Any]) -> Iterator[Check]:
    """All values given are among those that the equations, moved so, begin with."""
    if found is not None:
        spans = operators.spans
        inside = all(spans[x][0] + found <= m < spans[x][1] + found for x, m in given)
        whole = found == 0 or len(given) == sum(high - low for low, high in spans.values())
        yield Check.that("the values to begin with", "compared", inside and whole)


def of_latest_samples(found: Sequence[Any], operators: Any) -> Iterator[Claim | Check]:
    """Put into the equations, they hold for any earlier samples."""
    tops = [(name, operators.spans[name][1]) for name in operators.unknowns]
    yield Check.that("the latest samples", "compared", [each.jet for each in found] == tops)
    marks: dict[Any, Any] = {}

    def mark(jet: Any) -> Any:
        return marks.setdefault(jet, sp.Dummy(f"{jet[0]}{jet[1]}", real=True))

    def combined(terms: Mapping[Any, Any]) -> Any:
        return sp.Add(*(c * mark(jet) for jet, c in terms.items()))

    solved = {mark(each.jet): combined(each.samples) + combined(each.inputs) + each.rest for each in found}
    for row in operators.rows:
        yield Claim(combined(row.unknowns).xreplace(solved), combined(row.inputs) + row.rest)


def of_run_through(
    found: Any, latest: Any, start: Any, input_at: Any, rest_at: Any, span: tuple[int, int]
) -> Iterator[Claim | Check]:
    """Each value is the sum of its products, with the values before it."""
    count = (span[1] - span[0]) * len(latest)
    yield Check.that("as many samples as asked for", "counted", len(found.steps) == max(count, 0))
    told = {*start, *(jet for jet, _, _ in found.steps)}
    yield Check.that("the samples known", "compared", set(found.values) == told)
    for jet, products, value in found.steps:
        yield Claim(sp.Add(*(c * x for c, x in products)), value)
        each = next(one for one in latest if one.jet[0] == jet[0])
        k = jet[1] - each.jet[1]
        terms = [c * found.values.get((x, k + q), sp.S.Zero) for (x, q), c in each.samples.items()]
        terms += [c * input_at(x, k + p) for (x, p), c in each.inputs.items()]
        yield Claim(sp.Add(*terms, rest_at(each.rest, k)), value)
        yield Claim(found.values[jet], value)
    yield from (Claim(found.values[jet], value) for jet, value in start.items())
