"""Formulas as trees: their nodes, the reader of LaTeX with its white list, and what is made of a tree."""

from solver.formula.latex import latex
from solver.formula.reader import MathProblem
from solver.formula.reading import find_problem, read
from solver.formula.vocabulary import GREEK_LETTERS

__all__ = ["GREEK_LETTERS", "MathProblem", "find_problem", "latex", "read"]
