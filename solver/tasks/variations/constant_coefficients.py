"""Lemma: a linear differential equation with constant coefficients, by its characteristic equation."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import TYPE_CHECKING, Any

from solver.arithmetic.exactness import where_exact
from solver.arithmetic.quadratics import quadratic_formula, roots_of_squares
from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import power, product, quotient, total
from solver.stated.calculus import derivative

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.tasks.variations.unknowns import Constants, Unknown


def carried_out(coefficients: Sequence[Expr], function: Any, t: Symbol) -> Any:
    """Σ cᵢ dⁱ/dtⁱ of a function, as stated."""
    terms = [product(c, derivative(function, t, i)) for i, c in enumerate(coefficients) if c != 0]
    return total(*reversed(terms))


@lemma("constant_coefficients")
def by_characteristic_equation(
    form: exact.LinearForm, unknown: Unknown, t: Symbol, constants: Constants
) -> Derivation[Expr]:
    """The functions e^{λt} of the roots, a particular solution for each part of the right side, and their sum."""
    found = yield from fundamental_system_of(form, unknown, t, constants.taken)
    own = [constants.new() for _ in found.functions]
    free = sp.Add(*(c * f for c, f in zip(own, found.functions, strict=True)))
    claim = Claim(carried_out(form.coefficients, free, t), sp.S.Zero, "the homogeneous equation")
    yield Step("homogeneous", claims={"solves": claim}, x=unknown.symbol, solution=free, alone=form.right == 0,
               letter=_letter(unknown, constants.taken), kinds=_kinds(found.roots),
               exceptions=found.exceptions)  # fmt: skip
    if form.right == 0:
        return free
    particular = yield from particular_solution_of(form, unknown, t)
    whole = sp.Add(free, particular)
    claim = Claim(carried_out(form.coefficients, whole, t), form.right, "the equation")
    yield Step("general", claims={"solves": claim}, x=unknown.symbol, solution=whole, n=form.order)
    return whole


@lemma("constant_coefficients")
def fundamental_system_of(
    form: exact.LinearForm, unknown: Unknown, t: Symbol, taken: Collection[str] = ()
) -> Derivation[exact.FundamentalSystem]:
    """The characteristic equation and its roots, by λ or, beside multipliers of that name, by r."""
    try:
        found = exact.fundamental_system(form.coefficients, t)
    except exact.NotExact:
        raise Unsolved("ordinary_equations/roots", equation=form.of(unknown.jets) - form.right) from None
    lamda = _letter(unknown, taken)
    p = sp.Add(*(c * lamda**i for i, c in enumerate(form.coefficients)))
    trial = sp.exp(lamda * t)
    factors = product(*(power(lamda - root.value, root.multiplicity) for root in found.roots))
    claims = {
        "polynomial": Claim(
            quotient(carried_out(form.coefficients, trial, t), trial), p, "the characteristic equation"
        ),
        "roots": Claim(p, factors, "the roots with their multiplicities"),
    }
    split = split_of(found, lamda)
    if split is not None:
        claims["split"] = Claim(p, split, "the characteristic polynomial in factors")
    yield Step("characteristic", claims=claims, steps=_arithmetic(found, lamda), x=unknown.symbol, p=p, split=split,
               letter=lamda, left=form.of(unknown.jets), homogeneous=form.right == 0, roots=found.roots,
               decimals=[f.degree for f in found.factors if f.roots[0].kind == "decimal"])  # fmt: skip
    return found


def _letter(unknown: Unknown, taken: Collection[str]) -> Symbol:
    return sp.Symbol("r" if any(name.startswith("lam") for name in (unknown.name, *taken)) else "lamda")


def split_of(found: exact.FundamentalSystem, lamda: Symbol) -> Any:
    """The polynomial as a product of its factors; None where it is one."""
    factors = [(factor.polynomial(lamda), factor.multiplicity) for factor in found.factors]
    if len(factors) == 1 and factors[0][1] == 1:
        return None
    return product(*(power(p, m) for p, m in factors))


@where_exact
def _arithmetic(found: exact.FundamentalSystem, lamda: Symbol) -> tuple[Step, ...]:
    """The quadratic formula for each factor that needs it."""
    lines: list[Step] = []
    for factor in found.factors:
        roots = [root.value for root in factor.roots]
        if factor.roots[0].kind == "symbolic" and factor.coefficients[1] == 0:
            continue  # ± the root of what may have either sign
        if factor.degree == 2:
            _, b, c = factor.coefficients
            lines += quadratic_formula(lamda, b, c, roots if factor.roots[0].kind == "complex" else roots[::-1])
        elif factor.degree == 4 and factor.roots[0].kind != "decimal":
            squares = exact.squares_of_roots(factor)
            lines += quadratic_formula(lamda**2, factor.coefficients[2], factor.coefficients[4], squares)
            lines += roots_of_squares(lamda, squares, roots)
    return tuple(lines)


def _kinds(roots: Sequence[exact.Root]) -> set[str]:
    """What the roots are: "real", "zero", "pair", "imaginary"; "open", "level" where parameters decide; "repeated"."""
    found = {"repeated"} if any(root.multiplicity > 1 for root in roots) else set()
    for root in roots:
        if root.kind == "symbolic" and root.shift != 0:
            found.add("open" if root.sigma != 0 else "level")
        elif root.kind == "complex" or (root.kind == "decimal" and root.shift != 0):
            found.add("pair" if root.sigma != 0 else "imaginary")
        else:
            found.add("zero" if root.value == 0 else "real")
    return found


@lemma("constant_coefficients")
def particular_solution_of(form: exact.LinearForm, unknown: Unknown, t: Symbol) -> Derivation[Expr]:
    """A trial function for each exponent on the right side, by comparing coefficients."""
    try:
        trials = exact.trials(form, t)
    except exact.NotExact:
        raise Unsolved("ordinary_equations/right_side", right=form.right) from None
    return (yield from trial_steps(form, trials, unknown, t))


@lemma("constant_coefficients")
def trial_steps(form: exact.LinearForm, trials: Sequence[exact.Trial], unknown: Unknown, t: Symbol) -> Derivation[Expr]:
    """Each trial function, and the sum of what they give."""
    found = []
    for number, trial in enumerate(trials, 1):
        claims = {"solves": Claim(carried_out(form.coefficients, trial.solution, t), trial.right, "the trial function")}
        images = sp.Add(*(function * left for function, left, _ in trial.equations))
        claims["put_in"] = Claim(carried_out(form.coefficients, trial.function, t), images, "the trial function put in")
        for i, (_, left, right) in enumerate(trial.equations):
            values = dict(zip(trial.letters, trial.values, strict=True))
            claims[f"compared{i}"] = Claim(left.xreplace(values), right, "coefficients compared")
        yield Step("trial", claims=claims, x=unknown.symbol, trial=trial, number=number if len(trials) > 1 else 0,
                   values=list(zip(trial.letters, trial.values, strict=True)),
                   derivatives=_derivatives(form, trial, t), terms=[(f, left) for f, left, _ in trial.equations],
                   several=len(trials) > 1, powers=not form.is_constant(t))  # fmt: skip
        found.append(trial.solution)
    return sp.Add(*found)


def _derivatives(form: exact.LinearForm, trial: exact.Trial, t: Symbol) -> list[tuple[int, Expr]]:
    """The derivatives of the trial function that the equation has, each with its order."""
    orders = [i for i, c in enumerate(form.coefficients) if c != 0 and i > 0]
    if form.is_constant(t):
        return [(i, trial.derivative(i, t)) for i in orders]
    return [(i, sp.expand(sp.diff(trial.function, t, i))) for i in orders]
