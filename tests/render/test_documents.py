"""Whole documents: LaTeX that compiles, a deterministic PDF, Markdown; what is said of failed and unsolved parts."""

import re
import shutil
import subprocess
from dataclasses import replace

import pytest
import sympy as sp

from solver.derivation import Answers, Check, CheckStatus, PartResult, Status
from solver.document.checks import check_rows
from solver.document.model import Presentation, WorkStep
from solver.document.works import document_of
from solver.engine import Solution, solve_problem
from solver.problem.model import Display, Part, Problem
from solver.render import pdf
from solver.render.latex_document import latex_document
from solver.render.markdown import markdown_of
from solver.render.typst_document import typst_document
from solver.systems import StateSpace
from solver.words import Reason

t = sp.Symbol("t")
A = sp.ImmutableMatrix([[0, 1], [-2, -3]])

HOSTILE = r"""
Text with % # & _ { } ~ ^ \ "quotes" -- <script>, ^^5cinput{x}, \input{/etc/passwd}, λ ≤ 中 🙂 and $\frac{1}{2}$.

[ starts a paragraph

| a | b |
|---|--:|
| [x] | $y$ |
| 50% | `a_b` |

1. one
   - two
     - three
       - four
         - five
           - six

> quoted

$\input{x}$ and $$ \int_{0}^{1} x\,dx $$ inline.

```
code % \x
[ more
```
[link](https://example.org/a_b?c=%20&d#e)
"""


def problem(statement="", **display):
    plant = StateSpace(A, B=sp.ImmutableMatrix([0, 1]))
    parts = (
        Part("a", "state_transition_matrix", ("laplace", "cayley_hamilton"), plant, {}, marks=sp.Rational(7, 2)),
        Part(
            "b",
            "eigenstructure",
            ("eigenstructure",),
            StateSpace(sp.ImmutableMatrix([[1, 2], [3, 4]])),
            own_system=True,
        ),
    )
    return Problem(
        "demo",
        "Title with 50% & $ _ \\",
        parts,
        plant,
        source="Book, p. 3",
        statement=statement,
        display=Display(**display),
    )


@pytest.fixture(scope="module")
def solution():
    return solve_problem(problem())


def wide_matrix(n):
    return sp.ImmutableMatrix(n, n, lambda i, j: sum((i + 2 * j + m) * sp.exp(-m * t) for m in range(1, n + 1)))


@pytest.fixture(scope="module")
def troubled():
    """A solution with everything that makes a document difficult."""
    asked = problem(HOSTILE)
    wide = Answers(Phi=wide_matrix(8))
    failed = Check.within("$\\Phi$ | of `x` 50%", "scipy.linalg.expm_and_a_long_name", 0.5, 1e-9)
    skipped = Check.skipped("$A$", "numpy", "no numbers for $a$ & b_c")
    parts = (
        PartResult(
            "a",
            "state_transition_matrix",
            "laplace",
            Status.FAILED,
            wide,
            (failed, skipped),
            (),
            Reason("engine/failed_checks", {"failed": 1, "checks": 2}),
        ),
        PartResult("a", "state_transition_matrix", "cayley_hamilton", Status.VERIFIED, Answers(Phi=wide_matrix(3))),
        PartResult(
            "b",
            "eigenstructure",
            "eigenstructure",
            Status.UNSOLVED,
            reason=Reason("limits/ended", {"words": "It is *singular*, $\\det A = 0$ & 100%."}),
        ),
    )
    return Solution(asked, parts)


def log_of(latex, folder):
    """Compile in a folder; return TeX's log."""
    (folder / "solution.tex").write_text(latex, encoding="utf-8")
    subprocess.run(pdf.engine(), cwd=folder, check=True, capture_output=True, timeout=60)
    return (folder / "solution.log").read_text(encoding="utf-8", errors="replace")


@pytest.mark.parametrize("detail", ["brief", "full", "tutor"])
@pytest.mark.usefixtures("tex")
def test_a_solution_compiles_and_nothing_runs_off_the_page(solution, detail, tmp_path):
    log = log_of(latex_document(document_of(solution, Presentation(detail))), tmp_path)
    assert not re.findall(r"Overfull \\hbox \((?!0\.)\d+", log)


