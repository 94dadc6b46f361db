"""Usual mistakes with nonlinear equations, as the equations or the point that would have the value submitted."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from typing import TYPE_CHECKING, Any, TypeVar

from solver.derivation import Attempt, Options, Slip, Task, Unsolved
from solver.lazy import sympy as sp
from solver.lazy import systems
from solver.tasks.modelling.first_order import first_order_of, result_of

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import Equations

O = TypeVar("O", bound=Options)

SIN_COS = Slip("sin_cos", "sine and cosine are exchanged")
GRAVITY_REVERSED = Slip("gravity_sign", "gravity has the wrong sign")
WITHOUT_GRAVITY = Slip("without_gravity", "gravity is missing")
SMALL_ANGLE = Slip(
    "small_angle", r"$\sin\theta \approx \theta$ and $\cos\theta \approx 1$ are used far from $\theta = 0$"
)
COSINE_AS_ANGLE = Slip("small_angle", r"$\cos\theta \approx \theta$ is used; for small angles it is $1$")
INPUT_REVERSED = Slip("input_sign", "the input has the wrong sign")


def name_mistakes(task: Task[Any, Any], *, at_a_point: bool = False) -> None:
    """Register what goes wrong with equations in a task; `at_a_point` also where angles are taken as small."""
    changes: list[tuple[Slip, Callable[[Any, Any], Any]]] = [
        (SIN_COS, sine_for_cosine), (GRAVITY_REVERSED, gravity_reversed), (WITHOUT_GRAVITY, without_gravity),
        (INPUT_REVERSED, input_reversed),
    ]  # fmt: skip
    if at_a_point:
        changes += [(SMALL_ANGLE, small_angles), (COSINE_AS_ANGLE, cosine_as_angle)]
    for slip, change in changes:
        task.mistaken_question(slip)(change)


TERM_REVERSED = Slip("term_sign", "a term of the equations has the wrong sign")
TERMS = 16
"""Equations of more terms are not tried with each of them reversed."""


def term_reversed(attempt: Attempt[Equations, Options]) -> Iterator[Any]:
    """f and h of the equations with one term of one of them reversed."""
    model = attempt.given.system
    places = [(i, j, term) for i, pair in enumerate(model.sides) for j in (0, 1) for term in sp.Add.make_args(pair[j])]
    for i, j, term in places if len(places) <= TERMS else ():
        wrong = (model.sides[i][0] - 2 * term * (1 - j), model.sides[i][1] - 2 * term * j)
        sides = (*model.sides[:i], wrong, *model.sides[i + 1 :])
        with suppress(Unsolved):
            found = result_of(first_order_of(replace(model, sides=sides, written=())))
            yield sp.ImmutableMatrix(list(found.f if attempt.name == "f" else found.h))


def _changed(system: Any, options: O, put: Callable[[Expr], Expr]) -> tuple[Equations, O] | None:
    """The question about equations with something put into their sides; None where nothing is changed."""
    if not isinstance(system, systems.Equations):
        return None
    sides = tuple((put(left), put(right)) for left, right in system.sides)
    return None if sides == system.sides else (replace(system, sides=sides, written=()), options)


def _put(system: Any, options: O, values: Mapping[Any, Any]) -> tuple[Equations, O] | None:
    return _changed(system, options, lambda side: side.xreplace(dict(values))) if values else None


def _functions(system: Any, kind: Any) -> set[Any]:
    """The sines, or cosines, of anything that moves."""
    if not isinstance(system, systems.Equations):
        return set()
    found = set().union(*(side.atoms(kind) for pair in system.sides for side in pair))
    return {each for each in found if each.free_symbols & set(system.jets)}


def sine_for_cosine(system: Any, options: O) -> tuple[Equations, O] | None:
    """Sine for cosine, and the reverse."""
    sines = {each: sp.cos(each.args[0]) for each in _functions(system, sp.sin)}
    cosines = {each: sp.sin(each.args[0]) for each in _functions(system, sp.cos)}
    return _put(system, options, sines | cosines)


def gravity_reversed(system: Any, options: O) -> tuple[Equations, O] | None:
    """−g for g."""
    return _put(system, options, {g: -g for g in _named(system, "g")})


def without_gravity(system: Any, options: O) -> tuple[Equations, O] | None:
    """Nothing for g."""
    return _put(system, options, dict.fromkeys(_named(system, "g"), sp.S.Zero))


def input_reversed(system: Any, options: O) -> tuple[Equations, O] | None:
    """−u for u."""
    jets = getattr(system, "jets", {})
    return _put(system, options, {s: -s for s, (name, _) in jets.items() if name in system.inputs})


def _named(system: Any, name: str) -> list[Any]:
    return [each for each in getattr(system, "parameters", ()) if each.name == name]


def half_a_turn_away(system: Any, options: Any) -> tuple[Any, Any] | None:
    """The angles of the point, of which a sine or cosine is taken, by π further."""
    angles = {symbol.name for each in _functions(system, (sp.sin, sp.cos)) for symbol in each.free_symbols}
    if not options.at:
        return None
    turned = {s: sp.S.Zero if v == sp.pi else v + sp.pi for s, v in options.at.items() if str(s) in angles}
    return (system, replace(options, at={**options.at, **turned})) if turned else None


def at_the_origin(system: Any, options: Any) -> tuple[Any, Any] | None:
    """Zero for every value of the point."""
    zeros = dict.fromkeys(options.at or {}, sp.S.Zero)
    return None if zeros == dict(options.at or {}) else (system, replace(options, at=zeros))


def small_angles(system: Any, options: O) -> tuple[Equations, O] | None:
    """θ for sin θ and 1 for cos θ."""
    sines = {each: each.args[0] for each in _functions(system, sp.sin)}
    return _put(system, options, {**sines, **dict.fromkeys(_functions(system, sp.cos), sp.S.One)})


def cosine_as_angle(system: Any, options: O) -> tuple[Equations, O] | None:
    """θ for sin θ and for cos θ."""
    return _put(system, options, {each: each.args[0] for each in _functions(system, (sp.sin, sp.cos))})
