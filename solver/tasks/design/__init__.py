"""Design: feedback, observers, tracking."""

from solver.derivation import Topic

TOPIC = Topic(group="Design", order=60, title="Feedback, observers and tracking")
