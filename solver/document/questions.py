"""What a part asks, in words: its title, the methods that may be named, the question, what is given with it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from solver.derivation import Task
from solver.document.checks import Say
from solver.document.model import Presentation
from solver.problem.model import Chain, Part, Problem, Reference
from solver.render.wording import Wording
from solver.systems import EarlierPart, System
from solver.words import Phrase, Reason

CLOSED = "closed_loop"
"""The lemma that closes a loop by state feedback."""

Labels = Mapping[str, str]
"""The names of parts in print, by those of the file."""


def title_of(part: Part, task: Task[Any, Any], say: Say) -> str:
    """Return the title of a part, which tells it apart from others of its task where its options do."""
    title = say(task.title_of(part.options, part.written))
    closed = CLOSED in loops(task, part) or getattr(part.system, "gain", None) is not None
    return say(Phrase("{title} of the closed loop", title=title)) if closed else title


def method_title(part: Part, task: Task[Any, Any], method: str, told: Presentation, say: Say, title: str) -> str:
    """Return the title of the method, that of the part if it has none of its own.

    On a paper it is those of all that the file names, if they may be said.
    """
    if not told.is_paper:
        own = task.method_named(method, part.options).title
        return title if own == task.title else say(own)
    titles = dict.fromkeys(say(task.method_named(name, part.options).title) for name in part.methods)
    return ", ".join(titles) if part.names_methods else ""


def source_of(part: Part, task: Task[Any, Any], method: str, told: Presentation, say: Say) -> str:
    """Return the literature of the method; a paper names it where it names the method."""
    shown = told.sources and (not told.is_paper or (part.show.source and part.names_methods))
    return say(task.method_named(method, part.options).source) if shown else ""


def question_of(part: Part, task: Task[Any, Any], wording: Wording, labels: Labels) -> str:
    """Return the question, in which earlier parts have their printed names."""
    asked = [task.answers[name] for name in part.asked]
    return wording.question(printed(part, labels), loops=loops(task, part), asked=asked)


def loops(task: Task[Any, Any], part: Part) -> list[str]:
    """Return the lemmas that close a loop around the system, for the options that are given."""
    given = (option.loop for name, option in task.options.items() if part.options.get(name) is not None)
    return list(dict.fromkeys(loop for loop in given if loop))


def given_with(part: Part, problem: Problem, wording: Wording, labels: Labels) -> str:
    """Return what a part gives: its own system and assumptions, and the conditions that it adds."""
    told = {chain.place for chain in problem.conditions}
    own = [chain for chain in part.conditions if chain.place not in told]
    part = printed(part, labels)
    return given(wording, part, part.system if part.own_system else None, own)


def given(wording: Wording, of: Problem | Part, system: System | None, conditions: Sequence[Chain]) -> str:
    """Return what is given about a system, if there is one, and about the parameters."""
    told = [wording.given(system) if system is not None else "", wording.conditions(of.assumed, conditions)]
    return "\n\n".join(filter(None, told))


def printed(part: Part, labels: Labels) -> Part:
    """Return a part that refers to earlier ones by their printed names."""
    options = {name: _printed(value, labels) for name, value in part.options.items()}
    system = part.system
    if isinstance(system, EarlierPart):
        system = replace(system, part=labels[system.part], gain=_printed(system.gain, labels))
    return replace(part, options=options, system=system)


def _printed(value: Any, labels: Labels) -> Any:
    return replace(value, part=labels[value.part]) if isinstance(value, Reference) else value


def reason_in_print(reason: Reason | None, labels: Labels) -> Reason | None:
    """Return a reason that names an earlier part as it is printed."""
    if reason is None or reason.values.get("part") not in labels:
        return reason
    return replace(reason, values={**reason.values, "part": labels[reason.values["part"]]})
