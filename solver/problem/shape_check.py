"""Checking the shape of a problem file: the models' complaints in plain words, at their places."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from pydantic import BaseModel, ValidationError

from solver.problem import elements, shape
from solver.problem.nodes import MappingNode, Node, SequenceNode
from solver.problem.source import Diagnostic, did_you_mean, surplus
from solver.systems import kinds

Path = tuple[str | int, ...]

MODELS: Mapping[str | int, type[BaseModel]] = {
    **{name: model for name, model in shape.SYSTEMS.items()},  # noqa: C416 - a wider type of key
    **{name: model for name, model in shape.KEYED.items()},  # noqa: C416
    **{name: model for name, model in shape.DRAWN.items()},  # noqa: C416 - a wider type of key
    "<zeros_poles_gain>": elements.ZerosPolesGain,
    "<fraction>": elements.Fraction,
    "<end>": elements.EndShape,
    "<component>": elements.ComponentShape,
    "<mapping>": shape.DisplayShape,
    "show": shape.ShowShape,
}
"""The models by the names of alternatives, and by keys, as these stand in the location of an error."""

ALTERNATIVES: Sequence[Sequence[type[BaseModel]]] = (
    tuple(shape.SYSTEMS.values()),
    tuple(shape.DRAWN.values()),
    (elements.ZerosPolesGain, elements.Fraction),
)
"""Models of mappings of which one stands in one place; which one, some of its keys tell."""

EXPECTED = {
    "string_type": "a number or a text",
    "list_type": "a list",
    "dict_type": "a mapping (key: value)",
    "model_type": "a mapping (key: value)",
    "bool_type": "true or false",
}


@dataclass(frozen=True)
class Misshapen:
    """Something wrong with the shape: the path of keys to it, and words.

    A `surplus` key leaves the rest readable; one that is needed may be `absent`.
    """

    path: Path
    diagnostic: Diagnostic
    surplus: bool = False
    absent: bool = False

    @property
    def meant(self) -> Path:
        """The path to the key probably meant by the last one."""
        return (*self.path[:-1], self.diagnostic.suggestion)

    def spoils(self, path: Path) -> bool:
        """Whether what stands at the path can't be read because of it."""
        inside, around = self.path[: len(path)] == path, path[: len(self.path)] == self.path
        return around or (inside and not self.surplus)

    def spoils_part(self, name: str) -> bool:
        """Whether a part can't be read because of it; the part's own system is read apart."""
        return self.spoils(("find", name)) and self.path[:3] != ("find", name, "system")


def check_shape(
    root: Node,
    whole: type[BaseModel] = shape.ProblemShape,
    what: str = "a problem",
    within: Mapping[str | int, type[BaseModel]] = MODELS,
) -> list[Misshapen]:
    """Return what is wrong with the shape of a problem, or of what is told by another model.

    `within` has the models of mappings inside it, by the keys under which they stand.
    """
    try:
        whole.model_validate(root.plain())
    except ValidationError as error:
        return _once([_explained(root, each, whole, what, within) for each in error.errors(include_url=False)])
    return []


def _once(found: Sequence[Misshapen]) -> list[Misshapen]:
    """Return what is wrong, each slip once: a key that is missing may be there, misspelt; keys may be strange together.

    A misspelt one is then the key that is needed, without which the rest cannot be read.
    """
    missing = {each.path for each in found if each.absent}
    misspelt = {path for each in found if each.surplus and (path := each.meant) in missing}
    first = {(each.path[:-1], each.diagnostic.message): each for each in reversed(found)}
    told = [each for each in found if each is first[each.path[:-1], each.diagnostic.message]]
    return [
        replace(each, surplus=each.surplus and each.meant not in misspelt)
        for each in told
        if not (each.absent and each.path in misspelt)
    ]


def _explained(
    root: Node,
    error: Mapping[str, Any],
    whole: type[BaseModel],
    what: str,
    within: Mapping[str | int, type[BaseModel]],
) -> Misshapen:
    """Return one complaint in words, with the path to what it is about."""
    location, kind, context = error["loc"], error["type"], error.get("ctx", {})
    path, node, parent = _walk(root, location)
    if kind == "extra_forbidden":
        around = next((step for step in reversed(location[:-1]) if isinstance(step, str)), "")
        model = within.get(around, whole)
        return Misshapen(path, _key(parent, path).diagnostic(*_unknown(str(path[-1]), model, parent)), surplus=True)
    if kind == "string_pattern_mismatch":
        message = f"'{str(path[-1])[:40]}' cannot name a part: at most 32 letters, digits, and - _ . ( )"
        return Misshapen(path, _key(parent, path).diagnostic(message))
    if kind == "at_key":
        at = _key(node, (*path, context["key"]))
        return Misshapen((*path, context["key"]), at.diagnostic(error["msg"], context.get("suggestion", "")))
    if kind == "missing":
        return Misshapen((*path, location[-1]), _missing(node, path, str(location[-1]), what), absent=True)
    return Misshapen(path, node.diagnostic(*_words(error, node)))


def _walk(root: Node, location: Sequence[str | int]) -> tuple[Path, Node, Node]:
    """Follow a location to its node and the node around it; the names of alternatives in it are stepped over."""
    path: Path = ()
    node = parent = root
    for step in location:
        if isinstance(node, MappingNode) and isinstance(step, str) and step in node:
            path, node, parent = (*path, step), node[step], node
        elif isinstance(node, SequenceNode) and isinstance(step, int):
            path, node, parent = (*path, step), node.items[step], node
    return path, node, parent


def _key(mapping: Node, path: Path) -> Node:
    """Return the node of the last key of the path."""
    return mapping.entries[str(path[-1])].key if isinstance(mapping, MappingNode) else mapping


def _unknown(key: str, model: type[BaseModel], parent: Node) -> tuple[str, str]:
    """Return the message for a key that the model does not know, and the key probably meant."""
    present = list(parent.entries) if isinstance(parent, MappingNode) else []
    own = [*(name for name in kinds() if name in model.model_fields), *model.model_fields]
    alike = next((each for each in ALTERNATIVES if model in each), ())
    return surplus(key, present, own, [name for other in alike for name in other.model_fields])


def _missing(node: Node, path: Path, key: str, what: str) -> Diagnostic:
    if not path:
        return Diagnostic(f"'{key}' is missing", note=f"{what} needs the key '{key}:'")
    return node.diagnostic(f"'{key}' is missing here")


def _words(error: Mapping[str, Any], node: Node) -> tuple[str, str]:
    """Return what is wrong with a value, and the word probably meant."""
    kind, context = error["type"], error.get("ctx", {})
    got = node.what if len(node.what) < 60 else "a text"
    if kind == "expected":
        rows = isinstance(node, SequenceNode) and error["loc"][-1] == "transfer_function"
        return f"{error['msg']} is expected here, not {got}", "transfer_matrix" if rows else ""
    if kind in EXPECTED:
        return f"{EXPECTED[kind]} is expected here, not {got}", ""
    if kind == "literal_error":
        words = re.findall(r"'([^']*)'", context["expected"])
        return f"'{got}' is not known here; it is one of {', '.join(words)}", did_you_mean(got, words)
    if kind == "too_short":
        return "this is empty", ""
    if kind == "too_long":
        return f"there are more than {context['max_length']} parts", ""
    raise AssertionError(f"a complaint without words: {kind}")  # each kind the models can raise is named above
