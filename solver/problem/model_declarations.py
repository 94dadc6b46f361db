"""What a model of the library says of its names, beside what the problem says that takes it."""

from __future__ import annotations

from collections.abc import Collection

from solver.problem.lexicon import Declarations
from solver.problem.library import model_at, moved
from solver.problem.nodes import MappingNode, Node, SequenceNode


def with_model(own: Declarations, system: MappingNode, around: Collection[str]) -> Declarations:
    """Return the declarations of a problem or part with those of the model that is its system, if it is one.

    Values under `parameters` of the system count as those of the problem. Of names that have a value, or that the
    problem or what is `around` it assumes something of, the model assumes nothing.
    """
    at = system.get("model")
    model = model_at(at) if at is not None else None
    if at is None or model is None:
        return own
    parameters = _joined(own.parameters, system.get("parameters"))
    told = {*around, *_keys(parameters), *_keys(own.assume)}
    assume, conditions = (
        moved(node, at.place) if (node := model.root.get(key)) else None for key in ("assume", "conditions")
    )
    return Declarations(parameters, _joined(_without(assume, told), own.assume), _listed(conditions, own.conditions))


def _keys(node: Node | None) -> Collection[str]:
    return node.entries.keys() if isinstance(node, MappingNode) else ()


def _without(node: Node | None, names: Collection[str]) -> Node | None:
    if not isinstance(node, MappingNode):
        return node
    return MappingNode(node.place, {key: entry for key, entry in node.entries.items() if key not in names})


def _joined(first: Node | None, second: Node | None) -> Node | None:
    """The entries of two mappings, the second's where both have a name."""
    if not isinstance(first, MappingNode) or not isinstance(second, MappingNode):
        return second or first
    return MappingNode(second.place, {**first.entries, **second.entries})


def _listed(first: Node | None, second: Node | None) -> Node | None:
    """The items of two lists, or single values, one after the other."""
    if first is None or second is None:
        return second or first
    items = [node.items if isinstance(node, SequenceNode) else (node,) for node in (first, second)]
    return SequenceNode(second.place, (*items[0], *items[1]))
