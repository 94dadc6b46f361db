"""The shape of a problem file: one set of models validates files and gives the JSON Schema.

Scalars arrive as text (see `yaml_tree`), so `Value` is a string here and a number or a string in the schema.
What stands in the values, and the options of a part, is read elsewhere: it depends on the catalogue.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeVar, Union

from pydantic import BaseModel, BeforeValidator, ConfigDict, Discriminator, Field, StringConstraints, Tag, create_model
from pydantic import WithJsonSchema as Schema
from pydantic_core import PydanticCustomError

from solver.problem.elements import (
    AtEnd,
    Component,
    Matrix,
    Rational,
    Row,
    Shape,
    Value,
    Values,
    either,
    kind_of_value,
    optional,
)
from solver.problem.library import model_names
from solver.problem.source import did_you_mean
from solver.systems import kind, kinds

MAX_STATES = 12
MAX_PARTS = 60
PART_ID = r"^[\w.()-]{1,32}$"


def kind_of_system(value: Any) -> str | None:
    """Return the kind that the keys of a system tell; names of alternatives stand in <>, and are never keys."""
    if not isinstance(value, dict):
        return None
    return next((f"<{kinds()[key].name}>" for key in value if key in kinds()), "<state_space>")


YES_OR_NO = ("yes", "no", True, False)
YesOrNo = Annotated[Literal["yes", "no", True, False], Schema({"enum": [*YES_OR_NO]})]
Text = Annotated[str, Schema({"type": ["string", "number"]})]
Marks = Annotated[
    Annotated[Value, Tag("<value>")] | Annotated[dict[str, Value], Tag("<mapping>")],
    either("a number, or the marks of each answer, as in {K: 2, polynomial: 1},"),
]
Rule = Literal["entries", "none", "named"]
Costs = dict[str, Value]
PartialOfAnswer = Annotated[
    Annotated[Value, Tag("<value>")] | Annotated[Costs, Tag("<mapping>")],
    either("entries, none, named, or what a mistake costs, as in {sign: 1},"),
]
Partial = Annotated[
    Annotated[Rule, Tag("<value>")] | Annotated[dict[str, PartialOfAnswer], Tag("<mapping>")],
    either("entries, none, named, or a mapping such as {K: none, sign: 1},"),
]


def _model_name(value: Any) -> str:
    """Return the name of a model; whether there is one of that name is seen where it is read."""
    if not isinstance(value, str):
        raise PydanticCustomError("expected", "the name of a model ({names})", {"names": ", ".join(model_names())})
    return value


ModelName = Annotated[str, BeforeValidator(_model_name), Schema({"enum": list(model_names())})]

Taken = Annotated[
    Annotated[Value, Tag("<value>")]
    | Annotated[list[Row], Tag("<list>")]
    | Annotated[dict[str, Text], Tag("<mapping>")],
    either("a matrix, or {from: part},"),
]
Parameters = Annotated[
    Annotated[Value, Tag("<value>")]
    | Annotated[list[Value], Tag("<list>")]
    | Annotated[dict[str, Value], Tag("<mapping>")],
    either("a mapping (name: value)"),
]


S = TypeVar("S", bound=Shape)


class AnySystem(Shape):
    """What may stand beside any kind of system."""

    time: Literal["continuous", "discrete"] = Field(default="continuous", description="continuous or discrete time")
    sample_time: Value = optional("sampling period in discrete time")


KEYED: dict[str, type[Shape]] = {}
"""The models of mappings within a system by the key under which they stand."""


def _one_or_more(item: kind.Keyed) -> Discriminator:
    """Tell a mapping from a list of such, by the names of these alternatives."""
    needed = ", ".join(f"{key.name}: .." for key in item.keys if key.required)
    return Discriminator(
        lambda value: {"<mapping>": item.name, "<list>": f"{item.name}_list"}.get(kind_of_value(value) or ""),
        custom_error_type="expected",
        custom_error_message=f"a mapping {{{needed}}}, or a list of such mappings,",
    )


def _annotation(shape: kind.Shape) -> Any:
    """Return the type of what may stand under a key of a kind."""
    match shape:
        case kind.ListOf():
            return Annotated[list[_annotation(shape.item)], Field(min_length=1)]  # type: ignore[misc]  # made at run time
        case kind.MappingTo():
            return dict[str, _annotation(shape.value)]  # type: ignore[misc]  # made at run time
        case kind.OneOrMore():
            one: Any = _annotation(shape.item)
            KEYED[f"{shape.item.name}_list"] = KEYED[shape.item.name]
            alternatives = (
                Annotated[one, Tag(shape.item.name)],
                Annotated[list[one], Tag(f"{shape.item.name}_list"), Field(min_length=1)],
            )
            return Annotated[Union[alternatives], _one_or_more(shape.item)]  # noqa: UP007 - of a tuple made at run time
        case kind.Keyed():
            KEYED[shape.name] = _fields_of(f"{shape.name}_keys", shape.keys, Shape, f"What stands under {shape.name}.")
            return KEYED[shape.name]
        case _:
            return {
                kind.Value: Value,
                kind.Values: Values,
                kind.Matrix: Matrix,
                kind.Fraction: Rational,
                kind.Gain: Taken,
                kind.ModelName: ModelName,
                kind.AtEnd: AtEnd,
                kind.Component: Component,
            }[type(shape)]


def _fields_of(name: str, keys: Sequence[kind.Key], base: type[S], doc: str) -> type[S]:
    """Return the model of a mapping with these keys."""
    fields: dict[str, Any] = {}
    for key in keys:
        given = Field(description=key.doc) if key.required else optional(key.doc)
        fields[key.name] = (_annotation(key.shape), given)
    return create_model(name.title().replace("_", "") + "Shape", __base__=base, __doc__=doc, **fields)


def _model(declared: kind.Kind) -> type[AnySystem]:
    """Return the model of a kind of system."""
    return _fields_of(declared.name, declared.keys, AnySystem, declared.doc)


SYSTEMS: Mapping[str, type[AnySystem]] = {f"<{each.name}>": _model(each) for each in kinds().values()}
"""The model of each kind of system by the name of the alternative."""


def _known_kind(value: Any) -> Any:
    """Refuse, in words, a system whose keys tell no kind that can be read."""
    if not isinstance(value, dict) or any(key in value for key in kinds()):
        return value
    known = [key for model in SYSTEMS.values() for key in model.model_fields]
    for key in value:
        if key not in known:
            context = {"key": key, "suggestion": did_you_mean(key, known)}
            raise PydanticCustomError("at_key", "unknown key '{key}' in a system", context)
    return value


_ALTERNATIVES = tuple(Annotated[model, Tag(name)] for name, model in SYSTEMS.items())

if TYPE_CHECKING:
    System = AnySystem
else:
    System = Annotated[
        Union[_ALTERNATIVES],  # noqa: UP007 - of a tuple made at run time
        Discriminator(
            kind_of_system,
            custom_error_type="expected",
            custom_error_message="a system: a mapping such as {A: [[0, 1], [-2, -3]], B: [0, 1]}",
        ),
        BeforeValidator(_known_kind),
    ]


DRAWN = {
    "<choose>": _fields_of(
        "choose",
        [kind.Key("choose", kind.ListOf(kind.Value()), "the values to choose from", required=True)],
        Shape,
        "A list of values to choose from.",
    ),
    "<steps>": _fields_of(
        "steps",
        [
            kind.Key("from", kind.Value(), "the first value", required=True),
            kind.Key("to", kind.Value(), "no value is larger", required=True),
            kind.Key("step", kind.Value(), "from one value to the next, 1 if absent; 1/2, say, for halves"),
        ],
        Shape,
        "Values at equal distances: integers where nothing is said of the step.",
    ),
}
"""What a name of a family can be drawn from, by the name of the alternative."""

if TYPE_CHECKING:
    Drawn = Shape
else:
    Drawn = Annotated[
        Union[tuple(Annotated[model, Tag(name)] for name, model in DRAWN.items())],  # noqa: UP007 - as above
        Discriminator(
            lambda value: None if not isinstance(value, dict) else "<choose>" if "choose" in value else "<steps>",
            custom_error_type="expected",
            custom_error_message="what is drawn from, {from: 1, to: 9} or {choose: [1, 2, 5]},",
        ),
    ]

Niceness = Literal["integers", "rationals", "exact"]
Assumption = Literal["positive", "negative", "nonzero", "real", "complex", "integer"]


class ShowShape(Shape):
    """What a paper shows."""

    system: bool = Field(default=True, description="whether what is given about the system is printed")
    method: bool = Field(default=True, description="whether the method is named")
    source: bool = Field(default=True, description="whether the literature is named")


class PartShape(BaseModel):
    """One question with its options; the other keys are options of the task."""

    model_config = ConfigDict(extra="allow", strict=True)

    task: Text = Field(description="what is asked; `solve tasks` lists the names")
    method: Values = optional("one method of the task, or several")
    marks: Marks = optional("marks of the part, or of each of its answers")
    prompt: Text = optional("own wording of the question, in Markdown")
    answers: Values = optional("the answers that are asked for and earn the marks")
    digits: Value = optional("significant digits that a student's decimal must have")
    partial: Partial = optional("what wrong answers earn: entries, none, named, by answer, or by mistake: {sign: 1}")
    decimal_comma: YesOrNo = optional("whether students may write 1,5 for 1.5, where the part differs from the problem")
    show: ShowShape = optional("what a paper shows of the part; false leaves out what would give it away")
    system: System = optional("the part's own system")
    parameters: Parameters = optional("the part's own values of symbols, which win over those of the problem")
    assume: dict[str, Assumption] = optional("what the part knows of symbols")
    conditions: Values = optional("further relations that hold in the part, as those of the problem")


class DisplayShape(Shape):
    """How numbers are shown."""

    mode: Literal["exact", "decimals", "both"] = Field(default="decimals", description="how numbers are shown")
    decimals: Value = optional("significant digits of decimals")


Display = Annotated[
    Annotated[Literal["exact", "decimals", "both"], Tag("<value>")] | Annotated[DisplayShape, Tag("<mapping>")],
    either("exact, both or {decimals: 4}"),
]
Find = Annotated[
    Annotated[Text, Tag("<value>")] | Annotated[PartShape, Tag("<mapping>")],
    either("a task's name or a mapping {task: .., ..}"),
]


class ProblemShape(Shape):
    """A problem: a system and what is asked about it."""

    title: Text = optional("printed on top")
    source: Text = optional("where the problem is from; printed under the title")
    statement: Text = optional("the problem in words: Markdown with $math$")
    parameters: dict[str, Value] = optional("values of symbols that occur in the expressions")
    assume: dict[str, Assumption] = optional("what is known of symbols without a value")
    conditions: Values = optional('relations that hold between symbols: ["0 < zeta < 1", "a != b"]')
    vary: dict[str, Drawn] = optional("what names of the parameters are drawn from, in the other members of a family")
    require: Values = optional('what must hold of a member: "a != 2", "a b = 6", controllable, stable')
    nice: dict[str, Niceness] = optional("what must come out, by part and answer: {b.K: integers}")
    display: Display = optional("how numbers are shown")
    digits: Value = optional("significant digits that a student's decimals must have, 2 if nothing is said")
    partial: Partial = optional("what wrong answers of all parts earn: entries (if nothing is said), none or named")
    decimal_comma: YesOrNo = optional("whether students may write 1,5 for 1.5; lists are then separated by ;")
    show: ShowShape = optional("what a paper shows of all parts")
    language: Text = optional("the language of the solution: en, de")
    notation: Text = optional("the symbols of the solution: course (K_f, L_c, xi) or ogata (K, K_e, zeta)")
    system: System = optional("the system of all parts without their own")
    find: dict[Annotated[str, StringConstraints(pattern=PART_ID)], Find] = Field(
        min_length=1, max_length=MAX_PARTS, description="what is asked, in order, by the part's name as printed"
    )
