"""Systems of second order without zeros, k ω_n²/(s² + 2ζω_n s + ω_n²), and their step responses by formula.

Source: Ogata, Modern Control Engineering, section 5-3.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from solver.exact.linear_algebra.radicals import square_root
from solver.exact.linear_algebra.signs import is_positive, possible_signs
from solver.exact.time_response.response import weighting
from solver.systems import StateSpace

DAMPING = {-1: "underdamped", 0: "critically damped", 1: "overdamped"}
"""By the sign of the discriminant."""


@dataclass(frozen=True)
class StandardForm:
    """The gain k, ω_n, ζ, and ζω_n; `damping` is empty where parameters decide it."""

    gain: sp.Expr
    omega_n: sp.Expr
    zeta: sp.Expr
    sigma: sp.Expr
    damping: str

    @property
    def transfer_function(self) -> sp.Expr:
        """G(s)."""
        s = sp.Symbol("s")
        return self.gain * self.omega_n**2 / (s**2 + 2 * self.sigma * s + self.omega_n**2)

    @property
    def turn(self) -> sp.Expr:
        """ω_d of an underdamped system, half the distance of the poles of an overdamped one."""
        square = sp.expand(self.omega_n**2 - self.sigma**2)
        square = -square if self.damping == "overdamped" else square
        return square_root(square) if square.free_symbols else _tidied(sp.sqrt(_tidied(square)))

    @property
    def poles(self) -> tuple[sp.Expr, sp.Expr]:
        """Both poles of an overdamped system, the slower one first."""
        return sp.expand(self.turn - self.sigma), sp.expand(-self.turn - self.sigma)

    @property
    def overshoot(self) -> sp.Expr:
        """e^{−πζ/√(1−ζ²)} of an underdamped system."""
        return sp.exp(-sp.pi * _over(self.sigma, self.turn))

    def step_response(self, t: sp.Symbol) -> sp.Expr | None:
        """The response to a unit step by the formula of its damping; None where parameters decide that."""
        omega, sigma, k = self.turn, self.sigma, self.gain
        if self.damping == "undamped":
            return k * (1 - sp.cos(self.omega_n * t))
        if self.damping == "underdamped":
            wave = sp.cos(omega * t) + sp.radsimp(sigma / omega) * sp.sin(omega * t)
            return k * (1 - sp.exp(-sigma * t) * wave)
        if self.damping == "critically damped":
            return k * (1 - (1 + self.omega_n * t) * sp.exp(-self.omega_n * t))
        if self.damping == "overdamped":
            p, q = self.poles
            return k * (1 - (q * sp.exp(p * t) - p * sp.exp(q * t)) / sp.radsimp(q - p))
        return None

    @property
    def peak_time(self) -> sp.Expr:
        """π/ω_d of an underdamped system."""
        return _over(sp.pi, self.turn)


def standard_form(system: StateSpace) -> StandardForm | None:
    """The standard form of a system with one input and one output; None where it has none."""
    if system.B is None or system.C is None or (system.D is not None and not system.D.is_zero_matrix):
        return None
    if system.B.cols != 1 or system.C.rows != 1 or system.discrete:
        return None
    s = sp.Symbol("s")
    top, bottom = sp.fraction(sp.cancel(weighting(system).expression(s)[0]))
    if top == 0 or top.has(s) or sp.degree(bottom, s) != 2:
        return None
    lead, a1, a0 = (sp.Poly(bottom, s).coeff_monomial(s**i) for i in (2, 1, 0))
    a1, a0 = sp.cancel(a1 / lead), sp.cancel(a0 / lead)
    if not is_positive(a0) or not possible_signs(a1) <= {0, 1}:
        return None
    omega_n = _tidied(sp.sqrt(a0))
    signs = possible_signs(sp.expand(a1**2 - 4 * a0))
    damping = DAMPING[next(iter(signs))] if len(signs) == 1 else ""
    damping = "undamped" if a1 == 0 else damping
    zeta = _tidied(a1 / (2 * omega_n))
    return StandardForm(sp.cancel(top / lead / a0), omega_n, zeta, a1 / 2, damping)


def _over(above: sp.Expr, below: sp.Expr) -> sp.Expr:
    """A quotient; a root with parameters stays in the denominator, as in the formula."""
    return sp.cancel(above / below) if below.free_symbols else sp.radsimp(above / below)


def _tidied(value: sp.Expr) -> sp.Expr:
    """A short exact form."""
    return sp.factor(value) if value.free_symbols else sp.radsimp(sp.expand(value))
