"""A paper gives nothing away: no answer, no method that the file does not name, no key of the file."""

import re
from dataclasses import replace

import pytest
import sympy as sp

from solver.document.model import Presentation
from solver.document.questions import loops
from solver.document.works import document_of
from solver.engine import solve_problem
from solver.problem.labels import labels_of
from solver.problem.model import Reference
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.problem.template import new_problem
from solver.render.wording import Wording
from solver.systems import TransferFunction
from solver.tasks import catalogue
from tests.helpers.solved import EXAMPLES, PROBLEMS, by_problem, document_of_problem, solution_of

CATALOGUE = catalogue()
TELLING = 18
"""Characters of LaTeX from which on a value is hardly there by chance."""
LEANS = re.compile(r"\A(its|their|the same)\b|\b(there|they)\b|[,:;]\Z|\b(or|and)\Z")
"""Words that mean something told before, and ends of what was cut off: answers are asked for alone, too."""
FORMULA = re.compile(r"[^\u0000-\u024f–—…−]|[\^_=|<>]")
"""Signs that stand in formulas: fonts of text in a PDF do not have them all."""
PRINTED = {"ch2-ex03", "ch5-ex07"}
"""Problems that print a decomposition of the course and ask for one, which may come out as the same."""


def problem(find, system="{A: [[0, 1], [2, 3]], B: [0, 1], C: [1, 0]}", rest=""):
    return read_problem(Source("file.yaml", f"title: A paper\nsystem: {system}\n{rest}find:\n{find}"), CATALOGUE)


def paper(find, **given):
    return document_of(solve_problem(problem(find, **given)), Presentation("question"))


def given_in(solved, wording):
    """The values that the file gives, as a page prints them."""
    parts = solved.problem.parts
    systems = [part.system for part in parts] + [solved.problem.system]
    values = [value for part in parts for value in part.options.values()]
    values += [getattr(system, name, None) for system in systems for name in ("A", "B", "C", "D", "matrix")]
    written = [system.written for system in systems if isinstance(system, TransferFunction)]
    values += [above / below for above, below in filter(None, written)]
    return {wording.tex(value) for value in values if isinstance(value, sp.MatrixBase | sp.Expr)}


GIVEN = {("transfer_function", "G"), ("lagrangian", "kinetic"), ("lagrangian", "potential")}
"""Answers that may be given: a system is asked for its poles, or for the equations that energies lead to."""


@pytest.mark.parametrize(**by_problem((path for path in PROBLEMS if path.stem not in PRINTED), EXAMPLES[:12]))
def test_no_answer_of_a_problem_stands_on_its_paper(path):
    solved = solution_of(path)
    words = document_of(solved, Presentation("question")).markdown()
    known = given_in(solved, Wording.of(replace(solved.problem.display, decimals_typed=False)))
    known |= given_in(solved, Wording.of(replace(solved.problem.display, decimals_typed=True)))
    systems = {part.id: part.system.kind for part in solved.problem.parts}
    answers = [
        (part.id, each)
        for part in document_of_problem(path).parts
        for each in part.found
        if (systems[part.id], each.name) not in GIVEN
    ]
    assert [
        (name, each.name)
        for name, each in answers
        if len(each.tex) > TELLING and each.tex in words and each.tex not in known
    ] == []


def test_a_method_is_named_where_the_file_names_it():
    named = paper("  a: {task: pole_placement, poles: [-1, -2], method: ackermann}\n").parts[0]
    assert (named.method_title, named.source != "") == ("Ackermann's formula", True)
    for find in ("  a: {task: pole_placement, poles: [-1, -2]}\n", "  a: stability\n", "  a: controllability\n"):
        part = paper(find).parts[0]
        assert (part.method_title, part.source) == ("", "")
        assert "matrix" not in part.question


@pytest.mark.parametrize(
    ("task", "method", "words"),
    [
        ("controllability", "rank", "controllability matrix"),
        ("observability", "rank", "observability matrix"),
        ("routh_hurwitz", "array", "Routh array"),
        ("routh_hurwitz", "hurwitz_determinants", "Hurwitz's determinants"),
    ],
)
def test_a_question_says_by_what_to_decide_where_the_file_says_it(task, method, words):
    given = {"system": "{polynomial: s^3 + 2s^2 + 3s + 1}"} if task == "routh_hurwitz" else {}
    assert words in paper(f"  a: {{task: {task}, method: {method}}}\n", **given).parts[0].question
    assert words not in paper(f"  a: {task}\n", **given).parts[0].question


