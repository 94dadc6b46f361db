"""Images in the statement and the prompts: shown in every format, and nothing but images below the problem's folder."""

import base64
import struct
import zlib

import pytest

from solver import solve
from solver.document.formats import FORMATS
from solver.problem.files import load
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue

TEXT = """\
title: Pictures
statement: |
  The circuit:

  ![with $R$ & <b>](pics/a%20b.png)
system: {matrix: [[0, 1], [-2, -3]]}
find:
  a: {task: stability, prompt: "See ![a drawing](c.svg)."}
"""
SVG = '<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><rect width="5" height="5"/></svg>'


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


PNG = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 4, 4, 8, 0, 0, 0, 0))
PNG += chunk(b"IDAT", zlib.compress(b"\0\1\2\3\4" * 4)) + chunk(b"IEND", b"")


@pytest.fixture
def file(tmp_path):
    folder = tmp_path / "folder"
    (folder / "pics").mkdir(parents=True)
    (folder / "pics" / "a b.png").write_bytes(PNG)
    (folder / "c.svg").write_text(SVG, encoding="utf-8")
    (tmp_path / "secret.png").write_bytes(PNG)
    path = folder / "problem.yaml"
    path.write_text(TEXT, encoding="utf-8")
    return path


def refusal(file, text=TEXT):
    file.write_text(text, encoding="utf-8")
    with pytest.raises(InputError) as caught:
        read_problem(load(file), catalogue())
    return caught.value.render().removeprefix(str(file))


def test_a_page_holds_the_images_with_their_words(file):
    page = solve(file).html()
    assert f"data:image/png;base64,{base64.b64encode(PNG).decode()}" in page
    assert f"data:image/svg+xml;base64,{base64.b64encode(SVG.encode()).decode()}" in page
    assert 'alt="with R &amp; &lt;b&gt;"' in page


def test_solved_within_limits_the_page_is_the_same(file):
    assert solve(file, seconds=60).html() == solve(file).html()


def test_a_text_has_the_words_and_markdown_the_names(file):
    document = solve(file)
    assert "[with R & <b>]" in document.text()
    assert "[a drawing]" in document.text()
    assert "![with $R$ & < b>](pics/a%20b.png)" in document.markdown()


def test_latex_includes_what_tex_can_draw_from_files_beside_it(file):
    document = solve(file)
    ((name, content),) = FORMATS["latex"].beside(document).items()
    assert name.endswith(".png")
    assert content == PNG
    assert document.latex().count(name) == 1
    assert FORMATS["html"].beside(document) == {}


@pytest.mark.slow
@pytest.mark.usefixtures("tex")
def test_the_pdf_is_made_with_its_images(file):
    assert b"/Subtype/Image" in solve(file).rendered("pdf").replace(b" ", b"")


@pytest.mark.parametrize(
    ("old", "new", "place", "words"),
    [
        ("pics/a%20b.png", "pics/none.png", ":5:21:", "there is no such file"),
        ("pics/a%20b.png", "../secret.png", ":5:21:", "outside of the folder"),
        ("pics/a%20b.png", "pics/../../secret.png", ":5:21:", "outside of the folder"),
        ("pics/a%20b.png", "/etc/passwd", ":5:21:", "PNG, JPEG or SVG"),
        ("pics/a%20b.png", "pics", ":5:21:", "PNG, JPEG or SVG"),
        ("c.svg", "d.svg", ":8:50:", "there is no such file"),
    ],
)
def test_a_missing_image_or_one_from_elsewhere_is_refused_at_its_place(file, old, new, place, words):
    said = refusal(file, TEXT.replace(old, new))
    assert said.startswith(place)
    assert words in said


def test_a_link_out_of_the_folder_is_refused(file, tmp_path):
    (file.parent / "link.png").symlink_to(tmp_path / "secret.png")
    assert "outside of the folder" in refusal(file, TEXT.replace("pics/a%20b.png", "link.png"))


@pytest.mark.parametrize(
    "inside",
    [
        "<script>alert(1)</script>",
        "<SCRIPT/>",
        '<rect onload="alert(1)"/>',
        '<a href="javascript:alert(1)"/>',
        '<a href="&#106;avascript:alert(1)"/>',
        '<image href="https://example.org/x.png"/>',
        "<foreignObject/>",
        "<style>@import url(https://example.org)</style>",
        '<rect style="fill:url(https://example.org)"/>',
    ],
)
def test_a_drawing_that_does_more_than_draw_is_refused(file, inside):
    (file.parent / "c.svg").write_text(SVG.replace("<rect", f"{inside}<rect"), encoding="utf-8")
    assert "no scripts and nothing from outside" in refusal(file)


def test_an_image_must_be_what_its_name_says_and_not_too_large(file):
    for content in (PNG, b"a text", SVG.encode() + b"\0"):
        (file.parent / "c.svg").write_bytes(content)
        assert "not what the ending" in refusal(file)
    (file.parent / "c.svg").write_text(SVG, encoding="utf-8")
    (file.parent / "pics" / "a b.png").write_bytes(PNG + bytes(2 * 2**20))
    assert "larger than 2 MB" in refusal(file)


def test_a_text_without_a_folder_has_no_images():
    with pytest.raises(InputError, match="in no folder"):
        read_problem(Source("<text>", TEXT), catalogue())


def test_an_image_of_the_web_stays_a_link(file):
    file.write_text(TEXT.replace("pics/a%20b.png", "https://example.org/x.png"), encoding="utf-8")
    page = solve(file).html()
    assert 'src="https' not in page
    assert '<a href="https://example.org/x.png">' in page
