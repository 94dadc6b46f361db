"""Names in their place: which are known, and what was probably meant by those that are not."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from difflib import get_close_matches

from solver.problem.expressions.errors import ExpressionError
from solver.problem.expressions.names import Names
from solver.problem.expressions.notation import CONSTANTS, FUNCTIONS, GREEK_NAMES, OTHER_CONSTANTS, OTHER_FUNCTIONS
from solver.problem.expressions.tokens import Token

_TIMES = ("t", "k")
_STEPS = ("u", "sigma", "1", "1.0")
"""How the unit step is written elsewhere."""
_STEPS_ELSEWHERE = (*_STEPS, "theta", "epsilon", "eps")
"""The same, with names that more often mean something else."""


def check_name(token: Token, names: Names) -> None:
    """Raise an error unless the name has, or may be given, a meaning."""
    name = token.text
    if names.declares(name) or name in CONSTANTS:
        return
    length = token.end - token.at
    if name in OTHER_CONSTANTS:
        raise ExpressionError(f"{name} is no name of a symbol", token.at, length, OTHER_CONSTANTS[name])
    if product := as_product(name, names):
        message = f"{name} is not declared, and may be a product"
        raise ExpressionError(message, token.at, length, product)
    if not names.open:
        raise ExpressionError(f"unknown name {name}", token.at, length, names.like(name))


def check_call(token: Token, names: Names, following: Sequence[Token]) -> None:
    """Raise an error where `name(` cannot well be a product; `following` are the tokens after the bracket."""
    name, length = token.text, token.end - token.at
    if name in FUNCTIONS:
        message = f"unclear: {name} is declared as a name, and is also a function"
        raise ExpressionError(message, token.at, length, f"{name}*(...)")
    if not (names.declares(name) or name in CONSTANTS or _is_single_symbol(token)):
        of_time = any(each.text in _TIMES and each.text in names.variables for each in following)
        meant = f"step(...) or {name}*(...)" if of_time and name in _STEPS_ELSEWHERE else _function_like(name)
        raise ExpressionError(f"unknown function {name}", token.at, length, meant)
    if following[0].text in names.variables and [each.text for each in following[1:2]] == [")"]:
        raise _no_function(token, following[0].text, following[0].text)


def check_late(token: Token, names: Names, following: Sequence[Token], text: str) -> None:
    """Raise an error where `u(t - 1)` or `1(t)` is written, which is no product of two numbers.

    `following` are the tokens of the text after the bracket. Before a space only a sign of the unit step is refused.
    """
    inside = list(_to_its_end(following))
    time = next((each.text for each in inside if each.text in _TIMES and each.text in names.variables), "")
    tight = bool(following) and following[0].at == token.end + 1
    if time and token.text not in names.variables and (tight or token.text in _STEPS):
        raise _no_function(token, time, text[inside[0].at : inside[-1].end])


def _to_its_end(tokens: Sequence[Token]) -> Iterator[Token]:
    """Yield the tokens to the end of the bracket in which they stand."""
    depth = 0
    for each in tokens:
        depth += (each.text == "(") - (each.text == ")")
        if depth < 0:
            return
        yield each


def _no_function(token: Token, variable: str, inside: str) -> ExpressionError:
    name = token.text
    factor = inside if inside == variable else f"({inside})"
    suggestion = f"step({inside}) or {name}*{factor}" if name in _STEPS else f"{name}*{factor}"
    return ExpressionError(f"{name} is not a function of {variable} here", token.at, token.end - token.at, suggestion)


def prime_refused(token: Token, names: Names, end: int) -> ExpressionError:
    """Return the error for a prime after what is not a function of time."""
    message = f"a prime is a time derivative, and {token.text} is not a function of time here"
    meant = get_close_matches(token.text, names.functions, 1)
    return ExpressionError(message, token.at, end - token.at, f"{meant[0]}'" if meant else "")


def _is_single_symbol(token: Token) -> bool:
    """Whether one letter was typed, Latin or Greek, perhaps with an index: k, k_1, x10, ω_n, but not omega_n."""
    letter = token.text.partition("_")[0].rstrip("0123456789")
    return len(letter) == 1 or (letter in GREEK_NAMES and token.end - token.at < len(token.text))


def _function_like(name: str) -> str:
    """What was meant by an unknown function, or that a product needs its sign."""
    if known := OTHER_FUNCTIONS.get(name.lower()):
        return known
    return next(iter(get_close_matches(name.lower(), FUNCTIONS, 1, cutoff=0.7)), f"{name}*(...)")


def as_product(name: str, names: Names) -> str:
    """Return "x*y" for an undeclared name xy that can be read as a product, else an empty text.

    Its pieces are declared names or constants; or a letter before a variable of the task: Ts is T*s where s is one.
    """
    pieces = pieces_of(name, set(names.known()))
    if not pieces and names.open and name not in GREEK_NAMES:
        variable = next((each for each in names.variables if name.endswith(each)), "")
        factor = name.removesuffix(variable)
        if variable and (factor in GREEK_NAMES or (len(factor) == 1 and factor.isalpha())):
            pieces = [factor, variable]
    return "*".join(pieces)


def pieces_of(name: str, known: set[str]) -> list[str]:
    """Return the name cut into the fewest known names, at least two; empty if there is no such cut."""
    best: list[list[str] | None] = [[]]
    for end in range(1, len(name) + 1):
        cuts = [[*head, name[at:end]] for at in range(end) if (head := best[at]) is not None and name[at:end] in known]
        best.append(min(cuts, key=len, default=None))
    return best[-1] or [] if name not in known else []