@pytest.mark.parametrize(("task", "option"), [
    (name, option)
    for name in CATALOGUE
    for option, declared in CATALOGUE[name].options.items()
    if declared.kind.referable
])  # fmt: skip
def test_what_is_taken_from_an_earlier_part_is_named_and_not_shown(task, option):
    part = read_problem(Source("file.yaml", new_problem(CATALOGUE[task])), CATALOGUE).parts[-1]
    instead = {"gain": "poles", "observer_gain": "observer_poles"} if task == "observer_feedback" else {}
    kept = {name: value for name, value in part.options.items() if name != instead.get(option)}
    asked = replace(part, options={**kept, option: Reference("b7", "K")})
    question = Wording().question(asked, loops=loops(CATALOGUE[task], asked))
    assert "part (b7)" in question
    assert "Reference" not in question


def test_titles_tell_parts_of_one_task_apart():
    forms = {
        "controllable": "Controllable canonical form",
        "observable": "Observable canonical form",
        "diagonal": "Diagonal form",
        "jordan": "Jordan form",
        "modal": "Modal form",
    }
    find = "".join(f"  {form}: {{task: realization, form: {form}}}\n" for form in forms)
    document = paper(find, system="{transfer_function: 1/((s+1)(s+2))}")
    assert [part.title for part in document.parts] == list(forms.values())


def test_titles_say_what_moves_a_system_and_whether_its_loop_is_closed():
    find = """\
  a: {task: response, kind: zero_input, initial_state: [1, 0]}
  b: {task: response, input: 1}
  c: {task: stability, gain: [4, 5]}
"""
    assert [part.title for part in paper(find).parts] == [
        "Zero-input response",
        "Response",
        "Stability of the closed loop",
    ]


@pytest.mark.parametrize(
    ("keys", "printed"),
    [
        ("a b c", "a b c"),
        ("1 2 10", "1 2 10"),
        ("a-1 a-2 2.b x1 1a iii", "a-1 a-2 2.b x1 1a iii"),
        ("tf Mp ess Mp_full", "a b c d"),
        ("a c d d-part x1", "a c d d-i x1"),
        ("2a-electrical 2a-mechanical 2b 3-C 3-ess", "2a-i 2a-ii 2b 3-C 3-i"),
        ("a-i a-first over-all", "a-i a-ii b"),
        ("a b whole", "a b c"),
        ("y z poles", "y z a"),
        ("eig d", "a d"),
        ("(a) (b) c.", "a b c"),
        ("a (a) b", "a c b"),
        ("eigen a a1", "b a a1"),
        ("2f 2f-full 3-C part-full", "2f 2f-i 3-C a"),
    ],
)
def test_parts_are_named_in_print_by_letters_and_numbers_never_by_words_of_the_file(keys, printed):
    assert list(labels_of(keys.split()).values()) == printed.split()


def test_every_part_has_a_name_of_its_own():
    many = [f"word{i}" for i in range(40)]
    assert len(set(labels_of(many).values())) == len(many)


@pytest.mark.parametrize("format_", ["html", "latex", "md", "text"])
def test_the_keys_of_a_file_are_not_shown(format_):
    find = "  gain: {task: pole_placement, poles: [-1, -2]}\n  loop: {task: stability, gain: {from: gain}}\n"
    document = paper(find)
    text = document.rendered(format_).decode()
    assert "(gain)" not in text
    assert "(loop)" not in text
    assert "found in part (a)" in document.parts[1].question
    assert [part.id for part in document.parts] == ["gain", "loop"]


@pytest.mark.parametrize("name", CATALOGUE)
def test_what_each_answer_is_can_be_asked_for_alone(name):
    for answer in CATALOGUE[name].answers.values():
        asked = answer.doc.split(" (")[0]  # as the macro `asked` has it
        assert not LEANS.search(asked), asked
        assert not FORMULA.search(re.sub(r"\$[^$]*\$|`[^`]*`", "", asked)), asked
        assert (asked.count("("), asked.count("$") % 2) == (asked.count(")"), 0), asked
