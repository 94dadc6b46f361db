"""The equations of motion of a mechanical system by Euler and Lagrange, and their form with M, C and gravity."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from solver.derivation import (
    AnswerName,
    Answers,
    Attempt,
    Check,
    Claim,
    Derivation,
    Given,
    Options,
    Slip,
    Step,
    Task,
)
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import modelling as judges
from solver.stated.algebra import difference, product, total
from solver.stated.calculus import denoted, time_derivative
from solver.stated.matrices import transpose
from solver.systems import Lagrangian
from solver.tasks.modelling.euler_lagrange import Motion, equations_of_motion_of, following

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import System

EXACT = 1e-8
"""What doubles leave of the derivatives of an action."""
ORACLE = "the action along closed paths, differentiated by complex steps"


@dataclass(frozen=True, kw_only=True)
class EquationsOfMotionOptions(Options):
    """There are none."""


equations_of_motion: Task[Lagrangian, EquationsOfMotionOptions] = Task(
    "equations_of_motion",
    title="Equations of motion",
    doc="The equations of motion of a mechanical system that is given by its energies, or by bodies and springs.",
    needs=("lagrangian",),
    options=EquationsOfMotionOptions,
    answers=[
        AnswerName("kinetic", "T", "the kinetic energy", earned=("body", "kinetic")),
        AnswerName("potential", "V", "the potential energy", earned=("potential",)),
        AnswerName("lagrangian", "L", "the Lagrangian $T - V$", earned=("lagrangian",)),
        AnswerName("equations", r"\text{equations of motion}", "the equations of motion",
                   principal=True, earned=("lagrangian", "coordinate"), told=("equations", "coordinate"), zero=True),
        AnswerName("M", "M", "the inertia matrix of $M\\ddot{q} + C\\dot{q} + G = Q$", optional=True),
        AnswerName("C", "C", "the matrix of centrifugal and Coriolis terms, by Christoffel symbols", optional=True),
        AnswerName("gravity", "G", "the vector of gravity and springs", optional=True),
    ],
)  # fmt: skip


@equations_of_motion.method(
    "euler_lagrange", title="Euler–Lagrange", source="Goldstein, Poole and Safko, Classical Mechanics, §1–4"
)
def by_euler_lagrange(given: Given[Lagrangian, EquationsOfMotionOptions]) -> Derivation[Answers]:
    """The energies, the terms of d/dt ∂L/∂q' − ∂L/∂q + ∂D/∂q' = Q for each coordinate, then M, C and gravity."""
    motion = yield from equations_of_motion_of(given.system)
    energies = motion.energies
    answers = Answers(kinetic=energies.T, potential=energies.V, lagrangian=energies.L, equations=motion.expressions)
    answers.update((yield from _manipulator(given.system, motion)))
    return answers


def _manipulator(system: Lagrangian, motion: Motion) -> Derivation[dict[str, Any]]:
    """M q'' + C q' + G = Q, where T has degree two in the velocities and nothing else moves it."""
    energies = motion.energies
    moved = [system.symbol((name, k)) for name in system.inputs for k in range(4)]
    q, speeds = system.symbols(), system.symbols(1)
    found = None if energies.T.has(*moved) else exact.manipulator_form(energies.T, energies.V, q, speeds)
    if found is None:
        return {}
    M, C, G = found
    speed, acceleration = sp.ImmutableMatrix(speeds), sp.ImmutableMatrix(system.symbols(2))
    friction = [sp.S.Zero if system.dissipation is None else sp.diff(system.dissipation, v) for v in speeds]
    multipliers = [system.symbol((name, 0)) for name in system.multipliers]
    bound = sp.Add(*(x * c for x, c in zip(multipliers, system.constraints, strict=True)))
    drawn = [sp.diff(bound, each) - drag for each, drag in zip(q, friction, strict=True)]
    pairs = list(zip(motion.equations, drawn, strict=True))
    left = sp.ImmutableMatrix([each.expression + each.force + other for each, other in pairs])
    force = sp.ImmutableMatrix([each.force + other for each, other in pairs])
    yield Step("manipulator", claims={
        "whole": Claim(total(product(M, acceleration), product(C, speed), G), left, "the equations of motion"),
        "symmetric": Claim(transpose(M), M, "$M$ is symmetric"),
    }, M=M, C=C, G=G, force=force, one=len(q) == 1)  # fmt: skip
    if len(q) > 1:
        yield _skew(system, M, C)
    return {"M": M, "C": C, "gravity": G}


