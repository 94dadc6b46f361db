"""Lead, lag and PID controllers that meet specifications."""

from solver.derivation import Topic

TOPIC = Topic(group="Classical control", order=84, title="Compensators and PID controllers")
