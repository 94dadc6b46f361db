"""Several inputs and outputs: poles, zeros, interaction, decoupling."""

from solver.derivation import Topic

TOPIC = Topic(group="Several inputs and outputs", order=76, title="Several inputs and outputs")
