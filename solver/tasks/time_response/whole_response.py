"""The parts of a response put together: the sum, the output, and what the output shows in the long run."""

from __future__ import annotations

from typing import Any

from solver.derivation import Answers, Claim, Derivation, Step, lemma
from solver.derivation.figures import Curve, Mark, Plot
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, total
from solver.stated.calculus import derivative, value_at
from solver.tasks.time_response.question import Question, entry_or_column


@lemma("response")
def put_together(asked: Question) -> Derivation[Answers]:
    """The parts added up, and the output; returns the answers."""
    found = asked.answer
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
    answers["y"] = entry_or_column(found.y)
    if found.y_final is not None:
        answers["y_final"] = entry_or_column(found.y_final)
    if found.y_peak is not None:
        answers |= {"y_peak": found.y_peak.value, "t_peak": found.y_peak.time}
    yield behaviour(asked)
    return answers


@lemma("response")
def passed_on(asked: Question) -> Derivation[Answers]:
    """Without states the output is D u."""
    found = asked.answer
    y: Any = found.y
    u = sp.ImmutableMatrix(list(asked.inputs))
    yield Step("passed_on", claims={"y": Claim(product(asked.system.D, u), y, "output equation")}, u=u[0])
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
    """The limit and the peak of y, the modes that it does not show, and a plot."""
    found, t, s = asked.answer, asked.time, asked.variable
    claims: dict[str, Claim] = {}
    image = found.pieces[0][1].y
    transform = None if image is None else image.expression(s)
    if found.y_final is not None and transform is not None and len(found.pieces) == 1 and found.pieces[0][0] == 0:
        at = sp.Integer(1 if asked.discrete else 0)
        carried = transform.applyfunc(lambda entry: (s - at) * entry)
        claims["final"] = Claim(value_at(carried, s, at), found.y_final, "final value theorem")
    peak = found.y_peak
    if peak is not None:
        y: Any = found.y
        begun = y[0].xreplace({sp.Heaviside(t - found.pieces[0][0]): sp.S.One})
        if not asked.discrete:
            claims["slope"] = Claim(value_at(derivative(begun, t), t, peak.time), sp.Integer(0), "slope at the peak")
        claims["peak"] = Claim(value_at(begun, t, peak.time), peak.value, "value at the peak")
    figure = _plot(asked)
    return Step(
        "behaviour",
        claims=claims,
        unclaimed="" if claims else "a description of the answer",
        figures=(figure,) if figure else (),
        discrete=asked.discrete,
        peak=peak,
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


def _plot(asked: Question) -> Plot | None:
    """States and output over time; None where symbols other than time are left."""
    found, t = asked.answer, asked.time
    y: Any = found.y
    smooth = y - found.impulse if found.impulse is not None else y
    if (found.x.free_symbols | smooth.free_symbols) - {t}:
        return None
    stop = exact.horizon([each.x for _, each in found.pieces], discrete=asked.discrete)
    if stop is None:
        return None
    stop += max((delay for delay, _ in found.pieces), default=0)
    style = "samples" if asked.discrete else "line"
    states = [Curve(x, f"x_{{{i}}}", style=style) for i, x in enumerate(found.x.flat(), 1)]
    several = len(y) > 1
    outputs = [Curve(each, f"y_{{{i}}}" if several else "y", style=style) for i, each in enumerate(smooth.flat(), 1)]
    marks = (Mark(found.y_peak.time, found.y_peak.value, r"y_{\text{peak}}"),) if found.y_peak else ()
    caption = "States and outputs" if several else "States and output"
    letter = "k" if asked.discrete else "t"
    return Plot(caption, letter, "", t, sp.Integer(0), stop, (*states, *outputs), marks)
