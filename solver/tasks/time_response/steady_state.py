"""The steady state of a response to a cosine or sine, as a lemma: G(jω), amplitude and phase."""

from __future__ import annotations

from typing import Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference
from solver.stated.calculus import value_at
from solver.stated.complex_numbers import absolute, argument
from solver.tasks.time_response.question import Question


@lemma("response_steady_state")
def steady_state_of(asked: Question) -> Derivation[None]:
    """Amplitude and phase of what is left of the output; no step for other inputs or several channels."""
    found: Any = asked.answer
    if found.y is None or len(found.y) != 1 or len(asked.inputs) != 1 or found.impulse is not None or asked.late:
        return
    t, x, D = asked.time, asked.variable, asked.system.D
    G = sp.cancel(exact.weighting(asked.system).expression(x)[0] + (D[0] if D is not None else 0))
    steady = exact.steady_state(G, asked.inputs[0], found.y[0], t, discrete=asked.discrete)
    if steady is None:
        return
    turned = sp.exp(sp.I * steady.omega) if asked.discrete else sp.I * steady.omega
    claims = {
        "value": Claim(value_at(G, x, turned), steady.value, "frequency response"),
        "magnitude": Claim(absolute(steady.value), steady.magnitude, "amplitude ratio"),
        "argument": Claim(argument(steady.value), steady.argument, "phase"),
        "forced": Claim(steady.forced, steady.output, "one wave"),
        "transient": Claim(difference(found.y[0], steady.forced), steady.transient, "what dies out"),
    }
    if steady.input is not None:
        claims["input"] = Claim(asked.inputs[0], steady.input, "the input as one wave")
    yield Step("steady_state", claims=claims, G=G, u=asked.inputs[0], steady=steady, discrete=asked.discrete, x=x)
