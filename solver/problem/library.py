"""The library of models: the systems of the problem files in `problems/models/`, each by the name of its file."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from pathlib import Path

from solver.problem.files import load
from solver.problem.nodes import Entry, MappingNode, Node, Place, ScalarNode, SequenceNode
from solver.problem.source import Source, did_you_mean
from solver.problem.yaml_tree import parse_yaml
from solver.resources import root


def folder() -> Path:
    """Return the folder of the library."""
    return root("problems") / "models"


@cache
def model_names() -> tuple[str, ...]:
    """Return the names of the models, sorted. Reads the names of the files only."""
    return tuple(sorted(path.stem for path in folder().glob("*.yaml")))


@dataclass(frozen=True)
class LibraryModel:
    """The file of a model: its text, and the tree of it."""

    name: str
    source: Source
    root: MappingNode

    @property
    def title(self) -> str:
        """What it is called."""
        title = self.root.get("title")
        return title.text if isinstance(title, ScalarNode) else self.name

    @property
    def system(self) -> MappingNode | None:
        """The system; None where the file holds laws only."""
        system = self.root.get("system")
        return system if isinstance(system, MappingNode) else None

    def comment(self, node: Node) -> str:
        """Return the comment behind a value: of a parameter what it is, with its unit."""
        line = self.source.line(node.place.end_line)[node.place.end_column - 1 :]
        return line.partition("#")[2].strip()

    def meanings(self, section: str) -> dict[str, str]:
        """Return the names under a key of the file with the comments behind them."""
        node = self.root.get(section)
        entries = node if isinstance(node, MappingNode) else ()
        return {entry.key.text: self.comment(entry.value) for entry in entries}


@cache
def library_model(name: str) -> LibraryModel:
    """Return a model of the library by its name, one of `model_names`."""
    source = load(folder() / f"{name}.yaml")
    tree = parse_yaml(source)
    if not isinstance(tree, MappingNode):
        raise TypeError(f"{name}.yaml is no mapping")
    return LibraryModel(name, source, tree)


def model_at(node: Node) -> LibraryModel | None:
    """Return the model that a value names, None where there is none of that name with a system."""
    name = node.text if isinstance(node, ScalarNode) else ""
    found = library_model(name) if name in model_names() else None
    return found if found is not None and found.system is not None else None


def named_model(node: ScalarNode) -> LibraryModel:
    """Return the model that a value names; raises Fault with the name that is probably meant."""
    found = model_at(node)
    if found is not None:
        return found
    if node.text in model_names():
        raise node.fault(f"the model '{node.text}' holds laws, not a system", note="`solve models` lists the others")
    close = did_you_mean(node.text, model_names())
    note = "`solve models` lists what there is" if close else f"there are {', '.join(model_names())}"
    raise node.fault(f"there is no model '{node.text[:60]}'", suggestion=close, note=note)


def moved(node: Node, place: Place) -> Node:
    """Return a value of the library as if it stood at a place of the file that names it."""
    if isinstance(node, ScalarNode):
        return ScalarNode(place, node.text, node.style)
    if isinstance(node, SequenceNode):
        return SequenceNode(place, tuple(moved(item, place) for item in node.items))
    if isinstance(node, MappingNode):
        return MappingNode(place, {key: _moved_entry(entry, place) for key, entry in node.entries.items()})
    return node


def _moved_entry(entry: Entry, place: Place) -> Entry:
    return Entry(ScalarNode(place, entry.key.text, entry.key.style), moved(entry.value, place))
