"""What the input reaches and what the output shows."""

from solver.derivation import Topic

TOPIC = Topic(group="Representation and analysis", order=50, title="Controllability and observability")
