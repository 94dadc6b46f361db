"""What a question says and what its fields look like, which must not tell what is right."""

import pytest

from solver.document.model import Presentation
from solver.papers.exam.telling import Asked as Wanted
from solver.papers.export import fields as exported
from solver.papers.export.items import items_made
from solver.papers.export.quiz import Group, Quiz
from solver.papers.export.summary import told
from tests.papers.banks.making import items_of
from tests.papers.banks.test_fields import GAIN, SPECTRUM, laid_out, only


def test_the_fields_do_not_tell_whether_eigenvalues_are_complex():
    real, both = (only("title: t\n" + SPECTRUM % A) for A in ("[[3, 0], [0, -1]]", "[[0, 1], [-5, -2]]"))
    assert real.form == both.form
    assert [each.label for each in real.fields] == [each.label for each in both.fields]
    assert len({each.label for each in both.fields}) == 4


@pytest.mark.parametrize("B", ["[0, 1]", "[1, -1]"])
def test_a_list_whose_length_is_asked_for_is_an_essay_if_it_is_empty_or_not(B):
    find = "{task: controllability, answers: [controllable, uncontrollable_modes]}"
    items = items_of(f"title: t\nsystem: {{A: [[0, 1], [-2, -3]], B: {B}}}\nfind: {{a: {find}}}\n")
    assert items["a rest"].essay.reasons == {"uncontrollable_modes": exported.HOW_MANY}


def test_answers_with_the_same_reason_are_named_together():
    text = 'title: t\nsystem: {transfer_function: "6/(s(s+1)(s+2))"}\nfind: {a: {task: root_locus}}\n'
    essays = tuple(each for each in items_of(text).values() if each.essay)
    (line,) = told(Quiz("x", "", "en", (Group(("x", "t", "(a) Locus"), essays * 2),)))
    assert line.startswith("essay: t, (a) Locus: real_axis_segments, imaginary_axis_crossings: several values are")
    assert "; breakaway_points, breakaway_gains, " in line
    assert line.count(exported.HOW_MANY) == 1


def test_what_may_be_infinite_is_a_number_in_any_case():
    found = []
    for loop in ("1/(s+1)", "6/(s(s+1)(s+2))", "1/(s+1)^3"):
        text = f'title: t\nsystem: {{transfer_function: "{loop}"}}\nfind: {{a: {{task: stability_margins}}}}\n'
        found.append({each.name: each for each in items_of(text)["a"].answers})
    infinite, finite, mixed = found
    assert {str(field.value) for name in ("gain_margin", "phase_margin") for field in infinite[name].fields} == {
        "999999"
    }
    assert "Infinity is written as 999999" in finite["gain_margin"].form
    for name, asked in infinite.items():
        assert asked.form == finite[name].form == mixed[name].form
        kinds = [[type(each) for each in of[name].fields] for of in found]
        assert kinds[0] == kinds[1] == kinds[2]


def test_fields_of_one_answer_have_names_of_their_own():
    text = """\
title: t
system: {A: [[0, 1], [-8, -6]], B: [0, 3], C: [2, 1]}
find: {a: {task: transfer_function, answers: [G]}, b: {task: desired_poles, overshoot: 10%, settling_time: 4}}
"""
    items = items_of(text)
    assert [each.label for each in items["a"].fields] == [
        "G, numerator, coefficient of s^0",
        "G, denominator, coefficient of s^0",
    ]
    assert laid_out(items["b"].answers[0])[0].startswith("s_{1} = ")


def test_what_is_asked_is_told_where_the_question_asks_for_more():
    text = """\
title: t
system: {A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0]}
find: {a: stability, b: {task: eigenstructure}}
"""
    items = items_of(text)
    asked = "\n".join(block.markdown for block in items["a"].question.blocks)
    assert "whether it is BIBO stable" in asked
    assert r"Here only this is asked: $\text{verdict}$ (the free motion)." in asked
    assert items["b rest"].question.blocks[-1].markdown == "Say of each vector to which eigenvalue it belongs."


def test_letters_are_not_told_of_where_there_are_none():
    assert items_of(GAIN)["a"].answers[0].meaning == "the gain of the feedback"


def test_a_part_without_a_solution_is_left_out_and_told():
    text = """\
title: t
system: {transfer_function: "1/(s+1)"}
find: {a: {task: stability}, b: {task: second_order_parameters}}
"""
    made = items_made(text, "problem.yaml", Wanted((), Presentation("full")))
    assert not made.fault
    assert [(letter, len(items)) for letter, _, items in made.parts] == [("a", 1), ("b", 0)]
    assert len(made.left_out) == 1
    assert made.left_out[0].startswith("part b: ")
    none = items_made(text.replace("a: {task: stability}, ", ""), "p.yaml", Wanted((), Presentation("full")))
    assert ([items for _, _, items in none.parts], none.fault) == ([()], "")
    assert none.left_out[0].startswith("part b: ")
