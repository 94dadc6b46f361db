"""Stages of operational amplifiers: the current law at each minus input, in transforms."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import sympy as sp

from solver.derivation import Check, Claim
from solver.stated.algebra import product, total

S = sp.Symbol("s")


def _transform(response: Any) -> Any:
    """What a response stands for, each signal by a symbol of its own."""
    signals = (c * S**k * _signal(name) for name, powers in response.terms.items() for k, c in powers.items())
    return sp.Add(*signals, *(c * S**k for k, c in response.held.items()))


def _signal(name: str) -> Any:
    return sp.Symbol(f"signal_{name}")


def _admittance(part: Any) -> Any:
    return 1 / part.value if part.letter == "R" else S * part.value


def _balance(stage: Any, output: Any, arriving: Mapping[str, Any], starts: Mapping[str, Any]) -> Claim:
    """Σ Y V + Y_f V_o is what capacitors hold: C v(0−) each."""
    terms, held = [], []
    for name, part in stage.inputs:
        terms.append(product(_admittance(part), arriving.get(name, _signal(name))))
        held.append(part.value * starts.get(name, 0) if part.letter == "C" else sp.S.Zero)
    held.append(stage.feedback.value * stage.initial if stage.feedback.letter == "C" else sp.S.Zero)
    return Claim(total(*terms, product(_admittance(stage.feedback), output)), sp.Add(*held), "the current law")


def of_stage_response(
    found: Any, stage: Any, signals: Mapping[str, Any], starts: Mapping[str, Any] | None = None
) -> Iterator[Claim]:
    """The current law at the minus input holds."""
    arriving = {name: _transform(each) for name, each in signals.items()}
    before = {**(starts or {}), **{name: each.start for name, each in signals.items()}}
    yield _balance(stage, _transform(found), arriving, before)


def of_cascade_responses(found: Sequence[Any], stages: Sequence[Any]) -> Iterator[Claim]:
    """The current law holds at the minus input of each stage."""
    outputs = {stage.output: each for stage, each in zip(stages, found, strict=True)}
    arriving = {name: _transform(each) for name, each in outputs.items()}
    before = {name: each.start for name, each in outputs.items()}
    for stage in stages:
        yield _balance(stage, arriving[stage.output], arriving, before)
    for stage, each in zip(stages, found, strict=True):
        if stage.feedback.letter == "C":
            yield Claim(each.start, stage.initial, "the output before the beginning")
        else:
            still = [before[name] / part.value for name, part in stage.inputs if part.letter == "R" and name in before]
            yield Claim(
                total(*still, each.start / stage.feedback.value), sp.S.Zero, "the currents before the beginning"
            )


def of_stage_gains(found: Sequence[tuple[Any, int]], stage: Any) -> Iterator[Claim | Check]:
    """Z_f/Z = c sᵏ for each input."""
    yield Check.that("a factor for each input", "counted", len(found) == len(stage.inputs))
    for (gain, power), (_, part) in zip(found, stage.inputs, strict=True):
        yield Claim(product(gain, S**power, _admittance(stage.feedback)), _admittance(part), "a quotient of impedances")
