"""Two small problem files: one that can be solved, one with a mistake."""

GOOD = """\
title: A small problem
system: {A: [[0, 1], [-2, -3]]}
find:
  a: characteristic_polynomial
  b: {task: eigenstructure, marks: 2.5}
"""
BAD = GOOD.replace("eigenstructure", "eigenstructur")
