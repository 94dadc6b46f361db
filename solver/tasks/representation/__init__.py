"""Tasks about models and their forms: transfer functions, realizations, coordinates."""

from solver.derivation import Topic

TOPIC = Topic(group="Representation and analysis", order=20, title="Transfer functions, realizations and coordinates")
