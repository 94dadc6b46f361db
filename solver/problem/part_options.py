"""Reading the options of one part: those that the file gives, the defaults of the others, and what else is usual."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from solver.derivation import Option, Task
from solver.derivation.options import Typed
from solver.problem.context import Context
from solver.problem.model import Reference
from solver.problem.nodes import Entry, MappingNode, ScalarNode, node_of
from solver.problem.references import read_option
from solver.problem.source import Report, did_you_mean
from solver.systems import StateSpace

OWN_KEYS = ("task", "method", "marks", "prompt", "system", "assume", "conditions", "answers", "digits", "partial",
            "decimal_comma", "show")  # fmt: skip


class OptionsReader:
    """Reads the options of one part; `given` are the names of those in the file."""

    def __init__(self, task: Task[Any, Any], methods: tuple[str, ...], part: MappingNode, context: Context) -> None:
        self.task = task
        self.methods = methods
        self.part = part
        self.context = context
        self.takes = {name: option for method in methods for name, option in task.options_for(method).items()}
        own = {"parameters"} if isinstance(part.get("parameters"), MappingNode) else set()  # of names, not an option
        self.given = {entry.key.text for entry in part} - {*OWN_KEYS, *own}

    def options(self) -> dict[str, Any]:
        """Return the options given and the defaults of the others; raises Fault with all that is wrong."""
        report = Report()
        values: dict[str, Any] = {}
        for entry in sorted(self.part, key=self._closes_a_loop, reverse=True):  # their names are parameters too
            if entry.key.text in self.given:
                with report:
                    option = self._option(entry.key)
                    values[option.name] = value = read_option(option, entry.value, self.context)
                    if option.loop:
                        self.context = replace(self.context, around=_with_names(self.context.around, value))
        for option in self.takes.values():
            if option.name not in self.given:
                with report:
                    values |= self._default(option)
        if "gain" in self.given:
            with report:
                self._check_plant()
        report.conclude()
        return values

    def _closes_a_loop(self, entry: Entry) -> bool:
        option = self.takes.get(entry.key.text)
        return option is not None and bool(option.loop)

    def _option(self, key: ScalarNode) -> Option:
        name = key.text
        if name in self.takes:
            return self.takes[name]
        if name in self.task.options:
            of = ", ".join(self.task.options[name].methods)
            raise key.fault(f"'{name}' is an option of the method {of}, not of {', '.join(self.methods)}")
        known = [*self.takes, *(own for own in OWN_KEYS if own not in self.part)]
        note = f"it takes: {', '.join(self.takes)}"
        message = f"{self.task.name} has no option '{name[:60]}'"
        raise key.fault(message, suggestion=did_you_mean(name, known), note=note)

    def _default(self, option: Option) -> dict[str, Any]:
        """Return the value of an option that is not given, if it has one."""
        value = option.default
        if option.required:
            message = f"{self.task.name} needs the option '{option.name}': {option.doc}"
            raise self.part["task"].fault(message)
        if value is None:
            return {}
        return {option.name: self._typed(option, value)}

    def conventions(self) -> dict[str, dict[str, Any]]:
        """Return the usual values of the options that are conventions and not given, by option and as typed."""
        return {
            name: {str(typed): self._typed(option, typed) for typed in option.conventions if typed != option.default}
            for name, option in self.takes.items()
            if option.conventions and name not in self.given
        }

    def _typed(self, option: Option, value: Typed) -> Any:
        return read_option(option, node_of(value, self.part["task"].place), self.context)

    def _check_plant(self) -> None:
        """Refuse a gain where there is nothing to feed back to."""
        system = self.context.system
        if isinstance(system, StateSpace) and system.B is None:
            raise self.part.entries["gain"].key.fault(f"a gain needs A and B; {system.described}")


def _with_names(names: frozenset[str] | None, value: Any) -> frozenset[str] | None:
    """Add the names of the parameters in a value; None where the value is not known yet."""
    if names is None or isinstance(value, Reference):
        return None
    return names | {str(symbol.name) for symbol in getattr(value, "free_symbols", ())} - {"s", "z"}
