"""Errors of loops, their sensitivity, and block diagrams."""

from solver.derivation import Topic

TOPIC = Topic(group="Classical control", order=81, title="Loops and block diagrams")
