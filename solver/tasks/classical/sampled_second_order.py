"""Natural frequency and damping in discrete time: the poles in z are taken back to s."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import quotient
from solver.stated.calculus import value_at
from solver.stated.complex_numbers import absolute, argument
from solver.tasks.figures import plane, roots
from solver.words import Phrase

if TYPE_CHECKING:
    from solver.systems import Polynomial


@lemma("sampled_second_order")
def sampled_second_order(p: Polynomial, period: Any) -> Derivation[Answers]:
    """ω_n, ζ and the case of damping of p(z) of degree two with numbers as coefficients; `period` T may be a symbol."""
    if p.parameters and set(p.parameters) - period.free_symbols:
        raise Unsolved("second_order_parameters/parameters_in_z", names=[x.name for x in p.parameters])
    try:
        found = exact.sampled_damping_of(p.coefficients, period)
    except exact.NoCounterpart as finding:
        raise Unsolved("second_order_parameters/no_counterpart", pole=finding.pole) from None
    except exact.NoFrequency as finding:
        raise Unsolved("second_order_parameters/no_frequency_in_s", square=finding.square) from None
    z, upper = p.variable, found.poles_z[0]
    claims: dict[str, Claim] = {
        f"pole{i}": Claim(value_at(p.expression, z, pole), sp.Integer(0), "a pole")
        for i, pole in enumerate(found.poles_z, 1)
    }
    yield Step("poles_in_z", claims=claims, p=p.expression, poles=list(found.poles_z),
               figures=plane("The poles", roots("poles", found.poles_z), stable=True, discrete=True))  # fmt: skip
    if found.angle is not None:
        claims = {"size": Claim(absolute(upper), found.size, "$|z|$"),
                  "angle": Claim(argument(upper), found.angle, r"$\arg z$")}  # fmt: skip
    else:
        claims = {
            f"pole{i}": Claim(quotient(sp.log(pole), period), value, Phrase("pole {i} in s", i=i))
            for i, (pole, value) in enumerate(zip(found.poles_z, found.poles_s, strict=True), 1)
        }
    yield Step("poles_in_s", claims=claims, found=found, T=period)
    yield Step("of_the_poles", unclaimed="displayed, and the answers have checks of their own", found=found)
    yield Step("sampled_damping", unclaimed="read off; the answer has a check of its own", found=found, T=period)
    answers = Answers(natural_frequency=found.omega_n, damping_ratio=found.zeta)
    return Answers(**answers, damping=found.damping) if found.damping else answers
