"""PDF by typst: chosen where there is no TeX, tagged, the same bytes each time; it reads nothing outside its folder."""

import re
import shutil
import zlib
from dataclasses import replace

import pytest

from solver import solve
from solver.cli.run import PDF_ENGINE
from solver.document.model import Document
from solver.document.work import Work
from solver.document.works import document_of
from solver.formula import read
from solver.formula.typst import typst
from solver.render import pdf
from solver.render.prose_typst import inline_typst, to_typst
from solver.render.tex_text import escaped
from solver.render.typst_document import files_beside, typst_document
from solver.render.typst_text import heard, quoted, shows
from tests.document.test_images import PNG, SVG
from tests.helpers.sample_pages import sample
from tests.helpers.solved import EXAMPLES, by_problem, document_of_problem, solution_of
from tests.render.test_documents import HOSTILE

HEAD = '#set document(title: "x")\n'


def without(monkeypatch, *names):
    """Hide what makes a PDF."""
    if "tex" in names:
        monkeypatch.setattr(shutil, "which", lambda *_, **__: None)
    if "typst" in names:
        monkeypatch.setattr(pdf, "find_spec", lambda _: None)


def an_example(name):
    return next(path for path in EXAMPLES if path.stem == name)


def streams(content):
    """Return all that a PDF says, its streams unpacked."""
    packed = re.findall(rb"stream\r?\n(.*?)\r?\nendstream", content, re.DOTALL)
    return content + b"".join(map(unpacked, packed))


def unpacked(stream):
    try:
        return zlib.decompress(stream)
    except zlib.error:
        return b""


@pytest.mark.usefixtures("typst", "tex")
def test_tex_is_taken_where_it_is_and_typst_where_it_is_not_or_is_wanted(monkeypatch):
    assert pdf.chosen() == pdf.chosen("tex") == pdf.TEX
    assert pdf.chosen("typst") == pdf.TYPST
    without(monkeypatch, "tex")
    assert pdf.chosen() == pdf.TYPST
    with pytest.raises(pdf.PdfUnavailable, match="--pdf-engine typst"):
        pdf.chosen("tex")


def test_without_both_the_message_says_what_to_install_and_how_to_print(monkeypatch):
    without(monkeypatch, "tex", "typst")
    with pytest.raises(pdf.PdfUnavailable, match=r"pip install 'solve-control\[pdf\]'.*write HTML.*print it"):
        pdf.chosen()
    with pytest.raises(pdf.PdfUnavailable, match=r"typst is not installed: pip install 'solve-control\[pdf\]'"):
        pdf.chosen("typst")


def test_the_option_names_the_engines():
    def command():
        pass

    PDF_ENGINE(command)
    (option,) = command.__click_params__
    assert tuple(option.type.choices) == pdf.ENGINES


@pytest.mark.usefixtures("typst")
@pytest.mark.parametrize(**by_problem(EXAMPLES, [an_example("lqr"), an_example("op-amp-stages")], of=16))
def test_every_formula_figure_and_table_is_typeset_and_has_words(path):
    """PDF/UA-1 is refused where a picture or a formula has no words, a letter has no glyph or a heading is skipped."""
    document = document_of_problem(path)
    content = streams(pdf.pdf_by_typst(typst_document(document), files=files_beside(document)))
    assert b"/MarkInfo" in content
    assert b"/StructTreeRoot" in content
    assert b"pdfuaid:part" in content


@pytest.mark.usefixtures("typst")
def test_the_same_solution_gives_the_same_pdf():
    document = document_of(solution_of(an_example("dc-gain")))
    assert document.told(pdf_engine="typst").rendered("pdf") == document.pdf(pdf_engine="typst")


def test_a_solution_that_cannot_be_told_anew_can_have_another_engine():
    document = replace(document_of(solution_of(an_example("dc-gain"))), retell=None)
    assert document.told(pdf_engine="typst").presentation.pdf_engine == "typst"


@pytest.mark.usefixtures("typst")
def test_hostile_texts_stand_as_they_are():
    names = (
        "",
        "](#x) $a$ #panic(1) \\",
        '"',
        '#read("/etc/passwd")',
        "中 🙂 ﬁ \u202e\x07",
        "<a@b>",
        "// /* */",
        "\\u{41}",
    )
    parts = tuple(
        Work(
            f"p{i}", "stability", "m", name, name, name, name, HOSTILE, HOSTILE, False, (), (), (), "unsolved", HOSTILE
        )
        for i, name in enumerate(names)
    )
    for name in names:
        document = Document(name, name, HOSTILE + "\n\n" + name, name, parts, name=name)
        assert pdf.pdf_by_typst(typst_document(document)).startswith(b"%PDF")


