"""Modelling: from the equations of a system to its models."""

from solver.derivation import Topic

TOPIC = Topic(group="Modelling", order=70, title="Models of systems")
