"""The catalogue is whole: every step kind has wording, every task an example, and nothing is left over."""

import ast
import inspect
import re
import subprocess
import sys
from importlib import import_module
from pathlib import Path
from pkgutil import walk_packages

import pytest
from jinja2 import Environment, nodes

import solver.arithmetic
import solver.conversions
import solver.tasks
from solver.resources import root
from solver.systems import kinds
from solver.tasks import catalogue
from solver.words import languages

WORDING = root("templates") / "wording"
MODULES = [
    import_module(info.name)
    for room in (solver.tasks, solver.conversions, solver.arithmetic)
    for info in walk_packages(room.__path__, f"{room.__name__}.")
]


def kinds_of(module) -> set[str]:
    """Every kind of step that a module can emit, read from its text: Step("kind", ...) or kind = "a" if ..."""
    found: set[str] = set()
    for node in ast.walk(ast.parse(inspect.getsource(module))):
        if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "Step":
            found |= words_in(node.args[0])
        if isinstance(node, ast.Assign) and getattr(node.targets[0], "id", "") == "kind":
            found |= words_in(node.value)
        if isinstance(node, ast.For) and getattr(node.target, "id", "") == "kind":
            found |= words_in(node.iter)
    return found


def words_in(node: ast.expr) -> set[str]:
    if isinstance(node, ast.IfExp):
        return words_in(node.body) | words_in(node.orelse)
    if isinstance(node, ast.Tuple):
        return set().union(*map(words_in, node.elts))
    return {node.value} if isinstance(node, ast.Constant) and isinstance(node.value, str) else set()


def wordings_of(module) -> set[str]:
    """The wording files of a module's methods and lemmas."""
    functions = [
        value for value in vars(module).values() if inspect.isfunction(value) and value.__module__ == module.__name__
    ]
    return {function.wording for function in functions if hasattr(function, "wording")}


def macros_of(wording: str) -> set[str]:
    """The macros for steps; those with other arguments are helpers of the file."""
    path = WORDING / f"{wording}.md.jinja"
    if not path.exists():
        return set()
    macros = Environment(autoescape=True).parse(path.read_text(encoding="utf-8")).find_all(nodes.Macro)
    return {macro.name for macro in macros if [argument.name for argument in macro.args] == ["v", "c"]}


@pytest.mark.parametrize("module", MODULES, ids=lambda module: module.__name__)
def test_every_step_kind_has_a_macro_and_every_macro_a_step_kind(module):
    """Of a file of wording that several modules share, each macro belongs to one of them."""
    wordings = wordings_of(module)
    macros = set().union(*map(macros_of, wordings))
    assert kinds_of(module) <= macros
    assert macros <= set().union(*(kinds_of(each) for each in MODULES if wordings & wordings_of(each)))


def test_every_wording_file_belongs_to_a_method_or_lemma():
    used = set().union(*(wordings_of(module) for module in MODULES)) | {f"{name}/question" for name in catalogue()}
    used |= {f"systems/{kind.name}" for kind in kinds().values()}
    texts = [path.read_text(encoding="utf-8") for path in WORDING.rglob("*.md.jinja")]
    used |= {name for text in texts for name in re.findall(r'from "([\w/]+)\.md\.jinja" import', text)}
    files = {path.relative_to(WORDING).as_posix().removesuffix(".md.jinja") for path in WORDING.rglob("*.md.jinja")}
    others = (
        "reasons/",
        "lemmas/asked",
        "lemmas/conditions",
        "lemmas/given",
        "lemmas/special_cases",
        *(f"{language}/" for language in languages()),
    )
    assert {file for file in files if not file.startswith(others)} <= used


@pytest.mark.parametrize("task", catalogue().values(), ids=lambda task: task.name)
def test_every_task_is_documented_and_asked_in_a_problem(task):
    asked = "\n".join(path.read_text(encoding="utf-8") for path in root("problems").rglob("*.yaml"))
    assert task.doc
    assert all(answer.doc and answer.symbol for answer in task.answers.values())
    assert all(option.doc for option in task.options.values())
    assert all(method.derive.__doc__ for method in task.methods.values())
    assert (WORDING / task.name / "question.md.jinja").is_file()
    assert task.name in asked
    assert all(method in asked for method in task.methods if len(task.methods) > 1)


@pytest.mark.parametrize("task", catalogue().values(), ids=lambda task: task.name)
def test_every_method_gives_an_answer_that_the_question_is_after(task):
    for method in task.methods:
        assert any(not task.answers[name].methods or method in task.answers[name].methods for name in task.principal)


@pytest.mark.parametrize("task", catalogue().values(), ids=lambda task: task.name)
def test_every_answer_has_a_judge(task):
    judged = {name for verification in task.verifications for name in verification.answers}
    assert judged == set(task.answers)


@pytest.mark.parametrize("task", catalogue().values(), ids=lambda task: task.name)
def test_the_documented_commands_name_the_task(task):
    guide = Path(__file__).parents[2] / "docs" / "user-guide.md"
    assert f"`{task.name}`" in guide.read_text(encoding="utf-8")


def test_the_catalogue_is_read_without_sympy():
    heavy = "bool({'sympy', 'numpy'} & {*sys.modules})"
    code = f"import sys; from solver.tasks import catalogue; list(catalogue().values()); sys.exit({heavy})"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


@pytest.mark.parametrize("declared", catalogue().declarations(), ids=lambda declared: declared.name)
def test_what_is_read_from_a_declaration_is_what_the_task_has(declared):
    task = catalogue()[declared.name]
    assert (task.name, task.title) == (declared.name, declared.title)
    titles = {name: method.title for name, method in task.methods.items()}
    assert len(titles) == 1 or all(title != task.title for title in titles.values())
    assert tuple(task.methods) == declared.methods