def test_texts_are_strings_and_formulas_that_are_none_are_texts():
    assert inline_typst('a "b" \\ #x') == '#"a \\"b\\" \\\\ #x"'
    assert inline_typst(r"$\input{x}$") == r'#raw("\\input{x}")'
    assert inline_typst("**a** [b](#part-a) [c](https://x.org/a?b=c#d)") == (
        '#strong[#"a"]#" "#within("part-a")[#"b"]#" "#link("https://x.org/a?b=c#d")[#"c"]'
    )
    assert to_typst("So\n\n$$\nx = 1\n$$\n\nholds.") == (
        '#leading[#"So"]\n\n#formula("x = 1", framed: false, $x\\=1$)\n\n#"holds."'
    )
    assert quoted("ﬁ\tx中\x07é") == '"fi x[cjk unified ideograph-4e2d]é"'
    assert quoted("2e⁻ˢ, Aᵀ, x² + xₖ₊₁, Mª") == '"2e^(−s), A^T, x² + x_(k+1), Mª"'


def test_signs_that_tex_keeps_apart_are_kept_apart():
    document = Document("", "", "", "", (), name="")
    (joined,) = re.findall(r'#show regex\("(.*)"\): set text\(ligatures: false\)', typst_document(document))
    signs = [one + other for one in "-,`'?!.a" for other in "-,`'?!.a"]
    assert [each for each in signs if re.fullmatch(joined, each)] == [each for each in signs if "{}" in escaped(each)]


@pytest.mark.usefixtures("typst")
@pytest.mark.parametrize("body", ['#read("{secret}")', '#image("{secret}", alt: "x")', '#include "{secret}"'])
def test_nothing_outside_of_its_folder_is_read(body, tmp_path):
    secret = tmp_path / "secret.svg"
    secret.write_text(SVG, encoding="utf-8")
    for path in (str(secret), "../" * 12 + str(secret)[1:]):
        with pytest.raises(pdf.PdfUnavailable, match="typst stopped"):
            pdf.pdf_by_typst(HEAD + body.format(secret=path))


@pytest.mark.usefixtures("typst")
def test_no_package_is_fetched_though_there_is_a_network(monkeypatch):
    monkeypatch.setenv("NO_PROXY", "*")
    with pytest.raises(pdf.PdfUnavailable, match=r"failed to download package .*[Rr]efused"):
        pdf.pdf_by_typst(HEAD + '#import "@preview/cetz:0.3.0": *')


@pytest.mark.usefixtures("typst")
def test_a_document_that_does_not_end_is_stopped():
    with pytest.raises(pdf.PdfUnavailable, match="typst took longer than 1 s"):
        pdf.pdf_by_typst(HEAD + "#let f(n) = { for i in range(1000000000) { n += i } \n n }\n#f(1)", seconds=1)


@pytest.mark.usefixtures("typst")
def test_images_of_the_problem_are_shown_with_their_words(tmp_path):
    (tmp_path / "a.png").write_bytes(PNG)
    (tmp_path / "b.svg").write_text(SVG, encoding="utf-8")
    file = tmp_path / "p.yaml"
    file.write_text(
        "title: x\nstatement: '![first](a.png) ![second](b.svg) ![](a.png)'\n"
        "system: {matrix: [[0, 1], [-2, -3]]}\nfind: {a: stability}\n",
        encoding="utf-8",
    )
    said = streams(solve(file).pdf(pdf_engine="typst"))
    assert said.count(b"/Figure") >= 2
    assert b"first" in said
    assert b"second" in said


@pytest.mark.usefixtures("typst")
def test_the_fonts_have_every_letter_that_is_passed_on():
    passed = "".join(sign for sign in map(chr, range(0x20, 0x3000)) if quoted(sign) == f'"{sign}"')
    text = quoted(passed.replace('"', ""))
    shown = [f"#{text}", f"#emph({text})", f"#strong({text})", f"#raw({text})"]
    formula = typst(read(r"\operatorname{a-b}"))
    shown.append(f'#math.equation(alt: "x", ${formula}$)')
    assert pdf.pdf_by_typst("\n\n".join((HEAD, '#set text(font: "New Computer Modern")', *shown)))


def test_what_is_heard_needs_no_glyph():
    assert heard('ẋ "1"\\\x07\n中') == '"ẋ \\"1\\"\\\\中"'
    assert [shows(each) for each in ("Doe, #Jo", "Müller", "Žižek", "李明", "🙂")] == [True, True, True, False, False]
    assert inline_typst(r"$\dot x$").startswith('#eq("ẋ"')


def test_what_is_asked_stays_together_and_with_the_first_step_and_a_paper_may_break_behind_it():
    document = replace(sample(), given="")
    kept = "#block(sticky: true, width: 100%)["
    asked = replace(document, parts=tuple(replace(each, steps=()) for each in document.parts))
    method = "Method:"
    for each in typst_document(document).split(method)[:-1]:
        assert each.rstrip('#"').rstrip().endswith(f"{kept}\n#text(fill: quiet)[")
    assert f"{kept}\n#text(fill: quiet)" not in typst_document(asked)
    assert typst_document(asked).count(kept) == sum(each.question != "" and not each.again for each in asked.parts) > 0
