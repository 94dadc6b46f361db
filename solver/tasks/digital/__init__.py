"""Sampling of plants, and what is designed and decided in the z-plane."""

from solver.derivation import Topic

TOPIC = Topic(group="Digital control", order=90, title="Digital control")
