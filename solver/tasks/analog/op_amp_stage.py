"""Inverting stages of ideal operational amplifiers: the output by the virtual ground and the current law."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import (
    AnswerName,
    Answers,
    Check,
    Claim,
    Derivation,
    Given,
    Options,
    Step,
    Task,
    Unsolved,
    option,
)
from solver.derivation.answer_names import SignalNames
from solver.lazy import exact, numeric, systems
from solver.lazy import sympy as sp
from solver.numeric.judges import analog as judges
from solver.options.expression import Expression
from solver.tasks.analog import stage_mistakes
from solver.tasks.analog.stage_figures import schematic_of
from solver.tasks.analog.stage_formulas import UNITS, StageFormulas, sum_of
from solver.words import Phrase, Reason, formula

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import OpAmp, System


@dataclass(frozen=True, kw_only=True)
class OpAmpStageOptions(Options):
    """What the last stage holds."""

    initial_output: Expr | None = option(
        Expression(), "the output of the last stage before t = 0, where its feedback is a capacitor"
    )


def signals_of(given: Given[OpAmp, OpAmpStageOptions]) -> SignalNames:
    """The inputs, and what the output is before t = 0."""
    system = stages_of(given)
    return SignalNames(system.inputs, output=system.outputs[-1], held=system.stages[-1].initial)


def transforms_of(given: Given[OpAmp, OpAmpStageOptions]) -> SignalNames:
    """The transforms of the inputs."""
    system = stages_of(given)
    names = tuple(str(system.transform(name)) for name in system.inputs)
    return SignalNames(names, of_time=False, output=system.outputs[-1], held=system.stages[-1].initial)


op_amp_stage: Task[OpAmp, OpAmpStageOptions] = Task(
    "op_amp_stage",
    title="Operational-amplifier stage",
    doc="The output of inverting stages of ideal operational amplifiers, in time and transformed.",
    needs=("op_amp",),
    options=OpAmpStageOptions,
    example={"op_amp": "{inputs: {v1: R1, v2: R2}, feedback: R_f}"},
    answers=[
        AnswerName("v_o", "v_o", "the output in time",
                   principal=True, earned=("balance", "integrated", "solved", "cascade"), signals=signals_of),
        AnswerName("V_o", "V_o", "the Laplace transform of the output",
                   principal=True, earned=("transformed", "cascade"), signals=transforms_of),
    ],
)  # fmt: skip
stage_mistakes.register(op_amp_stage)


@op_amp_stage.refusal
def only_a_capacitor_holds(system: System, options: OpAmpStageOptions) -> Iterable[tuple[str, Reason]]:
    """An initial output that nothing holds, or one that is given twice."""
    if not isinstance(system, systems.OpAmp):
        return
    initial, last = options.initial_output, system.stages[-1]
    if initial is None or initial == 0:
        return
    if last.feedback.letter != "C":
        yield "initial_output", Reason("op_amp_stage/nothing_holds")
    elif last.initial not in (0, initial):
        yield "initial_output", Reason("op_amp_stage/two_initial_outputs")


def stages_of(given: Given[OpAmp, OpAmpStageOptions]) -> OpAmp:
    """The stages, with the initial output of the option."""
    initial = given.options.initial_output
    return given.system if initial is None else given.system.starting(initial)


@op_amp_stage.method(source="Chua, Desoer and Kuh, Linear and Nonlinear Circuits, chapter 4")
def by_virtual_ground(given: Given[OpAmp, OpAmpStageOptions]) -> Derivation[Answers]:
    """The currents into the minus input add up to zero; solved for the output, in time and transformed."""
    system = stages_of(given)
    several = len(system.stages) > 1
    try:
        responses = exact.cascade_responses(system.stages)
    except exact.ImpulseAtStartError:
        raise Unsolved("op_amp_stage/impulse") from None
    yield Step("virtual_ground", unclaimed="what an ideal amplifier does", several=several,
               inputs=len(system.inputs), figures=schematic_of(system))  # fmt: skip
    starts = {name: each.start for name, each in zip(system.outputs, responses, strict=True)}
    stages = [StageFormulas(system, each, i if several else 0, starts) for i, each in enumerate(system.stages, 1)]
    told: set[str] = set()
    for stage in stages:
        yield from _in_time(stage, told)
    for stage in stages:
        yield _transformed(stage)
    found = responses[-1]
    answers = Answers(
        v_o=found.in_time({name: system.symbol(name) for name in system.inputs}),
        V_o=found.transform({name: system.transform(name) for name in system.inputs}),
    )
    if several:
        yield from _cascade(system, stages, responses)
        yield Step("output", unclaimed="the transform, read back", v_o=answers["v_o"], V_o=answers["V_o"],
                   powers=sorted({k for powers in found.terms.values() for k in powers}))  # fmt: skip
    return answers


def _in_time(stage: StageFormulas, told: set[str]) -> Derivation[None]:
    """The currents, their sum, and the output of one stage; units that were `told` are not told again."""
    currents = list(stage.currents())
    named: dict[str, Any] = {"number": stage.number, "name": stage.system.symbol(stage.stage.output)}
    yield Step("currents", unclaimed="the laws of the elements", currents=currents,
               capacitors=any(part.letter == "C" for part in stage.parts), **named)  # fmt: skip
    balance = Claim(sum_of([law for _, law in currents]), sp.S.Zero, "the current law at the minus input")
    yield Step("balance", claims={"balance": balance}, indices=[index for index, _ in currents], **named)
    if stage.stage.feedback.letter == "C":
        charges = Claim(stage.integrated(), sp.S.Zero, "the current law, integrated")
        yield Step("integrated", claims={"charges": charges}, initial=stage.stage.initial,
                   passing=any(part.letter == "C" for _, part in stage.stage.inputs), **named)  # fmt: skip
    if stage.numeric:
        yield _numbers(stage, told)
    solved = Claim(stage.in_time(), stage.output, "the output of the stage")
    yield Step("solved", claims={"solved": solved}, numeric=stage.numeric, **named)


def _numbers(stage: StageFormulas, told: set[str]) -> Step:
    """What stands before each input, with the numbers put in, and its unit."""
    rows, claims = [], {}
    gains = exact.stage_gains(stage.stage)
    for (name, part), (gain, _) in zip(stage.stage.inputs, gains, strict=True):
        says = Phrase("the factor of ${v}$", v=formula(stage.system.symbol(name)))
        claims[f"gain_{name}"] = Claim(stage.gain(part), gain, says)
        claims[f"numbers_{name}"] = Claim(stage.gain(part, numbers=True), gain, says)
        rows.append((claims[f"gain_{name}"], claims[f"numbers_{name}"]))
    units = [UNITS[part.letter + stage.stage.feedback.letter] for _, part in stage.stage.inputs]
    new = [unit for unit in dict.fromkeys(units) if unit not in told]
    told |= set(units)
    return Step("numbers", claims=claims, rows=rows, units=new, number=stage.number)


def _transformed(stage: StageFormulas) -> Step:
    """The stage by its impedances."""
    claims = {
        "ratio": Claim(stage.by_impedances(), stage.transformed, "the output by impedances"),
        "transformed": Claim(stage.in_s(), stage.transformed, "the transform of the output"),
    }
    return Step("transformed", claims=claims, impedances=list(stage.impedances()), number=stage.number,
                initial=stage.stage.initial, static=stage.static, numeric=stage.numeric,
                name=stage.system.transform(stage.stage.output))  # fmt: skip


def _cascade(
    system: OpAmp, stages: list[StageFormulas], responses: tuple[exact.StageResponse, ...]
) -> Derivation[None]:
    """The outputs put into the following stages one after the other."""
    names = {name: system.transform(name) for name in system.inputs}
    found = {each: response.transform(names) for each, response in zip(system.outputs, responses, strict=True)}
    for stage in stages[1:]:
        here = found[stage.stage.output]
        put = Claim(stage.in_s(found), here, Phrase("the output of stage {i}", i=stage.number))
        inside = [system.transform(name) for name, _ in stage.stage.inputs if name in found]
        yield Step("cascade", claims={"put": put}, number=stage.number, inside=inside,
                   name=system.transform(stage.stage.output))  # fmt: skip


NODAL = "numpy.linalg.solve, nodal equations"
SERIES = "numpy.polynomial, current law along random signals"
EXACT = 1e-10
"""What doubles leave of both."""


@op_amp_stage.verification("V_o")
def solves_the_nodal_equations(given: Given[OpAmp, OpAmpStageOptions], answers: Answers) -> Iterable[Check]:
    """At random s the output is that of the nodal equations with every minus input at zero volts."""
    system, found = stages_of(given), answers["V_o"]
    near = 1e-6 if numeric.holds_decimals([found, *system.parameters]) else EXACT
    label = "the nodal equations at random $s$"
    yield numeric.check_residual(label, NODAL, lambda: judges.transform_residual(system, found), near, answer="V_o")


@op_amp_stage.verification("v_o")
def follows_from_the_currents(given: Given[OpAmp, OpAmpStageOptions], answers: Answers) -> Iterable[Check]:
    """Along random signals the output is what the currents into the minus inputs make of it."""
    system, found = stages_of(given), answers["v_o"]
    near = 1e-6 if numeric.holds_decimals(found) else EXACT
    label = "the currents into the minus inputs along random signals"
    yield numeric.check_residual(label, SERIES, lambda: judges.output_residual(system, found), near, answer="v_o")
