"""What the files of tasks declare, read without importing them: a topic, a task, its title and its methods.

A topic is a folder whose `__init__.py` says `TOPIC = Topic(group="Design", order=60, title="…")`. A task stands in a
file of its own name as `name: Task[…] = Task("name", title="…", …)`, each of its methods below as
`@name.method("method", …)`. What is written in another way is refused with its place and what to write.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple, TypeGuard

from solver.derivation import Topic


class DeclarationError(Exception):
    """A declaration that cannot be read, with its place and what to do."""


class Declaration(NamedTuple):
    """What the file of a task says of it; a task with one way to solve it may leave the method without a name."""

    name: str
    title: str
    methods: tuple[str, ...]
    module: str
    topic: Topic


def topics(root: Path) -> dict[Path, Topic]:
    """Return the topics by their folder, in their order, those of a group beside each other."""
    found = {path.parent: _topic(path) for path in sorted(root.glob("*/__init__.py"))}
    first: dict[str, int] = {}
    for topic in found.values():
        first[topic.group] = min(topic.order, first.get(topic.group, topic.order))
    return dict(sorted(found.items(), key=lambda each: (first[each[1].group], each[1].order, each[1].title)))


def declared_in(folder: Path, topic: Topic, package: str) -> Iterator[Declaration]:
    """Yield the tasks of a topic, by name; `package` is the name under which its folder is imported."""
    for path in sorted(folder.glob("*.py")):
        declaration = declared_by(path, topic, package)
        if declaration is not None:
            yield declaration


def declared_by(path: Path, topic: Topic, package: str) -> Declaration | None:
    """Return the task that a file declares, None for a file that declares none; raises DeclarationError."""
    text = path.read_text(encoding="utf-8")
    if "Task(" not in text:
        return None
    tree = _statements(path, text)
    statements = {id(each.value): each for each in tree.body if isinstance(each, ast.Assign | ast.AnnAssign)}
    calls = [each.value for each in statements.values() if _is_call(each.value)]
    if len(calls) != text.count("Task("):
        calls = [node for node in ast.walk(tree) if _is_call(node)]
    if not calls:
        return None
    if len(calls) > 1:
        raise _fault(path, calls[1], "one file declares one task; give this one a file of its own name")
    call = calls[0]
    statement = statements.get(id(call))
    if statement is None:
        raise _fault(path, call, "declare a task at the left margin, as `name: Task[…] = Task(…)`")
    name = _literal(path, call, "name", 0, 'its name comes first and is written out: Task("root_locus", …)')
    target = statement.targets[0] if isinstance(statement, ast.Assign) else statement.target
    if not (isinstance(target, ast.Name) and target.id == name):
        raise _fault(path, statement, f"the variable that holds the task must have its name: {name}: Task[…] = Task(…)")
    if path.stem != name:
        raise _fault(path, call, f"the task {name} must stand in a file of its own name, {name}.py")
    title = _literal(path, call, "title", None, 'give it a title that is written out: title="Root locus"')
    return Declaration(name, title, tuple(_methods(path, tree.body, name)), f"{package}.{path.stem}", topic)


def _is_call(node: ast.AST | None) -> TypeGuard[ast.Call]:
    return isinstance(node, ast.Call) and _named(node.func, "Task")


def _topic(path: Path) -> Topic:
    """Return the topic that a folder's `__init__.py` declares."""
    tree = _parsed(path, path.read_text(encoding="utf-8"))
    for node in tree.body:
        if isinstance(node, ast.Assign) and _named(node.targets[0], "TOPIC") and isinstance(node.value, ast.Call):
            try:
                values = {str(word.arg): ast.literal_eval(word.value) for word in node.value.keywords}
                topic = Topic(**values)
            except (ValueError, TypeError) as reason:
                raise _fault(path, node, f"{TOPIC_WANTED}, its values written out") from reason
            return topic
    raise _fault(path, tree, TOPIC_WANTED)


TOPIC_WANTED = 'a topic declares itself: TOPIC = Topic(group="Design", order=60, title="State feedback")'


def _methods(path: Path, statements: Sequence[ast.stmt], task: str) -> Iterator[str]:
    """Yield the names of a task's methods, in their order."""
    for function in statements:
        if not isinstance(function, ast.FunctionDef):
            continue
        for decorator in function.decorator_list:
            method = decorator.func if isinstance(decorator, ast.Call) else decorator
            if not (isinstance(method, ast.Attribute) and method.attr == "method" and _named(method.value, task)):
                continue
            if not isinstance(decorator, ast.Call):
                raise _fault(path, decorator, f"write @{task}.method() with brackets")
            named = decorator.args or any(word.arg == "name" for word in decorator.keywords)
            wanted = f'the name of a method is written out: @{task}.method("by_hand", …)'
            yield _literal(path, decorator, "name", 0, wanted) if named else task


def _literal(path: Path, call: ast.Call, name: str, position: int | None, wanted: str) -> str:
    """Return an argument that must be a text."""
    value: ast.expr = next((word.value for word in call.keywords if word.arg == name), call)
    if value is call and position is not None and len(call.args) > position:
        value = call.args[position]
    if not (isinstance(value, ast.Constant) and isinstance(value.value, str) and value.value):
        raise _fault(path, value, wanted)
    return value.value


def _named(node: ast.expr, name: str) -> bool:
    """Whether an expression is the name, perhaps with types, as in `Task[…]`."""
    if isinstance(node, ast.Subscript):
        return _named(node.value, name)
    return isinstance(node, ast.Name) and node.id == name


def _statements(path: Path, text: str) -> ast.Module:
    """Return what stands in a file, without the bodies of functions: reading these would take most of the time.

    Where a task seems to be declared in one, the whole file.
    """
    outline = _outline(text)
    if outline.count("Task(") == text.count("Task("):
        with suppress(SyntaxError):  # a text that begins at the margin
            return ast.parse(outline)
    return _parsed(path, text)


def _outline(text: str) -> str:
    """Put `...` for the bodies of functions at the margin; what is left stands in its line."""
    lines: list[str] = []
    header = body = False
    for line in text.splitlines():
        if line[:1].strip() and not (header and line[0] == ")"):
            header, body = line.startswith("def "), False
        lines.append("" if body else line)
        if header and line.endswith(":"):
            header, body = False, True
            lines[-1] += " ..."
    return "\n".join(lines)


def _parsed(path: Path, text: str) -> ast.Module:
    try:
        return ast.parse(text, str(path))
    except SyntaxError as fault:
        raise DeclarationError(f"{path}:{fault.lineno}: this is no Python: {fault.msg}") from fault


def _fault(path: Path, node: ast.AST, message: str) -> DeclarationError:
    return DeclarationError(f"{path}:{getattr(node, 'lineno', 1)}: {message}")
