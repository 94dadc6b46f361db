"""Functions of a matrix: powers, inverse, exponential, square root, sine, … by Cayley–Hamilton or the modal matrix."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.arithmetic.combinations import combined, multiplied_out
from solver.arithmetic.equations import eliminated
from solver.arithmetic.inverses import inverted as inverse_worked_out
from solver.arithmetic.products import polynomial_of
from solver.derivation import (
    AnswerName,
    Answers,
    Attempt,
    Check,
    Claim,
    Derivation,
    Given,
    Refusal,
    Step,
    Task,
    option,
)
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import time_response as judges
from solver.options.expression import Expression
from solver.stated import Stated
from solver.stated.algebra import power, product, total
from solver.stated.matrices import inverse
from solver.tasks import mistakes
from solver.tasks.form_meanings import commutes
from solver.tasks.freedom import a_root_is_asked_for
from solver.tasks.linear_algebra.characteristic_polynomial import determinant_of
from solver.tasks.linear_algebra.eigenstructure import eigenvalues_of, right_eigenvectors_of
from solver.tasks.plant_options import PlantOptions
from solver.words import Phrase, Reason

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

    from solver.systems import StateSpace, System


@dataclass(frozen=True, kw_only=True)
class MatrixFunctionOptions(PlantOptions):
    """The function."""

    function: Expr = option(
        Expression(("A", "I", "t", "k")),
        'f(A) as an expression in A: "A^10", "inv(A)", "exp(A t)", "sqrt(A)", "A^k", "A^3 - 2A + I"',
        required=True,
    )


matrix_function: Task[StateSpace, MatrixFunctionOptions] = Task(
    "matrix_function",
    title="Function of a matrix",
    doc="f(A) for a function f that is analytic at the eigenvalues: a power, inverse, exponential, root, sine, …",
    needs=("A",),
    options=MatrixFunctionOptions,
    complex_entries=True,
    answers=[
        AnswerName(
            "F",
            "f(A)",
            "the function of the matrix",
            free=a_root_is_asked_for,
            earned=("coefficients", "remainder", "modes"),
        )
    ],
)


@matrix_function.refusal
def not_of_the_matrix(_: System, options: MatrixFunctionOptions) -> Iterable[Refusal]:
    """A function of other names alone."""
    if "function" not in options.later and not options.function.free_symbols & set(sp.symbols("A, I")):
        yield "function", Reason("functions/not_of_the_matrix")


def _asked(given: Given[StateSpace, MatrixFunctionOptions]) -> Expr:
    """Return f as an expression in the symbol A; I stands for the identity, which is one."""
    f: Expr = given.options.function.xreplace({sp.Symbol("I"): sp.Integer(1)})
    return f


def _scalar(f: Expr) -> Expr:
    """Return f with λ in place of A."""
    return f.xreplace({sp.Symbol("A"): sp.Symbol("lamda")})


@matrix_function.method("cayley_hamilton", title="Cayley–Hamilton theorem", source="Lecture note, section 1.13")
def by_cayley_hamilton(given: Given[StateSpace, MatrixFunctionOptions]) -> Derivation[Answers]:
    """f(A) = Σ αᵢ Aⁱ, i < n, with αᵢ fixed by f(λ) = Σ αᵢ λⁱ and its λ-derivatives at repeated λ."""
    A, f = given.system.A, _asked(given)
    scalar = exact.ScalarFunction(f, sp.Symbol("A"))
    if not exact.asks_for_roots(A, scalar):
        answers = yield from _by_the_remainder(A, scalar)
        return answers
    spectrum = yield from eigenvalues_of(A)
    found = exact.matrix_function(A, scalar)
    m = len(found.coefficients)
    unknowns = sp.symbols(f"alpha_:{m}")
    polynomial = total(*(product(a, power(sp.Symbol("A"), i)) for i, a in enumerate(unknowns)))
    yield Step(
        "conditions",
        unclaimed="the conditions define the coefficients; they are checked when these are found",
        equations=[(each.right, _dot(each.row, unknowns)) for each in found.conditions],
        roots=spectrum.roots,
        f=_scalar(f),
        g=total(*(product(a, power(sp.Symbol("lamda"), i)) for i, a in enumerate(unknowns))),
        polynomial=polynomial,
        minimal=m < A.rows,
        m=m,
    )
    satisfied = {
        f"condition{i}": Claim(
            _dot(each.row, found.coefficients), each.right, Phrase("condition {i} for the coefficients", i=i)
        )
        for i, each in enumerate(found.conditions, 1)
    }
    equations = [(sp.Matrix([each.row]).dot(unknowns), each.right) for each in found.conditions]
    yield Step(
        "coefficients",
        claims=satisfied,
        steps=eliminated(equations, unknowns, found.coefficients),
        alpha=found.coefficients,
    )
    combination = _dot(found.coefficients, exact.powers(A, m))
    yield Step(
        "assemble",
        claims={"F": Claim(combination, found.value, "sum of the powers of $A$")},
        steps=combined(A, unknowns, found.coefficients, found.value),
        polynomial=polynomial,
        f=_shown(f),
        principal=_has_root(f),
    )
    return Answers(F=found.value)


def _by_the_remainder(A: ImmutableMatrix, f: exact.ScalarFunction) -> Derivation[Answers]:
    """f = p/q reduced modulo χ, which needs no eigenvalue: p = q g + h χ and χ(A) = 0 give f(A) = g(A)."""
    lamda = sp.Symbol("lamda")
    yield from determinant_of(A, lamda)
    value = exact.matrix_function(A, f)
    found = exact.remainder_identity(A, f, lamda)
    q, g = found.denominator, found.remainder
    claims = {}
    if found.quotient is not None:
        divided = g if q == 1 else product(q, g)
        identity = divided if found.quotient == 0 else total(product(found.quotient, found.chi), divided)
        claims["remainder"] = Claim(found.numerator, identity, r"division with remainder by $\chi$")
    yield Step(
        "remainder",
        claims=claims,
        unclaimed="" if claims else "the remainder is checked by the sum of powers that it gives",
        f=_scalar(f.expression),
        remainder=g,
        fraction=q != 1,
    )
    combination = _dot(value.coefficients, exact.powers(A, len(value.coefficients)))
    yield Step(
        "assemble",
        claims={"F": Claim(combination, value.value, "sum of the powers of $A$")},
        steps=polynomial_of(A, value.coefficients[::-1], value.value) if A.rows > 1 else (),
        polynomial=None,
        f=_shown(f.expression),
        principal=False,
    )
    return Answers(F=value.value)


def _shown(f: Expr) -> Expr | Stated | None:
    """The function as it is written of a matrix; None for a quotient, which of matrices is none."""
    A = sp.Symbol("A")
    if f == 1 / A:
        return inverse(A)
    quotients = (each for each in f.atoms(sp.Pow) if each.base.has(A) and each.exp.could_extract_minus_sign())
    return None if any(quotients) else f


def _has_root(f: Expr) -> bool:
    """Whether f takes a root of A, of which there are several."""
    return any(each.exp == sp.S.Half and each.base.has(sp.Symbol("A")) for each in f.atoms(sp.Pow))


def _dot(coefficients: Iterable[Any], terms: Iterable[Any]) -> Any:
    """Σ cᵢ Tᵢ as written; terms with the coefficient zero are left out, unless all are zero."""
    pairs = list(zip(coefficients, terms, strict=True))
    left = [product(c, term) for c, term in pairs if c != 0]
    return total(*left) if left else total(*(product(c, term) for c, term in pairs[:1]))


@matrix_function.method("modal", title="Modal matrix", source="Lecture note, section 1.13")
def by_modal_matrix(given: Given[StateSpace, MatrixFunctionOptions]) -> Derivation[Answers]:
    """f(A) = V f(J) V⁻¹, with J diagonal where A has n independent eigenvectors."""
    A, f = given.system.A, _asked(given)
    yield from eigenvalues_of(A)
    structure = yield from right_eigenvectors_of(A)
    scalar = exact.ScalarFunction(f, sp.Symbol("A"))
    modes = exact.function_of_blocks(structure, scalar)
    found = exact.matrix_function(A, scalar)
    V, inverted = structure.right, structure.right_inverse
    J, diagonal = structure.jordan_form, structure.diagonalizable
    yield Step(
        "inverse",
        claims={"inverse": Claim(inverse(V), inverted, "inverse of the modal matrix")},
        steps=inverse_worked_out("V", V, inverted),
        V=V,
        n=A.rows,
        diagonal=diagonal,
    )
    yield Step(
        "modes",
        claims={} if diagonal else {"similar": Claim(product(A, V), product(V, J))},
        unclaimed="a function of a diagonal matrix acts on the diagonal, by definition" if diagonal else "",
        modes=modes,
        J=J,
        diagonal=diagonal,
        f=f,
    )
    yield Step(
        "back",
        claims={"F": Claim(product(V, modes, inverted), found.value, "product of the matrices")},
        steps=multiplied_out((V, modes, inverted), found.value),
        f=_shown(f),
        diagonal=diagonal,
    )
    return Answers(F=found.value)


@matrix_function.verification("F")
def is_the_function_of_the_matrix(given: Given[StateSpace, MatrixFunctionOptions], answers: Answers) -> Iterable[Check]:
    """F against scipy's expm, sinm, sqrtm, logm, …, and products and inverses of numpy, at random values of symbols."""
    A, F, f = given.system.A, answers["F"], _asked(given)
    yield numeric.check_residual(
        "$F = f(A)$", "scipy.linalg", lambda: judges.matrix_function_residual(A, f, sp.Symbol("A"), F), answer="F"
    )


@matrix_function.mistake(mistakes.ENTRY_BY_ENTRY, "F")
def entry_by_entry(wrong: Attempt[StateSpace, MatrixFunctionOptions]) -> Iterable[Any]:
    """The function of each entry."""
    f, A = wrong.given.options.function, sp.Symbol("A")
    yield sp.ImmutableMatrix(wrong.given.system.A.applyfunc(lambda entry: f.xreplace({A: entry})))


@matrix_function.meaning("F")
def what_does_not_commute(wrong: Attempt[StateSpace, MatrixFunctionOptions]) -> Reason | None:
    """An entry in which AF and FA differ."""
    return commutes(wrong.given.system.A, wrong.value)
