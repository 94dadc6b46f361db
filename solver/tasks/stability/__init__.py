"""Questions about stability."""

from solver.derivation import Topic

TOPIC = Topic(group="Representation and analysis", order=40, title="Stability")
