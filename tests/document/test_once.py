"""What stands above on a page is referred to, and nothing is lost: references lead to what is told in full."""

import json
import re
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from solver.derivation import Check, CheckStatus, Status
from solver.derivation.figures import Diagram
from solver.document.model import Document, Presentation, Reference, Work, WorkAnswer, WorkStep, step_anchor
from solver.document.once import told_once
from solver.messages import Messages
from solver.render.latex_document import latex_document
from solver.render.markdown import markdown_of
from solver.render.page import render_page
from solver.render.pointing import referring
from solver.render.terminal import text_document
from solver.render.typst_document import typst_document

REASON = "The matrix is formed as the definition says, row by row, and every entry is found from the one before it."
INTRODUCED = "It is multiplied out and sorted by powers of the variable:"


def display(formula):
    return f"$$\n{formula}\n$$"


def step(name, *blocks, number=0, **more):
    text = "\n\n".join(blocks or (f"{REASON} It is {name}.", display(f"{name} = 1"), display(f"{name} + 1 = 2")))
    return WorkStep(name, f"Title of {name}", text, covers=(number,) if number else (), **more)


def work(name, *steps, method="one", again=False, answers=(), checks=()):
    numbered = tuple(replace(each, covers=(number,)) for number, each in enumerate(steps, 1))
    return Work(
        id=name, task="t", method=method, title=f"Task {name}", method_title=f"Way {method}", source="", marks="",
        question="?", given="", again=again, steps=numbered, answers=tuple(answers), rows=(), status=Status.VERIFIED,
        reason="", checks=tuple(checks),
    )  # fmt: skip


def answer(symbol, value, *, asked=True):
    equation = f"{symbol} = {value}"
    return WorkAnswer(symbol, symbol, value, "the answer", value, equation, equation, asked=asked)


def once(*works):
    return told_once(works, Messages().say)


def in_full(works):
    """The steps that are shown in full, by the names for links to them."""
    return {
        step_anchor(each.anchor, number): one
        for each in works
        for number, one in enumerate(each.steps, 1)
        if not one.refers
    }


LETTERS = st.lists(st.sampled_from("abcdef"), min_size=1, max_size=7)


@given(st.lists(LETTERS, min_size=1, max_size=5))
def test_no_step_is_lost_and_references_lead_to_steps_in_full(pages):
    works = tuple(work(f"p{i}", *map(step, names)) for i, names in enumerate(pages))
    shown = once(*works)
    full = in_full(shown)
    for before, after in zip(works, shown, strict=True):
        assert sorted(n for one in after.steps for n in one.covers) == list(range(1, len(before.steps) + 1))
        for one in after.steps:
            told = [before.steps[number - 1].kind for number in one.covers]
            targets = [step_anchor(there.part, n) for there in one.refers for n in there.numbers]
            assert set(targets) <= set(full)
            if one.refers:
                assert {full[target].kind for target in targets} == set(told)
                first, last = (before.steps[one.covers[i] - 1].title for i in (0, -1))
                assert one.title == (first if first == last else f"{first} … {last}")
            else:
                assert told == [one.kind]
    assert shown == once(*works)
    assert {one.kind for one in full.values()} == {name for names in pages for name in names}


@given(st.lists(LETTERS, min_size=1, max_size=4))
def test_what_is_told_once_is_not_told_twice(pages):
    works = tuple(work(f"p{i}", *map(step, names)) for i, names in enumerate(pages))
    kinds = [one.kind for one in in_full(once(*works)).values()]
    assert len(kinds) == len(set(kinds))


def test_a_run_of_steps_becomes_one_that_goes_on_with_its_last_results():
    first, second = once(work("a", *map(step, "abc")), work("b", *map(step, "abcd")))
    assert [one.refers for one in first.steps] == [(), (), ()]
    referring, last = second.steps
    assert referring.title == "Title of a … Title of c"
    assert referring.markdown == "\n\n".join((display("c = 1"), display("c + 1 = 2")))
    assert [(there.numbers, there.place) for there in referring.refers] == [((1, 2, 3), "(a), steps 1–3")]
    assert last.title == "Title of d"


def test_of_many_results_none_is_shown_alone():
    entries = " & ".join("1234567890" * 3)
    many = step("m", REASON, *(display(f"{name} = [{entries}]") for name in "JNM"))
    one, two = once(work("a", many), work("b", many, step("z")))
    assert one.steps[0].markdown.count("$$") == 6
    assert two.steps[0].markdown == ""


def test_a_result_is_shown_without_what_leads_to_it():
    found = step(
        "f", REASON, display(r"\det(sI - A) = \det\begin{bmatrix}s & 1 \\ 0 & s\end{bmatrix} = s \cdot s = s^{2}")
    )
    _, second = once(work("a", found, step("y")), work("b", found, step("z")))
    assert second.steps[0].markdown == display(r"\det(sI - A) = s^{2}")


