"""The oracles: formulas and answers judged by numbers, on their own algorithms; nothing exact is imported here.

Each is imported when it is first used, and scipy by the functions that need it.
"""

import os

from solver.startup import names_of_stub

# Of small matrices the threads of the linear algebra library cost ten to a hundred times what they save. It reads
# this when numpy is first imported; a choice of the user's is respected.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

__all__, __getattr__ = names_of_stub(__name__, __file__)
