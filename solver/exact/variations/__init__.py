"""Functionals: Euler-Lagrange equations and their solutions, conditions on extrema, finite horizons."""
