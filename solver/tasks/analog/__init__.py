"""Analog computing: stages of amplifiers, scaling, and programs of a machine."""

from solver.derivation import Topic

TOPIC = Topic(group="Analog computing", order=100, title="Analog computing")
