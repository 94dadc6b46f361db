"""Questions of linear algebra about the system matrix."""

from solver.derivation import Topic

TOPIC = Topic(group="Representation and analysis", order=10, title="Matrices, eigenvalues and subspaces")
