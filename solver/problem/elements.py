"""Values that stand in a problem file, as models: numbers, lists, matrices, quotients of polynomials, ends."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Discriminator, Field, Tag
from pydantic import WithJsonSchema as Schema


def kind_of_value(value: Any) -> str | None:
    """Return "<value>", "<list>" or "<mapping>"; None for anything else."""
    if isinstance(value, str):
        return "<value>"
    return "<list>" if isinstance(value, list) else "<mapping>" if isinstance(value, dict) else None


def either(expected: str) -> Discriminator:
    """Choose among alternatives by the kind of value; say what is expected where none fits."""
    return Discriminator(kind_of_value, custom_error_type="expected", custom_error_message=expected)


Value = Annotated[str, Schema({"type": ["number", "string"]})]
Values = Annotated[
    Annotated[Value, Tag("<value>")] | Annotated[list[Value], Tag("<list>")],
    either("a value or a list of values"),
]
Row = Annotated[
    Annotated[Value, Tag("<value>")] | Annotated[list[Value], Tag("<list>")],
    either("a row of numbers or expressions"),
]
Matrix = Annotated[
    Annotated[Value, Tag("<value>")] | Annotated[list[Row], Tag("<list>"), Field(min_length=1)],
    either("a matrix: a list of rows [[..], [..]]"),
]


def optional(description: str) -> Any:
    """Return a field that may be absent."""
    return Field(default=None, description=description)


class Shape(BaseModel):
    """A mapping with known keys only."""

    model_config = ConfigDict(extra="forbid", strict=True)


class ZerosPolesGain(Shape):
    """G = gain (s − z₁)…/((s − p₁)…)."""

    zeros: Values = optional("zeros; none if absent")
    poles: Values = optional("poles; none if absent")
    gain: Value = optional("the factor in front; 1 if absent")


class Fraction(Shape):
    """Coefficients, the highest power first."""

    numerator: Values = Field(description="coefficients of the numerator, highest power first")
    denominator: Values = Field(description="coefficients of the denominator, highest power first")


def _kind_of_transfer_function(value: Any) -> str | None:
    if isinstance(value, dict):
        return "<fraction>" if "numerator" in value or "denominator" in value else "<zeros_poles_gain>"
    return "<value>" if isinstance(value, str) else None


Rational = Annotated[
    Annotated[Value, Tag("<value>")]
    | Annotated[ZerosPolesGain, Tag("<zeros_poles_gain>")]
    | Annotated[Fraction, Tag("<fraction>")],
    Discriminator(
        _kind_of_transfer_function,
        custom_error_type="expected",
        custom_error_message="an expression, {zeros, poles, gain} or {numerator, denominator}",
    ),
]


class EndShape(Shape):
    """An end that is not fixed."""

    on: Value = Field(description="the curve on which the end lies, in t, as 2 - t")


AtEnd = Annotated[
    Annotated[Value, Tag("<value>")] | Annotated[EndShape, Tag("<end>")],
    Discriminator(
        lambda value: {"<mapping>": "<end>"}.get(kind := kind_of_value(value) or "", kind),
        custom_error_type="expected",
        custom_error_message="a value, free or {on: curve}",
    ),
]


class ComponentShape(Shape):
    """A resistor or a capacitor by its value."""

    R: Value = optional("a resistance in ohms")
    C: Value = optional("a capacitance in farads")


Component = Annotated[
    Annotated[Value, Tag("<value>")] | Annotated[ComponentShape, Tag("<component>")],
    Discriminator(
        lambda value: {"<mapping>": "<component>"}.get(kind := kind_of_value(value) or "", kind),
        custom_error_type="expected",
        custom_error_message="the name of a resistor or a capacitor, as R1, or its value, as {R: 5000},",
    ),
]
