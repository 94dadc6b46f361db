"""The step response of a second-order system without zeros, by the names of its quantities, as a lemma."""

from __future__ import annotations

from typing import Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product
from solver.stated.matrices import inverse
from solver.tasks.time_response.question import Question


@lemma("response_second_order")
def named_second_order(asked: Question) -> Derivation[None]:
    """ω_n, ζ, the damping, and of an underdamped system peak time and overshoot; no step for other responses."""
    t, found = asked.time, asked.answer
    pieces = asked.pieces
    if asked.x0 is not None or len(pieces) != 1 or asked.kind == "zero_input" or found.y is None:
        return
    piece, height = pieces[0], pieces[0].inputs[0]
    if height == 0 or height.has(t) or any(piece.impulses.flat()):
        return
    form = exact.standard_form(asked.system)
    if form is None:
        return
    system = asked.system
    transfer: Any = product(system.C, inverse(asked.pencil()), system.B)
    transfer = asked.transfer.matrix if asked.transfer is not None else transfer
    claims = {"form": Claim(transfer, sp.ImmutableMatrix([[form.transfer_function]]), "standard form")}
    response = form.step_response(t)
    y = asked.function(asked.output(piece))[0]
    if response is not None:
        claims["y"] = Claim(height * response, y, "formula of the step response")
    peak = found.y_peak
    if form.damping == "underdamped" and peak is not None:
        final = height * form.gain
        claims["peak_time"] = Claim(form.peak_time, sp.expand(peak.time - peak.delay), "peak time")
        claims["overshoot"] = Claim(product(final, 1 + form.overshoot), peak.value, "peak by the overshoot")
    peaks = "overshoot" in claims
    yield Step(
        "second_order",
        claims=claims,
        form=form,
        height=height,
        delay=piece.delay,
        peaks=peaks,
        overshoot=sp.N(form.overshoot, 30) if peaks and form.overshoot.is_number else None,
    )
