"""The guides of a first hour: what their commands print is what they show, and their pictures are there, and small."""

import pytest

from tests.helpers.shares import one_of
from tools.guides import BLOCK, GUIDES, Picture, Typed, Written, fits, follow, run, steps

names = dict(argvalues=GUIDES, ids=lambda guide: guide.stem)  # noqa: C408 - as the parameters are called


@pytest.mark.parametrize(
    "guide", [pytest.param(each, marks=one_of(i, len(GUIDES)), id=each.stem) for i, each in enumerate(GUIDES)]
)
def test_each_command_prints_what_the_guide_shows(guide, tmp_path):
    followed = list(follow(guide, tmp_path))
    assert len(followed) >= 5
    told_otherwise = [f"$ {step.command}\n{printed}" for step, printed in followed if not fits(step.printed, printed)]
    assert not told_otherwise, "\n".join(told_otherwise)


@pytest.mark.parametrize("guide", **names)
def test_every_block_of_commands_and_files_is_followed(guide):
    text = guide.read_text(encoding="utf-8")
    told = [block["kind"] for block in BLOCK.finditer(text) if block["kind"]]
    assert text.count("\n```") == 2 * len(told)
    read = list(steps(text))
    assert sum(isinstance(step, Written) for step in read) == sum(kind != "console" for kind in told)
    assert {step.command.split()[0] for step in read if isinstance(step, Typed)} <= {"solve", "cat", "rm"}


@pytest.mark.parametrize("guide", **names)
def test_its_pictures_are_there_and_small(guide):
    pictures = [step for step in steps(guide.read_text(encoding="utf-8")) if isinstance(step, Picture)]
    assert pictures
    for picture in pictures:
        assert (guide.parent / picture.file).stat().st_size < 60_000


@pytest.mark.parametrize("guide", **names)
def test_a_guide_is_read_in_an_hour(guide):
    assert len(guide.read_text(encoding="utf-8").splitlines()) <= 250


@pytest.mark.parametrize(
    ("expected", "printed", "fit"),
    [
        ("a\nb\n", "a\nb\n", True),
        ("a\nb\n", "a  \nb\n\n", True),  # blanks at ends of lines do not show
        ("a\n...\nc\n", "a\nb\nb\nc\n", True),
        ("a\n...\n", "a\n", True),
        ("a\n...\nc\n", "a\nb\n", False),
        ("a\n", "a\nb\n", False),
        ("", "a\n", False),
        ("a.c\n", "abc\n", False),
    ],
)
def test_three_dots_stand_for_lines_left_out(expected, printed, fit):
    assert fits(expected, printed) is fit


def test_a_guide_uses_no_other_program(tmp_path):
    with pytest.raises(ValueError, match="a guide does not use curl"):
        run("curl example.org", tmp_path)


def test_files_commands_and_pictures_are_told_apart():
    text = (
        "Write `a/b.yaml`:\n\n```yaml\nx: 1\n```\n\n```console\n$ solve a/b.yaml\nwrote b\n$ cat c\n```\n\n"
        "<!-- picture: b.html 700x500 from 20 -->\n![The page](images/b.png)\n\n```yaml\nonly: shown\n```\n"
    )
    assert list(steps(text)) == [
        Written("a/b.yaml", "x: 1\n"),
        Typed("solve a/b.yaml", "wrote b\n"),
        Typed("cat c", ""),
        Picture("b.html", "images/b.png", 700, 500, 20),
    ]
