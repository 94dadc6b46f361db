"""Reading the options of a part: one reader for each kind of option, and references to earlier parts."""

from __future__ import annotations

import re
from typing import Any

import sympy as sp

from solver.derivation import (
    Channel,
    Choice,
    Expression,
    ExpressionList,
    Flag,
    Integer,
    MatrixOf,
    Names,
    Number,
    Option,
    Poles,
    TransferFunctionOption,
)
from solver.problem.context import Context
from solver.problem.lexicon import scalar
from solver.problem.matrices import expect_shape, is_flat, read_matrix
from solver.problem.model import Reference
from solver.problem.nodes import MappingNode, Node, ScalarNode, SequenceNode
from solver.problem.poles import read_conjugate_list
from solver.problem.source import Fault, Report, did_you_mean
from solver.problem.transfer_functions import read_transfer_function
from solver.systems import StateSpace

REFERABLE = (MatrixOf, Poles, Expression, ExpressionList, Number, TransferFunctionOption)
"""Kinds of option whose value can be the answer of an earlier part."""

DEFAULT_ANSWERS = {"gain": "K", "observer_gain": "L"}
"""The answer that `{from: part}` takes for an option; for others the one of the option's own name."""


def read_option(option: Option, node: Node, context: Context) -> Any:
    """Return the value of an option as tasks get it; raises Fault.

    Integer: int. Choice: the word. Flag: bool. Number, Expression: an expression. ExpressionList, Poles: a tuple of
    expressions. MatrixOf: an immutable matrix. Channel: the index from 0. Names: a tuple of words.
    TransferFunctionOption: a rational function. Where it refers to an earlier part: a `Reference`.
    """
    if isinstance(node, MappingNode) and "from" in node:
        return _reference(option, node, context)
    name = option.name
    value: Any
    match option.kind:
        case Integer() as kind:
            value = read_integer(kind, node, name)
        case Choice() as kind:
            value = _choice(kind, node, name)
        case Flag():
            value = _flag(node, name)
        case Number() as kind:
            value = _number(kind, node, context)
        case Expression() as kind:
            value = context.lexicon.expression(node, context.variables(kind.variables), context.barred)
        case ExpressionList() as kind:
            value = _expressions(kind, node, context)
        case Poles():
            value = read_conjugate_list(node, context.lexicon)
        case MatrixOf() as kind:
            value = _matrix(kind, node, name, context)
        case Channel() as kind:
            value = _channel(kind, node, name, context)
        case Names():
            value = _words(node, context)
        case TransferFunctionOption():
            value = read_transfer_function(node, context.lexicon, context.discrete).cancelled()
    return value


def _reference(option: Option, node: MappingNode, context: Context) -> Reference:
    """`{from: b, answer: K}`."""
    if not isinstance(option.kind, REFERABLE):
        raise node.fault(f"'{option.name}' cannot be taken from an earlier part")
    for entry in node:
        if entry.key.text not in ("from", "answer"):
            suggestion = did_you_mean(entry.key.text, ["answer"])
            raise entry.key.fault(f"unknown key '{entry.key.text}' beside 'from'", suggestion=suggestion)
    part = scalar(node["from"]).text
    if part not in context.earlier:
        note = f"earlier parts are: {', '.join(context.earlier)}" if context.earlier else "there is no earlier part"
        message = f"'{part}' is not an earlier part"
        raise node["from"].fault(message, suggestion=did_you_mean(part, context.earlier), note=note)
    source = context.earlier[part]
    if source is None:
        raise Fault  # the part is wrong itself, and reported
    task, method = source
    answer = scalar(node["answer"]).text if "answer" in node else DEFAULT_ANSWERS.get(option.name, option.name)
    given = [name for name, each in task.answers.items() if not each.methods or method in each.methods]
    if answer not in given:
        message = f"part {part} ({task.name}) gives no '{answer}'"
        note = f"its answers are: {', '.join(given)}" + ("" if "answer" in node else "; name one by 'answer:'")
        at = node.get("answer") or node
        raise at.fault(message, suggestion=did_you_mean(answer, given), note=note)
    return Reference(part, answer)


def read_integer(kind: Integer, node: Node, name: str) -> int:
    """Return a whole number within bounds."""
    text = scalar(node).text
    bounds = [
        f"at least {kind.minimum}" if kind.minimum is not None else "",
        f"at most {kind.maximum}" if kind.maximum is not None else "",
    ]
    expected = " and ".join(["a whole number", *filter(None, bounds)]).replace(" and ", " of ", 1)
    if not re.fullmatch(r"[+-]?[0-9]{1,9}", text):
        raise node.fault(f"{name} must be {expected}, not {_shown(node)}")
    value = int(text)
    if (kind.minimum is not None and value < kind.minimum) or (kind.maximum is not None and value > kind.maximum):
        raise node.fault(f"{name} must be {expected}")
    return value


