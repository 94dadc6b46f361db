"""The shape of a problem file; it checks files, and the JSON Schema is made from it.

The options of a part are read elsewhere: they depend on the catalogue.
"""

from __future__ import annotations

from collections.abc import Iterator
from unicodedata import category

from solver.problem.nodes import MappingNode, Node
from solver.problem.shapes import (
    Either,
    Field,
    ListOf,
    MappingOf,
    Misshapen,
    Path,
    Record,
    Scalar,
    Schema,
    Word,
    is_text,
    kind_of_value,
)
from solver.problem.source import did_you_mean

MAX_STATES = 12
MAX_PARTS = 60
PART_ID = r"^[\w.()-]{1,32}$"
LONGEST_PART_ID = 32

RESERVED = ("equations", "lagrangian", "circuit", "functional", "model")
"""Kinds of system that are known but can't be read yet."""

TEXT = Scalar("string", "number")
VALUE = Scalar("number", "string")
VALUES = Either("a value or a list of values", kind_of_value, value=VALUE, list=ListOf(VALUE))
ROW = Either("a row of numbers or expressions", kind_of_value, value=VALUE, list=ListOf(VALUE))
MATRIX = Either("a matrix: a list of rows [[..], [..]]", kind_of_value, value=VALUE, list=ListOf(ROW, least=1))
MARKS = Either(
    "a number, or the marks of each answer, as in {K: 2, polynomial: 1},",
    kind_of_value,
    value=VALUE,
    mapping=MappingOf(VALUE),
)
MODE = Word("exact", "decimals", "both")


def _kind_of_transfer_function(node: Node) -> str:
    if isinstance(node, MappingNode):
        return "fraction" if "numerator" in node or "denominator" in node else "zeros_poles_gain"
    return "value" if is_text(node) else ""


RATIONAL = Either(
    "an expression, {zeros, poles, gain} or {numerator, denominator}",
    _kind_of_transfer_function,
    value=VALUE,
    zeros_poles_gain=Record(
        "ZerosPolesGain",
        "G = gain (s − z₁)…/((s − p₁)…).",
        {
            "zeros": Field(VALUES, "zeros; none if absent"),
            "poles": Field(VALUES, "poles; none if absent"),
            "gain": Field(VALUE, "the factor in front; 1 if absent"),
        },
    ),
    fraction=Record(
        "Fraction",
        "Coefficients, the highest power first.",
        {
            "numerator": Field(VALUES, "coefficients of the numerator, highest power first", required=True),
            "denominator": Field(VALUES, "coefficients of the denominator, highest power first", required=True),
        },
    ),
)


class _SystemOfKind(Record):
    """A system; the key `kind` tells that it is of this kind."""

    kind: str

    def __init__(self, kind: str, name: str, doc: str, fields: dict[str, Field]) -> None:
        super().__init__(name, doc, {**ANY_SYSTEM, **fields})
        self.kind = kind

    def unknown(self, key: str, node: MappingNode) -> tuple[str, str]:
        """Tell a key of another kind of system from one that no system has."""
        if key in (*STATE_SPACE.fields, *KINDS, *RESERVED):
            return f"'{key}' cannot stand beside '{self.kind}'", ""
        return super().unknown(key, node)


ANY_SYSTEM = {
    "time": Field(Word("continuous", "discrete"), "continuous or discrete time", default="continuous"),
    "sample_time": Field(VALUE, "sampling period in discrete time"),
    "inputs": Field(VALUES, "names of the inputs"),
    "outputs": Field(VALUES, "names of the outputs"),
}
"""What may stand beside any kind of system."""

STATE_SPACE = _SystemOfKind(
    "A",
    "StateSpaceShape",
    "x' = A x + B u, y = C x + D u.",
    {
        "A": Field(MATRIX, "system matrix, n×n", required=True),
        "B": Field(MATRIX, "input matrix, n×m; a flat list is a column"),
        "C": Field(MATRIX, "output matrix, p×n; a flat list is a row"),
        "D": Field(MATRIX, "feedthrough, p×m; zero if absent"),
        "initial_state": Field(MATRIX, "x(0), n values"),
        "states": Field(VALUES, "names of the states"),
    },
)
TRANSFER_FUNCTION = _SystemOfKind(
    "transfer_function",
    "TransferFunctionShape",
    "G(s), in discrete time G(z).",
    {
        "transfer_function": Field(
            RATIONAL,
            "an expression in s (discrete: z), {zeros, poles, gain} or {numerator, denominator}",
            required=True,
        )
    },
)
TRANSFER_MATRIX = _SystemOfKind(
    "transfer_matrix",
    "TransferMatrixShape",
    "G(s) of several inputs or outputs.",
    {
        "transfer_matrix": Field(
            ListOf(ListOf(RATIONAL, least=1), least=1),
            "rows of transfer functions: one row an output, one column an input",
            required=True,
        )
    },
)
BARE_MATRIX = _SystemOfKind(
    "matrix",
    "MatrixShape",
    "A bare matrix, for questions of linear algebra.",
    {"matrix": Field(MATRIX, "a matrix", required=True)},
)
KINDS = {system.kind: system for system in (STATE_SPACE, TRANSFER_FUNCTION, TRANSFER_MATRIX, BARE_MATRIX)}
"""Systems by the key that tells their kind."""


