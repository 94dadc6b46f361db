"""Lemma: the program step by step: the sign that each amplifier carries, the settings, the table to patch from."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product, quotient, total
from solver.stated.calculus import value_at
from solver.tasks.analog.machine_form import written
from solver.tasks.analog.patch_figures import drawn
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr

    from solver.tasks.analog.scaled_program import Machine

DIGITS = 15


@lemma("program")
def patched(found: exact.Synthesis, machine: Machine) -> Derivation[None]:
    """Signs, amplifiers, settings, and the table with the diagram."""
    yield _signs(found)
    yield _amplifiers(found, machine)
    yield _settings(found, machine)
    yield _table(found, machine)


def _signs(found: exact.Synthesis) -> Step:
    """Which variable each amplifier gives, and with which sign."""
    signs = found.signs
    return Step(
        "signs",
        unclaimed="a choice, which the simulation of the program confirms",
        carried=[(name, signs.of[x] * x) for x, name in found.amplifiers.items()],
        inverted=[(name, -signs.of.get(x, 1) * x) for x, name in found.inverters.items()],
        collected=[(name, x, found.amplifiers[x]) for x, name in found.collectors.items()],
        integrators=sum(row.initial is not None for row in found.rows),
        summers=sum(row.initial is None for row in found.rows),
        choices=signs.tried,
        exhaustive=signs.exhaustive,
    )


def _amplifiers(found: exact.Synthesis, machine: Machine) -> Step:
    """What each amplifier integrates or adds: minus the sum of what is there with its sign."""
    rows, claims = [], {}
    for i, row in enumerate(found.rows):
        sign = found.signs.of[row.variable]
        wires = [each for each in found.wires if each.variable == row.variable]
        direct = dict.fromkeys((each.term, each.sign) for each in wires if each.through is None)
        parts = [_part(abs(row.terms[term]), term, there) for term, there in direct]
        parts += _collected(row, [each for each in wires if each.through is not None])
        right = product(sp.S.NegativeOne, total(*parts) if len(parts) > 1 else parts[0]) if parts else sp.S.Zero
        claims[f"row{i}"] = Claim(product(sp.Integer(sign), written(row.terms)), right, "the inputs of an amplifier")
        rows.append((found.amplifiers[row.variable], sign * row.variable, row.initial, sign))
    summers = [(name, found.amplifiers[x]) for x, name in found.collectors.items()]
    return Step("amplifiers", claims=claims, rows=rows, beta=machine.beta, summers=summers)


def _part(size: Expr, term: Expr, sign: int) -> Any:
    """What an amplifier gets of a term that comes with that sign."""
    return sign * size if term == 1 else product(size, sign * term)


def _collected(row: exact.Row, wires: list[exact.Wire]) -> list[Any]:
    """What comes from the summer before an amplifier: its gain times minus the sum of what goes through."""
    if not wires:
        return []
    gain = wires[0].through
    terms = dict.fromkeys((each.term, each.sign) for each in wires)
    parts = [_part(abs(row.terms[term]) / gain, term, there) for term, there in terms]
    return [product(sp.S.NegativeOne, gain, total(*parts))]


def _settings(found: exact.Synthesis, machine: Machine) -> Step:
    """Each setting: coefficient × L_out/(L_in × gain × β)."""
    levels = _levels(machine)
    rows, direct, claims = [], [], {}
    made: dict[tuple[Any, Any], list[Expr]] = {}
    for wire in found.wires:
        before = made.setdefault((wire.variable, wire.term), [])
        if wire.pot:
            stated = _stated(wire, levels[wire.variable, wire.term], before, machine)
            claims[wire.pot] = Claim(stated, wire.setting, Phrase("the setting of {pot}", pot=wire.pot))
            rows.append((wire.pot, wire.origin, wire.into, wire.gain, wire.setting))
        else:
            direct.append((wire.origin, wire.into, wire.gain))
        before.append(wire.gain * wire.setting)
    shared = any(len(each) > 1 for each in made.values())
    unclaimed = "" if claims else "every coefficient is a gain of the machine"
    lines = [(f"P_{{{pot[1:]}}}", claim.left, claim.right) for pot, claim in claims.items()]
    return Step("settings", claims=claims, unclaimed=unclaimed, rows=rows, lines=lines, direct=direct, shared=shared,
                scaled=any(L != 1 for L in machine.scaling.factors.values()), beta=machine.beta,
                reference=machine.reference, sources=any(each.volts != 1 for each in found.wires),
                through=any(each.through not in (None, 1) for each in found.wires))  # fmt: skip


def _levels(machine: Machine) -> dict[tuple[Any, Any], tuple[Expr, Expr, Expr, bool]]:
    """For each term in volts: the coefficient that it comes from, L of the variable, L of the term, whether in time."""
    own: list[Any] = [*machine.equations.integrated, *machine.equations.summed]
    volts_of: list[Any] = [*machine.scaled.integrated, *machine.scaled.summed]
    return {
        (volts.variable, shown): (a, machine.scaling.of(each.variable), machine.scaling.of(term),
                                  isinstance(each, exact.Integrated))
        for each, volts in zip(own, volts_of, strict=True)
        for (term, a), shown in zip(each.terms.items(), volts.terms, strict=True)
    }  # fmt: skip


def _stated(wire: exact.Wire, levels: tuple[Expr, Expr, Expr, bool], before: list[Expr], machine: Machine) -> Any:
    """The formula of a setting; full inputs beside it are taken off first."""
    a, out, into, in_time = levels
    beta = machine.beta if in_time else sp.S.One
    below = [each for each in (into * wire.volts, wire.through or sp.S.One, beta) if each != 1]
    above = product(abs(a), out)
    if not before:
        return quotient(above, product(*below, wire.gain))
    whole = quotient(above, product(*below)) if below else above
    return quotient(difference(whole, sp.Add(*before)), wire.gain)


def _table(found: exact.Synthesis, machine: Machine) -> Step:
    """The elements as they are patched, and the diagram."""
    outputs = outputs_of(found, machine)
    rows = [
        (each if i == 0 else None, outputs.get(each.id), fed[0], fed[1] if each.is_amplifier else None)
        for each in found.program.elements
        for i, fed in enumerate(each.inputs or [("", None)])
    ]
    return Step(
        "program",
        unclaimed="the program is judged by its simulation",
        rows=rows,
        readout=[(sp.Symbol(name, real=True), of, factor) for name, (of, factor) in found.program.readout.items()],
        amplifiers=sum(each.is_amplifier for each in found.program.elements),
        figures=drawn("The program, to be patched", found.program, outputs),
    )


def outputs_of(found: exact.Synthesis, machine: Machine) -> dict[str, Expr]:
    """What each amplifier gives, in the variables of the question: -x'/25."""
    unscaled: dict[Any, Any] = {X: machine.scaling.of(x) * x for x, X in machine.named.items()}
    outputs = {name: found.signs.of[x] * unscaled.get(x, x) for x, name in found.amplifiers.items()}
    outputs |= {name: -found.signs.of.get(x, 1) * unscaled.get(x, x) for x, name in found.inverters.items()}
    for name in found.collectors.values():
        fed = [each.gain * each.setting * each.sign * each.term for each in found.wires if each.into == name]
        outputs[name] = -sp.Add(*fed).xreplace(unscaled)
    return outputs


@lemma("program")
def overload_of(equations: exact.MachineEquations, machine: Machine) -> Derivation[Expr | None]:
    """When a variable whose maximum is given exceeds it, from the exact solution; None if none does."""
    own = {x: value for x, value in machine.given.items() if x in {each.variable for each in equations.integrated}}
    if not own or machine.equations.inputs:
        return None
    found = exact.first_overload(equations, own)
    if found is None:
        return None
    x, time, motion = found
    t = sp.Symbol("t")
    at = sp.N(motion.xreplace({t: time}), 30)
    reached = own[x] if at > 0 else -own[x]
    yield Step(
        "overload",
        claims={"reached": Claim(value_at(motion, t, time), reached, "the maximum is reached")},
        x=x,
        maximum=own[x],
        motion=motion,
        time=time,
        decimal=None if time.is_Rational or time.is_Float else sp.N(time, DIGITS),
        amplifier_volts=machine.reference,
    )
    return time
