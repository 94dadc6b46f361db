"""A class of sixty with four variants, from an empty folder to grades: `python -m benchmarks desk`.

Writes an exam, lets a simulated class take it, marks what comes back, mends what could not be read, marks again, and
exports the exam to three learning systems. Every mark, and every right number of the exports, is compared with what it
must be. The time of each step is printed, and the processor time of all processes that it started, which tells more on
a machine that others use too. `python -m benchmarks.class_of_sixty FOLDER [STUDENTS]` keeps the files.
"""

from __future__ import annotations

import csv
import ctypes
import json
import os
import random
import subprocess
import sys
import tempfile
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from fractions import Fraction
from functools import partial
from pathlib import Path
from time import perf_counter
from typing import NamedTuple

from benchmarks.simulated_class import MARKS, NAMES, QUESTIONS, Student, answer_file, numbers, sat

STUDENTS, VARIANTS, SEED = 60, 4, 2026
SET_CHILD_SUBREAPER = 36
UNREADABLE = (7, 23, 41)
STRANGER = "exam: ../exam.yaml\nvariant: 9\nstudent: A stranger\nanswers:\n  1: {a: {controllable: yes}}\n"


class Step(NamedTuple):
    """A step that was taken, with its seconds of wall time and of processor time."""

    name: str
    wall: float
    processor: float


class Play:
    """The play in a folder: the steps that were taken, and what is not as it must be."""

    def __init__(self, folder: Path, students: int) -> None:
        self.folder = folder
        self.count = students
        self.steps: list[Step] = []
        self.faults: list[str] = []
        self.students: list[Student] = []
        self.drawn: dict[int, Mapping[str, Fraction]] = {}

    def step(self, name: str, work: Callable[[], object]) -> None:
        """Take a step and keep its time."""
        wall, processor = perf_counter(), sum(os.times()[:4])
        work()
        wall = perf_counter() - wall
        reap()
        self.steps.append(Step(name, wall, sum(os.times()[:4]) - processor))
        print(f"{name:<52} {wall:>8.1f} s {self.steps[-1].processor:>8.1f} s", flush=True)

    def expect(self, *, that: bool, told: str) -> None:
        """Keep what is not as it must be."""
        if not that:
            self.faults.append(told)

    def solve(self, *words: str, codes: Sequence[int] = (0,)) -> str:
        """Run the command in the folder; return what it says on both channels."""
        environment = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[1])}
        done = subprocess.run(
            [sys.executable, "-m", "solver", *words],
            cwd=self.folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False,
        )  # fmt: skip
        told = done.stdout.decode()
        self.expect(
            that=done.returncode in codes, told=f"solve {' '.join(words)}: code {done.returncode}\n{told[-600:]}"
        )
        return told

    def write_exam(self) -> None:
        """Write the five questions, and the exam that names them."""
        for name, text in QUESTIONS.items():
            (self.folder / name).write_text(text, encoding="utf-8")
        listed = [f"  - {{problem: {name}, marks: {marks}}}\n" for name, marks in zip(QUESTIONS, MARKS, strict=True)]
        head = "exam: Modern control systems, final\ncourse: EE 451\ndate: 2026-06-12\nduration: 120 min\n"
        head += "instructions: Answer all questions. State each condition that you use.\nquestions:\n"
        tail = f"variants: {{count: {VARIANTS}}}\nseed: {SEED}\n"
        (self.folder / "exam.yaml").write_text(head + "".join(listed) + tail, encoding="utf-8")

    def hand_in(self) -> None:
        """Let the class write: a file each, some unreadable, and one of a stranger."""
        with (self.folder / "build" / "variants.csv").open(encoding="utf-8", newline="") as table:
            rows = list(csv.DictReader(table))
        drawn = [{key: Fraction(value) for key, value in each.items() if "." in key} for each in rows]
        self.drawn.update(enumerate(drawn, 1))
        dice = random.Random(SEED)
        (self.folder / "answers").mkdir()
        for place in range(self.count):
            variant = 1 + place % VARIANTS
            skill = dice.choice([0.95, 0.8, 0.8, 0.6, 0.6, 0.4, 0.2])
            student = sat(f"Student {place + 1:02}", variant, drawn[variant - 1], skill, dice)
            student.readable = place not in UNREADABLE
            self.students.append(student)
            self.file_of(student).write_text(answer_file(student), encoding="utf-8")
        (self.folder / "answers" / "stranger.yaml").write_text(STRANGER, encoding="utf-8")

    def file_of(self, student: Student) -> Path:
        """The answer file of a student."""
        return self.folder / "answers" / f"{student.name.lower().replace(' ', '-')}.yaml"

    def mark(self) -> None:
        """Mark the class: sheets, the table of grades, the report."""
        told = self.solve(
            "check", "exam.yaml", "answers/", "-f", "html", "-o", "sheets/", "--csv", "grades.csv",
            "--report", "report.html", codes=(1, 2),
        )  # fmt: skip
        readable = sum(student.readable for student in self.students)
        self.expect(that=f"marked {readable} of " in told, told=f"not all files were marked:\n{told[-600:]}")

    def mend(self) -> None:
        """Mend the files that could not be read, take the stranger's away, and mark again."""
        before = self.written()
        for student in self.students:
            if not student.readable:
                student.readable = True
                self.file_of(student).write_text(answer_file(student), encoding="utf-8")
        (self.folder / "answers" / "stranger.yaml").unlink()
        self.mark()
        after = self.written()
        mended = {self.file_of(self.students[place]).stem for place in UNREADABLE if place < self.count}
        changed = {name.partition(".")[0] for name, when in after.items() if before.get(name) != when}
        self.expect(that=changed == mended, told=f"a rerun wrote {len(changed)} sheets, {len(mended)} were mended")

    def written(self) -> dict[str, int]:
        """When each sheet was written."""
        return {path.name: path.stat().st_mtime_ns for path in (self.folder / "sheets").glob("*.html")}

    def compare(self) -> None:
        """Compare the grades with what was earned, part by part, and who must be looked at."""
        with (self.folder / "grades.csv").open(encoding="utf-8", newline="") as table:
            found = {row["student"]: row for row in csv.DictReader(table) if row["out of"]}
        read = [student for student in self.students if student.readable]
        self.expect(that=set(found) == {each.name for each in read}, told="other students in the table than were read")
        for student in read:
            told = found.get(student.name, {})
            for part, marks in (*student.earned.items(), ("total", student.total)):
                given = Fraction(told.get(part) or told.get(part.partition(".")[0]) or 0)
                self.expect(that=given == marks, told=f"{student.name}, {part}: {float(given)}, not {float(marks)}")
            if student.review:
                self.expect(that=told.get("needs review") == "yes", told=f"{student.name} needs review")

    def diagnose(self) -> None:
        """Compare what the marking says of exchanged signs with those that were exchanged."""
        told = self.solve("check", "exam.yaml", "answers/", "-f", "json", "-o", "marks.json", codes=(1, 2))
        data = json.loads((self.folder / "marks.json").read_text(encoding="utf-8"))
        reasons = {
            (each["student"], part["id"], name): answer.get("reason", "")
            for each in data if "error" not in each
            for part in each["parts"] for name, answer in part["answers"].items()
        }  # fmt: skip
        self.expect(that=bool(reasons), told=f"no data: {told[-300:]}")
        for student in self.students if reasons else ():
            for answer in student.signs:
                part = answer.removesuffix(".K").removesuffix(".P")
                reason = reasons.get((student.name, part, NAMES[answer]), "")
                said = any(word in reason for word in ("sign", "A + B", "A + L", "subtracted"))
                self.expect(that=said, told=f"{student.name}, {answer}: the sign is not named in '{reason}'")

    def read_back(self) -> None:
        """Compare what the exports take for right with what is."""
        from benchmarks.exports_read import FILES, READERS  # noqa: PLC0415 - the readers of the tests, and lxml

        right = {
            (part, variant): told for variant, drawn in self.drawn.items() for part, told in numbers(drawn).items()
        }
        for system, read in READERS.items():
            count, found = read(self.folder / "build" / FILES[system])
            print(f"  {system}: {count} questions, {sum(map(len, found.values()))} fields for numbers")
            told = {place: values for place, values in found.items() if values}
            self.expect(that=told == right, told=f"{system} takes other numbers for right")


