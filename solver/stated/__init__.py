"""Formulas as a person writes them, not carried out; one file a small family of operations.

A worked solution shows `det(λI − A) = λ² + 3λ + 2`. The right side is an exact sympy object; the left side is a
`Stated` formula: it is printed as it stands, and `numeric` evaluates it with its own algorithms. So a wrong right side
cannot hide: nothing that derived it takes part in checking it.

An operation declares in its file how it is called, how it is printed and what it binds. Its evaluation is the module of
its name in `solver/numeric/evaluation/operations/`, which shares no code with the derivations.
"""

from solver.stated.declaration import Binding, Operation, Stated, every_operation, operation, operation_named

__all__ = ["Binding", "Operation", "Stated", "every_operation", "operation", "operation_named"]
