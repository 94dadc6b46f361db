"""The parts of a response put together: the sum, the output, and what the output shows in the long run."""

from __future__ import annotations

from typing import Any

from solver.derivation import Answers, Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, total
from solver.stated.calculus import value_at
from solver.tasks.time_response.intervals import intervals_of
from solver.tasks.time_response.peak import peak_of
from solver.tasks.time_response.question import Question, entry_or_column
from solver.tasks.time_response.response_figure import figure_of
from solver.tasks.time_response.second_order import named_second_order
from solver.tasks.time_response.steady_state import steady_state_of


@lemma("response")
def put_together(asked: Question) -> Derivation[Answers]:
    """The parts added up, and the output; returns the answers."""
    found = asked.answer
    if asked.transfer is not None:
        return (yield from _outputs_together(asked))
    parts = [asked.function(asked.zero_input)] if asked.x0 is not None else []
    parts += [asked.begun(asked.function(asked.zero_state(piece)), piece.delay) for piece in asked.pieces]
    if len(parts) > 1:
        yield Step(
            "sum",
            claims={"x": Claim(total(*parts), found.x, "sum of the parts")},
            discrete=asked.discrete,
            initial=asked.x0 is not None,
        )
    answers = Answers(x=found.x)
    if found.y is None:
        return answers
    yield _output(asked)
    answers |= yield from _what_it_does(asked)
    return answers


def _outputs_together(asked: Question) -> Derivation[Answers]:
    """The outputs to the pieces of the input added up, where there are several."""
    found: Any = asked.answer
    if len(asked.pieces) > 1:
        parts = [asked.begun(asked.function(asked.output(piece)), piece.delay) for piece in asked.pieces]
        smooth = found.y - found.impulse if found.impulse is not None else found.y
        yield Step(
            "outputs_added",
            claims={"y": Claim(total(*parts), sp.ImmutableMatrix(smooth), "sum of the parts")},
            discrete=asked.discrete,
            count=len(parts),
            y=found.y,
        )
    return (yield from _what_it_does(asked))


def _what_it_does(asked: Question) -> Derivation[Answers]:
    """The output as the answer, its limit and its peak."""
    found: Any = asked.answer
    answers = Answers(y=entry_or_column(found.y))
    if found.y_final is not None:
        answers["y_final"] = entry_or_column(found.y_final)
    if found.y_peak is not None:
        answers |= {"y_peak": found.y_peak.value, "t_peak": found.y_peak.time}
    yield from intervals_of(asked)
    yield from named_second_order(asked)
    yield from steady_state_of(asked)
    yield behaviour(asked)
    yield from peak_of(asked)
    return answers


@lemma("response")
def passed_on(asked: Question) -> Derivation[Answers]:
    """Without states the output is D u."""
    found = asked.answer
    y: Any = found.y
    u = sp.ImmutableMatrix(list(asked.inputs))
    claims = {"y": Claim(product(asked.system.D, u), y, "output equation")}
    yield Step("passed_on", claims=claims, late=asked.late, discrete=asked.discrete)
    return Answers(y=entry_or_column(y))


def _output(asked: Question) -> Step:
    """The output equation y = C x + D u; what impulses the input passes on through D is added beside the claim."""
    found, system = asked.answer, asked.system
    terms: list[Any] = [product(system.C, found.x)]
    through = system.D is not None and any(system.D.flat()) and bool(asked.inputs)
    u = sp.zeros(len(asked.inputs), 1)
    for piece in asked.pieces:
        u += asked.begun(piece.inputs, piece.delay)
    if through:
        terms.append(product(system.D, sp.ImmutableMatrix(u)))
    y: Any = found.y
    smooth = y - found.impulse if found.impulse is not None else y
    return Step(
        "output",
        claims={"y": Claim(total(*terms), sp.ImmutableMatrix(smooth), "output equation")},
        discrete=asked.discrete,
        through=through,
        u=entry_or_column(sp.ImmutableMatrix(u)) if through else None,
        y=y,
        impulse=found.impulse,
        single=len(y) == 1,
    )


def behaviour(asked: Question) -> Step:
    """The limit of y, the modes that it does not show, and a plot."""
    found, s = asked.answer, asked.variable
    claims: dict[str, Claim] = {}
    image = found.pieces[0][1].y
    transform = None if image is None else image.expression(s)
    if found.y_final is not None and transform is not None and len(found.pieces) == 1 and found.pieces[0][0] == 0:
        at = sp.Integer(1 if asked.discrete else 0)
        carried = transform.applyfunc(lambda entry: (s - at) * entry)
        claims["final"] = Claim(value_at(carried, s, at), found.y_final, "final value theorem")
    figure = figure_of(asked)
    return Step(
        "behaviour",
        claims=claims,
        unclaimed="" if claims else "a description of the answer",
        figures=(figure,) if figure else (),
        discrete=asked.discrete,
        image=None if transform is None else entry_or_column(transform),
        final=None if found.y_final is None else entry_or_column(found.y_final),
        hidden=_hidden_modes(asked),
        lasting=[] if found.y_final is not None else _lasting_poles(asked),
        variable=s,
        plotted=figure is not None,
        single=image is not None and image.shape == (1, 1),
    )


def _lasting_poles(asked: Question) -> list[tuple[Any, int]]:
    """The poles of Y, and how often, that keep y from a limit: neither do they die out nor are they one constant."""
    poles = [pole for _, each in asked.answer.pieces if each.y is not None for pole in each.y.poles]
    found: dict[Any, int] = {}
    for each, order in poles:
        constant = exact.constant_root(each.factor, discrete=asked.discrete) and order == 1
        if not constant and not exact.decays(each.factor, discrete=asked.discrete):
            found |= {root.value: max(order, found.get(root.value, 0)) for root in each.factor.roots}
    return list(found.items())


def _hidden_modes(asked: Question) -> list[Any]:
    """The eigenvalues of A whose modes are missing in y."""
    images = [each.y for _, each in asked.answer.pieces if each.y is not None]
    seen = {root.value for image in images for each, _ in image.poles for root in each.factor.roots}
    return [root.value for root in exact.spectrum(asked.system.A).roots if root.value not in seen]
