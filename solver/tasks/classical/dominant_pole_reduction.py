"""A model of lower order by the dominant poles, with the error of its step response."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any

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
    option,
)
from solver.derivation.figures import Curve, Mark, Plot
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import classical as judges
from solver.options.integer import Integer
from solver.stated.algebra import product, quotient
from solver.stated.calculus import value_at
from solver.stated.transforms import inverse_laplace, inverse_z
from solver.tasks.classical.paths import Path, numbers_of, path_of, poles_of, quietly
from solver.tasks.classical.step_measures import question_of
from solver.tasks.plant_options import LoopOptions
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr

    from solver.tasks.classical.paths import Plant


@dataclass(frozen=True, kw_only=True)
class ReductionOptions(LoopOptions):
    """How many poles are kept."""

    order: int = option(Integer(1), "the number of poles kept; a conjugate pair is not split", default=2)


dominant_pole_reduction: Task[Plant, ReductionOptions] = Task(
    "dominant_pole_reduction",
    title="Reduction to the dominant poles",
    doc="A model of lower order with the slowest poles and the same DC gain, and how far its step response is off.",
    needs=("path",),
    options=ReductionOptions,
    answers=[
        AnswerName("G", "G_r", "the reduced transfer function", free=True, principal=True, earned=("reduced",)),
        AnswerName("kept", r"p_{\text{kept}}", "the dominant poles", principal=True, earned=("chosen",)),
        AnswerName("dropped", r"p_{\text{dropped}}", "the poles dropped", earned=("chosen",)),
    ],
    example={"transfer_function": "20/((s + 1)(s + 2)(s + 10))"},
)


@dominant_pole_reduction.method(source="Ogata, Modern Control Engineering, section 5-4")
def by_dominant_poles(given: Given[Plant, ReductionOptions]) -> Derivation[Answers]:
    """Keep the poles nearest to the imaginary axis, in z those of largest size; what is fast is its value at rest."""
    path = yield from path_of(given)
    yield from poles_of(path)
    form = exact.pole_zero_factors(path.fraction)
    found = _reduced(form, given.options.order, discrete=path.discrete)
    yield Step("chosen", unclaimed="a choice, which has a check of its own", found=found, order=given.options.order,
               count=len(form.poles), discrete=path.discrete)  # fmt: skip
    if form.zeros:
        yield Step("zeros", unclaimed="a choice, which has a check of its own", found=found, discrete=path.discrete,
                   farthest=min((sp.Abs(p - path.rest) for p in found.poles_dropped), key=sp.N))  # fmt: skip
    yield _constant(found, path)
    yield _whole(path, form, found)
    yield from _compared(path, found)
    G = found.function * sp.exp(-path.delay * path.variable) if path.delay != 0 else found.function
    return Answers(G=G, kept=found.poles_kept, dropped=found.poles_dropped)


def _reduced(form: exact.PoleZeroForm, order: int, *, discrete: bool) -> exact.Reduction:
    """The reduction; raises Unsolved where it says nothing new, or is not told by the parameters."""
    try:
        return exact.reduction(form, order, discrete=discrete)
    except exact.NotReduced as finding:
        if finding.why == "open":
            raise Unsolved("dominant_pole_reduction/open") from None
        if finding.why == "lasting":
            raise Unsolved("dominant_pole_reduction/lasting", count=finding.count, discrete=discrete) from None
        raise Unsolved("dominant_pole_reduction/nothing", count=finding.count, order=order) from None


def _constant(found: exact.Reduction, path: Path) -> Step:
    """What the fast factors are at zero, at one."""
    stated = (_at_rest(roots, path.rest) for roots in (found.zeros_dropped, found.poles_dropped))
    claim = Claim(quotient(*stated), found.constant, "the fast factors for slow signals")
    return Step("constant", claims={"constant": claim}, x=path.variable, found=found, discrete=path.discrete)


def _at_rest(roots: Iterable[Expr], at: Expr) -> Any:
    """Π(0 − r), Π(1 − r) as it is written."""
    factors = [at - root for root in roots]
    return product(*factors) if len(factors) > 1 else factors[0] if factors else sp.Integer(1)


def _whole(path: Path, form: exact.PoleZeroForm, found: exact.Reduction) -> Step:
    """The reduced function; its DC gain, or velocity constant, is that of the whole one."""
    x, at = path.variable, path.rest
    stated = product(form.gain, found.constant, quotient(found.top, found.bottom))
    late = sp.exp(-path.delay * x) if path.delay != 0 else sp.Integer(1)
    N = sum(1 for pole in found.poles_kept if pole == at) - sum(1 for zero in found.zeros_kept if zero == at)
    whole, reduced = (sp.cancel(each * (x - at) ** N) for each in (path.top / path.bottom, found.function))
    same = reduced.subs(x, at)
    claims = {
        "reduced": Claim(stated, found.function, "the reduced function"),
        "same": Claim(whole.subs(x, at), same, "the value kept"),
    }
    return Step("reduced", claims=claims, x=x, integrators=N, value=same, late=path.delay, stated=product(late, stated),
                G=found.function * late, discrete=path.discrete, after=len(form.poles) - len(form.zeros),
                sooner=len(found.poles_kept) - len(found.zeros_kept))  # fmt: skip


def _compared(path: Path, found: exact.Reduction) -> Derivation[None]:
    """Both step responses, and the largest difference where it stays bounded."""
    if path.parameters:
        return
    both = _responses(path, found)
    if both is None:
        return
    y, y_r, error = both
    lasting = any(not _settles(pole, discrete=path.discrete) for pole in found.poles_kept)
    final = None if lasting else found.function.subs(path.variable, path.rest)
    s, t = path.variable, sp.Symbol("k" if path.discrete else "t")
    back, step = (inverse_z, s / (s - 1)) if path.discrete else (inverse_laplace, 1 / s)
    claims = {
        "whole": Claim(back(path.top / path.bottom * step, s, t), y, "the step response"),
        "slow": Claim(back(found.function * step, s, t), y_r, "that of the reduced system"),
    }
    if error is not None and error.time is not sp.oo:
        claims["error"] = Claim(value_at(y - y_r, t, error.time), error.value, "the largest difference")
    share = None if error is None or not final else sp.N(abs(error.value / final), 30)
    figure = _sampled_figure if path.discrete else _figure
    yield Step("compared", detail="full", claims=claims, error=error, share=share, late=path.delay, t=t,
               discrete=path.discrete, figures=figure(found, (y, y_r), error))  # fmt: skip


def _responses(path: Path, found: exact.Reduction) -> tuple[Expr, Expr, exact.LargestError | None] | None:
    """Y, y of the reduced function, and their largest difference; None where there are multiple poles in decimals."""
    whole, t = question_of(path).answer, sp.Symbol("t")
    y: Expr = whole.y[0]  # type: ignore[index]  # it has an output
    growing = any(exact.sign_of(sp.re(pole)) == 1 for pole in found.poles_kept)
    if found.function.has(sp.Float) and path.discrete:
        return None
    if found.function.has(sp.Float):
        modes = exact.reduced_modes(found)
        if modes is None:
            return None
        return y, exact.reduced_response(modes, t), None if growing else exact.largest_difference(whole, modes)
    top, bottom = sp.fraction(sp.cancel(found.function))
    given = replace(path.given, numerators=((sp.expand(top),),), denominators=((sp.expand(bottom),),))
    slow = replace(path, given=given, cancels=False)
    y_r: Expr = question_of(slow).answer.y[0]  # type: ignore[index]  # it has an output
    return y, y_r, _error(path, found)


def _settles(pole: Expr, *, discrete: bool) -> bool:
    """Whether the mode of a pole dies out."""
    real, imaginary = pole.as_real_imag()
    return bool(exact.sign_of(sp.expand(real**2 + imaginary**2) - 1 if discrete else real) == -1)


def _error(path: Path, found: exact.Reduction) -> exact.LargestError | None:
    """The largest difference of both responses; None where it grows."""
    x = path.variable
    left = sp.fraction(sp.cancel(sp.together(path.top / path.bottom - found.function)))
    top, bottom = (sp.Poly(each, x) for each in left)
    if top.is_zero:
        return exact.LargestError(sp.Integer(0), sp.Integer(0))
    given = replace(path.given, numerators=((top.as_expr(),),), denominators=((bottom.as_expr(),),))
    G = exact.transfer_matrix_of_fractions(given.numerators, given.denominators, x)
    if any(not _settles(pole, discrete=path.discrete) for pole in G.poles or []):
        return None
    difference = question_of(replace(path, given=given, cancels=False)).answer
    return exact.largest_sampled_error(difference) if path.discrete else exact.largest_error(difference)


def _sampled_figure(
    found: exact.Reduction, both: tuple[Any, Any], error: exact.LargestError | None
) -> tuple[Plot, ...]:
    """The samples of both responses until the slower modes have died out."""
    k = sp.Symbol("k")
    slowest = min((mode.rate for mode in (*found.kept, *found.dropped) if mode.sign == 1), key=sp.N)
    stop = sp.Integer(min(60, int(5 / sp.N(slowest)) + 3)) if slowest is not sp.oo else sp.Integer(6)
    curves = (Curve(both[0], "y", style="samples"), Curve(both[1], "y_r", style="samples"))
    seen = error is not None and error.time is not sp.oo and bool(error.time < stop)
    marks = (Mark(error.time, sp.N(both[0].subs(k, error.time), 15), r"e_{\max}"),) if seen and error else ()
    caption = "The samples of the step responses of the whole system and of the reduced one"
    return (Plot(caption, "k", "y", k, sp.Integer(0), stop, curves, marks),)


def _figure(found: exact.Reduction, both: tuple[Any, Any], error: exact.LargestError | None) -> tuple[Plot, ...]:
    """Both responses until the slower modes have died out."""
    t = sp.Symbol("t")
    slowest = min((mode.rate for mode in (*found.kept, *found.dropped) if mode.sign == 1), key=sp.N)
    stop = sp.Rational(str(float(f"{float(6 / sp.N(slowest)):.3g}")))
    curves = (Curve(both[0], "y"), Curve(both[1], "y_r", style="dashed"))
    seen = error is not None and error.time is not sp.oo and bool(error.time < stop)
    marks = (Mark(error.time, sp.N(both[0].subs(t, error.time), 15), r"e_{\max}"),) if seen and error else ()
    caption = "The step responses of the whole system and, dashed, of the reduced one"
    return (Plot(caption, "t", "y", t, sp.Integer(0), stop, curves, marks),)


@dominant_pole_reduction.verification("G", "kept", "dropped")
def has_the_slowest_poles_and_the_gain(given: Given[Plant, ReductionOptions], answers: Answers) -> Iterable[Check]:
    """The poles by eigenvalues, sorted by how slow they are; the function has those kept, and the DC gain."""
    plant, order, discrete = numbers_of(given.system), given.options.order, given.system.discrete
    for name, label in (("kept", "the slowest poles, no pair split"), ("dropped", "the other poles")):
        if name in answers:
            check = partial(judges.dominant_residual, plant, order, name, list(answers[name]), discrete=discrete)
            yield numeric.check_residual(label, "mpmath.eig (50 digits)", check, answer=name)
    if "G" in answers:
        G = answers["G"] * sp.exp(getattr(given.system, "delay", sp.Integer(0)) * sp.Symbol("s"))
        written = sp.expand(G, power_exp=True) if G.has(sp.exp) else G
        check = partial(judges.reduced_residual, plant, order, written, discrete=discrete)
        label = Phrase("poles, DC gain and slow zeros of the reduced function")
        yield numeric.check_residual(label, "mpmath.polyroots (50 digits)", check, answer="G")


NEAR = 0.005
"""How far a pole may be rounded, relatively: to three digits."""


@dominant_pole_reduction.consequence("dropped", of=("kept",), symbolic=False)
def what_is_left(given: Given[Plant, ReductionOptions], found: Mapping[str, Any]) -> Any:
    """The poles that are not kept; one that is kept may be rounded."""
    left = list(quietly(poles_of(quietly(path_of(given)))))
    for pole in found["kept"]:
        gaps = [abs(sp.N(each - pole)) for each in left]
        nearest = min(range(len(gaps)), key=gaps.__getitem__, default=None)
        if nearest is not None and gaps[nearest] <= NEAR * abs(sp.N(left[nearest])):
            del left[nearest]
    return left


GAIN = Slip(
    "gain_at_zero",
    "the DC gain is not kept: a factor that is dropped leaves its value for slow signals behind, $-p$ of "
    "$s - p$ and $1 - p$ of $z - p$",
)
FASTEST = Slip(
    "fastest",
    "these are the fastest poles; the dominant ones are those nearest to the imaginary axis, in $z$ of largest size",
)


@dominant_pole_reduction.mistake(GAIN, "G")
def without_the_constant(wrong: Attempt[Plant, ReductionOptions]) -> Iterable[Expr]:
    """The factors left out without their value at zero."""
    form = exact.pole_zero_factors(quietly(path_of(wrong.given)).fraction)
    found = _reduced(form, wrong.given.options.order, discrete=wrong.given.system.discrete)
    yield found.function / found.constant


@dominant_pole_reduction.mistake(FASTEST, "kept")
def the_other_end(wrong: Attempt[Plant, ReductionOptions]) -> Iterable[list[Expr]]:
    """The poles farthest from the axis."""
    poles = quietly(poles_of(quietly(path_of(wrong.given))))
    modes = exact.decay(poles, sp.Integer(1) if wrong.given.system.discrete else None).modes
    every = [pole for mode in reversed(modes) for pole in mode.every]
    yield every[: wrong.given.options.order]
