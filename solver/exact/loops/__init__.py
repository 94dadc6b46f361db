"""Errors of loops, sensitivities, and graphs of signals."""
