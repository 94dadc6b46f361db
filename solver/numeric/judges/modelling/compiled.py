"""Expressions as functions of numbers, or of arrays of them, with numpy."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import sympy as sp

Function = Callable[[Mapping[Any, Any]], Any]

NUMPY: dict[str, Callable[..., Any]] = {
    "Add": lambda *terms: sum(terms), "Mul": lambda *parts: np.prod(np.broadcast_arrays(*parts), axis=0),
    "sin": np.sin, "cos": np.cos, "tan": np.tan, "exp": np.exp, "sinh": np.sinh, "cosh": np.cosh, "tanh": np.tanh,
    "Abs": np.abs, "sign": np.sign, "log": lambda x: np.log(_complex(x)), "asin": lambda x: np.arcsin(_complex(x)),
    "acos": lambda x: np.arccos(_complex(x)), "atan": np.arctan, "asinh": np.arcsinh,
    "acosh": lambda x: np.arccosh(_complex(x)), "atanh": lambda x: np.arctanh(_complex(x)),
    "atan2": lambda y, x: np.arctan2(np.real(y), np.real(x)),
}  # fmt: skip


def _complex(x: Any) -> Any:
    """A number as it is where the function is real there, else as a complex one."""
    return x if isinstance(x, np.ndarray) else complex(x)


def compiled(e: Any) -> Function:
    """Return the function of the values of symbols, numbers or arrays of them."""
    if e.is_Symbol:
        return lambda at: at[e]
    if e.is_number:
        number = complex(e.evalf(20))
        value = number.real if number.imag == 0 else number
        return lambda _at: value
    parts = [compiled(each) for each in e.args]
    if e.is_Pow:
        return _power(e, *parts)
    function = NUMPY[e.func.__name__]
    return lambda at: function(*(part(at) for part in parts))


def _power(e: Any, base: Function, exponent: Function) -> Function:
    if e.exp.is_Integer:
        n = int(e.exp)
        return lambda at: base(at) ** n if n > 0 else 1.0 / base(at) ** -n
    if e.base is sp.S.NegativeOne:
        return lambda at: np.cos(np.pi * exponent(at))
    return lambda at: _complex(base(at)) ** exponent(at)
