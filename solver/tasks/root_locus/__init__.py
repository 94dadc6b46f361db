"""Where the poles of a loop go as a gain rises."""

from solver.derivation import Topic

TOPIC = Topic(group="Classical control", order=83, title="Root locus")
