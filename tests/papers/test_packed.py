"""What is held of a question while many variants are made."""

from dataclasses import replace

from solver.document.model import Presentation
from solver.papers.exam.packed import Packed
from solver.papers.exam.telling import Asked, question_made

TEXT = "system: {A: [[0, 1], [-2, -3]], B: [0, 1]}\nfind: {a: {task: pole_placement, poles: [-4, -5]}, b: stability}\n"


def test_a_packed_question_is_small_and_opens_as_it_was():
    made = question_made(TEXT, "a.yaml", Asked((), Presentation("key")))
    packed = Packed.of(made)
    assert isinstance(packed.content, bytes)
    assert len(packed.content) < 4000
    opened = packed.opened()
    assert (opened.status, opened.sheet, opened.paper) == (made.status, made.sheet, made.paper)
    assert opened.key.rendered("html") == made.key.rendered("html")


def test_what_is_no_plain_data_is_kept_as_it_is():
    made = replace(question_made(TEXT, "a.yaml", Asked((), Presentation("key"))), files={"x": object()})
    assert Packed.of(made).opened() is made
