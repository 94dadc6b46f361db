"""What tells parts of one task apart in their titles: "Linearization: x = 0, θ = π", "Stability: system of part (b)".

Where titles are alike, each says in what its question differs from the others: in its options, its loop, its system,
the values of the parameters, the method that the file names, what is asked for. Nothing is said that the question does
not say: not the options behind a prompt of one's own, nor a system that `show` hides.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import Any

import sympy as sp

from solver.derivation import Task
from solver.document.questions import Labels, title_of
from solver.problem.model import Part, Problem, Reference
from solver.render.prose import inline_as_text, plain
from solver.render.wording import Wording
from solver.systems import EarlierPart
from solver.tasks import catalogue
from solver.words import Phrase

LONGEST = 40
"""Characters of what a title says of one thing; longer formulas are left to the question."""

SYSTEM = 32
"""Characters of a system in a title."""

LABELS = {"input": "u", "initial_state": "x(0)"}
"""Symbols of options whose names are words."""

_TOKENS = re.compile(r"\\[A-Za-z]+|[A-Za-z]|\d+")

_NAME = re.compile(r"[A-Za-z]|[A-Za-z]+_?\d+|[A-Za-z]+_[A-Za-z]{1,3}")
"""Names of variables; words, such as those of a choice, are longer and have no index."""

_STEP = re.compile(r"(\d)1\(")
"""A multiple of the step 1(t) without a sign between them."""

_UNREADABLE = re.compile(r"\d{7}")
"""Numbers too long to be read."""

Saying = Callable[[Part], str]
"""Says one thing of a part, "" for nothing."""


def titles_of(problem: Problem, wording_of: Callable[[Part], Wording], labels: Labels) -> dict[str, str]:
    """Return the title of each part by its id, no two alike where their questions differ in what can be said."""
    tasks = catalogue()
    titles = {part.id: title_of(part, tasks[part.task], wording_of(part).say) for part in problem.parts}
    for title in dict.fromkeys(titles.values()):
        alike = [part for part in problem.parts if titles[part.id] == title]
        if alike[1:]:
            told = _Alike(alike, problem, wording_of, labels).told()
            titles |= {part.id: f"{title}: {words}" for part, words in zip(alike, told, strict=True) if words}
    return titles


class _Alike:
    """Parts whose titles are alike."""

    def __init__(
        self, parts: Sequence[Part], problem: Problem, wording_of: Callable[[Part], Wording], labels: Labels
    ) -> None:
        self.parts = parts
        self.problem = problem
        self.wording_of = wording_of
        self.labels = labels

    def told(self) -> list[str]:
        """Return what tells each part from the others: of what can be said as much as it takes."""
        kept: list[tuple[Saying, list[str]]] = []
        for said in self._sayings():
            words = [said(part) for part in self.parts]
            if len(set(words)) == len(words) and said not in (self._which_system, self._number):  # this alone will do
                return words
            before = _joined([each for _, each in kept], self.parts)
            more = [each if before.count(one) > 1 else "" for each, one in zip(words, before, strict=True)]
            if _count([*(each for _, each in kept), more], self.parts) > len(set(before)):
                kept.append((said, more))
        for said in [each for each, _ in kept if each in (self._kind, self._method, self._asked)]:
            others = [each for each in kept if each[0] != said]
            if _count([each for _, each in others], self.parts) == len(self.parts):
                kept = others
        return _joined([each for _, each in kept], self.parts)

    def _sayings(self) -> Iterator[Saying]:
        """Yield what can be said of a part, first what tells most."""
        for name in self._differing():
            yield partial(self._option, name=name)
        yield self._system
        yield self._parameters
        yield self._kind
        yield self._method
        yield self._asked
        yield self._which_system
        yield self._number

    def _differing(self) -> list[str]:
        """Return the options that are written and not the same in all parts, in the order of their declaration."""
        task: Task[Any, Any] = catalogue()[self.parts[0].task]
        written = {name for part in self.parts for name in part.written if name in part.options}
        return [name for name in task.options if name in written and self._differs(name)]

    def _differs(self, name: str) -> bool:
        first, *others = ((name in part.written, part.options.get(name)) for part in self.parts)
        return any(each != first for each in others)

    def _option(self, part: Part, name: str) -> str:
        """Return an option, unless the question is worded by a prompt that does not say it."""
        value, wording = part.options.get(name) if name in part.written else None, self.wording_of(part)
        if name == "feedback" and name in part.written and value in (None, 1):
            return wording.say("without feedback" if value is None else "with feedback")
        if value is None or (part.prompt and not self._said(part, value)):
            return ""
        words = ", ".join(filter(None, self._values(part, name, value)))
        if isinstance(value, Mapping | Reference):
            return _short(words)
        symbol = LABELS.get(name, "") if not isinstance(value, int) else ""
        symbol = _text(name, wording) if _NAME.fullmatch(name) else symbol
        label = f"{symbol} =" if symbol else wording.say(name.replace("_", " "))
        told = words if words == symbol else _short(f"{label} {words}")
        if not words:
            told = label if value is True else ""
        rows, columns = getattr(value, "shape", (0, 0))
        return told or (f"{label} {rows} × {columns}" if rows and not symbol else "")

    def _said(self, part: Part, value: Any) -> bool:
        """Whether a prompt or the statement has all numbers and names of a value."""
        if isinstance(value, Reference):
            return not value.item
        if value is True or (isinstance(value, tuple) and all(isinstance(each, str | sp.Symbol) for each in value)):
            return True  # which equation, which unknowns: no prompt asks without it
        said = set(_TOKENS.findall(f"{part.prompt} {self.problem.statement}"))
        values = list(value.values()) if isinstance(value, Mapping) else value
        flat = [_formula(each) for each in (values if isinstance(values, list | tuple) else [values])]
        tex = " ".join(self.wording_of(part).tex(each) for each in flat if each is not None)
        return bool(tex) and set(_TOKENS.findall(tex)) <= said

    def _values(self, part: Part, name: str, value: Any) -> Iterator[str]:
        """Yield the texts of a value, each as one line."""
        wording = self.wording_of(part)
        if isinstance(value, Reference):
            item, there = wording.say(catalogue()[part.task].options[name].kind.item), self._label(value)
            numbered = Phrase("{item} {number} of part ({part})", item=item, number=value.item, part=there)
            yield wording.say(numbered if value.item else Phrase("with the result of part ({part})", part=there))
        elif isinstance(value, Mapping):
            named = ((_text(key, wording), _text(each, wording)) for key, each in value.items())
            yield from (f"{key} = {each}" for key, each in named if key)
        elif isinstance(value, list | tuple):
            yield from (_text(sp.Symbol(each) if isinstance(each, str) else each, wording) for each in value)
        elif isinstance(value, int) and name in {"input", "output"}:  # channels are counted from one
            yield str(value + 1)
        else:
            yield _text(value, wording)

    def _label(self, there: Reference | EarlierPart) -> str:
        return plain(self.labels[there.part])

    def _system(self, part: Part) -> str:
        """Return the system of a part as a short formula, or as that of another part."""
        wording, system = self.wording_of(part), part.system
        if isinstance(system, EarlierPart):
            return wording.say(Phrase("system of part ({part})", part=self._label(system)))
        if not part.show.system or not part.own_system:
            return ""
        G, A = getattr(system, "matrix", None), getattr(system, "A", None)
        if system.kind == "transfer_function" and G is not None and G.shape == (1, 1):
            return _short(f"G = {_text(G[0, 0], wording)}", SYSTEM)
        return "" if A is None else _short(f"A = {_text(A, wording)}", SYSTEM)

    def _parameters(self, part: Part) -> str:
        """Return the values that only this part has for parameters, or that it has some."""
        if not part.show.system or part.parameters == self.problem.parameters:
            return ""
        wording = self.wording_of(part)
        given = {name: each for name, each in part.parameters.items() if self.problem.parameters.get(name) != each}
        values = ", ".join(
            f"{_text(sp.Symbol(name), wording)} = {_text(each, wording)}" for name, each in given.items()
        )
        return _short(values) or wording.say("with values")

    def _kind(self, part: Part) -> str:
        """Return what kind of system it is, and whether in discrete time."""
        if not part.show.system or isinstance(part.system, EarlierPart):
            return ""
        say = self.wording_of(part).say
        kind = say(part.system.kind.replace("_", " ").replace("state space", "state-space model"))
        return say(Phrase("{kind} in discrete time", kind=kind)) if part.system.discrete else kind

    def _method(self, part: Part) -> str:
        """Return the methods that the file names, if they may be said."""
        task, say = catalogue()[part.task], self.wording_of(part).say
        titles = [task.method_named(name, part.options).title for name in part.methods]
        return ", ".join(say(each) for each in titles if each != task.title) if part.names_methods else ""

    def _asked(self, part: Part) -> str:
        """Return what is asked for, where the file says it."""
        task, wording = catalogue()[part.task], self.wording_of(part)
        meant = (wording.say(task.answers[name].doc) for name in part.asked)
        words = [inline_as_text(re.split(r"[,;(:]", each)[0].strip()) for each in meant]
        return _short(", ".join(words)) or (words and _short(words[0])) or ""

    def _which_system(self, part: Part) -> str:
        """Return the number of the system among those of these parts."""
        systems = _each_once(each.system for each in self.parts)
        number = systems.index(part.system) + 1
        return self.wording_of(part).say(Phrase("system {number}", number=number)) if systems[1:] else ""

    def _number(self, part: Part) -> str:
        """Return the number of the question, where prompts of one's own are all that tells questions apart."""
        return self.wording_of(part).say(Phrase("question {number}", number=self.parts.index(part) + 1))


