"""The pole-zero form G = k Π(s − zᵢ)/Π(s − pᵢ) of a transfer function, of a discrete one in z."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import partial
from typing import TYPE_CHECKING, Any

from solver.arithmetic.roots import roots_found
from solver.derivation import (
    AnswerName,
    Answers,
    Attempt,
    Check,
    Claim,
    Derivation,
    Given,
    Slip,
    Step,
    Task,
    Unsolved,
)
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import classical as judges
from solver.numeric.judges import representation
from solver.stated.algebra import product, quotient
from solver.tasks import meanings
from solver.tasks.classical.paths import Path, numbers_of, path_of, quietly, stated_path
from solver.tasks.figures import plane, roots
from solver.tasks.mistakes import OPEN_LOOP, not_closed
from solver.tasks.plant_options import LoopOptions
from solver.tasks.representation.lowest_terms import from_roots
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.tasks.classical.paths import Plant

pole_zero_form: Task[Plant, LoopOptions] = Task(
    "pole_zero_form",
    title="Pole-zero form",
    doc="A transfer function as its gain times the factors of its zeros over those of its poles.",
    needs=("path",),
    options=LoopOptions,
    answers=[
        AnswerName("G", "G", "the transfer function in factors", earned=("form",)),
        AnswerName("zeros", "z_i", "the zeros, with multiplicity", optional=True, earned=("numerator",)),
        AnswerName("poles", "p_i", "the poles, with multiplicity", optional=True, earned=("denominator",)),
        AnswerName("gain", "k", "the factor before the fraction", earned=("numerator", "gain")),
    ],
)


@pole_zero_form.method(source="Dorf and Bishop, Modern Control Systems, section 2.4")
def by_the_roots(given: Given[Plant, LoopOptions]) -> Derivation[Answers]:
    """The leading coefficients make the gain; the roots of what is left are the zeros and the poles."""
    path = yield from path_of(given)
    x = path.variable
    if path.top == 0:
        raise Unsolved("pole_zero_form/zero", x=x)
    form = _form_of(path)
    leads = [sp.Poly(p, x).LC() for p in path.shown]
    yield Step("gain", claims={"gain": Claim(quotient(*leads), form.gain, "gain")}, x=x, shown=path.shown,
               leads=leads, late=path.delay != 0)  # fmt: skip
    zeros = _roots(path.top / form.gain, form.top, form.zeros, x)
    yield Step("numerator", claims=zeros, unclaimed=_constant(zeros), x=x,
               steps=roots_found(path.top, form.zeros, x), **_shown(form.zeros))  # fmt: skip
    poles = _roots(path.bottom, form.bottom, form.poles, x)
    yield Step("denominator", claims=poles, unclaimed=_constant(poles), x=x,
               steps=roots_found(path.bottom, form.poles, x), **_shown(form.poles))  # fmt: skip
    yield _whole(path, form)
    G = sp.exp(-path.delay * x) * form.function if path.delay != 0 else form.function
    return Answers(G=G, zeros=form.zeros, poles=form.poles, gain=form.gain)


def _form_of(path: Path) -> exact.PoleZeroForm:
    """The factors; raises Unsolved where parameters leave roots without a usable form."""
    try:
        return exact.pole_zero_factors(path.fraction)
    except exact.NotExact:
        G = path.fraction
        which = [p for p, found in ((path.top, G.zeros), (path.bottom, G.poles)) if found is None]
        raise Unsolved("pole_zero_form/no_roots", polynomials=which) from None


def _roots(polynomial: Expr, factors: Expr, found: list[Expr], x: Any) -> dict[str, Claim]:
    """A monic polynomial is the product of its factors, and of x − r over its roots."""
    if not found:
        return {}
    p = sp.Poly(sp.cancel(polynomial), x).as_expr()
    return {
        "factors": Claim(p, factors, "factors of the polynomial"),
        "roots": Claim(p, from_roots(x, found), "roots of the polynomial"),
    }


def _constant(claims: Mapping[str, Claim]) -> str:
    return "" if claims else "it is a constant"


def _shown(found: list[Expr]) -> dict[str, Any]:
    """The roots, and whether there are pairs or decimals among them."""
    return {
        "roots": found,
        "paired": any(root.has(sp.I) for root in found),
        "decimal": any(root.has(sp.Float) for root in found),
    }


def _whole(path: Path, form: exact.PoleZeroForm) -> Step:
    """Gain, zeros and poles put together."""
    x = path.variable
    stated = quotient(*path.shown)
    factors = [sp.exp(-path.delay * x)] if path.delay != 0 else []
    right = product(*factors, form.gain, quotient(form.top, form.bottom)) if form.gain != 1 or factors else quotient(
        form.top, form.bottom
    )  # fmt: skip
    claim = Claim(product(*factors, stated) if factors else stated, right, "pole-zero form")
    figure = plane("Poles and zeros", roots("poles", form.poles), roots("zeros", form.zeros, "ring"),
                   discrete=path.discrete, stable=True)  # fmt: skip
    return Step("form", claims={"form": claim}, x=x, right=right, excess=len(form.poles) - len(form.zeros),
                discrete=path.discrete, figures=figure)  # fmt: skip


@pole_zero_form.verification("G")
def has_the_values_of_the_given(given: Given[Plant, LoopOptions], answers: Answers) -> Iterable[Check]:
    """The same function at random points."""
    yield numeric.check_claim(
        Claim(stated_path(given.system), sp.ImmutableMatrix([[answers["G"]]])), "$G$ at random points"
    )


@pole_zero_form.verification("poles", "zeros", "gain")
def are_those_of_the_minimal_part(given: Given[Plant, LoopOptions], answers: Answers) -> Iterable[Check]:
    """Poles by the eigenvalues of the minimal part, zeros by its system matrix, the gain far from the origin."""
    plant = numbers_of(given.system)
    residuals = {
        "poles": ("the poles are the eigenvalues of the minimal part", representation.pole_residual),
        "zeros": ("the zeros are where the minimal part blocks", representation.zero_residual),
    }
    for name, (label, residual) in residuals.items():
        if name in answers:
            check = partial(residual, plant, list(answers[name]))
            yield numeric.check_residual(label, "orthogonal bases (50 digits)", check, answer=name)
    if "gain" in answers:
        check = partial(judges.leading_gain_residual, plant, answers["gain"])
        yield numeric.check_residual("the first Markov parameter that is not zero", "mpmath (50 digits)", check,
                                     answer="gain")  # fmt: skip


@pole_zero_form.consequence("G", of=("zeros", "poles", "gain"))
def function_of_its_roots(given: Given[Plant, LoopOptions], found: Mapping[str, Any]) -> Any:
    """k Π(s − z)/Π(s − p), with the dead time of the question."""
    s = _variable(given)
    top, bottom = (sp.Mul(*(s - root for root in found[name])) for name in ("zeros", "poles"))
    return getattr(given.system, "factor", sp.Integer(1)) * found["gain"] * top / bottom


def _variable(given: Given[Plant, LoopOptions]) -> Symbol:
    return sp.Symbol("z" if given.system.discrete else "s")


DC_OF_SAMPLES = Slip("gain_at_one", "it is the DC gain $G(1)$; $k$ stands before the factors $z - p$")
DC = Slip("gain_at_zero", "it is the DC gain $G(0)$, which belongs to factors $1 - s/p$; here the factors are $s - p$")
SIGN = Slip("sign", "the signs are turned: $s + a$ has the root $-a$")
EXCHANGED = Slip("exchanged", "zeros and poles are exchanged")


@pole_zero_form.mistake(DC, "gain")
def gain_of_the_time_constant_form(wrong: Attempt[Plant, LoopOptions]) -> Iterable[Expr]:
    """G without its poles and zeros at the origin, at zero."""
    s = sp.Symbol("s")
    path = quietly(path_of(wrong.given))
    if path.discrete:
        return
    top, bottom = (sp.Poly(p, s).terms()[-1][1] for p in (path.top, path.bottom))
    yield sp.cancel(top / bottom)


@pole_zero_form.mistake(DC_OF_SAMPLES, "gain")
def gain_of_constant_inputs(wrong: Attempt[Plant, LoopOptions]) -> Iterable[Expr]:
    """G(1) of a discrete system, its accumulators apart."""
    path = quietly(path_of(wrong.given))
    if path.discrete:
        yield exact.value_at_zero(path.fraction, discrete=True).value


@pole_zero_form.mistake(SIGN, "zeros", "poles")
def with_the_other_sign(wrong: Attempt[Plant, LoopOptions]) -> Iterable[list[Expr]]:
    """The roots times −1."""
    yield [-root for root in wrong.ours]


@pole_zero_form.mistake(EXCHANGED, "zeros", "poles")
def of_the_other_polynomial(wrong: Attempt[Plant, LoopOptions]) -> Iterable[list[Expr]]:
    """Poles for zeros, zeros for poles."""
    found = exact.pole_zero_factors(quietly(path_of(wrong.given)).fraction)
    yield found.poles if wrong.name == "zeros" else found.zeros


@pole_zero_form.meaning("poles", "zeros")
def value_at_one_of_them(wrong: Attempt[Plant, LoopOptions]) -> Reason | None:
    """The value of G where it has no pole, or no zero."""
    x = _variable(wrong.given)
    return meanings.finite_at(wrong.value, stated_path(wrong.given.system), x, zeros=wrong.name == "zeros")


@pole_zero_form.meaning("G")
def value_at_a_point(wrong: Attempt[Plant, LoopOptions]) -> Reason | None:
    """Its value and that of the given function."""
    return meanings.at_a_point(wrong.value, stated_path(wrong.given.system))


pole_zero_form.mistaken_question(OPEN_LOOP)(not_closed)
