"""Worked, verified solutions of control-engineering problems."""

__version__ = "0.1.0"
