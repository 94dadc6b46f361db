"""The verification of extremals: each answer by itself, against the functional as it is given."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import partial
from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Check, Given, Task
from solver.jets import jet_symbol
from solver.lazy import numeric
from solver.numeric.judges import variations as judges
from solver.tasks.variations.end_conditions import is_open

if TYPE_CHECKING:
    from solver.systems import Functional

NEAR = 1e-6
"""What differences, circles and quadrature leave of a residual."""
OF_DECIMALS = 1e-4
CIRCLES, QUADRATURE = "Cauchy's formula", "scipy.integrate.quad"
RITZ, JACOBI = "polynomials of Legendre", "scipy.integrate.solve_ivp"


def problem_of(system: Functional) -> judges.Problem:
    """What is given, as the judges take it."""
    highest = max([*system.orders.values(), *(k for _, k in system.jets.values())])
    usual = {jet_symbol((name, k)): (name, k) for name in system.functions for k in range(highest + 1)}
    known = {jet: symbol for symbol, jet in (usual | dict(system.jets)).items()}
    return judges.Problem(
        system.integrand,
        system.t,
        system.functions,
        {symbol: jet for jet, symbol in known.items()},
        system.start,
        system.stop,
        _kept_ends(system)
        if is_open(system)
        else {jet: (_end(first), _end(last)) for jet, (first, last) in system.ends.items()},
        system.terminal_cost,
        [left - right for left, right in system.constraints],
        [(each.integrand, each.value) for each in system.integral_constraints],
    )


def _kept_ends(system: Functional) -> dict[tuple[str, int], tuple[judges.End, judges.End]]:
    """Ends of which nothing is said: the constants are left, and nothing varies there."""
    kept = judges.End(kept=True)
    return {(name, k): (kept, kept) for name, order in system.orders.items() for k in range(order)}


def _end(end: Any) -> judges.End:
    return judges.End(end.value, end.curve)


def functions_of(system: Functional, x: Any) -> dict[str, Any]:
    """The functions by name: the answer is an expression for one, a mapping for several."""
    if isinstance(x, Mapping):
        return {str(name): value for name, value in x.items()}
    return {system.functions[0]: x} if len(system.functions) == 1 else {}


def register(task: Task[Functional, Any]) -> None:
    """Register the verifications of the functions, the value, the end time, Legendre's condition and the nature."""
    task.verification("x")(is_stationary)
    task.verification("value")(is_the_integral)
    task.verification("t_f")(is_the_end)
    task.verification("legendre")(is_the_second_derivative)
    task.verification("conjugate_point")(is_the_first_zero)
    task.verification("nature")(fits_the_second_variation)


def _functions(given: Given[Functional, Any], answers: Answers) -> dict[str, Any] | None:
    """The functions that are answered; None where they are not."""
    return functions_of(given.system, answers["x"]) if "x" in answers else None


def _near(*values: Any) -> float:
    return OF_DECIMALS if numeric.holds_decimals(list(values)) else NEAR


def is_stationary(given: Given[Functional, Any], answers: Answers) -> Iterable[Check]:
    """The equations, the natural conditions, the ends and the constraints; variations change nothing at first order."""
    problem, x, t_f = problem_of(given.system), _functions(given, answers) or {}, answers.get("t_f")
    residuals = [
        ("the Euler–Lagrange equations and the natural conditions", CIRCLES, judges.stationary_residual),
        ("what is asked at the ends", CIRCLES, judges.ends_residual),
        ("admissible variations do not change $J$ to first order", RITZ, judges.first_variation_residual),
    ]
    if problem.constraints or problem.integrals:
        residuals.append(("the constraints", QUADRATURE, judges.constraints_residual))
    for label, oracle, residual in residuals:
        yield _check("x", label, oracle, answers, partial(residual, problem, x, t_f))


def is_the_end(given: Given[Functional, Any], answers: Answers) -> Iterable[Check]:
    """The end time: with the functions all conditions hold there; without them it is that of an extremal."""
    problem, x, t_f = problem_of(given.system), _functions(given, answers), answers["t_f"]
    if x is None:
        yield _check("t_f", "the end time of an extremal", RITZ, answers, partial(judges.end_residual, problem, t_f))
        return
    transversal = partial(judges.stationary_residual, problem, x, t_f)
    yield _check("t_f", "the condition of transversality at the end", CIRCLES, answers, transversal)
    yield _check("t_f", "what is asked at the end", CIRCLES, answers, partial(judges.ends_residual, problem, x, t_f))


def is_the_integral(given: Given[Functional, Any], answers: Answers) -> Iterable[Check]:
    """The value of the functional by quadrature."""
    problem, x, t_f = problem_of(given.system), _functions(given, answers), answers.get("t_f")
    residual = partial(judges.value_residual, problem, x, answers["value"], t_f)
    yield _check("value", "the value of the functional along the extremal", QUADRATURE, answers, residual)


def is_the_second_derivative(given: Given[Functional, Any], answers: Answers) -> Iterable[Check]:
    """∂²φ/∂x'² along the extremal at several times."""
    problem, x, t_f = problem_of(given.system), _functions(given, answers), answers.get("t_f")
    residual = partial(judges.legendre_residual, problem, x, answers["legendre"], t_f)
    label = "the second derivative by the highest derivative, along the extremal"
    yield _check("legendre", label, CIRCLES, answers, residual)


def is_the_first_zero(given: Given[Functional, Any], answers: Answers) -> Iterable[Check]:
    """The first zero of a solution of Jacobi's equation that begins with zero."""
    problem, x, t_f = problem_of(given.system), _functions(given, answers), answers.get("t_f")
    residual = partial(judges.conjugate_residual, problem, x, answers["conjugate_point"], t_f)
    yield _check("conjugate_point", "the first zero of a solution of Jacobi's equation", JACOBI, answers, residual)


def fits_the_second_variation(given: Given[Functional, Any], answers: Answers) -> Iterable[Check]:
    """The sign of the second variation on polynomials."""
    problem, x, t_f = problem_of(given.system), _functions(given, answers), answers.get("t_f")
    label = "the sign of the second variation"
    try:
        holds = judges.nature_holds(problem, x, answers["nature"], t_f)
    except numeric.NotEvaluable as refusal:
        yield Check.skipped(label, RITZ, refusal.reason, answer="nature")
        return
    yield Check.that(label, RITZ, holds, answer="nature")


def _check(answer: str, label: str, oracle: str, answers: Answers, residual: Callable[[], float]) -> Check:
    """The check of a residual; the functions, where they are answered, may be rounded."""
    near = _near(answers[answer], answers.get("x"), answers.get("t_f"))
    return numeric.check_residual(label, oracle, residual, near, answer=answer)
