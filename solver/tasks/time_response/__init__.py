"""Questions about the motion of a system in time."""

from solver.derivation import Topic

TOPIC = Topic(group="Representation and analysis", order=30, title="Motion in time")
