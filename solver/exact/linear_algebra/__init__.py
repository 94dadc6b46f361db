"""Matrices and polynomials over the field of their entries: elimination, eigenvalues, eigenvectors."""