def _skew(system: Lagrangian, M: Any, C: Any) -> Step:
    """M' − 2 C is skew: the terms of C do no work beyond the change of M."""
    moves = following(system)
    rate = sp.ImmutableMatrix(M.applyfunc(lambda entry: exact.normal(exact.time_derivative(entry, moves))))
    N = sp.ImmutableMatrix((rate - 2 * C).applyfunc(exact.normal))
    stated = difference(time_derivative(denoted("M", M), moves.items()), product(2, denoted("C", C)))
    claims = {
        "skew": Claim(stated, N, r"$\dot{M} - 2C$"),
        "turned": Claim(transpose(N), product(-1, N), r"$\dot{M} - 2C$ is skew"),
    }
    return Step("skew", claims=claims, detail="tutor", N=N)


@equations_of_motion.verification("kinetic", "potential", "lagrangian")
def are_those_of_the_bodies(given: Given[Lagrangian, EquationsOfMotionOptions], answers: Answers) -> Iterable[Check]:
    """Positions differentiated numerically give T, heights and elongations V, up to a constant."""
    labels = {
        "kinetic": "the kinetic energy at random positions and velocities",
        "potential": "differences of the potential energy at random positions",
        "lagrangian": "differences of the Lagrangian at random positions and velocities",
    }
    for name, label in labels.items():
        if name not in answers:
            continue
        residual = judges.energy_of_motion_residual(given.system, name, answers[name])
        yield Check.within(label, ORACLE, residual, _near(answers[name]), answer=name)


@equations_of_motion.verification("equations")
def make_the_action_stationary(given: Given[Lagrangian, EquationsOfMotionOptions], answers: Answers) -> Iterable[Check]:
    """The equations are those of the action, up to factors and order, and keep the balance of energy."""
    equations = list(answers["equations"])
    near = _near(equations)
    residuals, independent = judges.equation_balance(given.system, equations)
    yield Check.that("as many independent equations as the action gives", ORACLE, independent, answer="equations")
    label = "the equations against the action at random positions, velocities and accelerations"
    yield Check.within(label, ORACLE, max(residuals, default=float("inf")), near, answer="equations")
    energy = judges.energy_residual(given.system, equations)
    if energy is not None:
        label = "the energy that the motions gain against the power of forces less that of friction"
        yield Check.within(label, ORACLE, energy, near, answer="equations")


@equations_of_motion.verification("M", "C", "gravity")
def are_the_inertias(given: Given[Lagrangian, EquationsOfMotionOptions], answers: Answers) -> Iterable[Check]:
    """M by energies of unit velocities, C and gravity by their changes with the position."""
    labels = {
        "M": "the inertia matrix at random positions",
        "C": "Christoffel symbols of the inertia matrix at random positions and velocities",
        "gravity": "the slope of the potential energy at random positions",
    }
    for name in [name for name in labels if name in answers]:
        residual = judges.form_residual(given.system, name, answers[name])
        yield Check.within(labels[name], ORACLE, residual, _near(answers[name]), answer=name)


def _near(value: Any) -> float:
    return 1e-6 if numeric.holds_decimals(value) else EXACT


Changed = tuple[Lagrangian, EquationsOfMotionOptions]


@equations_of_motion.mistaken_question(Slip("force_sign", "the sign of a force is reversed"))
def force_reversed(system: System, options: EquationsOfMotionOptions) -> Changed | None:
    """The generalized forces on the other side of the equations."""
    if not isinstance(system, Lagrangian) or not system.forces:
        return None
    return replace(system, forces={name: -force for name, force in system.forces.items()}), options


@equations_of_motion.mistaken_question(Slip("no_gravity", "gravity is missing"))
def without_gravity(system: System, options: EquationsOfMotionOptions) -> Changed | None:
    """No weights."""
    if not isinstance(system, Lagrangian) or system.gravity is None:
        return None
    return replace(system, gravity=None), options