LANGUAGE = r"""\ProvidesLanguage{ngerman}
\LdfInit{ngerman}{captionsngerman}
\newlanguage\l@ngerman
\StartBabelCommands*{ngerman}{captions}\EndBabelCommands
\ldf@finish{ngerman}
"""


@pytest.mark.parametrize(("definition", "penalty"), [("", 10000), (LANGUAGE, 50)])
@pytest.mark.usefixtures("tex")
def test_a_german_document_is_hyphenated_as_german_or_not_at_all(solution, definition, penalty, tmp_path):
    latex = latex_document(document_of(solution, Presentation(language="de")))
    assert "babel" not in latex_document(document_of(solution))
    if definition:
        (tmp_path / "ngerman.ldf").write_text(definition, encoding="utf-8")
    elif (finder := shutil.which("kpsewhich")) and subprocess.run(
        [finder, "ngerman.ldf"], stdout=-1, check=False
    ).stdout:
        pytest.skip("this TeX knows German")
    shown = latex.replace(r"\begin{document}", r"\begin{document}\typeout{penalty=\the\hyphenpenalty.}")
    assert f"penalty={penalty}." in log_of(shown, tmp_path)


@pytest.mark.usefixtures("tex")
def test_hostile_texts_wide_matrices_and_failures_compile(troubled, tmp_path):
    latex = latex_document(document_of(troubled))
    log = log_of(latex, tmp_path)
    assert not re.findall(r"Overfull \\hbox \((?:[2-9]\d|\d{3})", log)  # links and code may stick out a little
    assert "/etc/passwd" not in log
    assert not re.findall(r"Overfull \\vbox", log)
    assert latex.count(r"\display{\boxed{\begin{aligned}") == 3  # 64 entries


@pytest.mark.usefixtures("typst")
def test_hostile_texts_wide_matrices_and_failures_are_typeset(troubled):
    source = typst_document(document_of(troubled, Presentation(checks="table")))
    assert pdf.pdf_by_typst(source).startswith(b"%PDF")
    assert source.count("framed: true, $Φ") == 1
    assert "Do not rely on this answer:" in source


@pytest.mark.usefixtures("tex")
def test_the_same_solution_gives_the_same_pdf(solution):
    latex = latex_document(document_of(solution))
    first, second = pdf.pdf_of(latex), pdf.pdf_of(latex)
    assert first.startswith(b"%PDF")
    assert first == second


@pytest.mark.usefixtures("tex")
def test_tex_that_does_not_end_is_stopped():
    with pytest.raises(pdf.PdfUnavailable, match="longer than 1 s"):
        pdf.pdf_of(r"\documentclass{article}\begin{document}\loop\iftrue\repeat\end{document}", seconds=1)


@pytest.mark.usefixtures("tex")
def test_tex_reads_and_writes_no_other_files(tmp_path):
    secret = tmp_path / "secret.tex"
    secret.write_text("SECRET", encoding="utf-8")
    with pytest.raises(pdf.PdfUnavailable):
        pdf.pdf_of(rf"\documentclass{{article}}\begin{{document}}\input{{{secret}}}\end{{document}}")
    target = tmp_path / "written"
    body = rf"\newwrite\f\immediate\openout\f={target}\immediate\write\f{{x}}\immediate\write18{{touch {target}2}}x"
    with pytest.raises(pdf.PdfUnavailable):
        pdf.pdf_of(rf"\documentclass{{article}}\begin{{document}}{body}\end{{document}}")
    assert list(tmp_path.iterdir()) == [secret]


@pytest.mark.usefixtures("tex")
def test_an_error_of_tex_is_told_in_one_line():
    with pytest.raises(pdf.PdfUnavailable, match=r"Undefined control sequence.*nosuchcommand"):
        pdf.pdf_of(r"\documentclass{article}\begin{document}\nosuchcommand\end{document}")


