"""The page as a browser draws it: Chromium at two widths, in light and dark, with no network."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from solver import solve
from solver.classroom import mark, read_submission
from solver.classroom.report.sheet import render_sheet
from solver.document.works import document_of
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.render.page import render_page
from solver.resources import root
from solver.tasks import catalogue
from tests.helpers.sample_pages import SHORT, TALL, hostile, sample
from tests.helpers.solved import PROBLEMS, by_problem, document_of_problem

pytestmark = pytest.mark.xdist_group("browser")  # one browser serves all

FLAGS = (
    "--no-sandbox",
    "--disable-gpu",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--disable-extensions",
)
SWEEP = [pytest.param(view, marks=pytest.mark.slow) for view in ((1280, "dark"), (400, "light"), (400, "dark"))]
VIEWS = [(1280, "light"), *SWEEP]

FORMULAS = """() => [...document.querySelectorAll('math')].map(math => {
    const box = math.getBoundingClientRect();
    return [math.getAttribute('alttext'), box.width, box.height];
})"""
BRACKET = """latex => {
    const math = [...document.querySelectorAll('math')].find(math => math.getAttribute('alttext').endsWith(latex));
    const [left, right] = [...math.querySelectorAll('mo')].filter(mo => '[]'.includes(mo.textContent)).map(mo =>
        mo.getBoundingClientRect().height);
    return [left, right, math.querySelector('mtable').getBoundingClientRect().height];
}"""
CUT_OFF = """() => [...document.querySelectorAll('body *')].filter(element => {
    const box = element.getBoundingClientRect();
    const scrolls = element.closest('.formula, .scroll');
    return box.right > innerWidth + 1 && (!scrolls || scrolls === element);
}).map(element => element.outerHTML.slice(0, 200))"""
TOO_HIGH = """() => [...document.querySelectorAll('.formula, .scroll')].filter(box =>
    box.scrollHeight > box.clientHeight + 1).map(box => box.outerHTML.slice(0, 200))"""
FRAMES = """() => [...document.querySelectorAll('.verdict mrow[style]')].map(frame =>
    [frame.textContent, getComputedStyle(frame).borderTopWidth])"""
HIDDEN = """() => [...document.querySelectorAll('details > :not(summary), details > :not(summary) *')].filter(element =>
    !element.checkVisibility({contentVisibilityAuto: true})).length"""


def unavailable(reason: str) -> None:
    """Skip where a browser is a matter of luck, fail where it is promised."""
    if os.environ.get("CI") == "true":
        pytest.fail(reason)
    pytest.skip(reason)


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    try:
        from playwright.sync_api import sync_playwright  # noqa: PLC0415 - optional
    except ImportError:
        unavailable("playwright is not installed")
    names = (os.environ.get("CHROMIUM", ""), "chromium", "chromium-browser", "google-chrome")
    found = next((path for name in names if name and (path := shutil.which(name))), None)
    if found is None:
        unavailable("Chromium is not installed")
    fonts = tmp_path_factory.mktemp("fonts") / "fonts.conf"
    fonts.write_text(NO_MATH_FONT, encoding="utf-8")
    environment = {**os.environ, "FONTCONFIG_FILE": str(fonts)}
    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=found, args=FLAGS, env=environment)
        yield chromium
        chromium.close()


NO_MATH_FONT = """<?xml version="1.0"?><!DOCTYPE fontconfig SYSTEM "fonts.dtd">
<fontconfig>
  <include ignore_missing="yes">/etc/fonts/fonts.conf</include>
  <selectfont><rejectfont><glob>*math*</glob><glob>*Math*</glob></rejectfont></selectfont>
