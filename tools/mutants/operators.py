"""The slips: what can be changed in a file by a sign, a word, a number, or the order of two arguments."""

from __future__ import annotations

import ast
import copy
import hashlib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

COMPARISONS: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt, ast.Eq: ast.NotEq, ast.NotEq: ast.Eq,
    ast.Is: ast.IsNot, ast.IsNot: ast.Is, ast.In: ast.NotIn, ast.NotIn: ast.In,
}  # fmt: skip
SYMMETRIC = frozenset(
    (
        "isinstance issubclass zip max min gcd lcm getattr hasattr setattr hypot allclose "
        "add cast suppress TypeVar Claim"
    ).split()
)
"""Functions whose arguments may be swapped, or whose swapped arguments are no slip of anyone's."""
WORDED = frozenset({"check_residual", "that"})
"""Functions whose first two arguments are words for a reader: what is checked, and by what."""
UNSEEN_KEYWORDS = frozenset(
    "strict maxsize slots frozen kw_only stacklevel maxsteps maxn extraprec prec tol auto_reload".split()
)
"""Keywords that guard, make faster or refine what is right without them."""
CHANCE = frozenset("Random randint uniform choice".split())
"""Functions whose arguments say which of many points is drawn, where any point does."""
DIGITS = frozenset("N evalf workdps".split())
"""Functions whose number says how many digits are carried: one more changes none that is shown."""
SPEED = frozenset({"set_threshold", "lru_cache"})
"""Functions whose arguments make the program faster or slower and nothing else."""
WORDS = (ast.List, ast.Tuple, ast.ListComp, ast.JoinedStr, ast.Dict, ast.Set)


@dataclass(frozen=True)
class Mutant:
    """One slip: the text of an expression in a function of a file, and what stands there instead."""

    file: str
    function: str
    kind: str
    line: int
    last_line: int
    start: int
    end: int
    before: str
    after: str

    @property
    def room(self) -> str:
        """The folder of the program (or the file beside the folders) that it is in."""
        return Path(self.file).parts[1].removesuffix(".py")

    @property
    def place(self) -> str:
        """The room, and the folder in it."""
        return "/".join(Path(self.file).parts[1:-1][:2]) or self.room

    @property
    def key(self) -> str:
        """A number that depends on what is changed, not on where it stands: a sample keeps its members."""
        text = "\n".join((self.file, self.function, self.kind, self.before, self.after))
        return hashlib.sha256(text.encode()).hexdigest()

    def applied(self, source: bytes) -> bytes:
        """The file with the slip in it."""
        return source[: self.start] + self.after.encode() + source[self.end :]


def mutants_of(path: Path, root: Path) -> Iterator[Mutant]:
    """Yield every slip that can be made in a file."""
    source = path.read_bytes()
    starts = [0]
    for line in source.splitlines(keepends=True):
        starts.append(starts[-1] + len(line))
    for function, node in _expressions(ast.parse(source), ""):
        start = starts[node.lineno - 1] + node.col_offset
        end = starts[(node.end_lineno or node.lineno) - 1] + (node.end_col_offset or 0)
        before = source[start:end].decode()
        for kind, changed in _changes(node):
            last_line = node.end_lineno or node.lineno
            after = f"({ast.unparse(changed)})" if kind != "constant" else ast.unparse(changed)
            name = path.relative_to(root).as_posix()
            yield Mutant(name, function, kind, node.lineno, last_line, start, end, before, after)


def _expressions(node: ast.AST, function: str, raised: bool = False) -> Iterator[tuple[str, ast.expr]]:
    """Walk through what is computed, with the name of the function around it: no annotations, decorators, texts.

    In what is raised, what decides between two texts is no slip: it changes the words alone.
    """
    raised = raised or isinstance(node, ast.Raise)
    for field, value in ast.iter_fields(node):
        if field in {"annotation", "returns", "decorator_list", "type_params"}:
            continue
        if field == "test" and raised and _is_choice_of_words(node):
            continue
        for child in value if isinstance(value, list) else [value]:
            if not isinstance(child, ast.AST) or _is_unseen(child):
                continue
            if isinstance(child, ast.keyword) and child.arg in UNSEEN_KEYWORDS:
                continue
            if isinstance(child, ast.Constant) and _is_measure(node):
                continue
            inside = function
            if isinstance(child, (ast.FunctionDef, ast.ClassDef)):
                inside = f"{function}.{child.name}".lstrip(".")
            if isinstance(child, ast.expr):
                yield inside, child
            yield from _expressions(child, inside, raised)


