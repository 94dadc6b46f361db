"""The markup of texts: Markdown with `$math$`, parsed and checked; the reader and the pages share it."""

from solver.markup.formulas import GREEK_LETTERS, MathProblem, check_math, find_problem
from solver.markup.markdown import MATH_TOKENS, math_problems, parser, tokens

__all__ = [
    "GREEK_LETTERS",
    "MATH_TOKENS",
    "MathProblem",
    "check_math",
    "find_problem",
    "math_problems",
    "parser",
    "tokens",
]
