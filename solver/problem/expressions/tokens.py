"""The text cut into tokens, each with its place. Knows characters, not meaning; needs no algebra."""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass
from enum import StrEnum
from fractions import Fraction
from keyword import iskeyword

from solver.problem.expressions.errors import ExpressionError
from solver.problem.expressions.notation import (
    GREEK,
    INSTEAD,
    MAX_CHARACTERS,
    MAX_DIGITS,
    MAX_NAME,
    MAX_POWER_OF_TEN,
    MAX_TOKENS,
    OPERATORS,
    RESERVED,
    SPACES,
    SUPERSCRIPTS,
)

_LETTERS = "".join(GREEK)
_NUMBER = re.compile(r"(?:[0-9]+(?:\.[0-9]+)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")
_NAME = re.compile(rf"(?:[A-Za-z][A-Za-z0-9]*|[{_LETTERS}][0-9]*)(?:_[A-Za-z0-9{_LETTERS}]+)*")
_LAMBDA = re.compile(r"(?<![A-Za-z])lambda(?![A-Za-z])")
_MULTIPLIER = re.compile(r"lamda(?=\d+(?:_d{0,2}dot)?\Z)")
"""λ with a number is spelled as multipliers are, `lambda1`, and its derivatives as `lambda1_dot`."""
_SUPERSCRIPT = re.compile(r"⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]+")


class Kind(StrEnum):
    """What a token is."""

    NUMBER = "number"
    NAME = "name"
    OPERATOR = "operator"
    SUPERSCRIPT = "superscript"
    END = "end"


@dataclass(frozen=True, slots=True)
class Token:
    """A piece of the text from `at` to before `end`; `text` is its plain spelling (names and signs in ASCII)."""

    kind: Kind
    text: str
    at: int
    end: int


def tokenize(text: str) -> list[Token]:
    """Return the tokens of a text, the last one of kind END. Raises ExpressionError where a character is not read."""
    if len(text) > MAX_CHARACTERS:
        raise ExpressionError(f"the expression is longer than {MAX_CHARACTERS} characters", MAX_CHARACTERS)
    tokens: list[Token] = []
    at = 0
    while at < len(text):
        if text[at] in SPACES:
            at += 1
            continue
        found = _token(text, at)
        tokens.extend(found)
        at = found[-1].end
        if len(tokens) > MAX_TOKENS:
            raise ExpressionError(f"the expression has more than {MAX_TOKENS} numbers, names and signs", at - 1)
    return [*tokens, Token(Kind.END, "", at, at)]


def _token(text: str, at: int) -> list[Token]:
    """The token at a place; a double prime gives two."""
    if found := _NUMBER.match(text, at):
        return [_number(text, at, found.end())]
    if found := _NAME.match(text, at):
        return [_name(text, at, found.end())]
    if found := _SUPERSCRIPT.match(text, at):
        digits = "".join(SUPERSCRIPTS[sign] for sign in found.group())
        return [_short(Token(Kind.SUPERSCRIPT, digits, at, found.end()))]
    if text.startswith("**", at):
        return [Token(Kind.OPERATOR, "^", at, at + 2)]
    if signs := OPERATORS.get(text[at]):
        return [Token(Kind.OPERATOR, sign, at, at + 1) for sign in signs]
    raise _unreadable(text[at], at)


def _number(text: str, at: int, end: int) -> Token:
    if text.startswith(".", end):
        raise ExpressionError(
            "a digit is expected after the decimal point", end, 1, f"{text[at:end]} or {text[at:end]}.0"
        )
    return _short(Token(Kind.NUMBER, text[at:end], at, end))


def _short(token: Token) -> Token:
    """The token, if it has no more digits than a number may have."""
    mantissa, _, exponent = token.text.lower().partition("e")
    if sum(sign.isdigit() for sign in mantissa) > MAX_DIGITS:
        raise ExpressionError(f"a number has at most {MAX_DIGITS} digits", token.at, token.end - token.at)
    if len(exponent.lstrip("+-0")) > 2 or abs(int(exponent or 0)) > MAX_POWER_OF_TEN:
        message = f"powers of ten go from -{MAX_POWER_OF_TEN} to {MAX_POWER_OF_TEN}"
        raise ExpressionError(message, token.at, token.end - token.at)
    return token


def exact_number(token: Token) -> Fraction:
    """Return the value of a NUMBER (or SUPERSCRIPT) token, exactly as written."""
    return Fraction(token.text)


def is_decimal(token: Token) -> bool:
    """Whether the token is a number with a decimal point or a power of ten."""
    return token.kind is Kind.NUMBER and not token.text.isdigit()


def _name(text: str, at: int, end: int) -> Token:
    written = text[at:end]
    if text.startswith("_", end):
        raise ExpressionError("a letter or digit is expected after the underscore", end, 1, f"{written}_1")
    if written in ("δ", "Δ", "∆") and _NAME.match(text, end):
        message = f"unclear: {written}{text[end]} may be one name or a product"
        raise ExpressionError(message, at, 2, f"{GREEK[written]}_{text[end]} or {GREEK[written]}*{text[end]}")
    if len(written) > MAX_NAME:
        raise ExpressionError(f"a name has at most {MAX_NAME} characters", at, end - at)
    name = _LAMBDA.sub("lamda", "".join(GREEK.get(sign, sign) for sign in written))
    name = _MULTIPLIER.sub("lambda", name)
    if iskeyword(name) or name in RESERVED:
        raise ExpressionError(f"{written} is a reserved word and cannot be a name", at, end - at, f"{name}_1")
    return Token(Kind.NAME, name, at, end)


def _unreadable(sign: str, at: int) -> ExpressionError:
    if unicodedata.category(sign).startswith("C") or unicodedata.category(sign) in ("Zl", "Zp"):
        return ExpressionError(f"an invisible character (U+{ord(sign):04X}) is not allowed here", at)
    described = "" if sign.isascii() else f" (U+{ord(sign):04X}, {unicodedata.name(sign, 'unnamed').lower()})"
    message = f"the character {sign}{described} has no meaning in an expression"
    return ExpressionError(message, at, 1, INSTEAD.get(sign, ""))
