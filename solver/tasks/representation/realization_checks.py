"""What a realization must be: the form by inspection, det(xI − A), and the transfer function at random points."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Check, Claim, Given, Options
from solver.lazy import numeric, systems
from solver.lazy import sympy as sp
from solver.numeric.judges import linear_algebra, representation
from solver.stated.algebra import difference, product, quotient, total
from solver.stated.matrices import determinant
from solver.tasks.representation.plants import stated_matrix, stated_transfer, variable_of
from solver.words import Phrase

if TYPE_CHECKING:
    from solver.tasks.needed import InputOutput
    from solver.tasks.representation.realization import RealizationOptions


def realization_checks(given: Given[InputOutput, RealizationOptions], answers: Answers) -> Iterable[Check]:
    """The checks of A, B, C, D, together or alone."""
    outputs, inputs = shape_of(given.system)
    misfit = list(_misfits(answers, outputs, inputs))
    if misfit:
        yield from misfit
        return
    if "D" in answers:
        claim = Claim(answers["D"], at_infinity(given.system))
        yield numeric.check_claim(claim, r"$D = G(\infty)$", answer="D")
    if "A" in answers:
        yield Check.that(_form_in_words(given), "inspection", _has_form(given, answers), answer="A")
    if (outputs, inputs) == (1, 1):
        yield from _single_channel(given, answers)
    if {"A", "B", "C"} <= answers.keys():
        yield same_transfer(given, answers)
    else:
        yield from _alone(given, answers, siso=(outputs, inputs) == (1, 1))


def same_transfer(given: Given[InputOutput, Options], answers: Answers) -> Check:
    """C (xI − A)⁻¹ B + D = G at random points; without D, that of the problem."""
    x = variable_of(given.system)
    D = answers.get("D", at_infinity(given.system))
    A, B, C = (sp.ImmutableMatrix(answers[name]) for name in "ABC")
    found = systems.StateSpace(A, B, C, sp.ImmutableMatrix(D), discrete=given.system.discrete)
    label = Phrase("$C({x}I - A)^{{-1}}B + D = G({x})$ at random points", x=x)
    return numeric.check_claim(Claim(stated_transfer(found, x), stated_matrix(given.system)), label)


def shape_of(system: Any) -> tuple[int, int]:
    """Numbers of outputs and inputs."""
    if isinstance(system, systems.TransferFunction):
        return system.matrix.rows, system.matrix.cols
    return system.C.rows, system.B.cols


def at_infinity(system: Any) -> Any:
    """G(∞) as the problem states it: D, or the quotients of leading coefficients."""
    outputs, inputs = shape_of(system)
    if not isinstance(system, systems.TransferFunction):
        return system.D if system.D is not None else sp.ImmutableMatrix(sp.zeros(outputs, inputs))
    x = system.variable

    def limit(p: Any, q: Any) -> Any:
        top, bottom = sp.Poly(p, x), sp.Poly(q, x)
        return top.LC() / bottom.LC() if top.degree() == bottom.degree() else sp.Integer(0)

    pairs = zip(system.numerators, system.denominators, strict=True)
    return sp.ImmutableMatrix([[limit(p, q) for p, q in zip(*row, strict=True)] for row in pairs])


def _misfits(answers: Answers, outputs: int, inputs: int) -> Iterator[Check]:
    """Failed checks of matrices whose shapes fit neither the plant nor each other."""
    order = next((answers[name].shape[side] for name, side in (("A", 0), ("B", 0), ("C", 1)) if name in answers), 0)
    wanted = {"A": (order, order), "B": (order, inputs), "C": (outputs, order), "D": (outputs, inputs)}
    for name, (rows, columns) in wanted.items():
        if name in answers and answers[name].shape != (rows, columns):
            label = Phrase("${name}$ is {rows}×{columns}", name=name, rows=rows, columns=columns)
            yield Check.that(label, "inspection", False, answer=name)


def _form_in_words(given: Given[InputOutput, RealizationOptions]) -> str:
    first = given.options.convention == "first_row"
    above = given.options.convention == "superdiagonal"
    if shape_of(given.system) != (1, 1) and given.options.form in ("controllable", "observable"):
        rows = "columns" if given.options.form == "observable" else "rows"
        return Phrase("$A$ has companion blocks: all {lines} but one a channel pass on a state", lines=rows)
    place = "first" if first else "last"
    return {
        "controllable": Phrase("$A$ is a companion matrix, coefficients in the {place} row", place=place),
        "observable": Phrase("$A$ is a companion matrix, coefficients in the {place} column", place=place),
        "diagonal": "$A$ is diagonal",
        "jordan": Phrase("$A$ is in Jordan form, ones {side} the diagonal", side="above" if above else "below"),
        "modal": "$A$ has real blocks of order one and two, and chains of them",
    }[given.options.form]


def _has_form(given: Given[InputOutput, RealizationOptions], answers: Answers) -> bool:
    A = answers["A"]
    form, first, above = (
        given.options.form,
        given.options.convention == "first_row",
        given.options.convention == "superdiagonal",
    )
    if form == "diagonal":
        return bool(representation.is_diagonal(A))
    if form in ("jordan", "modal"):
        return bool(representation.is_chain_form(A, above=above, real=form == "modal"))
    if shape_of(given.system) != (1, 1):
        outputs, inputs = shape_of(given.system)
        if form == "observable":
            C = answers.get("C")
            return bool(representation.has_companion_blocks(A.T, C.T if C is not None else None, outputs))
        return bool(representation.has_companion_blocks(A, answers.get("B"), inputs))
    return bool(representation.is_companion(A, transposed=form == "observable", first=first))


def _denominator(system: Any) -> Any:
    """The monic denominator of the only channel, not cancelled: as typed, or det(xI − A)."""
    x = variable_of(system)
    if isinstance(system, systems.TransferFunction):
        q = system.denominators[0][0]
        return q / sp.Poly(q, x).LC()
    return determinant(difference(product(x, sp.ImmutableMatrix(sp.eye(system.order))), system.A))


def order_of(system: Any) -> int:
    """The degree of the denominator of the only channel."""
    if isinstance(system, systems.TransferFunction):
        return int(sp.Poly(system.denominators[0][0], system.variable).degree())
    return int(system.order)


def _single_channel(given: Given[InputOutput, RealizationOptions], answers: Answers) -> Iterator[Check]:
    """What one input and one output fix: the order, det(xI − A), and in companion form B and C too."""
    system, x, n = given.system, variable_of(given.system), order_of(given.system)
    for name, side in (("A", 0), ("B", 0), ("C", 1)):
        if name in answers and answers[name].shape[side] != n:
            yield Check.that(
                Phrase("the order is {n}, that of the denominator as given", n=n), "inspection", False, answer=name
            )
            return
    if "A" in answers:
        A = answers["A"]
        yield numeric.check_residual(
            Phrase("$\\det({x}I - A)$ is the denominator", x=x),
            "numpy.linalg.det",
            lambda: linear_algebra.polynomial_residual(A, _denominator(system), x),
            answer="A",
        )
    form = given.options.form
    if form not in ("controllable", "observable"):
        return
    first = given.options.convention == "first_row"
    unit, coefficients = ("B", "C") if form == "controllable" else ("C", "B")
    if unit in answers:
        place = 0 if first else n - 1
        word = "first" if first else "last"
        label = Phrase("${unit}$ has a one at the {place} place, else zeros", unit=unit, place=word)
        yield Check.that(label, "inspection", representation.is_unit_vector(answers[unit], place), answer=unit)
    if coefficients in answers:
        listed = list(answers[coefficients])
        rising = listed[::-1] if first else listed
        top = total(*(product(c, x**k) for k, c in enumerate(rising)))
        claim = Claim(total(quotient(top, _denominator(system)), at_infinity(system)), stated_matrix(system))
        label = Phrase("${coefficients}$ holds the coefficients of the numerator", coefficients=coefficients)
        yield numeric.check_claim(claim, label, answer=coefficients)


def _alone(given: Given[InputOutput, RealizationOptions], answers: Answers, *, siso: bool) -> Iterator[Check]:
    """B and C without the others, where states may be scaled: what can be said of them."""
    if siso and given.options.form in ("controllable", "observable"):
        return
    for name in ("B", "C"):
        if name not in answers:
            continue
        label = Phrase("${name}$ belongs to a realization of the form", name=name)
        if answers[name].is_zero_matrix and not stated_is_zero(given.system):
            yield Check.that(label, "inspection", False, answer=name)
        else:
            free = "the states may be scaled and ordered freely, so {name} is judged with A, B and C together"
            reason = Phrase(free, name=name)
            yield Check.skipped(label, "inspection", reason, answer=name)
    if not siso and "A" in answers:
        together = "with several inputs or outputs the order is free, so A is judged with B and C"
        yield Check.skipped("$A$ has the poles of $G$", "inspection", together, answer="A")


def stated_is_zero(system: Any) -> bool:
    """Whether the path from inputs to outputs is just D."""
    if isinstance(system, systems.TransferFunction):
        return bool(system.matrix == at_infinity(system))
    return bool(system.B.is_zero_matrix or system.C.is_zero_matrix)