def adopt() -> None:
    """Have the processes that a command leaves behind, its workers, counted here when they end (on Linux)."""
    with suppress(OSError, AttributeError):
        ctypes.CDLL(None).prctl(SET_CHILD_SUBREAPER, 1, 0, 0, 0)


def reap() -> None:
    """Wait for the processes that are left; their times are then among those of the children."""
    with suppress(OSError):
        while True:
            os.wait()


def play(folder: Path, students: int) -> Play:
    """Play the class through in an empty folder."""
    adopt()
    it = Play(folder, students)
    it.step("five families and the exam, written", it.write_exam)
    it.step(f"solve exam: {VARIANTS} papers and keys, HTML", lambda: it.solve("exam", "exam.yaml", "-o", "build/"))
    it.step("the same as PDF", lambda: it.solve("exam", "exam.yaml", "-o", "build/", "-f", "pdf", *engine()))
    it.step(f"{students} students write, and a stranger", it.hand_in)
    it.step("solve check: sheets, grades.csv, report.html", it.mark)
    it.step("grades compared with what was earned", it.compare)
    it.step(f"{len(UNREADABLE)} files mended, marked again", it.mend)
    it.step("grades compared again", it.compare)
    it.step("solve check -f json, diagnoses compared", it.diagnose)
    for system in ("moodle", "qti", "canvas"):
        it.step(
            f"solve exam --export {system}", partial(it.solve, "exam", "exam.yaml", "-o", "build/", "--export", system)
        )
    it.step("the exports read back", it.read_back)
    return it


def engine() -> tuple[str, ...]:
    """The option that makes PDF by typst where it is installed: it is the quicker one."""
    with suppress(ImportError):
        import typst  # noqa: F401, PLC0415 - whether it is there

        return ("--pdf-engine", "typst")
    return ()


def main(students: int = STUDENTS, keep: Path | None = None) -> int:
    """Play the class through, print the time of each step and what is wrong; return the exit code."""
    with tempfile.TemporaryDirectory() as name:
        folder = keep or Path(name)
        folder.mkdir(parents=True, exist_ok=True)
        it = play(folder, students)
    wall, processor = sum(each.wall for each in it.steps), sum(each.processor for each in it.steps)
    print(f"{'all':<52} {wall:>8.1f} s {processor:>8.1f} s")
    judged = sum(len(student.answers) for student in it.students)
    print(f"{len(it.students)} students, {judged} values typed, {len(it.faults)} faults")
    for fault in it.faults:
        print(f"! {fault}")
    return 1 if it.faults else 0


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[2:]), keep=Path(sys.argv[1]) if len(sys.argv) > 1 else None))
