"""Mark the answers that the course's note prints, and write docs/errata.md: which are wrong, where, and what is right.

    python tools/errata.py            write docs/errata.md
    python tools/errata.py --check    only say whether it is up to date (exit code 1 if not)

The printed answers are answer files like a student's, problems/course/printed/<entry>.answers.yaml.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import sympy as sp

from solver.classroom import Verdict, mark, read_submission
from solver.classroom.reading.answer_file import node_naming
from solver.classroom.report.words import wrong_places
from solver.classroom.verdicts import AnswerVerdict
from solver.engine import Solution, solve_problem
from solver.problem.files import load
from solver.problem.reader import read_problem
from solver.render.plain import sympy_text
from solver.tasks import catalogue

ROOT = Path(__file__).parents[1]
PRINTED = ROOT / "problems" / "course" / "printed"
PAGE = ROOT / "docs" / "errata.md"
LONGEST = 60
DIGITS = 5

HEAD = """\
# Errata of the lecture note

Made by `make errata` from the answer files in `problems/course/printed/`: every result that the note prints for a
problem of `problems/course/` is marked as a student's answer is, by the property that defines it. Listed are the ones
that fail. What is given as right has passed the checks; where several answers are right it is one of them.
"""


@dataclass(frozen=True)
class Line:
    """One wrong value."""

    chapter: str
    entry: str
    part: str
    answer: str
    printed: str
    right: str
    words: str

    def row(self) -> str:
        """Return the line of the table."""
        cells = (self.entry, self.part, f"`{self.answer}`", self.printed, self.right, self.words)
        return f"| {' | '.join(cell.replace('|', '∣') for cell in cells)} |"


def problem_of(path: Path) -> Path:
    """Return the file of the problem that an answer file is about."""
    named = node_naming(load(path), "problem")
    return (path.parent / (named.text.strip() if named else "")).resolve()


def solved(path: Path) -> Solution:
    """Return the solution of the problem in a file."""
    return solve_problem(read_problem(load(path), catalogue()))


def marked(path: Path, solving: Callable[[Path], Solution] = solved) -> tuple[int, list[Line], list[str]]:
    """Return how many values an answer file holds, its wrong ones, and what could not be judged."""
    source, name = load(path), problem_of(path)
    solution = solving(name)
    submission = read_submission(source, solution.problem)
    chapter = name.parent.name
    entry = path.name.removesuffix(".answers.yaml")
    ours: dict[str, dict[str, Any]] = {}
    for result in solution.parts:
        ours[result.id] = {**result.answers, **ours.get(result.id, {})}
    count, lines, open_ = 0, [], []
    for part in mark(solution, submission).parts:
        for answer in part.answers.values():
            count += 1
            if answer.verdict is Verdict.WRONG or answer.follows:
                right = shown(ours[part.id].get(answer.name))
                words = in_words(answer)
                printed = f"`{as_written(submission.answers[part.id][answer.name].plain())}`"
                lines.append(Line(chapter, entry, part.id, answer.name, printed, right, words))
            elif answer.verdict is Verdict.NOT_JUDGED:
                open_.append(f"{entry} {part.id} `{answer.name}`: {answer.reason}")
    return count, lines, open_


def as_written(value: Any) -> str:
    """Return a value as the answer file has it."""
    if isinstance(value, dict):
        return f"{{{', '.join(f'{name}: {as_written(each)}' for name, each in value.items())}}}"
    return f"[{', '.join(map(as_written, value))}]" if isinstance(value, list) else str(value)


def in_words(answer: AnswerVerdict) -> str:
    """Return what is wrong, and where; of what follows from another wrong value, from which."""
    if answer.follows:
        return str(answer.note).replace("your own", "the printed")
    places = wrong_places(answer)
    where = f"wrong at {'; '.join(places)}" if places else ""
    return "; ".join(filter(None, (answer.reason, where)))


def shown(value: Any) -> str:
    """Return a value as code; long exact numbers as decimals."""
    text = plain(value)
    if len(text) > LONGEST or re.search(r"\d\.\d{6}", text):
        text = plain(in_decimals(value))
    return f"`{text}`" if text else "–"


def plain(value: Any) -> str:
    """Return a value as an answer file has it."""
    if value is None:
        return ""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, list | tuple):
        return f"[{', '.join(map(plain, value))}]"
    if isinstance(value, sp.MatrixBase):
        return f"[{', '.join(plain(list(row)) for row in value.tolist())}]"
    return sympy_text(value).replace("**", "^").replace("*", " ")


def in_decimals(value: Any) -> Any:
    """Return a value with its irrational and long numbers as decimals."""
    if isinstance(value, list | tuple):
        return [in_decimals(each) for each in value]
    if isinstance(value, sp.MatrixBase):
        return value.applyfunc(in_decimals)
    if isinstance(value, sp.Expr):
        return value.xreplace({each: short(each) for each in numbers(value)}) if not value.is_number else short(value)
    return value


def numbers(value: sp.Expr) -> Iterator[sp.Expr]:
    """Yield the constant parts of an expression that are neither integers nor exponents of a variable."""
    if value.is_number:
        if not value.is_Integer:
            yield value
    elif not value.is_Pow:
        for part in value.args:
            yield from numbers(part)


def short(number: sp.Expr) -> sp.Expr:
    """Return a number to a few digits, as a symbol that prints as it is written."""
    real, imaginary = number.evalf(30).as_real_imag()
    if number.is_Integer:
        return number
    parts = [sp.Symbol(f"{float(part):.{DIGITS}g}") for part in (real, imaginary)]
    return parts[0] + (sp.I * parts[1] if imaginary else 0)


def page() -> str:
    """Return the page."""
    total, lines, open_ = 0, [], []
    for path in sorted(PRINTED.glob("*.answers.yaml")):
        count, wrong, undecided = marked(path)
        total += count
        lines += wrong
        open_ += undecided
    text = [HEAD, f"Of {total} printed values {len(lines)} are wrong."]
    text += [f"{len(open_)} could not be judged:", "", *(f"- {each}" for each in open_)] if open_ else []
    for chapter in sorted({line.chapter for line in lines}, key=lambda each: (not each.startswith("ch"), each)):
        text += ["", f"## {title(chapter)}", ""]
        text += ["| entry | part | answer | printed | right | what is wrong |", "|---|---|---|---|---|---|"]
        text += [line.row() for line in lines if line.chapter == chapter]
    return "\n".join(text) + "\n"


def title(folder: str) -> str:
    """Return "Chapter 3" for ch3."""
    return f"Chapter {folder[2:]}" if folder.startswith("ch") and folder[2:].isdigit() else folder.capitalize()


def main(arguments: list[str]) -> int:
    """Write the page, or with --check compare it."""
    text = page()
    if "--check" in arguments:
        current = PAGE.read_text(encoding="utf-8") if PAGE.exists() else ""
        if current != text:
            print("docs/errata.md is not up to date; run `make errata`", file=sys.stderr)
        return int(current != text)
    PAGE.write_text(text, encoding="utf-8")
    print(f"wrote {PAGE.relative_to(ROOT)}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
