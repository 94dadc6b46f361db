"""A small exam: a family, a problem that is the same in all variants, and one that stands in the exam itself."""

from tests.papers.conftest import FAMILY

PROBLEM = """\
title: Step response
system: {transfer_function: "2/(s+4)"}
find:
  a: {task: stability, marks: 1}
  b: {task: transfer_function, marks: {poles: 1, zeros: 1}}
"""

EXAM = """\
exam: Final <exam>
course: EE & 451
date: 2026-06-12
duration: 120 min
instructions: |
  Answer *all*, with $K > 0$.
questions:
  - {problem: family.yaml, marks: 10}
  - {problem: step.yaml, marks: 20, page_break: yes}
  - problem:
      system: {A: [[0, 1], [-2, -3]], B: [0, 1]}
      find: {a: stability, b: controllability, c: {task: eigenstructure, answers: [eigenvalues]}}
    marks: 20
variants: {count: 2}
seed: 2026
"""


def write_exam(folder, text=EXAM, **files):
    """Write the exam and the problems that it names; return the name of its file."""
    for name, content in {"exam": text, "family": FAMILY, "step": PROBLEM, **files}.items():
        (folder / f"{name}.yaml").write_text(content, encoding="utf-8")
    return "exam.yaml"