def _choice(kind: Choice, node: Node, name: str) -> str:
    word = node.text if isinstance(node, ScalarNode) else ""
    if word not in kind.words:
        message = f"{name} must be one of {', '.join(kind.words)}, not {_shown(node)}"
        raise node.fault(message, suggestion=did_you_mean(word, kind.words) if word else "")
    return word


def _flag(node: Node, name: str) -> bool:
    truth = node.truth if isinstance(node, ScalarNode) else None
    if truth is None:
        raise node.fault(f"{name} must be true or false, not {_shown(node)}")
    return truth


def _number(kind: Number, node: Node, context: Context) -> sp.Expr:
    """Return an expression; "14%" is 7/50."""
    text = scalar(node)
    if not kind.percent or not text.text.rstrip().endswith("%"):
        return context.lexicon.expression(node, barred=context.barred)
    without = ScalarNode(node.place, text.text.rstrip().removesuffix("%"), text.style)
    value: sp.Expr = context.lexicon.expression(without, barred=context.barred) / 100
    return value


def _expressions(kind: ExpressionList, node: Node, context: Context) -> tuple[sp.Expr, ...]:
    items = node.items if isinstance(node, SequenceNode) else (node,)
    if not items:
        raise node.fault("the list is empty")
    report = Report()
    values: list[sp.Expr] = []
    for item in items:
        with report:
            values.append(context.lexicon.expression(item, context.variables(kind.variables), context.barred))
    report.conclude()
    return tuple(values)


def _matrix(kind: MatrixOf, node: Node, name: str, context: Context) -> sp.ImmutableMatrix:
    """Return a matrix of the shape asked for; a flat list of the right length fits a column or a row."""
    rows, columns = context.size(kind.rows), context.size(kind.columns)
    flat = kind.flat
    if is_flat(node) and (columns == 1) != (rows == 1):
        flat = "column" if columns == 1 else "row"
    matrix = read_matrix(node, name, context.lexicon, flat, context.barred)
    owners = {"n": " for the states", "m": " for the inputs", "p": " for the outputs"}
    expect_shape(matrix, (rows, None), node, name, owners.get(str(kind.rows), ""))
    expect_shape(matrix, (None, columns), node, name, owners.get(str(kind.columns), ""))
    return matrix


def _channel(kind: Channel, node: Node, name: str, context: Context) -> int:
    """Return the index, from 0, of an input, output or state given by its name or its number from 1."""
    word = scalar(node).text
    names = context.names(kind.of)
    if word in names:
        return names.index(word)
    number = context.size({"input": "m", "output": "p", "state": "n"}[kind.of])
    if not re.fullmatch(r"[0-9]{1,3}", word):
        known = f"its name ({', '.join(names)}) or its number from 1" if names else "its number from 1"
        raise node.fault(f"{name} must be an {kind.of} by {known}", suggestion=did_you_mean(word, names))
    if int(word) < 1 or (number is not None and int(word) > number):
        count = "there is no such" if number is None else f"there are {number} of them, so it is not a number of an"
        raise node.fault(f"{name}: {count} {kind.of}")
    return int(word) - 1


def _words(node: Node, context: Context) -> tuple[str, ...]:
    """Return names of parameters or states, or numbers of states; unknown ones are refused if a system is known."""
    items = node.items if isinstance(node, SequenceNode) else (node,)
    words = tuple(scalar(item).text for item in items)
    if not words:
        raise node.fault("the list is empty")
    if isinstance(context.system, StateSpace):
        known = [str(symbol.name) for symbol in context.system.parameters]
        known += [name for of in ("state", "input", "output") for name in context.names(of)]
        numbers = [str(number + 1) for number in range(context.system.order)]
        known += [] if context.names("state") else [f"x{number}" for number in numbers]  # states go by these names
        for item, word in zip(items, words, strict=True):
            if word not in known and word not in numbers:
                note = f"it has: {', '.join(known)}" if known else ""
                message = f"'{word[:40]}' is no name in the system"
                raise item.fault(message, suggestion=did_you_mean(word, known), note=note)
    for position, item in enumerate(items):
        if words[position] in words[:position]:
            raise item.fault(f"'{words[position]}' is given twice")
    return words


def _shown(node: Node) -> str:
    return f"'{node.text[:40]}'" if isinstance(node, ScalarNode) and not node.is_null else node.what