def test_a_step_refers_to_a_place_once():
    long = f"{INTRODUCED[:-1]}, and so on, until all that is known of the matrix stands below each other:"

    def parted(i):
        blocks = (long, display("A = 1"), display(f"B = {i}"), f"Then {long}", display("C = 1"), display(f"D = {i}"))
        return step("x", *blocks)

    _, second = once(work("a", parted(1)), work("b", parted(2)))
    shown = ["As in [(a), step 1](#part-a-one-step-1):", *map(display, ("A = 1", "B = 2", "C = 1", "D = 2"))]
    assert second.steps[0].markdown == "\n\n".join(shown)


def test_a_result_that_the_next_step_shows_is_not_shown_before():
    matrix = r"\begin{bmatrix}s + 1 & 2 \\ 3 & s - 4\end{bmatrix}"
    found, following = step("b", REASON, display(f"R = {matrix}")), step("d", "So", display(f"x = {matrix}v"))
    _, second = once(work("a", step("a"), found), work("b", step("a"), found, following))
    assert second.steps[0].markdown == ""


def test_a_law_in_the_text_is_no_result_to_go_on_with():
    told = step("x", REASON, display("B = 1"), f"{INTRODUCED}\n$$b = x + y$$\nIt holds for every choice of the gain.")
    _, second = once(work("a", told, step("y")), work("b", told, step("z")))
    assert second.steps[0].markdown == display("B = 1")


def test_methods_share_their_preamble_by_the_name_of_the_method():
    _, second = once(work("a", *map(step, "ab")), work("a", *map(step, "abc"), method="two", again=True))
    assert second.steps[0].refers[0].place == "“Way one”, steps 1–2"


def test_where_another_part_is_named_the_part_itself_is_too():
    first, other = work("a", step("x")), work("b", *map(step, "pq"))
    *_, last = once(first, other, work("b", *map(step, "xpqr"), method="two", again=True))
    assert [each.place for each in last.steps[0].refers] == ["(a), step 1", "(b), “Way one”, steps 1–2"]


def test_an_explanation_is_left_out_but_a_conclusion_and_a_short_introduction_stay():
    texts = [(REASON, display(f"x = {i}"), "So", display("y = 1"), "It is not zero, so that the pair is controllable.")
             for i in (1, 2)]  # fmt: skip
    _, second = once(*(work(name, step("x", *blocks)) for name, blocks in zip("ab", texts, strict=True)))
    assert second.steps[0].markdown == "\n\n".join(texts[1][1:])


def test_under_its_title_an_introduction_is_not_told_again_and_elsewhere_it_is():
    texts = [(INTRODUCED, display(f"x = {i}"), INTRODUCED, display(f"y = {i}")) for i in (1, 2)]
    first, second = once(*(work(name, step("x", *blocks)) for name, blocks in zip("ab", texts, strict=True)))
    assert first.steps[0].markdown.count(INTRODUCED) == 2
    assert second.steps[0].markdown == "\n\n".join(texts[1][1:])


def test_lists_stay_and_steps_of_another_kind_tell_their_own():
    listed = f"- {REASON}"
    kept = (listed, display("x = 1"))
    _, second = once(work("a", step("x", *kept, display("z = 1"))), work("b", step("x", *kept, display("z = 2"))))
    assert listed in second.steps[0].markdown or second.steps[0].markdown.startswith("As in [(a), step 1]")
    _, other = once(work("a", step("x", REASON, display("x = 1"))), work("b", step("y", REASON, display("x = 2"))))
    assert REASON in other.steps[0].markdown


def test_a_figure_and_a_substep_stand_once():
    figure = Diagram("The loop", "state_feedback")
    below = step("below")
    works = [work(name, step(name, steps=(below,), figures=(figure,))) for name in "ab"]
    first, second = once(*works)
    assert first.steps[0].figures == (figure,)
    assert second.steps[0].figures == ()
    assert [there.place for there in second.steps[0].pictured] == ["(a), step 1"]
    assert first.steps[0].steps[0].markdown == below.markdown
    assert [there.place for there in second.steps[0].steps[0].refers] == ["(a), step 1.1"]


def test_a_reference_names_the_substep_and_formats_number_it():
    inner = step("inner")
    steps = [step(name, steps=(step(f"first {name}"), step(f"outer {name}", steps=(inner,)))) for name in "ab"]
    shown = once(work("a", step("x"), steps[0]), work("b", steps[1]))
    (there,) = shown[1].steps[0].steps[1].steps[0].refers
    assert (there.place, there.anchor) == ("(a), step 2.2.1", "part-a-one-step-2")
    page = Document("T", "", "", "", shown, Presentation())
    for write in (markdown_of, latex_document, typst_document, text_document):
        assert re.search(r"2\.2\.1\W+(enspace )?(h\(0\.5em\)#\W)?Title of inner", write(page)), write
    assert '<span class="number">2.2.1</span> Title of inner' in render_page(page)


