"""The markup of texts: Markdown with `$math$`, parsed and checked; the reader and the pages share it."""

from solver.markup.markdown import MATH_TOKENS, address_of, alignments, images_in, math_problems, parser, tokens

__all__ = ["MATH_TOKENS", "address_of", "alignments", "images_in", "math_problems", "parser", "tokens"]
