"""The library of models as plain text. Reads the files as they stand; needs no algebra."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from textwrap import wrap

from solver.problem.library import LibraryModel, library_model, model_names
from solver.problem.nodes import MappingNode, Node, ScalarNode, SequenceNode

WIDTH = 100
SOURCES = ("V", "I")


def all_models() -> str:
    """Return all models: name, title, states, inputs and outputs, parameters with their units."""
    models = [library_model(name) for name in model_names()]
    width = max((len(model.name) for model in models), default=0)
    systems, laws = ([each for each in models if (each.system is None) is without] for without in (False, True))
    lines = ["Models"]
    for model in systems:
        lines += [*_row(model.name, model.title, width), *_more(_short(model), width)]
    lines += ["", "Laws, without a system", *(line for each in laws for line in _row(each.name, each.title, width))]
    return "\n".join(
        [*lines, "", "`solve models NAME` tells more of one; `system: {model: NAME}` is its system in a problem."]
    )


def one_model(model: LibraryModel) -> str:
    """Return all about a model."""
    lines = [model.name, f"  {model.title}.", *_wrapped(_head(model), "  "), ""]
    for title, rows in (
        ("States, inputs and outputs", list(_channels(model))),
        ("Parameters", [(name, words or "-") for name, words in model.meanings("assume").items()]),
        ("Asked in its file", list(_asked(model))),
    ):
        width = max((len(name) for name, _ in rows), default=0)
        lines += [title, *(line for name, words in rows for line in _row(name, words, width)), ""] if rows else []
    return "\n".join([*lines, f"File  {model.source.name}"])


def _head(model: LibraryModel) -> str:
    """The comment on top of the file."""
    lines: list[str] = []
    for line in model.source.lines:
        if not line.startswith("#"):
            break
        lines.append(line.removeprefix("#").strip())
    return " ".join(lines)


def _channels(model: LibraryModel) -> Iterator[tuple[str, str]]:
    """What the system names: its states, inputs and outputs, with the comments behind them."""
    system = model.system
    for key in ("states", "inputs", "outputs") if system is not None else ():
        node = system.get(key) if system is not None else None
        if node is not None:
            yield key, "; ".join(filter(None, [", ".join(_texts(node)), model.comment(node)]))
        elif key == "inputs" and system is not None and "circuit" in system:
            yield key, ", ".join(_sources(system["circuit"]))


def _short(model: LibraryModel) -> list[str]:
    channels = [f"{key} {words.partition(';')[0]}" for key, words in _channels(model)]
    units = [f"{name} ({unit})" if unit else name for name, unit in _units(model)]
    return ["; ".join(channels), *(["parameters " + ", ".join(units)] if units else [])]


def _units(model: LibraryModel) -> Iterator[tuple[str, str]]:
    """The parameters with their units: what stands behind the last comma of a comment."""
    for name, words in model.meanings("assume").items():
        yield name, words.rpartition(", ")[2] if ", " in words else ""


def _sources(circuit: Node) -> Iterator[str]:
    """The names of the sources' values in a netlist."""
    for line in _texts(circuit):
        words = line.split()
        if line.startswith(SOURCES) and not words[-1][:1].isdigit():
            yield words[-1] if len(words) > 3 else words[0]


def _asked(model: LibraryModel) -> Iterator[tuple[str, str]]:
    find = model.root.get("find")
    for entry in find if isinstance(find, MappingNode) else ():
        value = entry.value
        task = value.get("task") if isinstance(value, MappingNode) else value
        yield entry.key.text, task.text if isinstance(task, ScalarNode) else ""


def _texts(node: Node) -> list[str]:
    items = node.items if isinstance(node, SequenceNode) else (node,)
    return [item.text for item in items if isinstance(item, ScalarNode)]


def _row(name: str, words: str, width: int) -> list[str]:
    """Two columns, the second wrapped."""
    first, *rest = _wrapped(words, " " * (width + 4)) or [""]
    return [f"  {name:{width}}  {first.lstrip()}", *rest]


def _more(texts: Iterable[str], width: int) -> Iterator[str]:
    for text in texts:
        yield from _wrapped(text, " " * (width + 4))


def _wrapped(text: str, indent: str) -> list[str]:
    return wrap(text, WIDTH, initial_indent=indent, subsequent_indent=indent, break_on_hyphens=False)
