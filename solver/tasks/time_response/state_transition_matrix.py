"""The state transition matrix Φ(t) = e^{At}, in discrete time Φ(k) = Aᵏ."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.arithmetic.beginnings import begun_right
from solver.arithmetic.combinations import combined, multiplied_out
from solver.arithmetic.equations import eliminated
from solver.arithmetic.inverses import inverted as inverse_worked_out
from solver.arithmetic.transformed import term_by_term
from solver.derivation import (
    AnswerName,
    Answers,
    Attempt,
    Check,
    Claim,
    Derivation,
    Given,
    Step,
    Task,
    option,
)
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import time_response as judges
from solver.options.choice import Choice
from solver.options.integer import Integer
from solver.stated import Stated
from solver.stated.algebra import power, product, total
from solver.stated.calculus import derivative, value_at
from solver.stated.matrices import inverse
from solver.stated.transforms import inverse_laplace, inverse_z
from solver.tasks import meanings, mistakes
from solver.tasks.linear_algebra.eigenstructure import eigenvalues_of, left_eigenvectors_of, right_eigenvectors_of
from solver.tasks.linear_algebra.resolvent import inverse_of_pencil, partial_fractions_of, transform_pairs_of
from solver.tasks.plant_options import PlantOptions
from solver.words import Phrase, Reason

if TYPE_CHECKING:
    from sympy import ImmutableMatrix, Symbol

    from solver.systems import StateSpace


@dataclass(frozen=True, kw_only=True)
class StateTransitionMatrixOptions(PlantOptions):
    """How the series and the eigenvectors are written."""

    terms: int = option(
        Integer(1, 12), "number of terms of the series, counting I as the first", default=3, methods=("power_series",)
    )
    convention: str = option(
        Choice(("right", "left")),
        "right: V e^{Jt} V⁻¹ with right eigenvectors as columns; left: M⁻¹ e^{Jt} M with left eigenvectors as rows",
        methods=("modal",),
    )


state_transition_matrix: Task[StateSpace, StateTransitionMatrixOptions] = Task(
    "state_transition_matrix",
    title="State transition matrix",
    doc="Φ(t) = e^{At}, which takes x(0) to x(t) when the input is zero; in discrete time Φ(k) = Aᵏ.",
    needs=("A",),
    options=StateTransitionMatrixOptions,
    complex_entries=True,
    answers=[
        AnswerName(
            "Phi",
            r"\Phi",
            "the state transition matrix in closed form",
            principal=True,
            earned=("inverse", "partial_fractions", "coefficients", "modes", "series"),
        ),
        AnswerName("Phi_truncated", r"\Phi_{\text{truncated}}", "the first terms of the series", ("power_series",)),
    ],
)


@state_transition_matrix.method(
    "laplace", title="Inverse Laplace transform", source="Lecture note, section 1.13", time="continuous"
)
def by_laplace(given: Given[StateSpace, StateTransitionMatrixOptions]) -> Derivation[Answers]:
    """Φ(t) = ℒ⁻¹{(sI − A)⁻¹}, the inverse by adjugate over determinant, transformed by partial fractions."""
    A, s, t = given.system.A, sp.Symbol("s"), sp.Symbol("t")
    yield from inverse_of_pencil(A, s)
    expansion = yield from partial_fractions_of(A, s)
    yield from transform_pairs_of(A, s, t, discrete=False)
    Phi = exact.exponential(A, t).matrix
    claim = Claim(inverse_laplace(expansion, s, t), Phi, "inverse Laplace transform of the partial fractions")
    worked_out = term_by_term(exact.resolvent_matrix(A), s, t, Phi, discrete=False)
    yield Step("inverse_transform", claims={"Phi": claim}, steps=(*worked_out, *begun_right(Phi, A, t, discrete=False)))
    return Answers(Phi=Phi)


@state_transition_matrix.method(
    "z_transform", title="Inverse z-transform", source="Lecture note, section 7.5", time="discrete"
)
def by_z_transform(given: Given[StateSpace, StateTransitionMatrixOptions]) -> Derivation[Answers]:
    """Φ(k) = 𝒵⁻¹{z (zI − A)⁻¹}, by partial fractions of (zI − A)⁻¹."""
    A, z, k = given.system.A, sp.Symbol("z"), sp.Symbol("k")
    yield from inverse_of_pencil(A, z)
    expansion = yield from partial_fractions_of(A, z)
    yield from transform_pairs_of(A, z, k, discrete=True)
    Phi = exact.power(A, k).matrix
    claim = Claim(inverse_z(product(z, expansion), z, k), Phi, "inverse z-transform of the partial fractions")
    worked_out = term_by_term(exact.resolvent_matrix(A), z, k, Phi, discrete=True)
    yield Step("inverse_transform", claims={"Phi": claim}, steps=(*worked_out, *begun_right(Phi, A, k, discrete=True)))
    return Answers(Phi=Phi)


@state_transition_matrix.method(
    "power_series", title="Power series", source="Lecture note, equation (1.13.5)", time="continuous"
)
def by_power_series(given: Given[StateSpace, StateTransitionMatrixOptions]) -> Derivation[Answers]:
    """Φ(t) = Σ Aⁱtⁱ/i!, truncated, and recognised as the expansion of the closed form."""
    A, t, terms = given.system.A, sp.Symbol("t"), given.options.terms
    powers = exact.powers(A, terms)
    yield Step(
        "powers",
        claims={f"power{i}": Claim(power(A, i), powers[i], f"$A^{i}$") for i in range(2, terms)},
        unclaimed="" if terms > 2 else "no power beyond A is needed",
        A=A,
        terms=terms,
    )
    truncated = exact.truncated_series(A, t, terms)
    series = total(*(product(t**i / sp.factorial(i), M) for i, M in enumerate(powers)))
    yield Step(
        "series",
        claims={"sum": Claim(series, truncated, Phrase("sum of the first {terms} terms", terms=terms))},
        terms=terms,
    )
    Phi = exact.exponential(A, t)
    yield Step(
        "recognition",
        claims={
            f"derivative{i}": Claim(
                value_at(derivative(Phi.matrix, t, i), t, sp.Integer(0)),
                powers[i],
                Phrase("derivative {i} at $t = 0$", i=i),
            )
            for i in range(terms)
        },
        expansions=[(function, total(*exact.taylor(function, t, terms))) for function in Phi.functions],
        Phi=Phi.matrix,
        terms=terms,
    )
    return Answers(Phi=Phi.matrix, Phi_truncated=truncated)


@state_transition_matrix.method("cayley_hamilton", title="Cayley–Hamilton theorem", source="Lecture note, section 1.13")
def by_cayley_hamilton(given: Given[StateSpace, StateTransitionMatrixOptions]) -> Derivation[Answers]:
    """Φ = Σᵢ αᵢ Aⁱ, i < n, with αᵢ fixed by e^{λt} = Σᵢ αᵢ λⁱ (λᵏ) and its λ-derivatives at repeated λ."""
    A, n, discrete = given.system.A, given.system.order, given.system.discrete
    x = _time(given)
    spectrum = yield from eigenvalues_of(A)
    conditions = exact.interpolation(spectrum, x, discrete=discrete)
    unknowns = sp.symbols(f"alpha_:{n}")
    polynomial = total(*(product(a, power(sp.Symbol("A"), i)) for i, a in enumerate(unknowns)))
    yield Step(
        "conditions",
        unclaimed="the conditions define the coefficients; they are checked when these are found",
        equations=[(condition.right, _dot(condition.row, unknowns)) for condition in conditions],
        roots=spectrum.roots,
        polynomial=polynomial,
        n=n,
        discrete=discrete,
    )
    alpha = exact.interpolation_coefficients(A, x, discrete=discrete)
    satisfied = {
        f"condition{i}": Claim(
            _dot(condition.row, alpha), condition.right, Phrase("condition {i} for the coefficients", i=i)
        )
        for i, condition in enumerate(conditions, 1)
    }
    equations = [(sp.Matrix([each.row]).dot(unknowns), each.right) for each in conditions]
    yield Step("coefficients", claims=satisfied, steps=eliminated(equations, unknowns, alpha), alpha=alpha, n=n)
    Phi = _matrix_function(given)
    combination = _dot(alpha, exact.powers(A, n))
    yield Step(
        "assemble",
        claims={"Phi": Claim(combination, Phi, "sum of the powers of $A$")},
        steps=(*combined(A, unknowns, alpha, Phi), *begun_right(Phi, A, x, discrete=discrete)),
        polynomial=polynomial,
        discrete=discrete,
    )
    return Answers(Phi=Phi)


def _dot(coefficients: Sequence[Any], terms: Sequence[Any]) -> Stated:
    """Σ cᵢ Tᵢ as written; terms with the coefficient zero are left out."""
    return total(*(product(c, term) for c, term in zip(coefficients, terms, strict=True) if c != 0))


def _time(given: Given[StateSpace, StateTransitionMatrixOptions]) -> Symbol:
    """The variable of time: t, or k in discrete time."""
    return sp.Symbol("k" if given.system.discrete else "t")


def _matrix_function(given: Given[StateSpace, StateTransitionMatrixOptions]) -> ImmutableMatrix:
    """e^{At}, or Aᵏ in discrete time, in closed form (n×n)."""
    compute = exact.power if given.system.discrete else exact.exponential
    Phi: ImmutableMatrix = compute(given.system.A, _time(given)).matrix
    return Phi


@state_transition_matrix.method("modal", title="Modal matrix", source="Lecture note, section 1.13")
def by_modal_matrix(given: Given[StateSpace, StateTransitionMatrixOptions]) -> Derivation[Answers]:
    """Φ = V e^{Jt} V⁻¹ (rows of left eigenvectors: M⁻¹ e^{Jt} M), with J diagonal where the eigenvectors are enough."""
    A, discrete, left = given.system.A, given.system.discrete, given.options.convention == "left"
    x = _time(given)
    yield from eigenvalues_of(A)
    if left:
        structure = exact.eigenstructure(A)
        modal = yield from left_eigenvectors_of(A, structure)
    else:
        structure = yield from right_eigenvectors_of(A)
        modal = structure.right
    inverted = structure.left_inverse if left else structure.right_inverse
    J, diagonal = structure.jordan_form, structure.diagonalizable
    yield Step(
        "inverse",
        claims={"inverse": Claim(inverse(modal), inverted, "inverse of the modal matrix")},
        steps=inverse_worked_out("M" if left else "V", modal, inverted),
        modal=modal,
        left=left,
        n=given.system.order,
        diagonal=diagonal,
    )
    modes = exact.power_of_blocks(structure, x) if discrete else exact.exponential_of_blocks(structure, x)
    similar = Claim(product(modal, A), product(J, modal)) if left else Claim(product(A, modal), product(modal, J))
    yield Step(
        "modes",
        claims={} if diagonal else {"similar": similar},
        unclaimed="a function of a diagonal matrix acts on the diagonal entries, by definition" if diagonal else "",
        modes=modes,
        J=J,
        diagonal=diagonal,
        left=left,
        discrete=discrete,
    )
    Phi = _matrix_function(given)
    factors = (inverted, modes, modal) if left else (modal, modes, inverted)
    yield Step(
        "assemble",
        claims={"Phi": Claim(product(*factors), Phi, "product of the three matrices")},
        steps=(*multiplied_out(factors, Phi), *begun_right(Phi, A, x, discrete=discrete)),
        left=left,
        diagonal=diagonal,
        discrete=discrete,
        complex=any(root.kind == "complex" for root in structure.spectrum.roots),
    )
    return Answers(Phi=Phi)


@state_transition_matrix.verification("Phi")
def is_the_matrix_function(given: Given[StateSpace, StateTransitionMatrixOptions], answers: Answers) -> Iterable[Check]:
    """Φ(t) = expm(A t) at several t including 0 (scipy); discrete: Φ(k) = Aᵏ for k = 0 … 8 (numpy)."""
    A, Phi = given.system.A, answers["Phi"]
    if given.system.discrete:
        yield numeric.check_residual(
            r"$\Phi(k) = A^k$ for $k = 0, 1, \ldots, 8$",
            "numpy.linalg.matrix_power",
            lambda: judges.power_residual(A, Phi, sp.Symbol("k")),
        )
        return
    yield numeric.check_residual(
        r"$\Phi(t) = e^{At}$ at several $t$, $\Phi(0) = I$",
        "scipy.linalg.expm",
        lambda: judges.exponential_residual(A, Phi, sp.Symbol("t")),
    )


@state_transition_matrix.verification("Phi_truncated")
def has_the_first_terms(given: Given[StateSpace, StateTransitionMatrixOptions], answers: Answers) -> Iterable[Check]:
    """The derivatives at t = 0 are the powers of A, and the one after the last term is zero."""
    A, truncated, t, terms = given.system.A, answers["Phi_truncated"], sp.Symbol("t"), given.options.terms
    for i in range(terms + 1):
        coefficient = value_at(derivative(truncated, t, i), t, sp.Integer(0))
        expected = power(A, i) if i < terms else sp.ImmutableMatrix(sp.zeros(A.rows))
        says = Phrase("coefficient of $t^{{{i}}}$ is $A^{{{i}}}/{i}!$", i=i) if i < terms else "no further terms"
        yield numeric.check_claim(Claim(coefficient, expected), says)


@state_transition_matrix.mistake(mistakes.ENTRY_BY_ENTRY, "Phi")
def entry_by_entry(wrong: Attempt[StateSpace, StateTransitionMatrixOptions]) -> Iterable[Any]:
    """The exponential function of each entry."""
    if not wrong.given.system.discrete:
        t = sp.Symbol("t")
        yield sp.ImmutableMatrix(wrong.given.system.A.applyfunc(lambda entry: sp.exp(entry * t)))


@state_transition_matrix.meaning("Phi")
def how_it_begins(wrong: Attempt[StateSpace, StateTransitionMatrixOptions]) -> Reason | None:
    """Its value at 0, and how it goes on from there."""
    plant = wrong.given.system
    return meanings.begins(wrong.value, plant.A, discrete=plant.discrete)