def _kind_of_system(node: Node) -> str:
    """Return the key that tells the kind: A where there is none, whose absence is then the fault."""
    if not isinstance(node, MappingNode):
        return ""
    return next((key for key in KINDS if key in node), "A")


class _System(Either):
    """A system of any kind."""

    def faults(self, node: Node, path: Path) -> Iterator[Misshapen]:
        """Yield the faults; of a system whose keys tell no kind that can be read, the key that is most telling."""
        stray = _stray_key(node) if isinstance(node, MappingNode) else None
        if stray is None or not isinstance(node, MappingNode):
            yield from super().faults(node, path)
            return
        message, known = f"unknown key '{stray}' in a system", [*STATE_SPACE.fields, *KINDS, *RESERVED]
        if stray in RESERVED:
            message, known = f"'{stray}' cannot be read yet; give A, B, C, D or a transfer_function", []
        fault = node.entries[stray].key.diagnostic(message, did_you_mean(stray, known))
        yield Misshapen((*path, stray), fault)


def _stray_key(node: MappingNode) -> str | None:
    """Return the key, if there is one, that keeps a system without the key of any kind from being read."""
    if any(key in node for key in KINDS):
        return None
    reserved = (key for key in RESERVED if key in node)
    return next(reserved, next((key for key in node.entries if key not in STATE_SPACE.fields), None))


SYSTEM = _System("a system: a mapping such as {A: [[0, 1], [-2, -3]], B: [0, 1]}", _kind_of_system, **KINDS)
PART = Record(
    "PartShape",
    "One question with its options; the other keys are options of the task.",
    {
        "task": Field(TEXT, "what is asked; `solve tasks` lists the names", required=True),
        "method": Field(VALUES, "one method of the task, or several"),
        "marks": Field(MARKS, "marks of the part, or of each of its answers"),
        "prompt": Field(TEXT, "own wording of the question, in Markdown"),
        "system": Field(SYSTEM, "the part's own system"),
    },
    is_open=True,
)
DISPLAY = Record(
    "DisplayShape",
    "How numbers are shown.",
    {
        "mode": Field(MODE, "how numbers are shown", default="decimals"),
        "decimals": Field(VALUE, "significant digits of decimals"),
    },
)


class _Parts(MappingOf):
    """The parts by name: at least one, and not too many."""

    def faults(self, node: Node, path: Path) -> Iterator[Misshapen]:
        """Yield the faults of names and parts, or that there are none or too many."""
        if not isinstance(node, MappingNode):
            yield from super().faults(node, path)
        elif not node.entries:
            yield Misshapen(path, node.diagnostic("this is empty"))
        elif len(node.entries) > MAX_PARTS:
            yield Misshapen(path, node.diagnostic(f"there are more than {MAX_PARTS} parts"))
        else:
            yield from self._names(node, path)
            yield from super().faults(node, path)

    @staticmethod
    def _names(node: MappingNode, path: Path) -> Iterator[Misshapen]:
        for entry in node:
            if not names_a_part(entry.key.text):
                message = f"'{entry.key.text[:40]}' cannot name a part: at most 32 letters, digits, and - _ . ( )"
                yield Misshapen((*path, entry.key.text), entry.key.diagnostic(message))

    def schema(self) -> Schema:
        """Return the object with the names' pattern."""
        bounds = {"maxProperties": MAX_PARTS, "minProperties": 1}
        return {**bounds, "patternProperties": {PART_ID: self.value.schema()}, "type": "object"}


def names_a_part(name: str) -> bool:
    """Whether a name fits `PART_ID`, where a letter is one of any language, with its marks and joiners."""
    return 1 <= len(name) <= LONGEST_PART_ID and all(
        each in "_.()-\u200c\u200d" or category(each)[0] in "LM" or category(each) in ("Nd", "Nl", "Pc")
        for each in name
    )


PROBLEM = Record(
    "ProblemShape",
    "A problem: a system and what is asked about it.",
    {
        "title": Field(TEXT, "printed on top"),
        "source": Field(TEXT, "where the problem is from; printed under the title"),
        "statement": Field(TEXT, "the problem in words: Markdown with $math$"),
        "parameters": Field(MappingOf(VALUE), "values of symbols that occur in the expressions"),
        "assume": Field(
            MappingOf(Word("positive", "negative", "nonzero", "real", "complex", "integer")),
            "what is known of symbols without a value",
        ),
        "display": Field(
            Either("exact, both or {decimals: 4}", kind_of_value, value=MODE, mapping=DISPLAY), "how numbers are shown"
        ),
        "system": Field(SYSTEM, "the system of all parts without their own"),
        "find": Field(
            _Parts(Either("a task's name or a mapping {task: .., ..}", kind_of_value, value=TEXT, mapping=PART)),
            "what is asked, in order, by the part's name as printed",
            required=True,
        ),
    },
)


def check_shape(root: Node) -> list[Misshapen]:
    """Return what is wrong with the shape of a problem."""
    return list(PROBLEM.faults(root, ()))
