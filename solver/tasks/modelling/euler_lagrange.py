"""Lemma: the equations of motion of a system that is given by its energies, by Euler and Lagrange."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.jets import jet_symbol
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, power, product, total
from solver.stated.calculus import denoted, partial_derivative, time_derivative
from solver.tasks.modelling.mechanism_figures import mechanism_of
from solver.words import Phrase, formula

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.stated import Stated
    from solver.systems import Lagrangian
    from solver.systems.bodies import Body

MOST_ORDER = 3
"""Inputs that move a body occur with up to so many derivatives."""


@dataclass(frozen=True)
class Energies:
    """T and V as the terms of a sum, in the order of a book."""

    system: Lagrangian
    kinetic: tuple[Expr, ...]
    potential: tuple[Expr, ...]

    @cached_property
    def T(self) -> Expr:
        """The kinetic energy."""
        return sp.Add(*self.kinetic)

    @cached_property
    def V(self) -> Expr:
        """The potential energy."""
        return sp.Add(*self.potential)

    @property
    def L(self) -> Expr:
        """The Lagrangian T − V."""
        return self.T - self.V

    @property
    def lagrangian(self) -> Stated:
        """T − V, its terms in order."""
        return total(*self.kinetic, *(-term for term in self.potential))


@dataclass(frozen=True, slots=True)
class EquationOfMotion:
    """The terms of the left side, and the generalized force on the right."""

    coordinate: str
    terms: tuple[Expr, ...]
    force: Expr

    @property
    def expression(self) -> Expr:
        """What is zero along every motion."""
        return sp.Add(*self.terms, -self.force)


@dataclass(frozen=True, slots=True)
class Motion:
    """The energies, the equation of each coordinate, and those of the constraints."""

    energies: Energies
    equations: tuple[EquationOfMotion, ...]

    @property
    def expressions(self) -> list[Expr]:
        """What is zero: the equations in the order of the coordinates, then the constraints."""
        return [*(each.expression for each in self.equations), *self.energies.system.constraints]


def following(system: Lagrangian) -> dict[Symbol, Symbol]:
    """Return the derivative of each function of time and of its derivatives."""
    of = [(name, MOST_ORDER if name in system.inputs else 2) for name in (*system.coordinates, *system.inputs)]
    return {jet_symbol((name, k)): jet_symbol((name, k + 1)) for name, order in of for k in range(order)}


@lemma("euler_lagrange")
def equations_of_motion_of(system: Lagrangian) -> Derivation[Motion]:
    """The energies, then for each coordinate the terms of d/dt ∂L/∂q' − ∂L/∂q + ∂D/∂q' = Q."""
    energies = yield from energies_of(system)
    equations = []
    for name in system.coordinates:
        equations.append((yield from _equation_of(energies, name)))
    found = Motion(energies, tuple(equations))
    if len(found.expressions) > 1:
        yield Step("equations", unclaimed="those found above", constraints=system.constraints,
                   equations=[(total(*each.terms), each.force) for each in equations])  # fmt: skip
    return found


@lemma("euler_lagrange")
def energies_of(system: Lagrangian) -> Derivation[Energies]:
    """T of the bodies by their velocities, V by their heights and the elongations of springs; L = T − V."""
    parts: list[Any] = []
    terms_of: list[Any] = []
    for number, body in enumerate(system.bodies, start=1):
        stated, terms = yield from _kinetic_energy(system, body, number)
        parts += terms
        terms_of.append(stated)
    given = [*parts, *([] if system.kinetic is None else [system.kinetic])]
    kinetic = _by_velocities(system, sp.Add(*given)) or (sp.Add(*given),)
    if len(system.bodies) != 1 or system.kinetic is not None:
        yield Step("kinetic", claims={"kinetic": Claim(total(*given), total(*kinetic), "$T$")},
                   several=bool(system.bodies))  # fmt: skip
    potential = yield from _potential_energy(system)
    energies = Energies(system, kinetic, potential)
    claim = Claim(difference(denoted("T", energies.T), denoted("V", energies.V)), energies.lagrangian, "$L = T - V$")
    yield Step("lagrangian", claims={"lagrangian": claim})
    return energies


def _by_velocities(system: Lagrangian, expression: Expr) -> tuple[Expr, ...] | None:
    """The terms of a sum collected by the velocities; None where it is no polynomial in them."""
    symbols = [symbol for symbol, (_, k) in _jets(system).items() if k > 0 and expression.has(symbol)]
    found = exact.collected(expression, symbols)
    return None if found is None else tuple(found)


def _jets(system: Lagrangian) -> dict[Symbol, tuple[str, int]]:
    """Every derivative that may occur, the coordinates in their order first."""
    names = (*system.coordinates, *system.inputs)
    return {jet_symbol((name, k)): (name, k) for k in range(MOST_ORDER + 1) for name in names}


@lemma("euler_lagrange")
def _kinetic_energy(system: Lagrangian, body: Body, number: int) -> Derivation[tuple[Any, tuple[Expr, ...]]]:
    """½ m v² + ½ J ω² of a body, collected by the velocities."""
    moves = following(system)
    claims, stated, half = {}, [], sp.Rational(1, 2)
    velocity = [exact.time_derivative(each, moves) for each in body.position]
    for name, position, rate in zip("xy", body.position, velocity, strict=False):
        if rate != 0 and not position.is_Symbol:
            claims[name] = Claim(time_derivative(position, moves.items()), rate, "the chain rule")
    squares = [power(rate, 2) for rate in velocity if rate != 0]
    terms: list[Expr] = []
    if squares:
        square = sp.Add(*(rate**2 for rate in velocity))
        stated.append(product(half, body.mass, total(*squares) if len(squares) > 1 else squares[0]))
        terms.append(half * body.mass * square)
        if len(sp.Add.make_args(expanded := sp.expand(square))) > 1:
            claims["square"] = Claim(total(*squares), expanded, "the squares multiplied out")
    if body.angle is not None and (turning := exact.time_derivative(body.angle, moves)) != 0:
        if len(sp.Add.make_args(turning)) > 1:
            claims["angle"] = Claim(time_derivative(body.angle, moves.items()), turning, "the chain rule")
        stated.append(product(half, body.inertia, power(turning, 2)))
        terms.append(half * body.inertia * turning**2)
    whole = sp.Add(*terms)
    found = _by_velocities(system, whole) or (whole,)
    if stated:
        energy = total(*stated) if len(stated) > 1 else stated[0]
        claims["energy"] = Claim(energy, total(*found), Phrase("kinetic energy of body {i}", i=number))
    only = len(system.bodies) == 1 and system.kinetic is None
    plain = len(found) == 1 and all(rate.is_Symbol or rate == 0 for rate in velocity)
    yield Step("body", claims=claims, unclaimed="" if claims else "it is at rest", number=number, only=only,
               body=body, moves=bool(stated), plain=plain,
               figures=mechanism_of(system) if number == 1 else ())  # fmt: skip
    return stated, found if stated else ()


@lemma("euler_lagrange")
def _potential_energy(system: Lagrangian) -> Derivation[tuple[Expr, ...]]:
    """M g y of each body, ½ k (length − rest)² of each spring, and what is given."""
    half, q = sp.Rational(1, 2), system.symbols()
    heights: list[tuple[Any, Any]] = [] if system.gravity is None else [
        (body.mass, body.position[1]) for body in system.bodies if body.position and body.position[1] != 0
    ]  # fmt: skip
    stated: list[Any] = [product(mass, system.gravity, y) for mass, y in heights]
    moving = [*q, *(jet_symbol((name, 0)) for name in system.inputs)]
    g: Any = system.gravity
    terms = exact.grouped(sp.Add(*(mass * g * y for mass, y in heights)), moving) if heights else []
    for spring in system.springs:
        elongation = spring.length - spring.rest
        stated.append(product(half, spring.stiffness, power(elongation, 2)))
        terms.append(sp.Mul(half, spring.stiffness, elongation**2))
    if system.potential is not None:
        stated.append(system.potential)
        terms += sp.Add.make_args(system.potential)
    found = tuple(term for term in terms if term != 0)
    if not stated:
        yield Step("no_potential", unclaimed="there is nothing that stores energy by its place")
        return ()
    claim = Claim(total(*stated), total(*found), "$V$")
    yield Step("potential", claims={"potential": claim}, weights=bool(heights), springs=bool(system.springs))
    return found


@lemma("euler_lagrange")
def _equation_of(energies: Energies, name: str) -> Derivation[EquationOfMotion]:
    """The four terms of one coordinate, each a line of its own, and the equation collected."""
    system, moves = energies.system, following(energies.system)
    q, speed = jet_symbol((name, 0)), jet_symbol((name, 1))
    L = denoted("L", energies.L)
    momentum = exact.partial(energies.T, speed)
    rate = exact.time_derivative(momentum, moves)
    by_place, restoring = exact.partial(energies.T, q), [exact.partial(term, q) for term in energies.potential]
    friction = sp.S.Zero if system.dissipation is None else exact.partial(system.dissipation, speed)
    bound = [
        jet_symbol((each, 0)) * exact.partial(c, q)
        for each, c in zip(system.multipliers, system.constraints, strict=True)
    ]
    dragging = _collected(system, friction)
    terms = (*_collected(system, rate - by_place), *dragging, *(_factored(t) for t in restoring if t != 0),
             *(-term for term in bound if term != 0))  # fmt: skip
    force = system.forces.get(name, sp.S.Zero)
    rates, places = (
        _collected(system, rate),
        (*_collected(system, by_place), *(-_factored(t) for t in restoring if t != 0)),
    )
    claims = {
        "momentum": Claim(partial_derivative(L, speed), _sum(_collected(system, momentum)), formula(speed)),
        "rate": Claim(time_derivative(partial_derivative(L, speed), moves.items()), _sum(rates), formula(speed)),
        "place": Claim(partial_derivative(L, q), _sum(places), formula(q)),
    }
    stated = [_sum(rates), *([product(-1, _sum(places))] if places else [])]
    if system.dissipation is not None:
        D = denoted("D", system.dissipation)
        claims["friction"] = Claim(partial_derivative(D, speed), _sum(dragging), formula(speed))
        stated.append(_sum(dragging))
    for each, c, term in zip(system.multipliers, system.constraints, bound, strict=True):
        if term != 0:
            stated_term = product(jet_symbol((each, 0)), partial_derivative(c, q))
            claims[each] = Claim(stated_term, term, formula(q))
            stated.append(-term)
    claims["equation"] = Claim(total(*stated), _sum(terms), Phrase("the equation of ${q}$", q=formula(q)))
    yield Step("coordinate", claims=claims, q=q, speed=speed, force=force, left=_sum(terms),
               multipliers=[each for each in system.multipliers if each in claims])  # fmt: skip
    return EquationOfMotion(name, terms, force)


def _collected(system: Lagrangian, expression: Expr) -> tuple[Expr, ...]:
    """Terms by accelerations, then velocities; as it stands where it is no polynomial in them."""
    if expression == 0:
        return ()
    jets = _jets(system)
    symbols = [symbol for k in (3, 2, 1) for symbol, (_, order) in jets.items() if order == k]
    inside = [symbol for symbol in symbols if symbol in expression.free_symbols]
    accelerations = [symbol for symbol in inside if jets[symbol][1] > 1]
    found = exact.collected(expression, inside)
    if found is None:
        return tuple(sp.Add.make_args(exact.normal(expression)))
    first = [term for term in found if term.has(*accelerations)] if accelerations else []
    return (*first, *(term for term in found if term not in first))


def _factored(term: Expr) -> Expr:
    """A term of a derivative with its number in front."""
    number, rest = term.as_content_primitive()
    return sp.Mul(number, rest)


def _sum(terms: Sequence[Expr]) -> Any:
    """The sum in the order of its terms."""
    if not terms:
        return sp.S.Zero
    return total(*terms) if len(terms) > 1 else terms[0]
