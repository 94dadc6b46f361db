"""Calculus of variations and optimal control over a finite horizon."""

from solver.derivation import Topic

TOPIC = Topic(
    group="Calculus of variations and optimal control", order=74, title="Calculus of variations and finite horizons"
)
