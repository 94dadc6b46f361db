"""Inverting stages of ideal operational amplifiers: inputs and feedback are resistors and capacitors, in cascade."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, ClassVar

from solver.jets import jet_symbol
from solver.lazy import sympy as sp
from solver.symbols import RESERVED
from solver.systems.kind import Component, Key, Keyed, Kind, MappingTo, OneOrMore, Reader, Value

if TYPE_CHECKING:
    from sympy import Expr, Symbol

KEY = "op_amp"
OUTPUT = "v_o"
"""The name of the output of the last stage."""
MOST_STAGES, MOST_INPUTS = 8, 12


@dataclass(frozen=True, slots=True)
class Part:
    """A resistor R or a capacitor C with its symbol and its value, the same where it has none of its own."""

    letter: str
    symbol: Symbol
    value: Expr


@dataclass(frozen=True, slots=True)
class Stage:
    """An inverting stage: `inputs` are signals by name with the part that leads from each to the minus input.

    `initial` is the output before t = 0, which a capacitor in the feedback holds; `output` is the name of the output.
    """

    inputs: tuple[tuple[str, Part], ...]
    feedback: Part
    initial: Expr
    output: str = OUTPUT


@dataclass(frozen=True)
class OpAmp:
    """The stages in cascade: the first input of each is the output of the stage before, others may be, too."""

    stages: tuple[Stage, ...]
    assumed: Mapping[str, Symbol] = field(default_factory=dict)
    discrete: bool = False
    sample_time: Expr | None = None

    is_linear: ClassVar[bool] = True
    states: ClassVar[tuple[str, ...]] = ()
    """Those of its circuit have their names there."""

    @property
    def kind(self) -> str:
        """The name of the kind that words it."""
        return KEY

    @property
    def outputs(self) -> tuple[str, ...]:
        """The names of the outputs of the stages."""
        return tuple(each.output for each in self.stages)

    @property
    def inputs(self) -> tuple[str, ...]:
        """The names of the signals that are given, in their order."""
        names = (name for each in self.stages for name, _ in each.inputs)
        return tuple(dict.fromkeys(name for name in names if name not in self.outputs))

    @property
    def parts(self) -> tuple[Part, ...]:
        """All resistors and capacitors, each once."""
        found = (part for each in self.stages for part in (*(part for _, part in each.inputs), each.feedback))
        return tuple(dict.fromkeys(found))

    @property
    def parameters(self) -> tuple[Symbol, ...]:
        """The free symbols of values and initial outputs, sorted by name."""
        values = [*(each.value for each in self.parts), *(each.initial for each in self.stages)]
        found: set[Any] = {symbol for value in values for symbol in value.free_symbols}
        return tuple(sorted(found, key=str))

    @property
    def provides(self) -> frozenset[str]:
        """The stages; "initial_state" tells that a state space made of them starts from somewhere."""
        held = ["initial_state"] if any(each.initial != 0 for each in self.stages) else []
        return frozenset({KEY, "inputs", *held})

    @property
    def described(self) -> str:
        """What it is given by, in words."""
        return "the system is given by stages of operational amplifiers"

    @property
    def rows(self) -> list[tuple[Any, ...]]:
        """The stages as a table: number, signal, part, feedback and output; the last two once in each stage."""
        return [
            (i, self.symbol(name), part, None if j else stage.feedback, None if j else self.symbol(stage.output))
            for i, stage in enumerate(self.stages, 1)
            for j, (name, part) in enumerate(stage.inputs)
        ]

    def symbol(self, name: str) -> Symbol:
        """Return the symbol of a signal: an input, or the output of a stage."""
        return jet_symbol((name, 0), assumed=self.assumed)

    def transform(self, name: str) -> Symbol:
        """Return the symbol of the Laplace transform of a signal."""
        return sp.Symbol(transform_name(name))

    def starting(self, initial: Expr) -> OpAmp:
        """Return the same stages with an initial output of the last one."""
        *before, last = self.stages
        return replace(self, stages=(*before, replace(last, initial=initial)))

    def size(self, of: str) -> int | None:
        """Return the number of inputs "m" or outputs "p"; that of states is not known yet."""
        return {"m": len(self.inputs), "p": 1}.get(of)

    def names(self, of: str) -> tuple[str, ...]:
        """Return the names of the "input"s and of the "output"."""
        return {"input": self.inputs, "output": (OUTPUT,)}.get(of, ())


def transform_name(name: str) -> str:
    """Return the name of a transform: V1 of v1."""
    return name[:1].upper() + name[1:]


def _read(reader: Reader) -> OpAmp:
    """Return the stages; the names of signals must not be names of anything else."""
    if reader.discrete:
        reader.complain(KEY, "an amplifier is a system in continuous time", at_key=True)
    stages = reader.each(KEY)
    if len(stages) > MOST_STAGES:
        reader.complain(KEY, f"at most {MOST_STAGES} stages can be read", at_key=True)
    read = [_stage(each) for each in stages]
    if reader.gives("initial_output") and stages:
        if stages[-1].gives("initial_output"):
            reader.complain("initial_output", "the initial output of the last stage is given twice")
        elif read[-1] is not None:
            read[-1] = replace(read[-1], initial=_initial(reader, read[-1].feedback))
    reader.conclude()
    found = tuple(_numbered([each for each in read if each is not None]))
    named = tuple(replace(each, output=name) for each, name in zip(found, _outputs(found), strict=True))
    joined = tuple(
        stage if i == 0 else replace(stage, inputs=((named[i - 1].output, stage.inputs[0][1]), *stage.inputs[1:]))
        for i, stage in enumerate(named)
    )
    system = OpAmp(joined)
    _check_names(stages, system)
    assumed = reader.assumed(system.inputs)
    reader.conclude()
    return replace(system, assumed=assumed)


def _stage(reader: Reader) -> Stage | None:
    """Return a stage without the name of its output; parts without a symbol have "R" or "C" for it."""
    inner = reader.within("inputs")
    if not inner.keys:
        reader.complain("inputs", "a stage needs an input, as {v1: R1}")
        return None
    if len(inner.keys) > MOST_INPUTS:
        reader.complain("inputs", f"at most {MOST_INPUTS} inputs can be read", at_key=True)
    inputs = [(name, _part(inner, key)) for key, name in inner.keys.items()]
    feedback = _part(reader, "feedback")
    if feedback is None or any(part is None for _, part in inputs):
        return None
    initial = _initial(reader, feedback)
    return Stage(tuple((name, part) for name, part in inputs if part is not None), feedback, initial)


def _part(reader: Reader, key: str) -> Part | None:
    read = reader.component(key)
    return None if read is None else Part(read[0], sp.Symbol(read[1] or read[0], real=True), read[2])


def _initial(reader: Reader, feedback: Part) -> Expr:
    """The output at the beginning, which only a capacitor in the feedback can hold."""
    value = reader.value("initial_output")
    if value is None:
        return sp.S.Zero
    if feedback.letter != "C" and value != 0:
        message = "only a capacitor in the feedback holds an initial output; without one the inputs determine it"
        reader.complain("initial_output", message)
    return value


def _numbered(stages: Sequence[Stage]) -> Iterator[Stage]:
    """Give the parts without a symbol one: R_1, R_2, C_f, and with the number of the stage where there are several."""
    taken = {str(x) for each in stages for part in (*dict(each.inputs).values(), each.feedback) for x in _own(part)}
    for i, stage in enumerate(stages, 1):
        mark = str(i) if len(stages) > 1 else ""
        inputs = []
        for j, (name, part) in enumerate(stage.inputs, 1):
            inputs.append((name, _called(part, f"{mark}{j}" if len(stage.inputs) > 1 or not mark else mark, taken)))
        yield replace(stage, inputs=tuple(inputs), feedback=_called(stage.feedback, f"f{mark}", taken))


def _own(part: Part) -> Iterable[Any]:
    return [part.symbol, *part.value.free_symbols]


def _called(part: Part, index: str, taken: set[str]) -> Part:
    if str(part.symbol) != part.letter or part.value == part.symbol:
        return part
    name = f"{part.letter}_{index}"
    while name in taken:
        name += "p"
    taken.add(name)
    return replace(part, symbol=sp.Symbol(name, real=True))


def _outputs(stages: Sequence[Stage]) -> Iterator[str]:
    """The names of outputs: as the next stage calls its first input, where that name is free, else v_o1, v_o2, ...."""
    taken = {OUTPUT, *(name for name, _ in stages[0].inputs)}
    for i, following in enumerate(stages[1:], 1):
        (name, _), *others = following.inputs
        taken |= {other for other, _ in others if other not in taken}
        chosen = f"{OUTPUT}{i}" if name in taken or name[:1].isupper() else name
        while chosen in taken:
            chosen += "p"
        taken.add(chosen)
        yield chosen
    yield OUTPUT


def _check_names(readers: Sequence[Reader], system: OpAmp) -> None:
    """Complain of signals whose name, or that of whose transform, stands for something else."""
    values = {str(x) for x in system.parameters} | {str(each.symbol) for each in system.parts}
    signals = {*system.inputs, *system.outputs}
    for i, reader in enumerate(readers):
        inner = reader.within("inputs")
        for j, (key, name) in enumerate(inner.keys.items()):
            if (name not in system.inputs and name != OUTPUT) or (i and not j):
                continue
            capital = transform_name(name)
            if name in RESERVED:
                inner.complain(key, f"'{name}' cannot be an input: it is a variable", at_key=True)
            elif name == OUTPUT:
                inner.complain(key, f"{OUTPUT} is the output; give the input another name", at_key=True)
            elif capital == name:
                message = f"the capital letter is that of the transform: call the signal {name[:1].lower()}{name[1:]}"
                inner.complain(key, message, at_key=True, like=[name[:1].lower() + name[1:]])
            elif name in values:
                inner.complain(key, f"{name} is an input and a value; give one of them another name", at_key=True)
            elif capital in values or capital in signals:
                inner.complain(key, f"{capital} would be the transform of {name} too; rename one of them", at_key=True)


_STAGE = Keyed("op_amp_stage", (
    Key("inputs", MappingTo(Component()), "signals with the part that leads from each to the minus input, as "
        "{v1: R1, v2: C2}; from the second stage on the first is the stage before", required=True),
    Key("feedback", Component(), "the part from the output to the minus input, as R_f or {C: 1e-6}", required=True),
    Key("initial_output", Value(), "the output before t = 0, where the feedback is a capacitor; 0 if absent"),
))  # fmt: skip

OP_AMP = Kind(
    KEY,
    doc="Inverting stages of ideal operational amplifiers, in cascade.",
    keys=(
        Key(KEY, OneOrMore(_STAGE), "inputs, feedback and initial output of a stage, or a list of stages",
            required=True),
        Key("initial_output", Value(), "that of the last stage"),
    ),
    read=_read,
    example=(
        ("op_amp: {inputs: {v1: R1, v2: R2}, feedback: R_f}", "parts are R.. or C.., or {R: 5000}, {C: 1e-6}"),
    ),
)  # fmt: skip