def _joined(told: Iterable[Sequence[str]], parts: Sequence[Part]) -> list[str]:
    """Return what is said of each part in one."""
    return [", ".join(filter(None, (words[i] for words in told))) for i in range(len(parts))]


def _count(told: Iterable[Sequence[str]], parts: Sequence[Part]) -> int:
    """Count the parts that are told apart by what is said of them."""
    return len(set(_joined(list(told), parts)))


def _each_once(values: Iterable[Any]) -> list[Any]:
    found: list[Any] = []
    for value in values:
        found += [] if value in found else [value]
    return found


def _formula(value: Any) -> Any:
    """Return a value that is printed as a formula: an expression, a matrix, of one entry that, a name; else None."""
    if isinstance(value, sp.MatrixBase):
        return value[0, 0] if value.shape == (1, 1) else value
    if isinstance(value, str):
        return sp.Symbol(value) if _NAME.fullmatch(value) else None
    return value if isinstance(value, sp.Basic) else None


def _text(value: Any, wording: Wording) -> str:
    """Return a value as plain text of one line; of what is no formula the word, of anything else nothing."""
    found = _formula(value)
    if found is not None:
        return _STEP.sub(r"\1 · 1(", inline_as_text(f"${wording.tex(found)}$"))
    return str(value).replace("_", " ") if isinstance(value, str | int) and not isinstance(value, bool) else ""


def _short(text: str, longest: int = LONGEST) -> str:
    return text if len(text) <= longest and not _UNREADABLE.search(text) else ""
