"""What a page displays is claimed: chains are read, their names bound to values, and every link judged."""

from solver.displayed.checking import displayed_checks, judged

__all__ = ["displayed_checks", "judged"]
