"""A commented problem file to start from, for `solve new TASK`. Imports no algebra."""

from __future__ import annotations

from textwrap import wrap
from typing import Any

from solver.derivation import Option, Task

PLANT = {
    "A": ("[[0, 1], [-2, -3]]", "a matrix, row by row; entries are exact: 0.75, 3/4, sqrt(2), k/m"),
    "B": ("[0, 1]", "a flat list is a column"),
    "C": ("[1, 0]", "a flat list is a row; D is zero unless it is given"),
    "initial_state": ("[1, 0]", "x(0)"),
}
"""An example of order two: controllable, observable, eigenvalues −1 and −2."""

WIDTH = 110
OTHER_NAMES = {"x0": "initial_state"}


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
    """Lines that give the example system with what the task needs; what it does not need as comments."""
    needs = {OTHER_NAMES.get(need, need) for need in task.needs}
    continuous = bool(task.methods_for(discrete=False))
    time = "  # time: discrete" if continuous else "  time: discrete"
    if not needs:
        return []
    if not needs & set(PLANT):
        x = "s" if continuous else "z"
        example = (
            "matrix: [[1, 2], [2, 4]]" if "matrix" in needs else f"transfer_function: ({x} + 3)/({x}^2 + 3{x} + 2)"
        )
        return ["system:", time, f"  {example}"]
    needs |= {"B", "C"} if needs & {"transfer_function", "D"} else set(task.example)
    given = [
        (f"{'' if key in needs or key == 'A' else '# '}{key}: {task.example.get(key, value)}", meaning)
        for key, (value, meaning) in PLANT.items()
    ]
    width = max(len(text) for text, _ in given)
    return ["system:", time, *(f"  {text:{width}}  # {meaning}" for text, meaning in given)]


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
