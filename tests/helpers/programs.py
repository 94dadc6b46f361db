"""Programs of an analog computer for tests: written by hand, and spoiled in each of their numbers."""

from collections.abc import Iterator
from dataclasses import replace

from sympy import Integer, Rational

from solver.patches import Element, Program

ONE, TEN = Integer(1), Integer(10)


def scaled_oscillator() -> Program:
    """x'' + 8x' + 25x = 500, x(0) = 40, x'(0) = 150 with x/5 and x'/25, as a course prints it."""
    return Program(
        TEN,
        (
            Element("U1", "source", value=TEN),
            Element("P1", "pot", (("A2", ONE),), setting=Rational(1, 2)),
            Element("P2", "pot", (("A3", ONE),), setting=Rational(1, 2)),
            Element("P3", "pot", (("A2", ONE),), setting=Rational(4, 5)),
            Element("P4", "pot", (("U1", ONE),), setting=Rational(1, 5)),
            Element("A1", "integrator", (("P1", TEN),), initial=Integer(8)),
            Element("A2", "integrator", (("P2", TEN), ("P3", TEN), ("P4", TEN)), initial=Integer(-6)),
            Element("A3", "inverter", (("A1", ONE),)),
        ),
        {"x": ("A1", Integer(5)), "x_dot": ("A2", Integer(-25))},
    )


def spoiled(program: Program) -> Iterator[tuple[str, Program]]:
    """Yield the program with one thing wrong, and what that is: each setting, gain, sign, voltage, factor, wire."""
    for i, each in enumerate(program.elements):

        def changed(wrong: Element, at: int = i) -> Program:
            return replace(program, elements=(*program.elements[:at], wrong, *program.elements[at + 1 :]))

        if each.kind == "pot":
            yield f"setting of {each.id}", changed(replace(each, setting=each.setting * Rational(49, 50)))
        if each.kind == "integrator":
            yield f"start of {each.id}", changed(replace(each, initial=each.initial + Rational(1, 10)))
            if each.initial:
                yield f"sign of the start of {each.id}", changed(replace(each, initial=-each.initial))
        if each.kind == "source" and not each.value.free_symbols:
            yield f"sign of {each.id}", changed(replace(each, value=-each.value))
        if each.kind == "inverter":
            yield f"{each.id} not inverting", changed(Element(each.id, "pot", each.inputs, setting=ONE))
        for j, (name, gain) in enumerate(each.inputs if each.kind in ("integrator", "summer") else ()):
            other = (*each.inputs[:j], (name, ONE if gain == TEN else TEN), *each.inputs[j + 1 :])
            yield f"gain of {each.id} for {name}", changed(replace(each, inputs=other))
            yield f"{each.id} without {name}", changed(replace(each, inputs=(*each.inputs[:j], *each.inputs[j + 1 :])))
    for name, (of, factor) in program.readout.items():
        for wrong in (-factor, factor * 2):
            yield f"readout of {name}", replace(program, readout={**program.readout, name: (of, wrong)})