@equations_of_motion.mistaken_question(Slip("gravity_sign", "gravity acts upward: the sign of its terms is reversed"))
def gravity_reversed(system: System, options: EquationsOfMotionOptions) -> Changed | None:
    """The weights with the other sign."""
    if not isinstance(system, Lagrangian) or system.gravity is None:
        return None
    return replace(system, gravity=-system.gravity), options


@equations_of_motion.mistaken_question(Slip("friction", "the friction is missing"))
def without_friction(system: System, options: EquationsOfMotionOptions) -> Changed | None:
    """Neither Rayleigh's function nor forces that grow with the velocities."""
    if not isinstance(system, Lagrangian):
        return None
    still = dict.fromkeys(system.symbols(1), sp.S.Zero)
    forces = {name: force.xreplace(still) for name, force in system.forces.items()}
    if system.dissipation is None and forces == dict(system.forces):
        return None
    return replace(system, dissipation=None, forces=forces), options


@equations_of_motion.mistaken_question(Slip("rotational_inertia", "the moment of inertia of a body is missing"))
def without_inertia(system: System, options: EquationsOfMotionOptions) -> Changed | None:
    """Bodies as points: ½ J ω² left out."""
    if not isinstance(system, Lagrangian) or all(body.inertia is None for body in system.bodies):
        return None
    points = [replace(body, inertia=None, angle=None) for body in system.bodies if body.mass is not None]
    return replace(system, bodies=tuple(points)), options


@equations_of_motion.mistaken_question(
    Slip("parallel_axis", "the inertia of a body is taken about its centre: the term of the parallel axis is missing")
)
def without_parallel_axis(system: System, options: EquationsOfMotionOptions) -> Changed | None:
    """Bodies that turn about another point with J in place of J + m l²."""
    if not isinstance(system, Lagrangian):
        return None
    lost = [
        body.mass * sp.diff(each, body.angle) ** 2 * system.symbol((name, 1)) ** 2 / 2
        for body in system.bodies
        for name in system.coordinates
        for each in body.position
        if body.angle == system.symbol((name, 0))
    ]
    if not any(lost):
        return None
    return replace(
        system, kinetic=sp.Add(*([] if system.kinetic is None else [system.kinetic]), *(-e for e in lost))
    ), options


@equations_of_motion.mistaken_question(Slip("exchanged", "sin and cos are exchanged in the positions"))
def sines_exchanged(system: System, options: EquationsOfMotionOptions) -> Changed | None:
    """Positions with sines for cosines."""
    if not isinstance(system, Lagrangian) or not any(
        each.has(sp.sin, sp.cos) for body in system.bodies for each in body.position
    ):
        return None
    bodies = [replace(body, position=tuple(map(_exchanged, body.position))) for body in system.bodies]
    return replace(system, bodies=tuple(bodies)), options


def _exchanged(expression: Expr) -> Expr:
    found: Expr = expression.xreplace(
        {f: (sp.cos if isinstance(f, sp.sin) else sp.sin)(f.args[0]) for f in expression.atoms(sp.sin, sp.cos)}
    )
    return found


@equations_of_motion.mistake(
    Slip("product_rule", "in $\\frac{d}{dt}\\frac{\\partial L}{\\partial\\dot{q}}$ the inertia is differentiated too: "
         "the product rule is forgotten"), "equations",
)  # fmt: skip
def without_product_rule(attempt: Attempt[Lagrangian, EquationsOfMotionOptions]) -> Iterable[Any]:
    """M q'' in place of d/dt (M q'); the value submitted, where it is this up to factors and order."""
    system, T = attempt.given.system, attempt.answers["kinetic"]
    lost = []
    moves = following(system)
    places = {q: moves[q] for q in system.symbols()}
    for speed in system.symbols(1):
        lost.append(exact.time_derivative(sp.diff(T, speed), places))
    wrong = [e - l for e, l in zip(attempt.ours, [*lost, *([sp.S.Zero] * len(system.constraints))], strict=True)]
    yield wrong
