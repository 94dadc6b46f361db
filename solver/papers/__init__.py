"""Families of problems and the papers made of them."""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before numpy is imported: a process with threads must not fork
