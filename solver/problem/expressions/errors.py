"""The one error of the notation."""

from __future__ import annotations


class ExpressionError(Exception):
    """A text is not an expression, or not a safe one.

    `at` is the offset in the text (0-based, in characters), `length` the number of characters concerned (at least 1;
    the place just after the text stands for what is missing there). `message` says what is wrong and what was
    expected; `suggestion` is what may be written instead, so that "write " can stand before it, or empty.
    """

    def __init__(self, message: str, at: int = 0, length: int = 1, suggestion: str = "") -> None:
        super().__init__(message)
        self.message = message
        self.at = at
        self.length = max(1, length)
        self.suggestion = suggestion
