"""Commented files to start from that are not about one task: an exam, a family of problems."""

from __future__ import annotations

FAMILY = """\
# A family: one question with many sets of numbers. `solve FILE` solves its default member, that of `parameters`;
# `solve variants FILE --count 4 --seed 7 --check` draws others, each solved and verified.
title: Pole placement by state feedback
parameters: {a: 1, b: 2, p: -3}            # the default member
vary:                                      # other values of names under parameters
  a: {from: -4, to: 4}                     # whole numbers; step: 1/2 for halves
  b: {from: 1, to: 3}
  p: {choose: [-5, -4, -3]}                # or a list
require:                                   # what must hold: <, <=, >, >=, !=, = between the names that are drawn,
  - "a != b"
  - controllable                           # or a word: controllable, observable, minimal, stable, unstable
nice: {a.K: integers}                      # what must come out, by part and answer: integers, rationals or exact
system:
  A: [[0, 1], [a, b]]
  B: [0, 1]
find:
  a: {task: pole_placement, poles: [p, -1], marks: 6}
"""

EXAM = """\
# An exam. `solve exam FILE` writes a paper and a key for each variant, and files to fill in;
# `solve check FILE answers/ --csv grades.csv --report report.html` marks what comes back.
exam: Modern control systems, final
# course: EE 451
# date: 2026-06-12
# duration: 120 min
instructions: |                            # Markdown with $math$
  Answer all questions. Show your work.
questions:
  - marks: 12                              # scales the marks of the parts
    problem:                               # a problem as it stands here, or the name of a file: problem: poles.yaml
      title: Pole placement by state feedback
      parameters: {a: 1, b: 2, p: -3}
      vary: {a: {from: -4, to: 4}, b: {from: 1, to: 3}, p: {choose: [-5, -4, -3]}}   # each variant has other numbers
      require: ["a != b", controllable]
      nice: {b.K: integers}
      system: {A: [[0, 1], [a, b]], B: [0, 1]}
      find:
        a: {task: controllability, marks: 2}
        b: {task: pole_placement, poles: [p, -1], marks: 4}
  # - {problem: regulator.yaml, marks: 8, page_break: true}
variants: {count: 2}                       # or {students: class.csv}: a paper for each student
seed: 2026                                 # the same seed draws the same papers anywhere
"""

BEGINNINGS = {
    "exam": (EXAM, "write the papers with: solve exam {file}"),
    "family": (FAMILY, "solve it with: solve {file}; draw members with: solve variants {file}"),
}
"""By name: a file that can be used as it stands, and what to do with it."""
