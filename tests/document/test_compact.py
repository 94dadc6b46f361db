"""A key is compact: equations beside each other, each once, and no part longer than a printed page."""

import re

import pytest

from solver.document.compact import compact
from solver.document.model import Presentation, WorkAnswer
from solver.formula import latex, read
from solver.render.pdf import pdf_by_typst
from solver.render.side_by_side import equations_in, side_by_side
from solver.render.typst_document import files_beside, typst_document
from tests.helpers.sample_pages import part, worded
from tests.helpers.solved import EXAMPLES, PROBLEMS, by_problem, told_of_problem

NAMED = {"root-locus", "analog-programs", "acrobot", "jordan-blocks"}
"""Problems whose keys were long."""

LONGER = {"smith-form": 1}
"""Pages that a key has more: ten operations, each with its matrix."""

STACK = r"\begin{aligned}a &= 1 \\ b &= \frac{4}{2} &= 2 \\ c &= 3\end{aligned}"
CHAIN = r"\begin{aligned}a &= b + c \\ &= d\end{aligned}"


def key(steps, *equations):
    answers = tuple(WorkAnswer(f"n{i}", "", "", "numbers", "", each) for i, each in enumerate(equations))
    return compact(part("a", "verified", steps=steps, answers=answers))


def shown(formula, room=76.0):
    return [latex(each) for each in side_by_side(*equations_in(read(formula)), room)]


@pytest.mark.parametrize(
    ("formula", "lines"),
    [
        (STACK, [r"a = 1,\qquad b = \frac{4}{2} = 2,\qquad c = 3"]),
        (CHAIN, [latex(read(CHAIN))]),
        (r"a = 1,\; b = 2", [r"a = 1,\; b = 2"]),
        (r"\text{P:}\quad \{a = 1,\; b = 2\}", [r"\text{P:}\quad a = 1,\qquad b = 2"]),
        (r"\text{set:}\quad \{1,\; 2\}", [r"\text{set:}\quad \{1,\; 2\}"]),
        (r"\begin{aligned}&\text{P:} \\ a &= 1 \\ b &= 2\end{aligned}", [r"\text{P:}\quad a = 1,\qquad b = 2"]),
        (
            r"\begin{aligned}a &= 0 &\quad \text{(twice)} \\ b &= 1\end{aligned}",
            [r"a = 0\quad \text{(twice)},\qquad b = 1"],
        ),
    ],
)
def test_equations_under_each_other_come_to_stand_beside_each_other(formula, lines):
    assert shown(formula) == lines


def test_as_many_equations_stand_on_a_line_as_fit():
    (two,) = shown(STACK, 20)
    assert two.count(r"\\") == 1
    assert re.findall("[abc] =", two) == ["a =", "b =", "c ="]


def test_an_equation_of_a_step_that_an_answer_has_is_told_there():
    steps = worded("Numbers", "Read off:\n\n$$\nx = 2\n$$\n\n$$\nz = 5\n$$"), worded("Again", "So:\n\n$$\ny = 3\n$$")
    told = key(steps, r"\begin{aligned}x &= 2 \\ y &= 3\end{aligned}")
    assert [step.markdown for step in told.steps] == ["Read off:\n\n$$\nz = 5\n$$"]


def test_what_leads_to_a_value_of_an_answer_stands_there():
    steps = (worded("Settings", "$$\nP_{1} = \\frac{4}{2} = 2\n$$"),)
    told = key(steps, r"\text{P:}\quad \{P_1 = 2,\; P_2 = 3\}")
    assert told.answers[0].shown == r"\text{P:}\quad P_{1} = \frac{4}{2} = 2,\qquad P_2 = 3"
    assert not told.steps


def test_an_answer_does_not_tell_again_what_one_above_has_told():
    first, second = r"\begin{aligned}x &= 2 \\ y &= 3\end{aligned}", r"\begin{aligned}x &= 2 \\ z &= 4\end{aligned}"
    told = key((), first, second)
    assert [each.shown for each in told.answers] == [r"x = 2,\qquad y = 3", "z = 4"]


def test_short_items_of_a_list_stand_in_a_line():
    told = key((worded("Cases", "- $a$: yes\n\n- $b$: no"), worded("Long", f"- {'long ' * 40}\n\n- $b$")))
    assert [step.markdown for step in told.steps] == ["$a$: yes; $b$: no", f"- {'long ' * 40}\n\n- $b$"]


def test_sentences_of_a_list_stay_sentences_in_a_line():
    told = key((worded("Cases", "- For $K < 1$ none.\n\n- For $K > 1$ one."),))
    assert [step.markdown for step in told.steps] == ["For $K < 1$ none. For $K > 1$ one."]


QUICK = [path for path in EXAMPLES if path.stem in NAMED][:1]


@pytest.mark.parametrize(**by_problem(PROBLEMS, QUICK, of=8))
def test_a_part_of_a_printed_key_is_no_longer_than_a_page(path):
    document = told_of_problem(path, Presentation("key"))
    source = typst_document(document)
    begun = f'#heading(level: 1)[#target("{document.shown[0].anchor}")'
    assert begun in source
    apart = source.replace('#heading(level: 1)[#target("', '#pagebreak()\n#heading(level: 1)[#target("')
    pages = re.findall(rb"/Type\s*/Page\b(?!s)", pdf_by_typst(apart, 60, files_beside(document)))
    assert len(pages) <= len(document.shown) + 1 + LONGER.get(path.stem, 0)