def test_a_run_goes_on_with_the_results_of_all_its_steps_of_the_last_kind():
    pairs = [replace(step(f"root{i}", REASON, display(f"x_{i} = {i}")), kind="root") for i in (1, 2)]
    _, second = once(work("a", step("p"), *pairs, step("y")), work("b", step("p"), *pairs, step("z")))
    assert second.steps[0].markdown == "\n\n".join((display("x_1 = 1"), display("x_2 = 2")))


def test_what_was_found_on_the_way_is_pointed_at_and_what_is_asked_is_boxed():
    asked, other, unseen = answer("K", "5"), answer("p", "7", asked=False), answer("q", "8", asked=False)
    part = work("a", step("x", display("p(s) = 3 + 4 = 7"), "So", display("K = 5")), answers=(asked, other, unseen))
    (shown,) = once(part)
    assert [each.name for each in shown.boxed] == ["K", "q"]
    assert [(there.numbers, [each.name for each in found]) for there, found in shown.noted] == [((1,), ["p"])]


def test_what_a_step_tells_with_lines_between_blocks_or_in_its_own_form_is_pointed_at():
    parted = r"T = \left[\begin{array}{c|cc}1 & 0 & 0 \\ \hline 0 & 1 & 0\end{array}\right]"
    whole = answer("T", r"\begin{bmatrix}1 & 0 & 0 \\ 0 & 1 & 0\end{bmatrix}", asked=False)
    listed = replace(answer("roots", "1, 2", asked=False), told=("best", "listed"))
    steps = [step("T", display(parted)), step("listed", display("s = 1")), step("U", display("U = T"))]
    (shown,) = once(work("a", *steps, answers=(answer("U", "T"), whole, listed)))
    assert [there.numbers for there, _ in shown.noted] == [(1,), (2,)]
    assert [each.name for each in shown.boxed] == ["U"]


def test_a_method_that_finds_the_same_says_so_and_one_that_does_not_shows_what_it_finds():
    def by(method, value, **more):
        return work("a", step(method, display(f"K = {value}")), method=method, answers=[answer("K", value)], **more)

    _, same, different = once(by("one", "5"), by("two", "5", again=True), by("three", "6", again=True))
    assert same.same is not None
    assert (same.same.place, same.same.anchor, same.boxed) == ("“Way one”", "part-a-one", ())
    assert different.same is None
    assert [each.value for each in different.boxed] == ["6"]


def test_checks_cite_the_steps_that_the_page_shows():
    checks = [Check("c", "o", 1e-16, 1e-9, CheckStatus.PASSED, step=number) for number in (1, 2, 2, 3, 3)]
    _, second = once(work("a", *map(step, "ab")), work("b", *map(step, "abc"), checks=checks))
    assert [row.claim for row in second.rows] == ["3 equalities of step 1", "2 equalities of step 2"]


@pytest.fixture(scope="module")
def document():
    figure = Diagram("The loop", "state_feedback")
    check = Check("c", "numpy", 1e-16, 1e-9, CheckStatus.PASSED, step=1)
    parts = (
        work("a", *map(step, "ab"), step("f", REASON, display("K = 5"), figures=(figure,)), answers=[answer("K", "5")]),
        work("b", *map(step, "abc"), answers=[answer("K", "5"), answer("c", "1", asked=False)], checks=[check]),
        work("b", step("g", display("K = 5"), figures=(figure,)), method="two", again=True, answers=[answer("K", "5")]),
    )
    return Document("T", "", "", "", parts, Presentation(checks="table"))


@pytest.mark.parametrize("write", [render_page, latex_document, markdown_of, text_document])
def test_every_format_refers(document, write):
    text = " ".join(write(document).split())
    for words in ("As in", "(a), steps 1–2", "Found on the way:", "The figure is that of", "The same as by"):
        assert words in text or words.replace("“", "``").replace("–", "--") in text, words
    assert text.index("Checks") >= 0


def test_links_lead_to_places_of_the_page(document):
    page, latex = render_page(document), latex_document(document)
    assert 'href="#part-a-one-step-1"' in page
    assert page.count('id="part-a-one-step-1"') == 1
    assert r"\hyperlink{part-a-one-step-1}{" in latex
    assert r"\target{part-a-one-step-1}" in latex


