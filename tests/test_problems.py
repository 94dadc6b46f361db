"""Every problem in problems/ is solved, every check passes, and every format words it at every level of detail."""

import json
import re
from dataclasses import replace
from functools import cache, partial

import pytest
import sympy as sp
from sympy.core.function import AppliedUndef

from solver.derivation import CheckStatus, Status
from solver.document.model import Presentation
from solver.numeric import NoRule
from solver.patches import Program, program_of
from solver.render.data import render_json
from solver.render.latex_document import latex_document
from solver.render.markdown import markdown_of
from solver.render.page import render_page
from solver.render.wording import LEVELS
from solver.symbols import NOTATIONS
from tests.helpers.repeated import repeated
from tests.helpers.shares import WHOLE, in_turn
from tests.helpers.solved import EXAMPLES, PROBLEMS, by_problem, document_of_problem, solution_of, told_of_problem
from tools.corrupted_kernels.samples import covering

CLUMSY = re.compile(
    r"(?<![\d.])\d+\.0(?!\d)|[-+] ?[-+]|(?<![\d._])1 ?\\cdot|\bNone\b|Matrix\(|(?<=[\w)])\*\*(?=[\w(])"
    r"|= (?P<twice>-?[\d.]+) \\approx (?P=twice)(?![\d.])"
)
"""What nobody would write: 1.0, - -2, + -, 1 · x, remains of Python, 0.5 ≈ 0.5."""

FORMULA = re.compile(r"\$\$.*?\$\$|\$.*?\$", re.DOTALL)
SLOVENLY = re.compile(
    r"[a-z]{2}[.:;,!?][A-Z]|\b(?:first|last|the) 1 |\b1 (?:columns|rows|steps|states|equations|unknowns|values|poles)\b"
    r"|\b([a-z]+) \1\b| [.,;:](?=\s|$)"
)
"""Sentences without a blank between them, the first 1 column, a word twice, a blank before a full stop."""

ODD = re.compile(r"\\lambda\\lambda|\\begin\{bmatrix\}[^&\\]*\\end\{bmatrix\}\^\{-1\}")
"""λλ, and the inverse of a matrix of one entry."""


def carelessly_written(markdown):
    """What is slovenly in the words of a step, or odd in its formulas, with what stands around it."""
    for text, kind in ((FORMULA.sub("x", markdown), SLOVENLY), (markdown, ODD)):
        for found in kind.finditer(text):
            yield text[max(0, found.start() - 60) : found.end() + 60]


IMPOSSIBLE = {
    ("appC-final1", "3-infeasible"): "No lead section has this crossover",
    ("appC-final3", "1b"): "There is nothing to drop",
    ("ch7-ex04", "b"): "A potentiometer is set to a number",
}
"""What the course asks and nobody can give; the reason says why."""


OPEN = {"no solution is missing"}
"""Of a Riccati equation with letters others may be real for some of their values only: that is said, not decided."""


COURSE = [path for path in PROBLEMS if "course" in path.parts]
QUICK = [*EXAMPLES, *[path for path in PROBLEMS if path not in EXAMPLES][::3]]
"""The others are solved and verified in CI."""


@pytest.mark.parametrize(**by_problem(PROBLEMS, QUICK))
def test_the_problem_is_verified(path):
    for part in solution_of(path).parts:
        if (reason := IMPOSSIBLE.get((path.stem, part.id))) is not None:
            assert part.status is Status.UNSOLVED
            assert reason in str(part.reason)
            continue
        failed = [check for check in part.checks if check.status is not CheckStatus.PASSED]
        assert part.status is Status.VERIFIED, (part.id, part.method, part.reason, failed)
        assert {check.claim for check in failed} <= OPEN


TWICE = 10
"""The percentage of a page that may be told twice."""


@pytest.mark.parametrize("detail", ["tutor", "full"])
@pytest.mark.parametrize(**by_problem(COURSE, quick=[], of=2))
def test_a_page_tells_everything_once(path, detail):
    share, twice = repeated(document_of_problem(path).told(detail=detail))
    assert share < TWICE, twice


