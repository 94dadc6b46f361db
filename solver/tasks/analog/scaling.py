"""Lemmas: the largest size of each variable, its volts per unit, and the equations in volts and machine time."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, quotient
from solver.stated.calculus import derivative, value_at
from solver.tasks.analog.machine_form import written
from solver.words import Phrase, formula

if TYPE_CHECKING:
    from sympy import Expr, Symbol


@lemma("scaling")
def maxima_of(equations: exact.MachineEquations, given: Mapping[Symbol, Expr]) -> Derivation[dict[Symbol, Expr]]:
    """The largest size of each integrated variable, given or found from the response. Raises Unsolved."""
    wanted = [each.variable for each in equations.integrated if each.variable not in given]
    if given:
        yield Step("given", unclaimed="the question gives them", maxima=list(given.items()), all=not wanted)
    found = {x: _largest(equations, x) for x in wanted}
    if found:
        yield _solution(equations)
    for x, largest in found.items():
        yield _maximum(equations, x, largest)
    own = {x: largest.value for x, largest in found.items()}
    known = {**own, **given}
    return {x: known[x] for x in (*(e.variable for e in equations.integrated), *given)}


def _largest(equations: exact.MachineEquations, x: Symbol) -> exact.Largest:
    """The largest size, or why there is none."""
    try:
        found: exact.Largest = exact.largest_size(equations, {x: sp.S.One})
    except exact.Unbounded:
        raise Unsolved("machines/unbounded", variable=x) from None
    except exact.Undecided:
        raise Unsolved("machines/symbolic", variable=x) from None
    except exact.Unsearched:
        raise Unsolved("machines/unsearched", variable=x) from None
    return found


def _solution(equations: exact.MachineEquations) -> Step:
    """The motions, which satisfy the equations and begin at the initial values."""
    motions, t = exact.motions_of(equations), sp.Symbol("t")
    claims = {}
    for i, each in enumerate(equations.integrated):
        x = motions[each.variable]
        if not any(motion.has(sp.Heaviside) for motion in motions.values()):
            right = exact.combined(each.terms).xreplace(motions)
            says = Phrase("the equation of ${x}$", x=formula(each.variable))
            claims[f"rate{i}"] = Claim(derivative(x, t), right, says)
            claims[f"start{i}"] = Claim(value_at(x, t, sp.S.Zero), each.initial, says)
    return Step(
        "solution",
        claims=claims,
        unclaimed="" if claims else "the largest sizes are judged by themselves",
        motions=list(motions.items()),
        first=equations.integrated[0].variable,
    )


def _maximum(equations: exact.MachineEquations, x: Symbol, largest: exact.Largest) -> Step:
    """Where the slope is zero, and what the size is there, at the start and in the end."""
    t, flat = sp.Symbol("t"), largest.flat
    claims = {}
    if flat is not None and flat.slope != 0:
        claims["slope"] = Claim(derivative(largest.motion, t), flat.slope, "slope")
        for i, (time, value) in enumerate(zip(flat.times, largest.values, strict=True)):
            if flat.equation is not None:
                left, right = flat.equation
                claims[f"equation{i}"] = Claim(value_at(left, t, time), right, "equation at the zero of the slope")
            claims[f"zero{i}"] = Claim(value_at(flat.slope, t, time), sp.S.Zero, "slope at its zero")
            claims[f"value{i}"] = Claim(value_at(largest.motion, t, time), value, "value there")
            claims[f"decimal{i}"] = Claim(value, exact.in_decimals(value), "value there in decimals")
    elif largest.kind == "peak" and not largest.motion.has(sp.Heaviside):
        claims["zero0"] = Claim(
            value_at(derivative(largest.motion, t), t, largest.time), sp.S.Zero, "slope at its zero"
        )
    start = next((each.initial for each in equations.integrated if each.variable == x), sp.S.Zero)
    return Step(
        "maximum",
        claims=claims,
        unclaimed="" if claims else "what is seen of the motion",
        x=x,
        largest=largest,
        flat=flat,
        fading=largest.motion.has(sp.exp),
        decimals=[
            (exact.in_decimals(time), exact.in_decimals(value))
            for time, value in zip(flat.times if flat else (), largest.values, strict=True)
        ],
        size=exact.in_decimals(largest.value),
        start=start,
    )


def voltages_of(scaled: exact.MachineEquations) -> dict[Symbol, Expr]:
    """The derivatives of the voltages by their names X1_dot, X2_dot, …; of relations without derivatives Y, …."""
    rates = {
        sp.Symbol(f"{each.variable.name}_dot", real=True): exact.combined(each.terms) for each in scaled.integrated
    }
    return rates or {each.variable: exact.combined(each.terms) for each in scaled.summed}


@lemma("scaling")
def used_range_of(
    equations: exact.MachineEquations, scaling: exact.Scaling, given: Mapping[Symbol, Expr], reference: Expr
) -> Derivation[None]:
    """How much of the range the given maxima use, where the largest sizes themselves are found."""
    rows: list[tuple[Any, ...]] = []
    claims = {}
    for each in equations.integrated:
        x = each.variable
        if x not in given or given[x].free_symbols:
            continue
        try:
            found = exact.largest_size(equations, {x: sp.S.One})
        except (exact.Unbounded, exact.Undecided, exact.Unsearched, exact.NotExact):
            continue
        size, L = exact.in_decimals(found.value), scaling.of(x)
        volts = L * size
        claims[f"volts{len(rows)}"] = Claim(product(L, size), volts, "the largest voltage")
        rows.append((x, size, volts, bool((volts - reference).is_positive)))
    if rows:
        yield Step("used", claims=claims, rows=rows, reference=reference, detail="full",
                   beyond=[x for x, *_, beyond in rows if beyond])  # fmt: skip


@lemma("scaling")
def scaled_equations_of(
    equations: exact.MachineEquations, maxima: Mapping[Symbol, Expr], reference: Expr, beta: Expr
) -> Derivation[tuple[exact.Scaling, exact.MachineEquations]]:
    """L = reference/maximum, x = X/L put in, dx/dt = β dx/dτ, each coefficient (L_out/L_in) a/β."""
    factors = exact.scale_factors(maxima, reference)
    yield Step(
        "factors",
        claims={
            f"factor{i}": Claim(
                quotient(reference, exact.in_decimals(maxima[x])), L, Phrase("the scale factor of ${x}$", x=formula(x))
            )
            for i, (x, L) in enumerate(factors.items())
            if maxima[x] != 0
        },
        unclaimed="" if any(maxima.values()) else "nothing moves",
        rows=[(x, maxima[x], L) for x, L in factors.items()],
        reference=reference,
    )
    scaling = exact.Scaling(factors, beta)
    names, scaled = exact.scaled_symbols(equations, scaling), exact.scaled(equations, scaling)
    yield _substitution(equations, scaling, names, scaled)
    for each, volts in zip(equations.integrated, scaled.integrated, strict=True):
        yield _row(each, volts, scaling)
    for y, sum_in_volts in () if equations.integrated else zip(equations.summed, scaled.summed, strict=True):
        yield _row(y, sum_in_volts, exact.Scaling(factors, sp.S.One))
    return scaling, scaled


def _substitution(
    equations: exact.MachineEquations, scaling: exact.Scaling, names: Mapping[Any, Any], scaled: exact.MachineEquations
) -> Step:
    """The variables in volts, with the initial values, and the time of the machine."""
    claims = {
        f"start{i}": Claim(product(scaling.of(x.variable), x.initial), X.initial, "the initial value in volts")
        for i, (x, X) in enumerate(zip(equations.integrated, scaled.integrated, strict=True))
    }
    rows = [
        (x.variable, names[x.variable], scaling.of(x.variable), x.initial, X.initial)
        for x, X in zip(equations.integrated, scaled.integrated, strict=True)
    ]
    others = [(u, names[u], scaling.of(u)) for u in equations.inputs if u in names]
    return Step(
        "substitution",
        claims=claims,
        unclaimed="" if claims else "there is no state",
        rows=rows,
        others=others,
        beta=scaling.time_scale,
        inverse=1 / scaling.time_scale,
        slower=(scaling.time_scale - 1).is_positive,
        started=any(start != 0 for *_, start, _ in rows),
    )


def _row(each: Any, volts: Any, scaling: exact.Scaling) -> Step:
    """One equation: each coefficient by its rule, and what it becomes."""
    out, beta = scaling.of(each.variable), scaling.time_scale
    claims, rows = {}, []
    for i, ((term, a), (shown, value)) in enumerate(zip(each.terms.items(), volts.terms.items(), strict=True)):
        into = scaling.of(term)
        stated = (
            product(quotient(out, into), quotient(a, beta) if beta != 1 else a)
            if into != 1
            else (quotient(product(out, a), beta) if beta != 1 else product(out, a))
        )
        claims[f"coefficient{i}"] = Claim(stated, value, "a coefficient")
        rows.append((term, a, into, shown, value))
    return Step(
        "row",
        claims=claims,
        unclaimed="" if claims else "the right side is zero",
        static=isinstance(each, exact.Summed),
        x=each.variable,
        X=volts.variable,
        L=out,
        beta=beta,
        front=out / beta,
        constant=any(level == 1 for _, _, level, _, _ in rows),
        rows=rows,
        sum=written(volts.terms),
    )
