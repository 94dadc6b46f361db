"""Sinusoids through a system: Bode, margins, Nyquist."""

from solver.derivation import Topic

TOPIC = Topic(group="Classical control", order=82, title="Frequency response")
