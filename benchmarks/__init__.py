"""Side-by-side timings with the peers named in the speed targets; run `python -m benchmarks`."""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # as the program does, whoever imports numpy first
