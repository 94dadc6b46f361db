"""A model of the library, by its name: the system that its file holds."""

from __future__ import annotations

from typing import Any

from solver.systems.kind import Key, Kind, MappingTo, ModelName, Reader, Value


def _read(reader: Reader) -> Any:
    """Return the system of the model: the object of its own kind, so that every task takes it."""
    if reader.discrete:
        reader.complain("time", "the models of the library are in continuous time")
    system = reader.named_model("model")
    reader.conclude()
    return system


MODEL = Kind(
    "model",
    doc="A model of the library; `solve models` lists them.",
    keys=(
        Key("model", ModelName(), "the name of the model", required=True),
        Key("parameters", MappingTo(Value()), "values of its parameters; the others stay symbols"),
    ),
    read=_read,
    example=(
        ("model: rlc-series", "`solve models` lists them"),
        ("parameters: {R: 1}", "the other parameters stay symbols"),
    ),
)