@pytest.mark.parametrize(**by_problem(COURSE, quick=[], of=2))
def test_one_matrix_has_one_symbol_and_one_symbol_one_meaning(path):
    """Λ is not J, what A becomes in modal coordinates; ξ is not a damping ratio and a vector of coordinates."""
    markdown = markdown_of(document_of_problem(path).told(detail="full"))
    assert not (re.search(r"\\Lambda(?!_| =)", markdown) and "J" in markdown and r"V\Lambda" in markdown)
    assert not (
        r"\xi\omega_{n}" in markdown and re.search(r"x = T ?\\,?\\xi|\\xi = (?:P|T) ?x|\\dot\{\\xi\}", markdown)
    )


@pytest.mark.parametrize(**by_problem(PROBLEMS, quick=[], of=4))
def test_checks_cite_steps_that_the_page_shows(path):
    for detail in ("brief", "full"):
        for part in document_of_problem(path).told(detail=detail).shown:
            cited = [int(number) for row in part.rows for number in re.findall(r"step (\d+)", row.claim)]
            assert all(1 <= number <= len(part.steps) for number in cited)


@pytest.mark.parametrize(**by_problem(PROBLEMS, QUICK))
def test_no_check_is_left_out_for_want_of_a_rule(path):
    """What can not be judged is told with its reason; that the oracle was never taught an operation is no reason."""
    wanting = [check for part in solution_of(path).parts for check in part.checks if str(NoRule("")) in check.reason]
    assert not wanting


@pytest.mark.parametrize(**by_problem(PROBLEMS, quick=EXAMPLES[::3], of=4))
def test_every_format_shows_it_with_every_step(path):
    shown_in_every_format(document_of_problem(path))


@pytest.mark.parametrize("detail", ["full", "brief"])
@pytest.mark.parametrize(**by_problem(PROBLEMS, quick=[], of=8))
def test_every_format_shows_it_at_every_level_of_detail(path, detail):
    shown_in_every_format(document_of_problem(path).told(detail=detail))


def shown_in_every_format(document):
    shown = [render_page(document), latex_document(document), markdown_of(document)]
    for part in document.shown:
        assert all(answer.equation in shown[2] or f"= {answer.tex}\n" in shown[2] for answer in part.boxed)
        for formula in [step.markdown for step in part.steps] + [answer.tex for answer in part.answers]:
            assert not CLUMSY.search(formula), formula
        assert not [each for step in part.steps for each in carelessly_written(step.markdown)]
    assert all(len(text) > 500 for text in shown)


PRESENTATIONS = [Presentation(detail, notation=each) for detail in ("key", *LEVELS) for each in NOTATIONS]
PRESENTATIONS += [Presentation(language="de", notation=each) for each in NOTATIONS]


@cache
def covered():
    """Problems that together ask every task by every method: they are told at every level and in German."""
    return frozenset(covering())  # chosen when it is needed: it takes seconds, which collecting need not


def presentations_of(path):
    """Each in one notation, another one in other turns; in German and for `tutor` what is in its turn.

    Problems that cover all tasks are told in all ways, for a tutor in both notations. What an example displays at
    `full` and in a key, the quick tests judge.
    """
    if WHOLE:
        return PRESENTATIONS
    way_of = {each: each.language or each.detail for each in PRESENTATIONS}
    turned = {way: sorted(NOTATIONS)[in_turn(f"{path.stem} {way}", 2)] for way in way_of.values()}
    if path in covered():
        return [each for each in PRESENTATIONS if each.detail == "tutor" or turned[way_of[each]] == each.notation]
    left_out = set() if in_turn(path.stem, 2) else {"de", "tutor"}
    left_out |= {"full", "key"} if path in EXAMPLES else set()
    return [each for each in PRESENTATIONS if way_of[each] not in left_out and turned[way_of[each]] == each.notation]


def all_holds(solution, document):
    """Fail where the judge finds something displayed wrong, or a status that is not that of the solution."""
    general = [part for part in document.parts if not part.case]
    for part in document.parts:
        wrong = [check for check in part.checks if check.status is CheckStatus.FAILED]
        assert not wrong, (document.presentation, part.id, part.method, part.case, wrong)
        assert "the judge cannot" not in part.unchecked
    for result, part in zip(solution.parts, general, strict=True):
        assert part.status is result.status, (document.presentation, part.id, part.method)


