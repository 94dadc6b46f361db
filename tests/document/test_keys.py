"""A key has for each answer that earns marks the lines that earn it, once, and is short."""

import re

import pytest
import sympy as sp

from solver.derivation import AnswerName, Status
from solver.document.keys import key_of
from solver.document.model import Presentation
from solver.document.works import document_of
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.render.wording import Wording
from solver.resources import root
from solver.tasks import catalogue
from tests.helpers.solved import EXAMPLES, PROBLEMS, by_problem, solution_of, told_of_problem

CATALOGUE = catalogue()
PAGE = 75
"""Lines of text on a page of a printed key."""

READ_OFF = 5
"""Steps of a part whose answer needs no working: it is given, read off a table, or the one equation scaled."""


def problem(find, system="{A: [[0, 1], [2, 3]], B: [0, 1], C: [1, 0]}"):
    return read_problem(Source("file.yaml", f"title: A key\nsystem: {system}\nfind:\n{find}"), CATALOGUE)


def key(find, *system):
    return document_of(solve_problem(problem(find, *system)), Presentation("key"))


def told(part):
    return "\n".join([*(step.markdown for step in part.steps), *(each.shown for each in part.answers)])


@pytest.mark.parametrize(**by_problem(PROBLEMS, EXAMPLES[:12]))
def test_each_part_of_a_key_has_lines_that_earn_its_marks_on_at_most_a_page(path):
    solved = solution_of(path)
    document = told_of_problem(path, Presentation("key"))
    for part, result in zip(document.parts, solved.parts, strict=True):
        if part.status is not Status.VERIFIED:
            continue
        led_to = part.steps or part.equations or any(each.derived for each in part.answers)
        assert led_to or len(result.steps) <= READ_OFF, part.id
        titles = [step.title for step in part.steps]
        assert not {"Response of the closed loop", "From input to output"} & set(titles)
        displays = re.findall(r"\$\$\n(.+?)\n\$\$", told(part), re.DOTALL)
        assert len(set(displays)) == len(displays), "a line is told twice"
        assert sum(len(step.markdown.splitlines()) for step in part.steps) <= PAGE


@pytest.mark.parametrize(
    ("find", "lines"),
    [
        ("{task: pole_placement, poles: [-1, -2]}", [r"\hat{p}(s) = ", "det(sI - A + BK_f)", "k_1 - 2 = 2"]),
        ("{task: pole_placement, poles: [-1, -2], method: ackermann}", [r"K_f = q\,\hat{p}(A) = "]),
        ("{task: stability}", [r"\lambda_{1} = "]),
        ("{task: stability, method: lyapunov}", ["P = "]),
        ("{task: controllability}", [r"\mathcal{C}_o = ", r"\det \mathcal{C}_o", r"\operatorname{rank}"]),
        ("{task: controllability, system: {A: [[1, 0], [0, 2]], B: [0, 1]}}", [r"\lambda = 1"]),
        ("{task: controllability, method: pbh}", ["The rank is $2 = n$"]),
        ("{task: lqr, Q: [[1, 0], [0, 1]], R: 1}", [r"p_{12}", "P = ", "K_f = R^{-1}B^{T}P = "]),
        ("{task: observer, poles: [-4, -5]}", [r"det(sI - A + L_cC)", "l_1"]),
        ("{task: state_transition_matrix, method: laplace}", ["(sI - A)^{-1} = ", r"\mathcal{L}^{-1}"]),
        ("{task: transfer_function}", [r"C\operatorname{adj}(sI - A)\,B = 1", r"G = \frac{1}{s^{2} - 3s - 2}", "p = "]),
        ("{task: observer_feedback, poles: [-1, -2], observer_poles: [-4, -5]}", [r"\lambda = -1,\; -2,\; -4,\; -5"]),
        ("{task: eigenstructure}", ["M = ", "J = "]),
        (
            "{task: step_specifications, system: {transfer_function: 4/(s^2 + 2s + 4)}}",
            [r"\omega_{n} = 2", r"\xi = \frac{1}{2}"],
        ),
        (
            "{task: minimum_energy_control, method: gramian, initial_state: [1, 0], final_time: 1, "
            "system: {A: [[0, 1], [0, 0]], B: [0, 1]}}",
            ["W = ", "d = ", r"\eta = "],
        ),
        (
            "{task: routh_hurwitz, system: {polynomial: s^4 + s^3 + 3s^2 + 2s + 2}}",
            ["a(s) = s^{2} + 2", "2 on the imaginary axis"],
        ),
        (
            "{task: routh_hurwitz, answers: [condition], system: {polynomial: s^3 + 2s^2 + 3s + K}}",
            ["3 - \\frac{1}{2}K", "K < 6"],
        ),
        (
            "{task: jury, answers: [stable], system: {time: discrete, polynomial: z^3 + z^2/2 - z/4 + 1/8}}",
            [r"-\frac{63}{64}", r"|b_{0}| = \frac{63}{64} > \frac{5}{16}"],
        ),
        ("{task: response, kind: zero_input, initial_state: [1, 0]}", ["X_{\\text{zi}}(s)", "y(t) = Cx = "]),
        (
            "{task: nyquist, system: {transfer_function: 2(s + 3)/(s(s - 1))}}",
            [r"With $w = \omega^{2}$:", "w - 3 = 0", "downward, $-2$ with its mirror image", "Together $N = -1$"],
        ),
        (
            "{task: stability_margins, system: {transfer_function: 10/(s(s + 1)(s + 5))}}",
            [r"With $w = \omega^{2}$:", "w^{3} + "],
        ),
        (
            "{task: lead_compensator, velocity_constant: 20, phase_margin: 50, "
            "system: {transfer_function: 4/(s(s + 2))}}",
            [r"\mathrm{PM}_0 = 180 + \varphi_0 = 17.964"],
        ),
    ],
)
def test_the_lines_that_earn_marks_are_those_an_instructor_looks_for(find, lines):
    part = key(f"  a: {find}\n").parts[0]
    for line in lines:
        assert line in told(part)


