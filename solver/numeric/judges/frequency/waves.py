"""Inputs that are sums of oscillations and a constant, taken apart by Euler's formula."""

from __future__ import annotations

from typing import Any

import mpmath
import sympy as sp

from solver.numeric.judges.frequency.crossings import decimal


def oscillations(u: Any, time: Any) -> list[tuple[Any, Any]] | None:
    """Return the pairs c and ω of u = Σ c e^{jω·time}, c complex; None for other signals."""
    found: dict[Any, Any] = {}
    for term in sp.Add.make_args(sp.expand(sp.expand(u.rewrite(sp.exp)))):
        c, wave = term.as_independent(time, as_Add=False)
        exponent = sp.expand(sp.S.Zero if wave == 1 else wave.args[0]) if wave == 1 or wave.func is sp.exp else None
        if exponent is None or c.free_symbols:
            return None
        slope, start = exponent.coeff(time, 1), exponent.coeff(time, 0)
        omega = sp.expand(-sp.I * slope)
        if sp.expand(exponent - slope * time - start) != 0 or not omega.is_real:
            return None
        found[omega] = found.get(omega, mpmath.mpc(0)) + _number(c) * mpmath.exp(_number(start))
    return [(c, decimal(omega)) for omega, c in found.items() if abs(c) > mpmath.mpf(10) ** -30]


def _number(value: Any) -> Any:
    real, imaginary = sp.N(value, mpmath.mp.dps).as_real_imag()
    return mpmath.mpc(decimal(real), decimal(imaginary))


__all__ = ["oscillations"]
