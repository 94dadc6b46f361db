"""The JSON Schema of problem files (Draft 2020-12), for editors: the shape, and the options of every task.

Imports no algebra: it is made from the declarations of the catalogue.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from pydantic import TypeAdapter

from solver.derivation import Option, Task
from solver.derivation.options import Schema
from solver.problem.elements import Matrix, Values
from solver.problem.shape import MAX_PARTS, PART_ID, ProblemShape

MATRIX: Schema = TypeAdapter(Matrix).json_schema()
VALUES: Schema = TypeAdapter(Values).json_schema()
REFERENCE: Schema = {
    "type": "object",
    "description": "the answer of an earlier part",
    "properties": {
        "from": {"type": ["string", "number"], "description": "name of the part"},
        "answer": {"type": "string", "description": "name of the answer"},
    },
    "required": ["from"],
    "additionalProperties": False,
}


def json_schema(catalogue: Mapping[str, Task[Any, Any]]) -> Schema:
    """Return the schema of problem files for the tasks of the catalogue."""
    schema = _tidy(ProblemShape.model_json_schema(ref_template="#/$defs/{model}"))
    definitions = schema["$defs"]
    common = definitions.pop("PartShape")["properties"]
    definitions["Reference"] = REFERENCE
    definitions["Matrix"] = MATRIX
    definitions["Values"] = VALUES
    names = sorted(catalogue)
    definitions |= {f"task_{name}": _part(task, common) for name, task in catalogue.items()}
    definitions["Part"] = {
        "type": "object",
        "required": ["task"],
        "properties": {"task": {"enum": names, "description": "what is asked"}},
        "allOf": [_choice(name) for name in names],
    }
    schema["properties"]["find"] = {
        "type": "object",
        "description": "what is asked, in order, by the part's name as printed",
        "minProperties": 1,
        "maxProperties": MAX_PARTS,
        "propertyNames": {"pattern": PART_ID},
        "additionalProperties": {"oneOf": [_named(catalogue.values()), {"$ref": "#/$defs/Part"}]},
    }
    schema["title"] = "A problem for `solve`"
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **schema}


def _named(tasks: Iterable[Task[Any, Any]]) -> Schema:
    """A task by its name alone: those that need no option."""
    plain = [task for task in tasks if not any(option.required for option in task.options.values())]
    return {"oneOf": [{"const": task.name, "description": task.doc} for task in plain]} if plain else {"const": None}


def _choice(name: str) -> Schema:
    """If the task is this one, the options are its own."""
    condition = {"properties": {"task": {"const": name}}, "required": ["task"]}
    return {"if": condition, "then": {"$ref": f"#/$defs/task_{name}"}}


def _part(task: Task[Any, Any], common: Schema) -> Schema:
    """Return the schema of a part that asks for this task; `common` has the keys of every part."""
    properties = {key: value for key, value in common.items() if key != "method"}
    properties["task"] = {"const": task.name, "description": task.doc}
    if list(task.methods) != [task.name]:
        properties["method"] = _methods(task)
    own = {name: _option(option) for name, option in task.options.items()}
    properties |= {name: _either(schema, common[name]) if name in common else schema for name, schema in own.items()}
    required = ["task", *(name for name, option in task.options.items() if option.required and not option.methods)]
    return {
        "type": "object",
        "title": task.title,
        "description": task.doc,
        "properties": properties,
        "required": required,
        "additionalProperties": False,
    }


def _either(option: Schema, key: Schema) -> Schema:
    """An option of the name of a key of every part: a list of names, say, where the key is a mapping of values."""
    described = f"{option['description']}; or {key['description']}"
    return {"anyOf": [{k: v for k, v in each.items() if k != "description"} for each in (option, key)]} | {
        "description": described
    }


def _methods(task: Task[Any, Any]) -> Schema:
    """One method, or several in a list."""
    one = {"oneOf": [{"const": method.name, "description": method.title} for method in task.methods.values()]}
    several = {"type": "array", "items": one, "minItems": 1, "uniqueItems": True}
    return {"description": "one method, or a list of several", "anyOf": [one, several]}


def _option(option: Option) -> Schema:
    """Return the schema of an option with its meaning and default."""
    schema = dict(option.kind.schema)
    if option.kind.referable:
        schema = {"anyOf": [schema, _reference(option.kind.item)]}
    of = f" (method {', '.join(option.methods)})" if option.methods else ""
    schema["description"] = option.doc + of
    if isinstance(option.default, (str, int, bool)):
        schema["default"] = option.default
    return schema


def _reference(item: str) -> Schema:
    """The answer of an earlier part; of a list the one whose number stands under the key `item`."""
    if not item:
        return {"$ref": "#/$defs/Reference"}
    number = {"type": "integer", "minimum": 1, "description": "the place in the list"}
    return {**REFERENCE, "properties": {**REFERENCE["properties"], item: number}}


def _tidy(schema: Any) -> Any:
    """Drop the titles made from key names, and defaults that only mean "absent"."""
    if isinstance(schema, list):
        return [_tidy(each) for each in schema]
    if not isinstance(schema, dict):
        return schema
    dropped = {"title"} if isinstance(schema.get("title"), str) else set()
    dropped |= {"default"} if "default" in schema and schema["default"] is None else set()
    return {key: _tidy(value) for key, value in schema.items() if key not in dropped}
