"""From the text of a problem file to a `Problem`, or to everything that is wrong with it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import PurePath
from typing import Any

from solver.derivation import Task
from solver.problem.asked import read_comma, read_digits
from solver.problem.conditions import check_occurring
from solver.problem.family import KEYS, Family, read_family
from solver.problem.files import load
from solver.problem.lexicon import Declarations, Lexicon, check_used, read_lexicon
from solver.problem.model import DIGITS, Display, Part, Problem, Show
from solver.problem.model_declarations import with_model
from solver.problem.nodes import Entry, MappingNode, Node, ScalarNode, scalar, whole_number
from solver.problem.other_files import PROBLEM, mistaken
from solver.problem.partial import Said, read_partial, slips_of
from solver.problem.parts import PartReader, PlantOf, Usual, read_show
from solver.problem.shape_check import check_shape
from solver.problem.source import InputError, Report, Source, did_you_mean
from solver.problem.systems import read_system
from solver.problem.texts import check_texts
from solver.problem.yaml_tree import parse_yaml
from solver.symbols import COURSE, NOTATIONS
from solver.systems import System
from solver.words import ENGLISH, languages

MAX_DECIMALS = 30
MODES = {"exact": "exact", "both": "both", "decimals": "decimal"}


def read_problem(source: Source, catalogue: Mapping[str, Task[Any, Any]]) -> Problem:
    """Return the problem of a source; raises InputError with all that is wrong with it, in the order of the file."""
    root = parse_yaml(source)
    if not isinstance(root, MappingNode):
        message = f"a problem is a mapping with the keys 'system' and 'find', not {_what(root)}"
        raise InputError(source, [root.diagnostic(message)])
    if other := mistaken(source, root, PROBLEM):
        raise InputError(source, [other])
    return problem_of(source, root, catalogue)


def problem_of(source: Source, root: MappingNode, catalogue: Mapping[str, Task[Any, Any]]) -> Problem:
    """Return the problem that a mapping of a source tells, the whole of it or a part; raises InputError."""
    return _ProblemReader(source, root, catalogue).problem()


def _what(node: Node) -> str:
    return node.what if len(node.what) < 40 else "a text"


def _one_of(node: ScalarNode, known: Iterable[str], what: str) -> str:
    """Return one of some words; raises Fault with a suggestion."""
    if node.text not in known:
        raise node.fault(
            f"there is no {what} '{node.text[:60]}'",
            suggestion=did_you_mean(node.text, known),
            note=f"there are {', '.join(known)}",
        )
    return node.text


class _ProblemReader:
    """Reads one file. Sections whose shape is wrong are reported and left out; the others are still read."""

    def __init__(self, source: Source, root: MappingNode, catalogue: Mapping[str, Task[Any, Any]]) -> None:
        self.source = source
        self.root = root
        self.catalogue = catalogue
        self.misshapen = check_shape(root)
        self.report = Report([wrong.diagnostic for wrong in self.misshapen])
        self.lexicon = read_lexicon(self.declarations(), self.report, positive=periods_of(root))
        self.occurring: set[str] = set()
        self.show = Show() if self.spoilt("show") else read_show(root, Show())

    def section(self, *path: str) -> Node | None:
        """Return the value at a path if it is there and its shape is right."""
        node: Node = self.root
        for key in path:
            if not isinstance(node, MappingNode) or key not in node:
                return None
            node = node[key]
        return None if self.spoilt(*path) else node

    def problem(self) -> Problem:
        """Return the problem; raises InputError."""
        by_names, system, display = self.lexicon.took_decimals(), self.system("system"), self.display()
        typed = self.lexicon.took_decimals() or by_names
        images = check_texts(self.root, self.source, self.report)
        parts = self.parts(system, by_names, typed)
        family = self.family(parts)
        if not self.report.diagnostics:
            check_used(self.declarations().parameters, self.lexicon, self.report)
            check_occurring(self.lexicon, {*self.occurring, *self.lexicon.found}, self.report)
        if self.report.diagnostics:
            raise InputError(self.source, self.report.diagnostics)
        name = file_stem(self.source.name)
        return Problem(
            name=name,
            title=self.text("title") or name.replace("-", " ").replace("_", " ").capitalize(),
            parts=tuple(parts),
            system=system,
            source=self.text("source"),
            statement=self.text("statement"),
            display=replace(display, decimals_typed=typed),
            parameters=dict(self.lexicon.values),
            symbols=dict(sorted({**self.lexicon.symbols, **self.lexicon.found}.items())),
            assumed=self.lexicon.assumptions,
            conditions=self.lexicon.chains,
            show=self.show,
            images=images,
            family=family,
            file=self.source,
        )

    def spoilt(self, *path: str) -> bool:
        """Whether the shape of what stands at a path is wrong."""
        return any(wrong.spoils(path) for wrong in self.misshapen)

    def text(self, key: str) -> str:
        """Return a text of the problem, or ""."""
        node = self.section(key)
        return node.text.strip() if isinstance(node, ScalarNode) else ""

    def system(self, *path: str, lexicon: Lexicon | None = None, parts: PartReader | None = None) -> System | None:
        """Return the system at a path, in the names of a part; None if it is absent or wrong."""
        node = self.section(*path)
        system: System | None = None
        if isinstance(node, MappingNode):
            with self.report:
                known = (parts.earlier, parts.times) if parts else ()
                system = read_system(node, lexicon or self.lexicon, *known)
        return system

    def parts(self, common: System | None, by_names: bool, typed: bool) -> list[Part]:
        """Return the parts in order, without those that are wrong; `common` is the system of all parts.

        `by_names` tells that the values of parameters hold decimals, `typed` that these or the common system do.
        """
        digits = DIGITS if self.spoilt("digits") else read_digits(self.root, DIGITS, self.report)
        usual = Usual(self.show, digits, self.partial(), read_comma(self.root, default=False))
        reader = PartReader(self.catalogue, self.lexicon, usual)
        parts: list[Part] = []
        find = self.root.get("find")
        for entry in find if isinstance(find, MappingNode) else ():
            name, system, known = entry.key.text, common, common is not None or "system" not in self.root
            lexicon = self.lexicon_of(entry)
            if isinstance(entry.value, MappingNode) and "system" in entry.value:
                system = self.system("find", name, "system", lexicon=lexicon, parts=reader)
                known = system is not None
            elif lexicon is not self.lexicon and known:
                system = self.system("system", lexicon=lexicon)
            with self.report:
                if any(wrong.spoils_part(name) for wrong in self.misshapen):
                    reader.skip(name)
                part = reader.read(entry, PlantOf(system, known), common, lexicon)
                decimals = lexicon.took_decimals() or (by_names if part.own_system else typed)
                going_on = any(each.decimals_typed for each in parts if each.id in part.sources)
                parts.append(replace(part, decimals_typed=decimals or going_on))
            if lexicon is not self.lexicon:
                self.lexicon.used |= lexicon.used
                self.occurring |= set(lexicon.found)
                check_used(self.declarations("find", name).parameters, lexicon, self.report)
                if not self.report.diagnostics:
                    own = replace(lexicon, conditions=lexicon.conditions[len(self.lexicon.conditions) :])
                    check_occurring(own, {*self.occurring, *self.lexicon.found}, self.report)
        return parts

    def family(self, parts: list[Part]) -> Family | None:
        """Return what the problem says of its other members, None where it has none or that is misshapen."""
        if self.spoilt("vary"):
            return None
        sections = {key: self.section(key) for key in KEYS}
        return read_family(sections, self.declarations(), parts, self.catalogue, self.report)

    def partial(self) -> Said:
        """Return what the problem says that wrong answers can earn."""
        find = self.section("find")
        words = [_task_of(entry.value) for entry in find] if isinstance(find, MappingNode) else []
        tasks = [self.catalogue[word] for word in dict.fromkeys(words) if word in self.catalogue]
        answers = {name for task in tasks for name in task.answers}
        with self.report:
            return read_partial(self.section("partial"), answers, slips_of(tasks))
        return Said()

    def lexicon_of(self, entry: Entry) -> Lexicon:
        """Return the names of a part: those of the problem, and its own, which win."""
        own = self.declarations("find", entry.key.text)
        return read_lexicon(own, self.report, self.lexicon) if own else self.lexicon

    def declarations(self, *path: str) -> Declarations:
        """Return what says what names mean, in the problem or in the part at a path, and of the model taken."""
        own = Declarations(*(self.section(*path, key) for key in ("parameters", "assume", "conditions")))
        system = self.section(*path, "system")
        around = self.lexicon.values.keys() | self.lexicon.assumed.keys() if path else ()
        return with_model(own, system, around) if isinstance(system, MappingNode) else own

    def choice(self, key: str, known: Iterable[str], usual: str) -> str:
        """Return one of some words, or the usual one where the file says nothing."""
        node = self.section(key)
        if isinstance(node, ScalarNode):
            with self.report:
                return _one_of(node, known, key)
        return usual

    def display(self) -> Display:
        """Return how the solution is shown: its numbers, language and notation."""
        node = self.section("display")
        language = self.choice("language", languages(), ENGLISH)
        notation = self.choice("notation", NOTATIONS, COURSE)
        display = Display(language=language, notation=notation)
        if isinstance(node, ScalarNode):
            return replace(display, mode=MODES[node.text])
        with self.report:
            if isinstance(node, MappingNode):
                mode = MODES[scalar(node["mode"]).text] if "mode" in node else "decimal"
                digits = whole_number(node["decimals"], "decimals", 1, MAX_DECIMALS) if "decimals" in node else 5
                display = replace(display, mode=mode, digits=digits)
        return display


def periods_of(root: MappingNode) -> list[str]:
    """The names that stand for sampling periods in a file, which are positive where nothing else is said of them."""
    find = root.get("find")
    parts = [entry.value for entry in find] if isinstance(find, MappingNode) else []
    holders = [each for part in (root, *parts) if isinstance(part, MappingNode) for each in (part, part.get("system"))]
    found = [each.get("sample_time") for each in holders if isinstance(each, MappingNode)]
    return list(dict.fromkeys(each.text.strip() for each in found if isinstance(each, ScalarNode)))


def _task_of(part: Node) -> str:
    """The name of the task of a part, "" where none stands there."""
    node = part.get("task") if isinstance(part, MappingNode) else part
    return node.text if isinstance(node, ScalarNode) else ""


def file_stem(name: str) -> str:
    """Return the name of a problem from the name of its source: of a file without folder and suffix."""
    return "problem" if name.startswith("<") else PurePath(name).stem or "problem"


__all__ = ["load", "read_problem"]
