"""`solve exam --export qti,canvas`: where the packages are, and that they are the same bytes however they are made."""

import io
import zipfile

from lxml import etree

from tests.papers.banks.canvas_reader import quizzes_of
from tests.papers.banks.qti_schema import QTI, faults
from tests.papers.exams import write_exam

EXAM = """\
exam: Final <exam>
questions:
  - {problem: family.yaml, marks: 10}
  - problem:
      system: {A: [[0, 1], [-2, -3]], B: [0, 1]}
      find: {a: {task: stability, answers: [verdict]}}
    marks: 5
variants: {count: 2}
"""


def test_packages_are_the_same_for_any_jobs_and_hashes(process, tmp_path):
    exam = write_exam(tmp_path, EXAM)
    made = []
    for jobs, seed in ((1, "0"), (2, "77")):
        folder = tmp_path / f"build-{jobs}"
        done = process("exam", exam, "--export", "qti,canvas", "-o", folder, "--jobs", jobs, PYTHONHASHSEED=seed)
        assert done.code == 0, done.err
        made.append({path.name: path.read_bytes() for path in folder.glob("*.zip")})
    assert sorted(made[0]) == ["exam-canvas.zip", "exam-qti.zip"]
    assert made[0] == made[1]
    archive = zipfile.ZipFile(io.BytesIO(made[0]["exam-qti.zip"]))
    for name in archive.namelist():
        if name.endswith(".xml"):
            assert faults(etree.fromstring(archive.read(name))) == [], name
    test = etree.fromstring(archive.read("test.xml"))
    sections = test.findall(f"{QTI}testPart/{QTI}assessmentSection")
    assert [each.find(f"{QTI}selection") is not None for each in sections] == [True, False]
    quizzes = quizzes_of(made[0]["exam-canvas.zip"])
    assert [each.title for each in quizzes] == ["Final <exam> (1)", "Final <exam> (2)"]
    assert {float(each.settings["points_possible"]) for each in quizzes} == {15.0}
