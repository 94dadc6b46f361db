"""Conversions between kinds of system, one file a pair, found by themselves; see `solver.derivation.conversion`."""