</fontconfig>"""
"""The machine as it is, less its math fonts: most have none."""

REAL = ("course/ch1/ch1-ex02.yaml", "examples/parameters.yaml", "examples/discrete-time.yaml")


class Visit:
    """A page opened from a file, with what it asked for and complained of."""

    def __init__(self, browser: Any, file: Path, width: int, scheme: str) -> None:
        self.context = browser.new_context(viewport={"width": width, "height": 900}, color_scheme=scheme)
        self.page = self.context.new_page()
        self.requests: list[str] = []
        self.complaints: list[str] = []
        self.page.on("request", lambda request: self.requests.append(request.url))
        self.page.on("console", lambda message: self.complaints.append(message.text))
        self.page.on("pageerror", lambda error: self.complaints.append(str(error)))
        self.page.goto(file.as_uri())
        self.page.evaluate("document.fonts.ready.then(() => null)")


def barriers(visit: Visit) -> list[tuple[str, list[str]]]:
    """Return what axe-core finds to keep readers out, of whatever impact."""
    axe = pytest.importorskip("axe_playwright_python.sync_playwright")
    violations = axe.Axe().run(visit.page).response["violations"]
    return [(each["id"], [node["html"][:200] for node in each["nodes"][:3]]) for each in violations]


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("page") / "sample.html"
    path.write_text(render_page(sample()), encoding="utf-8")
    return path


@pytest.fixture(scope="module", params=VIEWS, ids=lambda view: f"{view[0]}-{view[1]}")
def visit(request: pytest.FixtureRequest, browser: Any, file: Path) -> Iterator[Visit]:
    opened = Visit(browser, file, *request.param)
    yield opened
    opened.context.close()


def test_every_formula_has_a_box(visit: Visit) -> None:
    formulas = visit.page.evaluate(FORMULAS)
    assert len(formulas) > 30
    assert [source for source, width, height in formulas if width < 3 or height < 5] == []


def test_brackets_stretch_to_their_matrix(visit: Visit) -> None:
    for latex in (SHORT, TALL):
        left, right, body = visit.page.evaluate(BRACKET, latex)
        assert left == pytest.approx(right)
        assert 0.8 * body < left < 1.5 * body
    assert visit.page.evaluate(BRACKET, TALL)[0] > 4 * visit.page.evaluate(BRACKET, SHORT)[0]


def test_the_font_of_formulas_is_the_one_on_the_page(visit: Visit) -> None:
    fonts = "[...document.fonts].map(font => [font.family.replaceAll('\"', ''), font.status])"
    assert visit.page.evaluate(fonts) == [["Solve Math", "loaded"]]
    family = "getComputedStyle(document.querySelector('math')).fontFamily"
    assert visit.page.evaluate(family).startswith('"Solve Math"')


def test_nothing_is_wider_than_the_page(visit: Visit) -> None:
    assert visit.page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    assert visit.page.evaluate(CUT_OFF) == []
    assert visit.page.evaluate(TOO_HIGH) == []


def test_a_wide_formula_is_told_by_a_shadow_at_its_edge(visit: Visit) -> None:
    shades = visit.page.evaluate(
        "() => [...document.querySelectorAll('.formula.display')].map(box => getComputedStyle(box).backgroundImage)"
    )
    assert all(shade.count("linear-gradient") == 4 for shade in shades)


def test_punctuation_begins_no_line(visit: Visit) -> None:
    tops = visit.page.evaluate("""() => [...document.querySelectorAll('.glued')].map(span => {
        const boxes = [...span.getClientRects()].map(box => box.top);
        return Math.max(...boxes) - Math.min(...boxes);
    })""")
    assert all(apart < 2 for apart in tops)


def test_no_request_leaves_the_page_and_nothing_is_complained_of(visit: Visit, file: Path) -> None:
    assert [url for url in visit.requests if not url.startswith("data:")] == [file.as_uri()]
    assert visit.complaints == []


def test_nothing_is_in_the_way_of_anyone(visit: Visit) -> None:
    assert barriers(visit) == []


def test_boxes_that_scroll_can_be_reached_by_keyboard(visit: Visit) -> None:
    unreachable = """() => [...document.querySelectorAll('.formula, .scroll')].filter(box =>
        box.scrollWidth > box.clientWidth + 1 && getComputedStyle(box).overflowX === 'auto' && box.tabIndex < 0
    ).map(box => box.outerHTML.slice(0, 200))"""
    assert visit.page.evaluate(unreachable) == []


def test_on_paper_steps_that_were_closed_are_open(visit: Visit) -> None:
    visit.page.evaluate("document.querySelectorAll('details').forEach(step => step.open = false)")
    assert visit.page.evaluate(HIDDEN) > 0
    visit.page.emulate_media(media="print")
    for _ in range(100):  # the page's policy forbids the browser to wait for a function
        if visit.page.evaluate(HIDDEN) == 0:
            break
        visit.page.wait_for_timeout(100)
    assert visit.page.evaluate(HIDDEN) == 0
    visit.page.emulate_media(media="screen")
    visit.page.evaluate("document.querySelectorAll('details').forEach(step => step.open = true)")


@pytest.mark.slow
@pytest.mark.parametrize("problem", REAL)
def test_real_solutions_with_every_arithmetic_step_fit_a_phone(browser: Any, tmp_path: Path, problem: str) -> None:
    path = tmp_path / "page.html"
    path.write_text(solve(root("problems") / problem).html(detail="tutor"), encoding="utf-8")
    visit = Visit(browser, path, 400, "light")
    assert [source for source, width, height in visit.page.evaluate(FORMULAS) if width < 3 or height < 5] == []
    assert visit.page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    assert visit.page.evaluate(CUT_OFF) == []
    assert visit.page.evaluate(TOO_HIGH) == []
    assert visit.page.locator("code.not-drawn").count() == 0
    assert barriers(visit) == []
    visit.context.close()


NO_CUE = """() => [...document.querySelectorAll('body *')].filter(box => {
    const style = getComputedStyle(box);
    const clipped = box.clientWidth && box.scrollWidth > box.clientWidth + 1 && style.overflowX !== 'visible';
    return clipped && box.tagName !== 'CAPTION' && !box.closest('math') && !style.backgroundImage.includes('gradient');
}).map(box => box.outerHTML.slice(0, 200))"""


@pytest.mark.parametrize(**by_problem(PROBLEMS, quick=[], of=32))
def test_nothing_is_clipped_without_a_cue_and_no_heading_ends_a_printed_page(
    browser: Any, tmp_path: Path, path: Path
) -> None:
    document = document_of_problem(path).told(detail="full")
    page = tmp_path / "page.html"
    page.write_text(render_page(document), encoding="utf-8")
    for width in (1100, 420):
        visit = Visit(browser, page, width, "light")
        assert visit.page.evaluate("document.documentElement.scrollWidth <= innerWidth")
        for clipped in (CUT_OFF, TOO_HIGH, NO_CUE):
            assert visit.page.evaluate(clipped) == []
        visit.context.close()
    visit = Visit(browser, page, 1100, "light")
    titles = visit.page.evaluate("[...document.querySelectorAll('h1, h2, h3, h4, h5, h6')].map(each => each.innerText)")
    (tmp_path / "page.pdf").write_bytes(visit.page.pdf(format="A4"))
    visit.context.close()
    assert titles_at_ends(tmp_path / "page.pdf", {" ".join(each.split()) for each in titles}) == []


def titles_at_ends(pdf: Path, titles: set[str]) -> list[str]:
    """The titles that are the last line of a page of a PDF; none where nothing is installed that reads it."""
    reader = shutil.which("pdftotext")
    if reader is None:
        return []
    read = subprocess.run([reader, "-layout", pdf, "-"], capture_output=True, check=True, text=True).stdout
    pages = [[line for line in page.split("\n") if line.strip()] for page in read.split("\f")[:-1]]
    return [last for page in pages if page and (last := " ".join(page[-1].split())) in titles]


SHEET = """\
title: A sheet
system: {A: [[1, 2], [3, 1]], B: [0, 1]}
find:
  a: {task: controllability, marks: {controllable: 1, controllability_matrix: 2}}
  b: {task: eigenstructure, marks: 2}
  c: {task: observability, system: {A: [[1]], C: [1]}}
