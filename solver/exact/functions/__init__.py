"""Residues of rational matrices and what is written with them: partial fractions, transforms, functions of a matrix."""
