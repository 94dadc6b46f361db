"""What is asked of a response: a system, an initial state and inputs, and what the kernels find for them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

from solver.derivation import Given
from solver.lazy import exact, systems
from solver.lazy import sympy as sp

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

    from solver.systems import DeadTime, LateInput, StateSpace, TransferFunction
    from solver.tasks.time_response.response import ResponseOptions

    Moving = StateSpace | LateInput | TransferFunction | DeadTime


@dataclass(frozen=True)
class Question:
    """What is asked: the response of a system to an initial state (None: zero) and to inputs (none: no input).

    Where a transfer function is given, `transfer` is it, without its dead time (`late`: it has one); then `system`
    serves the kernels only, and its states are no part of the question.
    """

    system: StateSpace
    x0: ImmutableMatrix | None
    inputs: tuple[Expr, ...]
    kind: str
    transfer: TransferFunction | None = None
    late: bool = False

    @staticmethod
    def of(given: Given[Moving, ResponseOptions]) -> Question:
        """The question of a part: the initial state is the option, or else the system's; late inputs are delayed."""
        system: Any = given.system
        delay, transfer = sp.S.Zero, None
        if isinstance(system, systems.LateInput):
            system, delay = system.plant, system.delay
        elif isinstance(system, systems.DeadTime):
            system, delay = system.rational, system.delay
        if isinstance(system, systems.TransferFunction):
            transfer, system = system, _behind(system)
        x0 = given.options.initial_state if given.options.initial_state is not None else system.x0
        if given.options.kind == "zero_state" or (
            x0 is not None and x0.is_zero_matrix and given.options.kind != "zero_input"
        ):
            x0 = None
        inputs = () if given.options.kind == "zero_input" else given.options.input or ()
        t = sp.Symbol("k" if system.discrete else "t")
        late = tuple(exact.later(u, t, delay) for u in inputs)
        return Question(system, x0, late, given.options.kind, transfer, delay != 0)

    @property
    def discrete(self) -> bool:
        """Whether time is discrete."""
        return self.system.discrete

    @cached_property
    def time(self) -> Symbol:
        """The symbol t, or k."""
        return sp.Symbol("k" if self.discrete else "t")

    @cached_property
    def variable(self) -> Symbol:
        """The symbol s, or z."""
        return sp.Symbol("z" if self.discrete else "s")

    @cached_property
    def pieces(self) -> tuple[exact.Piece, ...]:
        """What begins in the inputs, time by time; of inputs that are zero one piece, unless an initial state moves."""
        found = exact.read_inputs(self.inputs, self.time, discrete=self.discrete) if self.inputs else ()
        return tuple(filter(None, found)) or (found if self.x0 is None else ())

    @cached_property
    def answer(self) -> exact.ClosedForm:
        """The response in closed form."""
        return exact.response(self.system, self.x0, self.inputs, self.time)

    @cached_property
    def zero_input(self) -> exact.RationalMatrix:
        """The transform of the zero-input response of the states (in discrete time divided by z)."""
        return exact.piece_response(self.system, self.x0, None).x

    def zero_state(self, piece: exact.Piece) -> exact.RationalMatrix:
        """The transform of what a piece of the inputs adds to the states, from the start of the piece."""
        return exact.piece_response(self.system, None, piece).x

    def output(self, piece: exact.Piece) -> exact.RationalMatrix:
        """The transform of what a piece of the inputs adds to the outputs, from its start, without impulses in y."""
        image = exact.piece_response(self.system, None, piece).y
        assert image is not None  # noqa: S101 - asked where there is C
        return image

    def function(self, image: exact.RationalMatrix) -> ImmutableMatrix:
        """The function of time that has an image."""
        f: ImmutableMatrix = image.function(self.time, discrete=self.discrete).matrix
        return f

    def begun(self, f: ImmutableMatrix, delay: Any) -> ImmutableMatrix:
        """A function of the time since a delay, as one of time."""
        found: ImmutableMatrix = exact.shifted(f, self.time, delay, discrete=self.discrete)
        return found

    def pencil(self) -> ImmutableMatrix:
        """The matrix sI − A (zI − A)."""
        return exact.pencil(self.system.A, self.variable)


def _behind(G: TransferFunction) -> StateSpace:
    """A realization of G, nothing cancelled."""
    form = exact.controllable_realization(exact.transfer_matrix_of_fractions(G.numerators, G.denominators, G.variable))
    return systems.StateSpace(form.A, form.B, form.C, form.D, None, G.discrete, G.sample_time)


def entry_or_column(column: ImmutableMatrix) -> Any:
    """Return the entry of a 1×1 matrix, any other as it is."""
    return column[0] if len(column) == 1 else column
