"""The order of steps of each method, read from the derivations by `ast`: which step may follow which.

A derivation becomes a tree of steps, alternatives and repetitions. Lemmas and helpers are followed; a table of
functions stands for any of them. `docs/methods.md` prints the trees; a test matches them with the steps of problems.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path

from solver.tasks import catalogue

ROOT = Path(__file__).parents[1]
ROOMS = ("solver/tasks", "solver/conversions")
Function = ast.FunctionDef
TERMINAL = (ast.Return, ast.Raise, ast.Continue, ast.Break)


@dataclass(frozen=True)
class Named:
    """A step: the file of its wording, and its kind."""

    wording: str
    kind: str


@dataclass(frozen=True)
class Then:
    """Parts one after the other."""

    parts: tuple[Node, ...] = ()


@dataclass(frozen=True)
class Either:
    """One of several ways; one of them may be empty."""

    ways: tuple[Node, ...]


@dataclass(frozen=True)
class Repeated:
    """A part any number of times."""

    part: Node


Node = Named | Then | Either | Repeated
NOTHING = Then()


@dataclass
class Module:
    """A file: its functions, what it imports from other files, and its tables of functions."""

    name: str
    functions: dict[str, Function] = field(default_factory=dict)
    imports: dict[str, tuple[str, str]] = field(default_factory=dict)
    tables: dict[str, ast.expr] = field(default_factory=dict)


@cache
def modules() -> dict[str, Module]:
    """Return the files of the rooms by the names of their modules."""
    found = {}
    for path in (path for room in ROOMS for path in sorted((ROOT / room).rglob("*.py"))):
        name = ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__")
        found[name] = _module(name, ast.parse(path.read_text(encoding="utf-8")))
    return found


def _module(name: str, tree: ast.Module) -> Module:
    module = Module(name)
    for node in tree.body:
        if isinstance(node, ast.FunctionDef):
            module.functions[node.name] = node
        elif isinstance(node, ast.ClassDef):
            methods = (each for each in node.body if isinstance(each, ast.FunctionDef))
            module.functions |= {f".{each.name}": each for each in methods}
        elif isinstance(node, ast.ImportFrom) and node.module:
            module.imports |= {each.asname or each.name: (node.module, each.name) for each in node.names}
        elif isinstance(node, ast.Assign | ast.AnnAssign) and node.value is not None:
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            module.tables |= {each.id: node.value for each in targets if isinstance(each, ast.Name)}
    return module


@dataclass(frozen=True)
class Route:
    """A method of a task and the order of its steps."""

    task: str
    method: str
    title: str
    order: Node


@cache
def methods() -> tuple[Route, ...]:
    """Return the methods of all tasks."""
    found = []
    for each in catalogue().declarations():
        for name, method in catalogue()[each.name].methods.items():
            function = getattr(method.derive, "__wrapped__", method.derive).__name__
            found.append(Route(each.name, name, method.title, order_of(each.module, function, f"{each.name}/{name}")))
    return tuple(found)


def order_of_method(task: str, method: str) -> Node:
    """Return the order of the steps of one method."""
    return next(each.order for each in methods() if (each.task, each.method) == (task, method))


def order_of(module: str, function: str, wording: str) -> Node:
    """Return the steps of a method in their order."""
    return _Reader(modules()[module], wording, ()).function(modules()[module], modules()[module].functions[function])


@dataclass(frozen=True)
class _Reader:
    """Reads the statements of one function; `within` are the functions that called it.

    What is not `yielding` makes steps that may be yielded later, or be substeps.
    """

    module: Module
    wording: str
    within: tuple[str, ...]
    owner: Function | None = None
    yielding: bool = False

    def body(self, statements: Sequence[ast.stmt]) -> Node:
        """Return the steps of some statements; what follows a way that ends the function is another way."""
        parts: list[Node] = []
        for i, each in enumerate(statements):
            if isinstance(each, ast.If):
                parts.append(self.expression(each.test))
                if not _may_end(each):
                    parts.append(_either([self.body(each.body), self.body(each.orelse)]))
                    continue
                rest = self.body(statements[i + 1 :])
                ways = [self._way(branch, rest) for branch in (each.body, each.orelse)]
                return _then([*parts, _either(ways)])
            parts.append(self.statement(each))
            if isinstance(each, TERMINAL):
                break
            if any(isinstance(node, ast.Return) for node in ast.walk(each)):
                return _then([*parts, _either([NOTHING, self.body(statements[i + 1 :])])])
        return _then(parts)

    def _way(self, branch: Sequence[ast.stmt], rest: Node) -> Node:
        """A branch and what follows it, nothing where it ends the function, perhaps nothing where a part of it may."""
        here = self.body(branch)
        if branch and isinstance(branch[-1], TERMINAL):
            return here
        return _then([here, _either([NOTHING, rest]) if any(map(_may_end, branch)) else rest])

    def statement(self, each: ast.stmt) -> Node:  # noqa: PLR0911 - one for each kind
        """Return the steps of one statement."""
        if isinstance(each, ast.For | ast.While):
            head = each.iter if isinstance(each, ast.For) else each.test
            return _then([self.expression(head), _repeated(self.body(each.body))])
        if isinstance(each, ast.Try):
            handlers = [self.body(handler.body) for handler in each.handlers]
            return _then([self.body(each.body), _either([NOTHING, *handlers]), self.body(each.orelse)])
        if isinstance(each, ast.With):
            return self.body(each.body)
        if isinstance(each, ast.Match):
            return _then([self.expression(each.subject), _either([NOTHING, *(self.body(c.body) for c in each.cases)])])
        if isinstance(each, ast.FunctionDef | ast.ClassDef):
            return NOTHING
        if isinstance(each, ast.Return) and each.value is not None:
            return replace(self, yielding=True).expression(each.value)
        return _then([self.expression(node) for node in ast.iter_child_nodes(each)])

    def expression(self, node: ast.AST) -> Node:  # noqa: PLR0911 - one for each kind
        """Return the steps that are made while an expression is evaluated."""
        if isinstance(node, ast.IfExp):
            return _then(
                [self.expression(node.test), _either([self.expression(node.body), self.expression(node.orelse)])]
            )
        if isinstance(node, ast.BoolOp):
            first, *others = (self.expression(value) for value in node.values)
            return _then([first, *(_either([NOTHING, each]) for each in others)])
        if isinstance(node, ast.ListComp | ast.SetComp | ast.GeneratorExp | ast.DictComp | ast.Lambda):
            return _repeated(_then([self.expression(each) for each in ast.iter_child_nodes(node)]))
        if isinstance(node, ast.Call):
            return self.call(node) if self.yielding else _either([NOTHING, self.call(node)])
        if isinstance(node, ast.Name):
            return self.named(node.id)
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            return self.attribute(node.value.id, node.attr)
        return _then([self.expression(each) for each in ast.iter_child_nodes(node)])

    def call(self, node: ast.Call) -> Node:
        """Return the steps of the arguments, then those of what is called; substeps are no steps of their own."""
        given = [*node.args, *(each.value for each in node.keywords if each.arg != "steps")]
        arguments = [replace(self, yielding=False).expression(each) for each in given]
        if isinstance(node.func, ast.Name) and node.func.id == "Step":
            kinds = [kind for each in self.assigned(node.args[0]) for kind in _texts(each)]
            return _then([*arguments, _either([Named(self.wording, each) for each in kinds])])
        return _then([*arguments, self.expression(node.func)])

    def assigned(self, kind: ast.expr) -> list[ast.expr]:
        """Return the kind of a step as it is written, or what its name was given in this function."""
        if not isinstance(kind, ast.Name) or self.owner is None:
            return [kind]
        inside = list(ast.walk(self.owner))
        given = (each for each in inside if isinstance(each, ast.Assign))
        loops = (each for each in inside if isinstance(each, ast.For))
        return [
            *(each.value for each in given if any(ast.unparse(target) == kind.id for target in each.targets)),
            *(each.iter for each in loops if ast.unparse(each.target) == kind.id),
        ]

    def named(self, name: str) -> Node:
        """Return the steps of a function, of any function of a table; nothing for other names."""
        if name in self.module.functions:
            return self.function(self.module, self.module.functions[name])
        if name in self.module.tables and f"{self.module.name}:{name}" not in self.within:
            reader = _Reader(self.module, self.wording, (*self.within, f"{self.module.name}:{name}"))
            return _either([reader.expression(each) for each in _entries(self.module.tables[name])])
        if name in self.module.imports:
            module, original = self.module.imports[name]
            if module in modules():
                return _Reader(modules()[module], self.wording, self.within).named(original)
        return NOTHING

    def attribute(self, owner: str, name: str) -> Node:
        """Return the steps of a function of an imported module, or of a method of that name."""
        if owner in self.module.imports and ".".join(self.module.imports[owner]) in modules():
            return _Reader(modules()[".".join(self.module.imports[owner])], self.wording, self.within).named(name)
        method = self.module.functions.get(f".{name}")
        return NOTHING if method is None else self.function(self.module, method)

    def function(self, module: Module, function: Function) -> Node:
        """Return the steps of a function, worded by its own file where it is a lemma."""
        name = f"{module.name}:{function.name}"
        if name in self.within:
            return NOTHING
        wording = _lemma(function) or self.wording
        return _Reader(module, wording, (*self.within, name), function).body(function.body)


def _texts(kind: ast.expr) -> list[str]:
    """Return the texts that an expression may be; those compared with are none of them."""
    compared = {id(each) for node in ast.walk(kind) if isinstance(node, ast.Compare) for each in ast.walk(node)}
    constants = (each for each in ast.walk(kind) if isinstance(each, ast.Constant) and id(each) not in compared)
    return [each.value for each in constants if isinstance(each.value, str)]


def _may_end(statement: ast.stmt) -> bool:
    """Whether a statement may end the function, or the pass of a loop."""
    return any(isinstance(node, TERMINAL) for node in ast.walk(statement))


def _entries(table: ast.expr) -> Iterable[ast.expr]:
    return [each for each in ast.walk(table) if isinstance(each, ast.Name | ast.Attribute | ast.Lambda)]


def _lemma(function: Function) -> str:
    """The file of wording that the decorator names."""
    for each in function.decorator_list:
        if isinstance(each, ast.Call) and isinstance(each.func, ast.Name) and each.func.id == "lemma":
            name = each.args[0]
            return f"lemmas/{name.value}" if isinstance(name, ast.Constant) else ""
    return ""


def _then(parts: Iterable[Node]) -> Node:
    flat: list[Node] = []
    for part in parts:
        flat += part.parts if isinstance(part, Then) else (part,)
    return flat[0] if len(flat) == 1 else Then(tuple(flat))


def _either(ways: Iterable[Node]) -> Node:
    flat: list[Node] = []
    for way in ways:
        flat += way.ways if isinstance(way, Either) else (way,)
    distinct = tuple(dict.fromkeys(flat))
    if not distinct:
        return NOTHING
    return distinct[0] if len(distinct) == 1 else Either(distinct)


def _repeated(part: Node) -> Node:
    return part if part == NOTHING or isinstance(part, Repeated) else Repeated(part)


def follows(order: Node, steps: Sequence[Named]) -> bool:
    """Whether some steps may come in this order (where a derivation was cut short: begin in it)."""
    return len(steps) in _after(order, steps, {0})


def _after(node: Node, steps: Sequence[Named], starts: set[int]) -> set[int]:
    """Return where a node may end that begins at one of these places; the end of all steps is an end of everything."""
    end = len(steps)
    if isinstance(node, Named):
        return {i + 1 for i in starts if i < end and steps[i] == node} | ({end} & starts)
    if isinstance(node, Then):
        for part in node.parts:
            starts = _after(part, steps, starts)
        return starts
    if isinstance(node, Either):
        return set().union(*(_after(way, steps, starts) for way in node.ways))
    reached = set(starts)
    new = set(starts)
    while new:
        new = _after(node.part, steps, new) - reached
        reached |= new
    return reached


def walked(node: Node) -> Iterator[Named]:
    """Yield the steps of a tree in the order of writing."""
    if isinstance(node, Named):
        yield node
        return
    parts = node.parts if isinstance(node, Then) else node.ways if isinstance(node, Either) else (node.part,)
    for part in parts:
        yield from walked(part)
