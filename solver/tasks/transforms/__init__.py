"""Laplace transforms and their inverses; linear differential equations."""

from solver.derivation import Topic

TOPIC = Topic(group="Transforms and differential equations", order=71, title="Transforms and differential equations")