def test_without_tex_the_message_says_what_to_do(monkeypatch):
    monkeypatch.setattr(shutil, "which", lambda _name: None)
    monkeypatch.setattr(pdf, "find_spec", lambda _name: None)
    with pytest.raises(pdf.PdfUnavailable, match="texlive-latex-recommended"):
        pdf.pdf_of("x")


def test_the_document_says_all_there_is(solution):
    latex = latex_document(document_of(solution))
    for part in (
        r"Title with 50\% \& \$ \_",
        "Book, p. 3",
        "3.5 marks",
        "Cayley–Hamilton theorem",
        r"\boxed{\Phi =",
        "passed",
    ):
        assert part in latex
    assert latex.count("Find the state transition matrix") == 1  # asked once, answered by two methods
    assert "failed" not in latex.split(r"\begin{document}")[1]


def test_failed_and_unsolved_parts_are_marked(troubled):
    latex = latex_document(document_of(troubled))
    assert r"\textbf{Do not rely on this answer:} 1 of 2 checks failed" in latex
    assert r"\textcolor{failed}{\textbf{failed}}" in latex
    assert r"\textbf{Unsolved.} It is \emph{singular}, $\det A = 0$ \& 100\%." in latex
    markdown = markdown_of(document_of(troubled))
    assert "**Do not rely on this answer:** 1 of 2 checks failed" in markdown
    assert "> **Unsolved.** It is *singular*" in markdown
    assert "<script" not in markdown


def test_markdown_has_titles_steps_answers_and_checks(solution):
    markdown = markdown_of(document_of(solution))
    assert markdown.startswith("# Title with 50% \\& \\$ \\_ \\\\\n")
    assert "## (a) State transition matrix (3.5 marks)" in markdown
    assert re.search(r"^### 1\. Form the matrix \$s ?I - A\$$", markdown, re.MULTILINE)
    assert "\\Phi = \\begin{bmatrix}2e^{-t} - e^{-2t}" in markdown
    rows = [line for line in markdown.splitlines() if line.startswith("| ")]
    assert all(len(re.findall(r"(?<!\\)\|", row)) == 5 for row in rows)
    assert "\n\n\n" not in markdown


def shown(solution, *display):
    return document_of(replace(solution, problem=replace(solution.problem, display=Display(*display))))


def test_the_same_solution_gives_the_same_document_in_every_number_format(solution):
    exact = shown(solution, "exact")
    assert exact == shown(solution, "exact")
    first, second, third = exact.parts
    assert (first.again, second.again, third.again) == (False, True, False)
    assert second.question == first.question
    assert third.given
    assert len({part.anchor for part in exact.parts}) == 3
    assert first.answers[0].symbol == r"\Phi"
    decimal = shown(solution, "decimal", 3).parts[2].answers[0]
    assert decimal.tex == r"-0.372,\; 5.37"


def test_claims_are_one_row_a_step_and_failures_are_rows_of_their_own():
    steps = [WorkStep("x", "First", "", covers=(1,)), WorkStep("z", "Third, which refers", "", covers=(3, 4))]
    good = replace(Check.within("one", "random points", 1e-16, 1e-9), step=1)
    worse = replace(Check.within("one", "random points", 1e-12, 1e-9), step=1)
    bad = replace(Check.within("one", "random points", 1.0, 1e-9), step=1)
    second = replace(good, step=2)
    final = Check.that("property", "scipy", True)

    def rows(*checks):
        return [(row.claim, row.residual, row.status.value) for row in check_rows(checks, steps, str)]

    assert rows(good, worse, second, replace(good, step=3), final) == [
        ("2 equalities of step 1", "10^{-12}", "passed"),
        ("one (step 2)", "10^{-16}", "passed"),
        ("equalities of steps that are not shown at this level: 1", "10^{-16}", "passed"),
        ("property", "", "passed"),
    ]
    assert ("2 equalities of step 2", "10^{-16}", "passed") in rows(replace(good, step=4), replace(good, step=3))
    assert ("one", "1", "failed") in rows(good, bad, second, final)
    assert check_rows((), (), str) == []
    assert CheckStatus.PASSED.value == "passed"
