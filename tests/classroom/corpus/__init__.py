"""A corpus of submissions: what students type, with the truth of each established apart from the program.

Each case has the typed text and, beside it, what the text means in numbers. A judge by numpy and scipy tells from the
question's data whether that is right, so that a slip in the corpus is found as well as one in the marking.
`python -m tests.classroom.corpus` prints how each kind of form and mistake is marked.
"""
