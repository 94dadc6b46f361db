"""The markup of texts: Markdown with `$math$`, parsed and checked; the reader and the pages share it."""

from solver.markup.markdown import MATH_TOKENS, math_problems, parser, tokens

__all__ = ["MATH_TOKENS", "math_problems", "parser", "tokens"]
