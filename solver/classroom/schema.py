"""The JSON Schemas (Draft 2020-12) of answer files and of an instructor's changes, for editors."""

from __future__ import annotations

from typing import Any

from solver.classroom.verdicts import Verdict
from solver.problem.model import Part, Problem
from solver.tasks import catalogue

Schema = dict[str, Any]

DRAFT = "https://json-schema.org/draft/2020-12/schema"
TEXT: Schema = {"type": ["string", "number"]}
VALUE: Schema = {
    "description": "a value: a number or an expression, a matrix [[1, 2], [3, 4]], a list, yes or no, words",
    "type": ["string", "number", "boolean", "null", "array", "object"],
    "items": {"$ref": "#/$defs/Value"},
    "additionalProperties": {"$ref": "#/$defs/Value"},
}


def answers_schema(problem: Problem | None = None) -> Schema:
    """Return the schema of answer files; of those to a problem with its parts and their answers."""
    parts = {} if problem is None else {part.id: _part(part) for part in problem.parts}
    listed = _fixed(parts) if parts else _mapping({"$ref": "#/$defs/Value"})
    keys = {
        "problem": {**TEXT, "description": "the problem file, beside this one"},
        "student": {"type": ["string", "number", "null"], "description": "a label of the student"},
        "answers": {**listed, "description": "the answers by part"},
    }
    title = "Answers to a problem for `solve check`"
    return {"$schema": DRAFT, "title": title, **_fixed(keys), "required": ["answers"], "$defs": {"Value": VALUE}}


def _part(part: Part) -> Schema:
    task = catalogue()[part.task]
    names = {name: {"$ref": "#/$defs/Value", "description": answer.doc} for name, answer in task.answers.items()}
    schema = {**_fixed(names), "title": task.title, "type": ["object", "null"]}
    return schema if len(names) > 1 else {"anyOf": [schema, {"$ref": "#/$defs/Value"}]}


def changes_schema() -> Schema:
    """Return the schema of the files of `--override`."""
    comment = {**TEXT, "description": "what is said on the sheet, Markdown with $math$"}
    change = _fixed(
        {
            "verdict": {"enum": [str(each) for each in Verdict], "description": "in place of the program's verdict"},
            "marks": {**TEXT, "description": "in place of the program's marks, at most those that the answer carries"},
            "comment": comment,
        }
    )
    part = {**_mapping(change), "properties": {"comment": comment}}
    student = {**_mapping(part), "properties": {"comment": comment}}
    described = "by the label of a student, or the name of an answer file: the parts, and in them the answers"
    keys = {"changes": {**_mapping(student), "description": described}}
    return {
        "$schema": DRAFT,
        "title": "Changes of a marking for `solve check`",
        **_fixed(keys),
        "required": ["changes"],
    }


def _mapping(value: Schema) -> Schema:
    return {"type": "object", "additionalProperties": value}


def _fixed(keys: dict[str, Schema]) -> Schema:
    return {"type": "object", "properties": keys, "additionalProperties": False}
