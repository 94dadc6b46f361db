"""Reading the parts of a problem: the task, its methods, its options, and whether the system has what it needs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import fields, replace
from typing import Any, NamedTuple

from solver.derivation import Task
from solver.derivation.conversion import reachable
from solver.problem.asked import answer_named, given_by, read_asked, read_comma, read_digits
from solver.problem.context import Context
from solver.problem.lexicon import Lexicon, exact_number
from solver.problem.model import Part, Partial, Show
from solver.problem.nodes import Entry, MappingNode, Node, ScalarNode, SequenceNode, scalar
from solver.problem.part_options import OptionsReader
from solver.problem.partial import Said, read_partial, settled, slips_of
from solver.problem.source import Fault, Report, did_you_mean
from solver.problem.systems import NOTHING
from solver.systems import System

IN_WORDS = {
    "transfer_function": "a transfer function (or A, B and C)",
    "matrix": "a matrix",
    "polynomial": "a polynomial",
    "x0": "initial_state",
    "motion": "A",
    "rest": "equations (or A)",
    "machine": "equations (or A, or a transfer function)",
    "gains": "a transfer matrix (or A, B and C)",
    "path": "a transfer function (or A, B and C)",
    "open_loop": "a transfer function (or A, B and C)",
    "polynomial_matrix": "a matrix of polynomials",
    "signal_flow": "a signal-flow graph",
}


class PlantOf(NamedTuple):
    """The system of a part. It is None if there is none, or, when not `known`, if it could not be read."""

    system: System | None
    known: bool = True

    @property
    def discrete(self) -> bool:
        """Whether it is known to be in discrete time."""
        return self.system is not None and self.system.discrete


class Usual(NamedTuple):
    """What a problem says of all its parts: what a paper shows, how decimals are read, what wrong answers can earn."""

    show: Show
    digits: int
    partial: Said
    decimal_comma: bool = False


class PartReader:
    """Reads the parts one after the other; knows the earlier ones, to which later ones may refer."""

    def __init__(self, catalogue: Mapping[str, Task[Any, Any]], lexicon: Lexicon, usual: Usual) -> None:
        self.catalogue = catalogue
        self.lexicon = lexicon
        self.usual = usual
        self.earlier: dict[str, tuple[Task[Any, Any], str] | None] = {}
        self.times: dict[str, Any] = {}
        """The sampling periods of the parts whose answers are in discrete time; None where one is not given."""

    def skip(self, name: str) -> Part:
        """Remember a part that can't be read, and raise a fault without words: it is reported already."""
        self.earlier[name] = None
        raise Fault

    def read(self, entry: Entry, plant: PlantOf, common: System | None, lexicon: Lexicon) -> Part:
        """Return the part of an entry under `find`; raises Fault with all that is wrong with it.

        `common` is the system of the whole problem; the lexicon has the names of the part.
        """
        name, node = entry.key.text, entry.value
        context = Context(lexicon, plant.system, plant.discrete, dict(self.earlier))
        self.earlier[name] = None
        bare = {"task": Entry(ScalarNode(node.place, "task"), node)}
        mapping = node if isinstance(node, MappingNode) else MappingNode(node.place, bare)
        task = self._task(mapping["task"])
        methods = _methods(mapping, task, plant)
        self.earlier[name] = (task, methods[0])
        reader = OptionsReader(task, methods, mapping, context)
        report = Report()
        options, split, asked = dict[str, Any](), dict[str, Any](), tuple[str, ...]()
        with report:
            options = reader.options()
        self._note_time(name, task, plant, options)
        with report:
            _check_needs(task, plant, reader.given, mapping["task"])
        with report:
            asked = read_asked(mapping, task, methods)
        digits = read_digits(mapping, self.usual.digits, report)
        partial = self._partial(mapping, task, methods, report)
        with report:
            split = _split_marks(mapping, task, methods)
            marks = sum(split.values()) if split else _marks(mapping["marks"]) if "marks" in mapping else None
        report.conclude()
        return Part(
            id=name,
            task=task.name,
            methods=methods,
            system=plant.system or NOTHING,
            options=options,
            prompt=scalar(mapping["prompt"]).text.strip() if "prompt" in mapping else "",
            marks=marks,
            own_system="system" in mapping or (plant.system != common and _renames(mapping)),
            answer_marks=split,
            asked=asked,
            digits=digits,
            partial=partial,
            decimal_comma=read_comma(mapping, default=self.usual.decimal_comma),
            show=read_show(mapping, self.usual.show),
            conventions=reader.conventions(),
            conditions=lexicon.chains,
            **_in_the_file(mapping, lexicon),
            **({} if lexicon is self.lexicon else lexicon.declared),
        )

    def _note_time(self, name: str, task: Task[Any, Any], plant: PlantOf, options: Mapping[str, Any]) -> None:
        """Note the sampling period of a part whose answers are in discrete time."""
        if plant.discrete or any(answer.discrete for answer in task.answers.values()):
            given = plant.system.sample_time if plant.system is not None else None
            self.times[name] = options["sample_time"] if options.get("sample_time") is not None else given

    def _partial(
        self, part: MappingNode, task: Task[Any, Any], methods: Sequence[str], report: Report
    ) -> dict[str, Partial]:
        with report:
            said = read_partial(part.get("partial"), given_by(task, methods), slips_of([task]))
            return settled(task.answers, said, self.usual.partial)
        return {}

    def _task(self, node: Node) -> Task[Any, Any]:
        word = scalar(node).text
        if word not in self.catalogue:
            note = "`solve tasks` lists what can be asked"
            raise node.fault(
                f"there is no task '{word[:60]}'", suggestion=did_you_mean(word, self.catalogue), note=note
            )
        return self.catalogue[word]


