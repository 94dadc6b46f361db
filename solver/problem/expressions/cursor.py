"""The tokens of a text, and how far they have been read."""

from __future__ import annotations

from solver.problem.expressions.syntax import Node
from solver.problem.expressions.tokens import Kind, Token, tokenize


class Cursor:
    """A place between the tokens of a text: `last` is the token before it, `token` the one after it."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.tokens = tokenize(text)
        self.position = 0

    @property
    def token(self) -> Token:
        """The next token; at the end of the text it is of kind END."""
        return self.tokens[self.position]

    @property
    def last(self) -> Token:
        """The token read last; there must be one."""
        return self.tokens[self.position - 1]

    def after(self, count: int) -> list[Token]:
        """Return up to `count` tokens that follow the next one."""
        return self.tokens[self.position + 1 : self.position + 1 + count]

    def take(self) -> Token:
        """Read the next token."""
        self.position += 1
        return self.last

    def sees(self, *signs: str) -> bool:
        """Whether the next token is one of these operators."""
        return self.token.kind is Kind.OPERATOR and self.token.text in signs

    def sees_kind(self, kind: Kind) -> bool:
        """Whether the next token is of this kind."""
        return self.token.kind is kind

    def sees_adjacent(self, *signs: str) -> bool:
        """Whether one of these operators follows without a space."""
        return self.sees(*signs) and self.token.at <= self.last.end

    def written(self, node: Node) -> str:
        """Return the text of a node."""
        return self.text[node.at : node.end]
