"""The exact kernels: algebra on matrices over a field, with no prose and no floats.

Each is imported when it is first used. The stub of each topic says which names tasks may use.
"""

from pathlib import Path

from solver.startup import names_of_stubs

__all__, __getattr__ = names_of_stubs(__name__, *sorted(Path(__file__).parent.glob("*/__init__.pyi")))
