"""The glossary: names that mean the same in every problem, and the symbols of the field's quantities by notation.

Whoever treats a name by what it means takes it from here: the reader, which refuses it as a parameter; the printer,
which orders by it; the oracles, which choose points for it; marking, which reads it in answers.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType


@dataclass(frozen=True, slots=True)
class Variable:
    """A variable: its meaning in words, its `domain` ("complex", "real", "integer") and how terms are ordered by it.

    `order` is "polynomial" (by falling powers) or "time" (by rising powers, by decay). `time` tells the kind of systems
    that it belongs to ("continuous", "discrete", "any"), `counterpart` the variable that takes its place in the other.
    One that is not `reserved` is used on pages only: problems may have a parameter of that name.
    """

    name: str
    meaning: str
    domain: str
    order: str
    time: str = "any"
    counterpart: str = ""
    reserved: bool = True


@dataclass(frozen=True, slots=True)
class Quantity:
    """A quantity of the field: its symbol as LaTeX in the notation of the course, and in others where it differs."""

    name: str
    symbol: str
    others: Mapping[str, str] = field(default_factory=lambda: MappingProxyType({}))


VARIABLES = (
    Variable("s", "s is the variable of the Laplace transform", "complex", "polynomial", "continuous", "z"),
    Variable("z", "z is the variable of the z-transform", "complex", "polynomial", "discrete", "s"),
    Variable("t", "t is the time", "real", "time", "continuous", "k"),
    Variable("k", "k counts the samples in discrete time", "integer", "time", "discrete", "t"),
    Variable("lamda", "λ stands for eigenvalues", "complex", "polynomial"),
    Variable("tau", "τ is the time that is integrated over", "real", "time", reserved=False),
)

QUANTITIES = (
    Quantity("x", "x"),
    Quantity("xdot", r"\dot{x}"),
    Quantity("u", "u"),
    Quantity("y", "y"),
    Quantity("A", "A"),
    Quantity("B", "B"),
    Quantity("C", "C"),
    Quantity("D", "D"),
    Quantity("Phi", r"\Phi(t)"),
    Quantity("omega_n", r"\omega_n"),
    Quantity("overshoot", "M_p"),
    Quantity("settling_time", "t_s"),
    Quantity("rise_time", "t_r"),
    Quantity("peak_time", "t_p"),
    Quantity("P", "P"),
    Quantity("Q", "Q"),
    Quantity("R", "R"),
    Quantity("K", "K_f", {"ogata": "K"}),
    Quantity("L", "L_c", {"ogata": "K_e"}),
    Quantity("controllability_matrix", r"\mathcal{C}_o", {"ogata": "M"}),
    Quantity("observability_matrix", r"\mathcal{O}_v", {"ogata": "N"}),
    Quantity("hidden_states", "N", {"ogata": "Z"}),
    Quantity("damping_ratio", r"\xi", {"ogata": r"\zeta"}),
    Quantity("integrator", r"\xi"),
)

RESERVED = frozenset(each.name for each in VARIABLES if each.reserved)
"""Names whose meaning is fixed."""

SAMPLES = {"k": next(each.meaning for each in VARIABLES if each.name == "k")}
"""What is reserved in discrete time only: k is a usual name of a spring's stiffness."""

MEANINGS = {each.name: each.meaning for each in VARIABLES if each.reserved and each.name not in SAMPLES}
"""Names that cannot be parameters in any problem, since answers are written in them, and why."""

COMPLEX = frozenset(each.name for each in VARIABLES if each.domain == "complex")
CONTINUOUS = COMPLEX | {each.name for each in VARIABLES if each.reserved and each.domain == "real"}
"""Variables that vary in the plane, and those that never stand for a whole number."""

POLYNOMIAL = frozenset(each.name for each in VARIABLES if each.order == "polynomial")
TIME = frozenset(each.name for each in VARIABLES if each.order == "time")
"""Variables of polynomials and transfer functions, and of functions of time."""

OTHER_TIME = {
    discrete: {each.name: each.counterpart for each in VARIABLES if each.time == kind}
    for discrete, kind in ((True, "continuous"), (False, "discrete"))
}
"""By whether time is discrete: variables of the other kind of time, and the ones that take their place."""

COURSE = "course"
NOTATIONS: Mapping[str, Mapping[str, str]] = {
    notation: {each.name: each.others.get(notation, each.symbol) for each in QUANTITIES}
    for notation in (COURSE, *sorted({name for each in QUANTITIES for name in each.others}))
}
"""The symbols of the quantities by the name of the notation."""