"""
ANSWERS = """\
student: A-17
answers:
  a: {controllable: no, controllability_matrix: [[0, 2], [1, 2]], rank: 2}
  b: {right_eigenvectors: [[2, 1], [-sqrt(6), 1]], eigenvalues: [3.449, -1.449]}
  c: {unobservable_modes: []}
"""


@pytest.mark.slow
@pytest.mark.parametrize("width", [900, 400])
@pytest.mark.parametrize("with_solution", [False, True])
def test_a_sheet_of_marked_answers_fits_and_keeps_nobody_out(
    browser: Any, tmp_path: Path, width: int, with_solution: bool
) -> None:
    solution = solve_problem(read_problem(Source("sheet.yaml", SHEET), catalogue()))
    submission = read_submission(Source("answers.yaml", ANSWERS), solution.problem)
    marking = mark(solution, submission)
    path = tmp_path / "sheet.html"
    document = document_of(solution) if with_solution else None
    path.write_text(render_sheet(solution, marking, document, key=True), "utf-8")
    visit = Visit(browser, path, width, "light")
    assert visit.page.evaluate(FRAMES) == [["2", "1px"], ["1", "1px"], ["1", "1px"]]
    assert visit.page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    assert visit.page.evaluate(CUT_OFF) == []
    assert barriers(visit) == []
    visit.context.close()


def test_hostile_text_does_nothing(browser: Any, tmp_path: Path) -> None:
    path = tmp_path / "hostile.html"
    path.write_text(render_page(hostile()), encoding="utf-8")
    visit = Visit(browser, path, 800, "light")
    dialogs: list[str] = []
    visit.page.on("dialog", lambda dialog: dialogs.append(dialog.message))
    visit.page.wait_for_timeout(200)
    assert dialogs == []
    assert visit.page.evaluate("document.querySelectorAll('script, img, svg, [onclick], [onerror]').length") == 0
    assert [url for url in visit.requests if not url.startswith("data:")] == [path.as_uri()]
    visit.context.close()