def read_show(holder: MappingNode, default: Show) -> Show:
    """Return what a paper shows, as the key `show` of a problem or part says; what it leaves out is as by default."""
    node = holder.get("show")
    if not isinstance(node, MappingNode):
        return default
    said = {each.name: node.get(each.name) for each in fields(Show)}
    truths = {name: value.truth is True for name, value in said.items() if isinstance(value, ScalarNode)}
    return replace(default, **truths)


def _in_the_file(part: MappingNode, lexicon: Lexicon) -> dict[str, Any]:
    """Return which keys a part has, and where they and its conditions stand."""
    keys = {entry.key.text: entry.value.place for entry in part}
    conditions = {f"conditions {i}": chain.place for i, chain in enumerate(lexicon.chains)}
    return {"written": frozenset(keys), "places": keys | conditions}


def _renames(part: MappingNode) -> bool:
    """Whether a part gives names other meanings; conditions leave the system as it is."""
    return isinstance(part.get("parameters"), MappingNode) or "assume" in part


def _marks(node: Node) -> Any:
    """Return a number of marks; raises Fault."""
    marks = exact_number(node)
    if marks < 0:
        raise node.fault("marks can't be negative")
    return marks


def _split_marks(part: MappingNode, task: Task[Any, Any], methods: tuple[str, ...]) -> dict[str, Any]:
    """Return the marks of each answer, {K: 2, polynomial: 1}; nothing where the part carries a number, or none."""
    node = part.get("marks")
    if not isinstance(node, MappingNode):
        return {}
    if not len(node.entries):
        raise node.fault("no answer is named here; write marks: 3, or the marks of each answer: {K: 2, polynomial: 1}")
    report, found = Report(), {}
    for entry in node:
        with report:
            name = answer_named(entry.key, task, methods)
            found[name] = _marks(entry.value)
    report.conclude()
    return found


def _methods(part: MappingNode, task: Task[Any, Any], plant: PlantOf) -> tuple[str, ...]:
    """Return the methods asked for, in their order; without any the first for the system's kind of time."""
    known = plant.known
    system = plant.system.kind if plant.system is not None else ""
    fitting = task.methods_for(plant.discrete, system) if known else list(task.methods)
    time = "discrete" if plant.discrete else "continuous"
    if not fitting:
        other = "continuous" if plant.discrete else "discrete"
        message = f"{task.name} cannot be asked of a system in {time} time"
        raise part["task"].fault(message, note=f"its methods ({', '.join(task.methods)}) are for {other} time")
    if "method" not in part:
        return (fitting[0],)
    node = part["method"]
    if list(task.methods) == [task.name]:
        raise part.entries["method"].key.fault(f"{task.name} has one method only; leave out 'method'")
    items = node.items if isinstance(node, SequenceNode) else (node,)
    if not items:
        raise node.fault("the list of methods is empty")
    report, methods = Report(), [scalar(item).text for item in items]
    for position, (item, method) in enumerate(zip(items, methods, strict=True)):
        with report:
            if method not in task.methods:
                note = f"its methods are: {', '.join(fitting)}"
                message = f"{task.name} has no method '{method[:60]}'"
                raise item.fault(message, suggestion=did_you_mean(method, fitting), note=note)
            if method not in fitting and task.methods[method].system not in ("", system):
                kind = task.methods[method].system
                raise item.fault(f"the method {method} is for a {kind}", note=f"here there is: {', '.join(fitting)}")
            if method not in fitting:
                note = f"in {time} time there is: {', '.join(fitting)}"
                raise item.fault(f"the method {method} is not for systems in {time} time", note=note)
            if method in methods[:position]:
                raise item.fault(f"the method {method} is given twice")
    report.conclude()
    return tuple(methods)


def _check_needs(task: Task[Any, Any], plant: PlantOf, given: set[str], node: Node) -> None:
    """Raise Fault if the question is about a matrix that neither the system nor an option gives."""
    if not plant.known:
        return
    has = (reachable(plant.system) if plant.system is not None else frozenset()) | given
    missing = [need for need in task.needs if need not in has]
    if not missing:
        return
    if plant.system is None:
        raise node.fault(
            f"{task.name} is about a system, and there is none", note="add 'system:' to the problem or the part"
        )
    words = [IN_WORDS.get(need, need) for need in missing]
    raise node.fault(f"{task.name} needs {' and '.join(words)}; {plant.system.described}")
