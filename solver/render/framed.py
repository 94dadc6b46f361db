"""A value in a frame, in whatever it stands: what a reader is pointed to, in colour or without."""

from __future__ import annotations

import sympy as sp


class Framed(sp.Expr):
    """An expression that is printed in a frame; its only argument is the expression."""