def test_json_has_every_step_in_full(document):
    data = json.loads(replace(document, presentation=Presentation(data=True)).json())
    assert [len(part["steps"]) for part in data["parts"]] == [3, 3, 1]
    assert data["parts"][1]["steps"][0]["text"] == step("a").markdown


def test_a_key_is_not_told_by_references(document):
    assert replace(document, presentation=Presentation("key")).shown == document.parts


def test_a_step_does_not_refer_to_itself_and_row_operations_say_again_what_is_done():
    lead = "The equation above with the value that was found put into it:"
    _, twice = once(work("a", step("a")), work("b", step("x", "Case", lead, display("y = 1"), lead, display("y = 1"))))
    assert "As in" not in twice.steps[0].markdown
    done = r"Pivot in row 1, column 1. With $R_{1} \leftarrow -R_{1}$ and $R_{3} \leftarrow R_{3} + 2R_{1}$:"
    texts = [(display(f"M = {i}"), done, display(f"N = {i}")) for i in (1, 2)]
    _, second = once(*(work(name, step("x", *blocks)) for name, blocks in zip("ab", texts, strict=True)))
    assert done in second.steps[0].markdown


def test_what_was_not_asked_for_is_left_out_where_another_part_has_told_it():
    told, asked = answer("p", "-1", asked=False), answer("z", "-2")
    _, second = once(work("a", step("x"), answers=(told,)), work("b", step("y"), answers=(told, asked)))
    assert [each.name for each in second.boxed] == ["z"]
    assert second.noted == ()
    other = replace(work("c", step("z"), answers=(told, asked)), given="of another system")
    assert [each.name for each in once(work("a", step("x"), answers=(told,)), other)[1].boxed] == ["p", "z"]


def test_a_method_with_one_of_the_answers_in_its_steps_has_the_others_in_the_box_above():
    answers = [answer("K", "5"), answer("u", "-5x")]
    one, two = work("a", step("x", display("K = 5")), answers=answers), step("y", display("K = 5"))
    assert once(one, work("a", two, method="two", again=True, answers=answers))[1].same is not None
    unseen = work("a", step("y"), method="two", again=True, answers=answers)
    assert [each.name for each in once(one, unseen)[1].boxed] == ["K", "u"]


def test_a_long_remark_at_the_end_is_told_once_and_a_conclusion_each_time():
    remark = f"{REASON} {REASON}"
    texts = [(display(f"x = {i}"), "So it is zero, and that is the end of it, as was to be shown here.", remark)
             for i in (1, 2)]  # fmt: skip
    first, second = once(*(work(name, step("x", *blocks)) for name, blocks in zip("ab", texts, strict=True)))
    assert first.steps[0].markdown.endswith(remark)
    assert second.steps[0].markdown == "\n\n".join(texts[1][:2])


def test_results_that_are_needed_stay_without_the_explanation_that_stands_above():
    text = (REASON, display("x = 1"), display("y = 2"))
    _, second = once(*(work(name, step("x", *text, display(f"z = {name}"))) for name in "ab"))
    assert REASON not in second.steps[0].markdown
    assert display("y = 2") in second.steps[0].markdown


def test_references_in_a_text_are_links_where_the_page_has_targets():
    text = ("The long introduction of some steps which are all alike but for their ends:", display("x = 1"))
    parts = [work(name, step("x", REASON, *text, display(f"z = {name}"))) for name in "ab"]
    told = Document("T", "", "", "", tuple(parts))
    assert '<a href="#part-a-one-step-1">(a), step 1</a>:' in render_page(told)
    assert "As in (a), step 1:" in markdown_of(told)
    assert "#part-a" not in text_document(told)


def test_two_places_are_joined_by_and():
    refers = (Reference("p", (1,), "(a), step 1"), Reference("q", (2,), "(b), step 2"))
    referred = WorkStep("x", "X", "", refers=refers)
    assert referring(referred, Messages().say) == "As in (a), step 1, and (b), step 2."
    assert referring(replace(referred, refers=refers[:1]), Messages().say) == "As in (a), step 1."


@pytest.mark.parametrize("chain", [r"\operatorname{rank} C = 2 < 3 = n", r"x = 1 \ne 2 = y", r"a = b,\qquad c = d = e"])
def test_what_compares_is_not_cut_to_its_ends(chain):
    """From rank = 2 < 3 = n nobody may conclude that the rank is n."""
    told = step("x", REASON, display(chain))
    _, second = once(work("a", told, step("y")), work("b", told, step("z")))
    assert second.steps[0].markdown == display(chain)


def test_a_case_is_called_one():
    part, other = work("a", step("x")), replace(work("a", step("x"), step("z")), case="c = 0")
    third = replace(work("a", step("z")), case="c = 1")
    *_, last = once(part, other, third)
    assert [each.place for each in last.steps[0].refers] == ["the case `c = 0`, step 2"]
