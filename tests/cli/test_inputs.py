"""Folders, patterns and standard input among the files of a command: what is found, in what order, and passed over."""

import pytest

from solver.cli.inputs import problems_in
from tests.helpers.small_problems import BAD, GOOD
from tests.papers.exams import EXAM


@pytest.fixture
def course(tmp_path, monkeypatch):
    """Chapters with problems and with what else lies there."""
    monkeypatch.chdir(tmp_path)
    files = {
        "ch1/b.yaml": GOOD,
        "ch1/a.yml": GOOD,
        "ch1/page.html": "<p>",
        "ch1/.hidden.yaml": GOOD,
        "ch1/exam.yaml": EXAM,
        "ch1/answers.yaml": "student: A\nanswers: {a: 1}\n",
        "ch1/changes.yaml": "changes: {A: {comment: x}}\n",
        "ch1/config.yaml": "version: 3\n",
        "ch1/more/c.yaml": GOOD,
        "ch2/b.yaml": BAD,
        "ch2/flow.yaml": "{title: x, system: {matrix: [[1]]}, find: {a: eigenstructure}}",
        "ch2/quoted.yaml": '"system": {matrix: [[1]]}\n"find": {a: eigenstructure}\n',
        "ch2/broken.yaml": "title: [",
        "ch2/misspelt.yaml": "system: {matrix: [[1]]}\nfnd: {a: eigenstructure}\n",
        ".git/x.yaml": GOOD,
        "a[1].yaml": GOOD,
    }
    for name, text in files.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    (tmp_path / "ch1" / "folder.yaml").mkdir()
    return tmp_path


@pytest.mark.parametrize(
    ("named", "files"),
    [
        (["ch1"], ["ch1/a.yml", "ch1/b.yaml"]),
        (["ch1/"], ["ch1/a.yml", "ch1/b.yaml"]),
        (["ch1/*.yaml"], ["ch1/b.yaml"]),
        (["ch?/b.yaml"], ["ch1/b.yaml", "ch2/b.yaml"]),
        (["ch[12]/b.yaml"], ["ch1/b.yaml", "ch2/b.yaml"]),
        (["**/b.yaml"], ["ch1/b.yaml", "ch2/b.yaml"]),
        (["ch1/**/*.y*ml"], ["ch1/a.yml", "ch1/b.yaml", "ch1/more/c.yaml"]),
        (["ch1/b.yaml", "ch1", "./ch1/b.yaml"], ["ch1/b.yaml", "ch1/a.yml"]),
        (["-", "ch1", "-"], ["-", "ch1/a.yml", "ch1/b.yaml"]),
        (["ch2"], [f"ch2/{name}.yaml" for name in ("b", "broken", "flow", "misspelt", "quoted")]),
        (["a[1].yaml"], ["a[1].yaml"]),
        (["ch1/exam.yaml"], ["ch1/exam.yaml"]),
        (["none.yaml", "ch1/b.yaml"], ["none.yaml", "ch1/b.yaml"]),
    ],
)
def test_what_arguments_mean(course, named, files):
    assert list(problems_in(named).files) == files


def test_what_is_found_and_is_no_problem_is_told(course):
    found = problems_in(["ch1"])
    assert dict(found.passed_over) == {
        "ch1/answers.yaml": "an answer file",
        "ch1/changes.yaml": "a file of changes",
        "ch1/config.yaml": "it asks nothing",
        "ch1/exam.yaml": "an exam",
    }
    assert found.several
    assert not found.missing


@pytest.mark.parametrize(
    ("named", "message"),
    [
        ("nothing*.yaml", "nothing*.yaml: error: no problem file fits this pattern"),
        ("**nothing", "**nothing: error: no problem file fits this pattern"),
        ("ch1/more/..", "ch1/more/../a.yml"),
        (".", "there is no problem file in this folder"),
        ("[", "["),
    ],
)
def test_where_nothing_is_found_it_is_said(course, named, message):
    (course / "a[1].yaml").unlink()
    found = problems_in([named])
    assert message in " ".join((*found.missing, *found.files))


def test_one_file_is_not_several_and_a_folder_of_one_is(course):
    assert not problems_in(["ch1/b.yaml"]).several
    assert problems_in(["ch1/more"]).several
    assert "solve '**/*.yaml'" in problems_in(["."]).missing[0] if problems_in(["."]).missing else True


def test_links_in_circles_end(course):
    (course / "ch1" / "more" / "up").symlink_to(course / "ch1")
    assert problems_in(["**/c.yaml"]).files == ("ch1/more/c.yaml",)


def test_a_folder_is_solved_and_the_rest_is_told(solve, course):
    done = solve("ch1", "nothing*.yaml", "-o", "out")
    assert done.code == 2
    assert {path.name for path in (course / "out").glob("*.html")} == {"a.html", "b.html"}
    assert "passed over, no problems: ch1/answers.yaml (an answer file), ch1/changes.yaml" in done.err
    assert "nothing*.yaml: error: no problem file fits this pattern" in done.err


def test_alike_names_of_two_chapters_keep_apart(solve, course):
    (course / "ch2" / "b.yaml").write_text(GOOD, encoding="utf-8")
    assert solve("**/b.yaml", "-o", "out").code == 0
    assert {path.name for path in (course / "out").glob("*.html")} == {"ch1-b.html", "ch2-b.html"}


def test_standard_input_is_one_of_several(process, course):
    done = process("-", "ch1/b.yaml", "-o", "out", stdin=GOOD.encode())
    assert done.code == 0
    assert {path.name for path in (course / "out").glob("*.html")} == {"solution.html", "b.html"}


def test_a_pattern_is_a_word_for_solve(solve, course):
    assert solve("ch1/b?yaml", "-o", "out").code == 0
    assert solve("b*", "-o", "out").code == 2
