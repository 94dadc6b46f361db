"""A bare matrix, which stands for A in tasks about A."""

from __future__ import annotations

from solver.systems.kind import Key, Kind, Matrix, Reader
from solver.systems.state_space import StateSpace


def _read(reader: Reader) -> StateSpace:
    """Return the matrix as a system with A alone."""
    A = reader.matrix("matrix")
    reader.conclude()
    assert A is not None  # noqa: S101 - the shape was checked, and what is wrong with it concluded above
    return StateSpace(A, discrete=reader.discrete, sample_time=reader.sample_time, bare=True)


MATRIX = Kind(
    "matrix",
    doc="A bare matrix, for questions of linear algebra.",
    keys=(Key("matrix", Matrix(), "a matrix", required=True),),
    read=_read,
    example=(("matrix: [[1, 2], [2, 4]]", ""),),
)
