"""Arithmetic as on paper: the lines between a formula with numbers put in and its result, shown at the level `tutor`.

Each function returns substeps for the step that states the formula: `Step(…, steps=multiplied(A, B, AB))`. They know no
topic; every line of them is a claim.
"""