@pytest.mark.parametrize("detail", ["full", "key"])
@pytest.mark.parametrize(**by_problem(EXAMPLES))
def test_what_an_example_displays_holds(path, detail):
    """Of every task, so that no change of a template stays unseen until all tests are run."""
    all_holds(solution_of(path), told_of_problem(path, Presentation(detail)))


@pytest.mark.slow
@pytest.mark.parametrize(**by_problem(PROBLEMS))
def test_what_is_displayed_holds_at_every_level_in_every_notation(path):
    """And the same is checked in every notation. The page for a tutor is told of every problem: other tests show it."""
    solution, checked, tutor = solution_of(path), {}, Presentation("tutor")
    own = solution.problem.display.notation  # so other tests of this problem tell it, too
    asked = [replace(each, notation=None) if each.notation == own else each for each in presentations_of(path)]
    documents = [(each, told_of_problem(path, each)) for each in asked if each != tutor]
    for presentation, document in [(tutor, document_of_problem(path)), *documents]:
        all_holds(solution, document)
        done = [[(check.step, check.status) for check in part.checks] for part in document.parts]
        way = (presentation.detail, presentation.language)
        assert checked.setdefault(way, done) == done, presentation


def are_alike(ours, theirs):
    """Programs are the same, their numbers but for the last digits."""
    assert list(ours.readout) == list(theirs.readout)
    for a, b in zip(ours.elements, theirs.elements, strict=True):
        assert (a.id, a.kind, [fed for fed, _ in a.inputs]) == (b.id, b.kind, [fed for fed, _ in b.inputs])
        pairs = [(getattr(a, key), getattr(b, key)) for key in ("value", "setting", "initial")]
        for one, other in [*pairs, *zip([g for _, g in a.inputs], [g for _, g in b.inputs], strict=True)]:
            point = {symbol: sp.Rational(7, 5) for symbol in getattr(one, "free_symbols", ())}
            named = {sp.Symbol(symbol.name): value for symbol, value in point.items()}
            assert one == other or abs(one.subs(point) - other.subs(named)) <= 1e-12


@pytest.mark.parametrize(**by_problem(PROBLEMS, quick=[], of=4))
def test_the_values_in_json_are_read_back_as_they_were(path):
    solution = solution_of(path)
    data = json.loads(render_json(document_of_problem(path)))
    names = {name: sp.Symbol(name) for name in data["symbols"]}
    for result, part in zip(solution.parts, data["parts"], strict=True):
        for name, answer in part["answers"].items():
            if isinstance(result.answers[name], str):  # words, where the catalogue says so
                assert answer["value"] == result.answers[name]
                continue
            if isinstance(result.answers[name], Program):
                are_alike(result.answers[name], program_of(answer["value"], partial(sp.sympify, locals=names)))
                continue
            ours, theirs = result.answers[name], sp.sympify(answer["value"], locals=names)
            plain = {symbol: sp.Symbol(symbol.name) for symbol in getattr(ours, "free_symbols", ())}
            if isinstance(ours, sp.MatrixBase):
                samples = {f: sp.Symbol(str(f).replace(" ", "")) for f in theirs.atoms(AppliedUndef)}
                theirs = theirs.xreplace(samples)  # y(k+1), not a function y
                point = {symbol: sp.Rational(7 + i, 5) for i, symbol in enumerate(sorted(theirs.free_symbols, key=str))}
                point = {symbol: 3 if symbol.name == "k" else value for symbol, value in point.items()}
                ours, theirs = (M.subs(point).evalf(20) for M in (ours.xreplace(plain), theirs))
                assert all(abs(a - b) <= 1e-12 * max(1, abs(a)) for a, b in zip(ours, theirs, strict=True))
            elif isinstance(ours, bool):
                assert theirs in (sp.true, sp.false)
                assert bool(theirs) is ours