def test_a_line_that_ends_in_the_answer_is_the_answers_and_no_line_of_a_step():
    part = key("  a: {task: pole_placement, poles: [-1, -2], method: ackermann, marks: 4}\n").parts[0]
    gain = part.answers[0]
    assert gain.marks == "4"
    assert gain.derived.startswith("K_f = ")
    assert gain.derived.endswith(gain.tex)
    assert not any(gain.derived in step.markdown for step in part.steps)


def test_a_verdict_is_not_taken_for_a_number():
    """Not controllable is False, which Python holds for 0: the determinant is no finding of it."""
    part = key("  a: {task: controllability, method: pbh}\n", "{A: [[1, 0], [0, 2]], B: [0, 1]}").parts[0]
    assert [each.derived for each in part.answers] == [""]
    assert all("agree" not in step.title for step in part.steps)


def test_an_entry_of_a_matrix_is_told_in_the_matrix():
    pendulum = "{equations: [\"theta'' + sin(theta) + theta' = u\"], inputs: [u]}"
    part = key("  a: {task: linearization, at: {theta: 0, u: 0}}\n", pendulum).parts[0]
    lines = "\n".join(step.markdown for step in part.steps)
    assert r"\frac{\partial f_{2}}{\partial\theta}" in lines
    assert "a_{21} = " not in lines
    assert r"\begin{bmatrix}0 & 1 \\ -1 & -1\end{bmatrix}" in told(part)


def test_where_no_step_earns_anything_the_last_is_told():
    result = solve_problem(problem("  a: {task: stability}\n")).parts[0]
    wording = Wording(detail="brief")
    worded = wording.words(result.steps)
    shown = key_of(worded, {"other": sp.Integer(1234)}, {"other": AnswerName("other", "o", "another")}, wording)
    assert [step.title for step in shown.steps] == [worded[-1].title]
    assert not shown.derived


def macros_of(name):
    """The kinds of steps that are worded, of a task or of a lemma."""
    files = [*(root("templates") / "wording" / name).glob("*.jinja")]
    files += (root("templates") / "wording" / "lemmas").rglob("*.jinja")
    return set(re.findall(r"macro (\w+)\(v, c\)", "\n".join(file.read_text(encoding="utf-8") for file in files)))


@pytest.mark.parametrize("task", CATALOGUE)
def test_the_steps_that_earn_marks_exist(task):
    earned = {kind for answer in CATALOGUE[task].answers.values() for kind in answer.earned}
    others = set().union(*(macros_of(each) for each in ("controllability", "observability")))
    assert earned <= macros_of(task) | others


@pytest.mark.parametrize("task", CATALOGUE)
def test_no_principal_answer_is_without_a_step_that_earns_it_or_a_formula(task):
    assert any(CATALOGUE[task].answers[name].earned for name in CATALOGUE[task].principal)


def test_marks_stand_beside_the_answers_in_every_format():
    document = key("  a: {task: pole_placement, poles: [-1, -2], marks: {K: 3, closed_loop_A: 1.5}}\n")
    for format_ in ("html", "latex", "md"):
        text = document.rendered(format_).decode()
        assert "3 marks" in text
        assert "1.5 marks" in text
    assert sp.Rational(9, 2) == sp.Rational(document.parts[0].marks)
