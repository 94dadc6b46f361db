"""Lemma: the path from the input to the output, one transfer function in lowest terms, a dead time apart from it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeVar

from solver.arithmetic.roots import roots_found
from solver.derivation import Claim, Derivation, Given, Step, Unsolved, lemma
from solver.lazy import exact, systems
from solver.lazy import sympy as sp
from solver.numeric.judges import representation as judges
from solver.stated.algebra import quotient
from solver.tasks.representation.lowest_terms import from_roots
from solver.tasks.representation.plants import matrices_of, stated_matrix
from solver.tasks.time_response.dead_time import dead_time_apart

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.systems import DeadTime, StateSpace, TransferFunction

    Plant = StateSpace | TransferFunction | DeadTime

R = TypeVar("R")


@dataclass(frozen=True)
class Path:
    """G = e^{−Ts} N/D: N/D in lowest terms, `given` before anything is cancelled; D is monic, T = `delay`."""

    fraction: exact.TransferMatrix
    given: TransferFunction
    delay: Expr
    cancels: bool

    @property
    def variable(self) -> Symbol:
        """The symbol s (discrete: z)."""
        return self.fraction.variable

    @property
    def discrete(self) -> bool:
        """Whether time is discrete."""
        return self.given.discrete

    @property
    def rest(self) -> Expr:
        """Where the variable is for what is constant: s = 0, z = 1."""
        return sp.Integer(1 if self.discrete else 0)

    @property
    def top(self) -> Expr:
        """N."""
        return self.fraction.numerators[0][0]

    @property
    def bottom(self) -> Expr:
        """D."""
        return self.fraction.denominators[0][0]

    @property
    def shown(self) -> tuple[Expr, Expr]:
        """N and D as they were given where nothing cancels, with any leading coefficients."""
        if self.cancels:
            return self.top, self.bottom
        return self.given.numerators[0][0], self.given.denominators[0][0]

    @property
    def name(self) -> str:
        """What N/D is called: G, where there is a dead time beside it G₀."""
        return "G_{0}" if self.delay != 0 else "G"

    @property
    def parameters(self) -> tuple[Symbol, ...]:
        """The parameters, sorted by name."""
        symbols: set[Any] = {*self.given.parameters, *self.delay.free_symbols}
        return tuple(sorted(symbols, key=str))


@lemma("paths")
def path_of(given: Given[Plant, Any]) -> Derivation[Path]:
    """N/D in lowest terms, what cancels named; raises Unsolved where there are several inputs or outputs."""
    plant: Any = given.system
    if isinstance(plant, systems.LateLoop):
        raise Unsolved("conversions/dead_time_in_a_loop", closed=True)
    delay = sp.Integer(0)
    if isinstance(plant, systems.DeadTime):
        yield from dead_time_apart(plant)
        plant, delay = plant.rational, plant.delay
    G: TransferFunction = plant
    if G.matrix.shape != (1, 1):
        raise Unsolved("paths/several_channels", p=G.size("p"), m=G.size("m"))
    whole = exact.transfer_matrix_of_fractions(G.numerators, G.denominators, G.variable)
    lowest = whole.reduced
    cancels = whole.cancelled_polynomial.degree() > 0
    if cancels:
        claim = Claim(
            quotient(G.numerators[0][0], G.denominators[0][0]), lowest.matrix[0, 0], "lowest terms of the fraction"
        )
        factored = quotient(whole.numerator_factored, whole.chi_factored) if whole.matrix[0, 0] != 0 else None
        yield Step("cancelled", claims={"lowest": claim}, x=G.variable, common=whole.cancelled_factored,
                   modes=whole.cancelled, factored=factored, late=delay != 0)  # fmt: skip
    return Path(lowest, G, delay, cancels)


@lemma("paths")
def poles_of(path: Path) -> Derivation[list[Expr]]:
    """The poles with multiplicity, of a fraction in lowest terms; raises Unsolved where they have no usable form."""
    x, poles = path.variable, path.fraction.poles
    if poles is None:
        raise Unsolved("paths/no_roots", polynomial=path.bottom)
    if not poles:
        raise Unsolved("paths/no_poles")
    claims = {"roots": Claim(path.bottom, from_roots(x, poles), "poles")}
    factors = exact.pole_factors(path.fraction)
    if factors != path.bottom:
        claims["factors"] = Claim(path.bottom, factors, "factors of the denominator")
    yield Step("poles", claims=claims, steps=roots_found(path.bottom, poles, x), x=x, poles=poles, bottom=path.bottom,
               lead=path.shown[1] != path.bottom)  # fmt: skip
    return poles


def quietly(derivation: Derivation[R]) -> R:
    """What a derivation returns, without its steps; raises what it raises."""
    while True:
        try:
            next(derivation)
        except StopIteration as end:
            found: R = end.value
            return found


def rational_plant(plant: Plant) -> StateSpace | TransferFunction:
    """What is beside the dead time."""
    return plant.rational if isinstance(plant, systems.DeadTime) else plant


def numbers_of(plant: Plant) -> Any:
    """The rational factor as matrices A, B, C, D for the oracles."""
    rational = rational_plant(plant)
    if isinstance(rational, systems.TransferFunction):
        return judges.realized(rational.numerators, rational.denominators, rational.variable)
    return matrices_of(rational)


def stated_path(plant: Any) -> Any:
    """G as the problem states it, a formula (1×1); T of a loop round a dead time."""
    if isinstance(plant, systems.LateLoop):
        late: Any = plant.plant
        path = plant.controller * late.uncancelled
        return sp.ImmutableMatrix([[path / (1 + path * plant.feedback)]])
    stated = stated_matrix(rational_plant(plant))
    return sp.ImmutableMatrix(stated * plant.factor) if isinstance(plant, systems.DeadTime) else stated
