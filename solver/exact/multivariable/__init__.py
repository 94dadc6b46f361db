"""Matrices of polynomials and of rational functions: minors, Smith forms, zeros, decoupling."""
