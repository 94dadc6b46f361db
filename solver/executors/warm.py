"""Importing this module loads what any problem may need, once for all processes that are forked afterwards."""

from solver.limits.child import load_all_algebra
from solver.startup import begin_loading, end_loading, quiet_threads

quiet_threads()  # before numpy is imported
begin_loading()
load_all_algebra()
end_loading()
