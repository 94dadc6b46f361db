"""Classical control: questions about polynomials, transfer functions and loops."""

from solver.derivation import Topic

TOPIC = Topic(group="Classical control", order=80, title="Classical control")