def _is_unseen(node: ast.AST) -> bool:
    match node:
        case ast.JoinedStr():
            return True
        case ast.If(ast.Name("TYPE_CHECKING")) | ast.If(ast.Compare(ast.Name("__name__"))):
            return True
        case ast.Call(function):
            return _name(function) in SPEED | CHANCE | {"cast"}
    return _is_tiny(node)


def _is_tiny(node: ast.AST) -> bool:
    """Whether it is a power of ten below which nothing is left: others near it do as well."""
    match node:
        case ast.BinOp(base, ast.Pow(), exponent):
            return _is_ten(base) and ast.unparse(exponent).startswith("-")
    return False


def _is_ten(node: ast.expr) -> bool:
    match node:
        case ast.Constant(value):
            return value == 10
        case ast.Call(_, [only]):
            return _is_ten(only)
    return False


def _is_measure(node: ast.AST) -> bool:
    """Whether the numbers in it are counts of digits, or the 1 of the scale 1 + |x|."""
    match node:
        case ast.Call(function):
            return _name(function) in DIGITS
        case ast.BinOp(ast.Constant(), ast.Add(), ast.Call(function)):
            return _name(function) == "abs"
    return False


def _is_choice_of_words(node: ast.AST) -> bool:
    """Whether it is one of two texts that a person reads: a single word may be a key."""
    match node:
        case ast.IfExp(_, ast.Constant(str() as one), ast.Constant(str() as other)):
            return " " in one and " " in other
    return False


def _name(function: ast.expr) -> str:
    return function.attr if isinstance(function, ast.Attribute) else getattr(function, "id", "")


def _changes(node: ast.expr) -> Iterator[tuple[str, ast.expr]]:
    match node:
        case ast.BinOp(left, ast.Add() | ast.Sub() as op, right) if not _is_text(left) and not _is_text(right):
            yield "sign", ast.BinOp(left, ast.Sub() if isinstance(op, ast.Add) else ast.Add(), right)
            yield "dropped term", left
        case ast.BinOp(left, ast.Mult(), right) if not _is_text(left) and not _is_text(right):
            yield "dropped term", left
            yield "dropped term", right
        case ast.UnaryOp(ast.USub(), operand) if not isinstance(operand, ast.Constant):
            yield "sign", operand
        case ast.UnaryOp(ast.USub(), ast.Constant(int() as value)):
            yield "constant", ast.Constant(value)
        case ast.UnaryOp(ast.Not(), operand):
            yield "negation", operand
        case ast.BoolOp(op, values):
            yield "and/or", ast.BoolOp(ast.Or() if isinstance(op, ast.And) else ast.And(), values)
            for i in range(len(values)):
                rest = values[:i] + values[i + 1 :]
                yield "dropped term", ast.BoolOp(op, rest) if len(rest) > 1 else rest[0]
        case ast.Compare(left, [ast.Lt() | ast.LtE() | ast.Gt() | ast.GtE()], [right]) if _is_decimal(left, right):
            return  # no number meets a threshold exactly
        case ast.Compare(left, [op], [right]):
            yield "comparison", ast.Compare(left, [COMPARISONS[type(op)]()], [right])
        case ast.Constant(bool() as value):
            yield "constant", ast.Constant(not value)
        case ast.Constant(int() as value):
            yield "constant", ast.Constant(value + 1)
        case ast.Call(function, [first, second, *rest]) if _is_ordered(function, first, second):
            swapped = copy.copy(node)
            swapped.args = [second, first, *rest]
            yield "swapped argument", swapped


def _is_decimal(*nodes: ast.expr) -> bool:
    """Whether one of the expressions is a decimal other than 0.0, which is met, or of a small power of ten."""
    decimals = (isinstance(node, ast.Constant) and isinstance(node.value, float) and node.value for node in nodes)
    return any(decimals) or any(_is_tiny(part) for node in nodes for part in ast.walk(node))


def _is_number(node: ast.expr) -> bool:
    """Whether it is a number as it stands, which commutes with every factor."""
    return isinstance(node.operand if isinstance(node, ast.UnaryOp) else node, ast.Constant)


def _is_text(node: ast.expr) -> bool:
    """Whether an operand is a text or a collection: what is joined to it is no term."""
    if isinstance(node, ast.BinOp):
        return _is_text(node.left) or _is_text(node.right)
    return isinstance(node, WORDS) or (isinstance(node, ast.Constant) and isinstance(node.value, str))


def _is_ordered(function: ast.expr, first: ast.expr, second: ast.expr) -> bool:
    plain = not isinstance(first, ast.Starred) and not isinstance(second, ast.Starred)
    factor = _name(function) == "product" and (_is_number(first) or _is_number(second))
    return plain and not factor and _name(function) not in SYMMETRIC | WORDED and ast.dump(first) != ast.dump(second)
