"""Judges: analog computing. Each is imported when it is first used."""

from solver.startup import names_of_stub

__all__, __getattr__ = names_of_stub(__name__, __file__)
