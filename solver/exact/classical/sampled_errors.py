"""How far the step response of a reduced discrete system is from that of the whole one, sample by sample."""

from __future__ import annotations

import mpmath
import numpy as np
import sympy as sp

from solver.exact.classical.power_sums import MOST, PowerSum
from solver.exact.classical.reduction_errors import LargestError
from solver.exact.linear_algebra.fields import NotExact
from solver.exact.linear_algebra.spectrum import DIGITS
from solver.exact.time_response.peaks import modes_of
from solver.exact.time_response.response import ClosedForm

NEAR = 1e-9


def largest_sampled_error(found: ClosedForm) -> LargestError:
    """The sample of largest size of a response that tends to a limit, in 30 digits; raises NotExact for a slow one."""
    final = found.y_final[0]  # type: ignore[index]  # it has a limit
    with mpmath.workdps(DIGITS + 15):
        modes = [mode for mode in modes_of(found.pieces[0][1].y) if mode[0] != 1]  # type: ignore[arg-type]  # an output
    away = PowerSum(tuple(mode for mode in modes if mode[2]))
    limit, stop = float(sp.N(final)), 64
    while stop < MOST:
        sizes = abs(limit + away.rough(stop))
        best = float(sizes.max())
        beyond = best - abs(limit)
        if beyond <= NEAR * best:
            if stop > away.within(max(NEAR * abs(limit), 1e-280)):
                return LargestError(sp.oo, sp.N(final, DIGITS))
        elif stop > away.within(beyond * (1 - NEAR)):
            k = int(np.argmax(sizes >= best * (1 - NEAR)))
            with mpmath.workdps(DIGITS + 15):
                value = mpmath.mpmathify(sp.N(final, DIGITS + 15)) + away.value(k)
                return LargestError(sp.Integer(k), sp.Float(value, DIGITS))
        stop *= 2
    raise NotExact("step_specifications/slow")
