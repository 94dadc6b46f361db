"""A commented problem file to start from, for `solve new TASK`. Imports no algebra."""

from __future__ import annotations

from textwrap import wrap
from typing import Any

from solver.derivation import Option, Task
from solver.systems import kinds

WIDTH = 110
OTHER_NAMES = {
    "x0": "initial_state",
    "motion": "A",
    "rest": "equations",
    "machine": "equations",
    "gains": "transfer_matrix",
    "path": "transfer_function",
    "open_loop": "transfer_function",
}


def new_problem(task: Task[Any, Any]) -> str:
    """Return a problem file that asks for the task: it can be read and solved as it stands."""
    lines = [*_comment(f"{task.title}. {task.doc}", ""), f"title: {_quoted(task.title)}", *_system(task)]
    lines += ["find:", "  a:", f"    task: {task.name}", *_methods(task), *_options(task)]
    lines += ["    # marks: 5", "    # prompt: the question in your own words, with $math$"]
    return "\n".join(lines) + "\n"


def _comment(text: str, indent: str) -> list[str]:
    return [f"{indent}# {line}" for line in wrap(text, WIDTH - len(indent))]


def _quoted(text: str) -> str:
    """Return a text as YAML reads it back, in single quotes where it must be."""
    plain = text[:1].isalpha() and not any(sign in text for sign in (": ", " #"))
    return text if plain else "'" + text.replace("'", "''") + "'"


def _system(task: Task[Any, Any]) -> list[str]:
    """Lines that give the example of a kind of system with what the task needs; the rest of it as comments."""
    first = next(iter(task.methods.values()))
    needs = {OTHER_NAMES.get(need, need) for need in task.needs or first.needs}
    continuous = bool(task.methods_for(discrete=False))
    time = "  # time: discrete" if continuous else "  time: discrete"
    if not needs:
        return []
    kind = next((each for each in kinds().values() if each.name in needs), kinds()["A"])
    keys = {line.partition(":")[0] for line, _ in kind.example}
    if needs & keys:
        needs |= {"B", "C"} if needs & {"transfer_function", "D"} else set(task.example)
    required = needs | {key.name for key in kind.keys if key.required}
    given = []
    for line, meaning in kind.example:
        key, _, value = line.replace("{x}", "s" if continuous else "z").partition(": ")
        given.append((f"{'' if key in required else '# '}{key}: {task.example.get(key, value)}", meaning))
    width = max(len(text) for text, _ in given)
    return ["system:", time, *(f"  {text:{width}}  # {meaning}" if meaning else f"  {text}" for text, meaning in given)]


def _methods(task: Task[Any, Any]) -> list[str]:
    """The line with the method, and the others as a comment; nothing where there is one only."""
    if list(task.methods) == [task.name]:
        return []
    continuous, discrete = (task.methods_for(discrete) for discrete in (False, True))
    fitting, others = (continuous, discrete) if continuous else (discrete, continuous)
    text = f"one of {', '.join(fitting)}, or a list of several"
    text += f"; in discrete time: {', '.join(others)}" if others and others != fitting else ""
    return [*_comment(text, "    "), f"    method: {fitting[0]}"]


def _options(task: Task[Any, Any]) -> list[str]:
    """Each option under its meaning; those that the method or the example needs are given, the others are comments."""
    taken = task.options_for((task.methods_for(discrete=False) or task.methods_for(discrete=True))[0])
    lines: list[str] = []
    for option in task.options.values():
        of = f" (for {', '.join(option.methods)})" if option.methods else ""
        lines += _comment(option.doc + of, "    ")
        own = task.example.get(option.name, "")
        hidden = "" if own or (option.required and option.name in taken) else "# "
        lines.append(f"    {hidden}{option.name}: {own or example(option)}")
    return lines


def example(option: Option) -> str:
    """Return a value for an option, as it is written in a file: its default if it has one."""
    default = option.default
    if default is None or isinstance(default, list):
        return option.kind.example
    return str(default).lower() if isinstance(default, bool) else str(default)
