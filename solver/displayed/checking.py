"""The checks of all that a part displays, and the status that they give it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import replace
from typing import Any

import sympy as sp

from solver.derivation import Check, CheckStatus, PartResult, Status, Step
from solver.derivation.displayed import STANDS, Written
from solver.displayed.judging import Judge
from solver.displayed.names import VARIABLES, Names
from solver.displayed.sides import frozen, listed
from solver.displayed.statements import Chain, chains_in, chains_of, name_in
from solver.displayed.unknowns import Unknowns
from solver.engine import verdict
from solver.lazy import numeric
from solver.problem.model import Part
from solver.render.wording import WordedStep, Wording
from solver.symbols import COURSE, NOTATIONS
from solver.systems import DeadTime, StateSpace, TransferFunction
from solver.systems.loops import Loop
from solver.tasks import catalogue
from solver.words import Phrase

OPTIONS = {"gain": "K"}
"""Options whose quantity has another name."""


def judged(result: PartResult, part: Part, worded: Sequence[WordedStep], wording: Wording) -> PartResult:
    """Return a result with the checks of all that its steps display in these words, and the status they give it."""
    declared = catalogue()[result.task].answers
    symbols = {name: wording.symbol(declared[name]) for name in result.answers}
    free = {name for name in result.answers if declared[name].free}
    checks = displayed_checks(result, worded, part, symbols, free, wording.notation)
    if not checks:
        return result
    claims = tuple(check for check in result.checks if check.step)
    every = (*claims, *checks, *(check for check in result.checks if not check.step))
    if result.status is Status.UNSOLVED and all(check.status is not CheckStatus.FAILED for check in checks):
        return replace(result, checks=every)
    status, reason = verdict(every, result.answers)
    return replace(result, checks=every, status=status, reason=reason)


def displayed_checks(
    result: PartResult,
    worded: Sequence[WordedStep],
    part: Part,
    symbols: Mapping[str, str],
    free: AbstractSet[str] = frozenset(),
    notation: str = COURSE,
) -> tuple[Check, ...]:
    """Return the checks of all equalities that the steps of a part display, beyond those of their claims.

    `symbols` are the LaTeX symbols of the answers by name; `free` names those with many right values (the matrices of
    a realization), whose symbols may stand for others on the way, as long as the answer is what is displayed last.
    """
    names = Names()
    _give(names, part, NOTATIONS[notation])
    of_system = _symbols(value for known in names.fixed.values() for value in known) | {*part.system.parameters}
    last = _displayed_last(worded)
    open_names = frozenset(
        symbols[each]
        for each in free & result.answers.keys()
        if last.get(symbols[each]) == result.answers[each] or _is_empty(result.answers[each])
    )
    given = of_system | _symbols(part.options.values())
    for answer, symbol in symbols.items():
        if answer in result.answers and symbol:
            _fix(names, symbol, result.answers[answer])
    answered = _symbols(result.answers.values())
    weights = _taken_as_positive(result.steps, given)
    given, of_system = given | weights, of_system | weights
    own = {symbol.name for symbol in of_system}  # C may be a capacitance beside the matrix
    matrices = {
        name: frozen(found[0])
        for name, found in names.fixed.items()
        if isinstance(found[0], sp.MatrixBase) and name not in own
    }
    variables = frozenset(VARIABLES.values())
    for own_variable in given - variables:
        if own_variable.name in VARIABLES:  # in continuous time k is a parameter like any other
            names.fixed.setdefault(own_variable.name, []).append(own_variable)
    of_system |= variables
    unknowns = Unknowns(given | variables, answered, of_system)
    judge = Judge(names, unknowns, numeric.Environments(), open_names, matrices)
    _go_through(judge, worded, given | answered, result.steps)
    return tuple(judge.checks)


def _go_through(
    judge: Judge, worded: Sequence[WordedStep], parameters: AbstractSet[Any], all_steps: Sequence[Step]
) -> None:
    """Let the judge see the displays of the steps in the order of reading; they are numbered among all of the part."""
    for place, step in enumerate(worded, start=1):
        number = all_steps.index(step.step) + 1 if step.step in all_steps else place
        for each in step.walk():
            judge.begin(number, Phrase("equality displayed in “{title}”", title=each.title))
            for claim in each.step.claims.values():
                judge.claimed(frozen(claim.left), frozen(claim.right))
            for displayed in each.displayed:
                if displayed.relation == STANDS:
                    judge.stands(*displayed.sides)
                    continue
                chains = chains_of(displayed, parameters)
                for chain in chains * min(len(chains), 2):  # what is explained behind an equation may stand in it
                    _judge(judge, chain)
    judge.finish()


def _judge(judge: Judge, chain: Chain) -> None:
    """Judge a chain; whatever a template may write, the page is not lost."""
    try:
        judge.chain(chain)
    except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError, RecursionError) as error:
        judge.skip(Phrase("the judge cannot deal with it ({error})", error=type(error).__name__))


def _displayed_last(worded: Sequence[WordedStep]) -> dict[str | None, Any]:
    """Return the value displayed last for each name, as it is written."""
    return {
        name.latex: value
        for step in worded
        for each in step.walk()
        for displayed in each.displayed
        if len(displayed.sides) == 2 and displayed.relation != STANDS
        for name, value in [displayed.sides]
        if isinstance(name, Written) and not isinstance(value, Written)
    }


def _taken_as_positive(steps: Iterable[Step], given: AbstractSet[Any]) -> frozenset[Any]:
    """The symbols that stand in the steps for those given, as positive ones (weights)."""
    names = {symbol.name for symbol in given}
    if not names:
        return frozenset()
    claims = (claim for first in steps for step in first.walk() for claim in step.claims.values())
    met = _symbols(side for claim in claims for side in (claim.left, claim.right))
    return frozenset(symbol for symbol in met if symbol.is_positive and symbol.name in names)


def _is_empty(value: Any) -> bool:
    """Whether a value is a matrix without entries, which no step displays."""
    return isinstance(value, sp.MatrixBase) and 0 in value.shape


def _symbols(values: Iterable[Any]) -> frozenset[Any]:
    """Return the symbols in some values, lists among them, without those that are variables anyway."""
    found = frozenset().union(*map(numeric.free_symbols, values))
    return frozenset(found - set(VARIABLES.values()))


def _give(names: Names, part: Part, quantities: Mapping[str, str]) -> None:
    """Let A, B, C, D, or G, stand for what is given, and Q, R, T, K_f, M_p for the options that they are symbols of."""
    system = part.system.plant if isinstance(part.system, Loop) else part.system
    if isinstance(system, StateSpace):
        given = {"A": system.A, "B": system.B, "C": system.C, "D": system.D}
        names.fixed.update({name: [value] for name, value in given.items() if value is not None})
    elif isinstance(system, TransferFunction | DeadTime):
        value = system.matrix[0] if system.matrix.shape == (1, 1) else system.matrix
        _fix(names, f"G({system.variable.name})", value)
    for name, value in part.options.items():
        if len(name) == 1 and isinstance(value, sp.MatrixBase):
            names.fixed[name] = [value]
        elif isinstance(value, sp.MatrixBase | sp.Expr) and (symbol := quantities.get(OPTIONS.get(name, name))):
            _fix(names, symbol, value)


def _fix(names: Names, symbol: str, value: Any) -> None:
    """Let a symbol stand for a value in the whole part."""
    found = chains_in(symbol)
    meaning = found[0].sides[0].meaning if found and len(found[0].sides) == 1 else None
    if meaning is None or listed(value) or not (key := name_in(meaning)) or key in VARIABLES:
        return
    names.fixed.setdefault(key, []).append(value)
    if meaning.kind == "apply" and meaning.parts[1].text in VARIABLES:
        names.found[f"{meaning.text}()"] = (value, VARIABLES[meaning.parts[1].text])
