"""A class that takes an exam: its questions, what each student writes, and the marks that this must earn.

What is right is worked out here by formulas of its own, and what a student's values earn by how they were made, so that
grades are compared with a truth that the program has no part in.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from math import isqrt

QUESTIONS: Mapping[str, str] = {
    "placement.yaml": """\
title: Pole placement by state feedback
parameters: {a: 2, b: 3, p: -4}
vary: {a: {from: -9, to: 9}, b: {from: -9, to: 9}, p: {choose: [-4, -5, -6, -7]}}
require: ["a != 0", "b != 0", "a - 3 p != 0", "b + 3 - p != 0", unstable]
nice: {b.K: integers}
system: {A: [[0, 1], [a, b]], B: [0, 1]}
find:
  a: {task: controllability, marks: 4, answers: [controllable]}
  b: {task: pole_placement, poles: [p, -3], marks: 6, answers: [K]}
""",
    "regulator.yaml": """\
title: A regulator of the double integrator
parameters: {q: 9, v: 10}
vary: {q: {from: 1, to: 100}, v: {from: 0, to: 60}}
nice: {a.P: integers}
system: {A: [[0, 1], [0, 0]], B: [0, 1]}
find:
  a: {task: lqr, Q: [[q, 0], [0, v]], R: 1, answers: [P, K]}
""",
    "motion.yaml": """\
title: Motion of a free system
parameters: {a: 1, b: 3}
vary: {a: {from: 1, to: 4}, b: {from: 3, to: 9}}
require: ["a < b"]
system: {A: [[0, 1], ["-a b", "-(a + b)"]], initial_state: [1, 0]}
find:
  a: {task: state_transition_matrix, marks: 15}
  b: {task: response, kind: zero_input, marks: 10, answers: [x]}
""",
    "step.yaml": """\
title: Step response
parameters: {a: 1, c: 2}
vary: {a: {from: 1, to: 9}, c: {from: 1, to: 12}}
system: {transfer_function: "c/(s + a)"}
find:
  a: {task: stability, marks: 5}
  b: {task: response, kind: zero_state, input: "step(t)", marks: 10, answers: [y]}
""",
    "observer.yaml": """\
title: An observer
parameters: {a: 2, b: 1, p: -6}
vary: {a: {from: -9, to: 9}, b: {from: -5, to: 5}, p: {choose: [-6, -7, -8]}}
require: ["a != 0", "b != 0", "b + 4 - p != 0"]
nice: {a.L: integers}
system: {A: [[0, 1], [a, b]], B: [0, 1], C: [1, 0]}
find:
  a: {task: observer, poles: [p, -4], answers: [L]}
""",
}
"""The five questions: a file each."""

MARKS = (20, 20, 25, 15, 20)
ANSWERS = ("1.a", "1.b", "2.a.P", "2.a.K", "3.a", "3.b", "4.a", "4.b", "5.a")
Values = Mapping[str, Fraction]
Marks = Mapping[str, Fraction]


@dataclass
class Student:
    """A student: the file that is handed in, and what it must earn by part; `readable` is the file."""

    name: str
    variant: int
    answers: dict[str, str] = field(default_factory=dict)
    earned: dict[str, Fraction] = field(default_factory=dict)
    signs: list[str] = field(default_factory=list)  # the answers in which a sign was exchanged
    review: bool = False
    readable: bool = True

    @property
    def total(self) -> Fraction:
        """The marks of all parts."""
        return sum(self.earned.values(), Fraction(0))


@dataclass(frozen=True)
class Choice:
    """What may be written for an answer: the text, its share of the marks, whether someone must look at it."""

    text: str
    share: Fraction
    sign: bool = False
    review: bool = False


RIGHT, NOTHING = Fraction(1), Fraction(0)
NONSENSE = ("no idea", "see the other page", "42 bananas", "?!", "a matrix, I think")


def number(value: Fraction) -> str:
    """A number as it is written by hand."""
    return str(value)


def decimal(value: Fraction) -> str:
    """A number to four digits, as a pocket calculator shows it."""
    return f"{float(value):.4g}"


def row(*values: Fraction) -> str:
    """A row as YAML."""
    return f"[{', '.join(map(number, values))}]"


def of_row(right: tuple[Fraction, ...], dice: random.Random) -> tuple[Choice, ...]:
    """What is written for a row of numbers that are not zero: right in three forms, wrong in three."""
    texts = [
        row(*right),
        f"'[{' '.join(map(number, right))}]'",
        f"[{', '.join(f'{float(each):.2f}' for each in right)}]",
    ]
    slip = (right[0], right[1] + dice.choice([-1, 1]))
    return (
        Choice(dice.choice(texts), RIGHT),
        Choice(row(*(-each for each in right)), NOTHING, sign=True),
        Choice(row(*slip), Fraction(1, 2)),
    )


def gain(values: Values) -> tuple[Fraction, Fraction]:
    """K of question 1: s² − (b − k₂)s − (a − k₁) is to be (s − p)(s + 3)."""
    a, b, p = values["1.a"], values["1.b"], values["1.p"]
    return a - 3 * p, b + 3 - p


def riccati(values: Values) -> tuple[Fraction, Fraction]:
    """K of question 2, the second row of P: p₁₂ = √q, p₂₂ = √(v + 2√q); p₁₁ = p₁₂p₂₂."""
    first = Fraction(isqrt(int(values["2.q"])))
    return first, Fraction(isqrt(int(values["2.v"] + 2 * first)))


def injection(values: Values) -> tuple[Fraction, Fraction]:
    """L of question 5: s² + (l₁ − b)s + l₂ − b l₁ − a is to be (s − p)(s + 4)."""
    a, b, p = values["5.a"], values["5.b"], values["5.p"]
    first = 4 - p + b
    return first, b * first + a - 4 * p


def numbers(values: Values) -> dict[str, list[Fraction]]:
    """The right numbers of the parts that a learning system can mark, row by row."""
    first, last = riccati(values)
    return {
        "1.b": [*gain(values)],
        "2.a": [first * last, first, first, last, first, last],
        "5.a": [*injection(values)],
    }


def placement(values: Values, dice: random.Random) -> dict[str, tuple[Choice, ...]]:
    """Question 1: whether it is controllable, and the gain."""
    verdicts = (Choice(dice.choice(["yes", "true", "controllable"]), RIGHT), Choice("no", NOTHING))
    return {"1.a": verdicts, "1.b": of_row(gain(values), dice)}


def regulator(values: Values, dice: random.Random) -> dict[str, tuple[Choice, ...]]:
    """Question 2: P and K; a slip in the last entry of P goes on into K, which is right with it."""
    first, last = riccati(values)
    right = f"[[{first * last}, {first}], [{first}, {last}]]"
    slip = f"[[{first * last}, {first}], [{first}, {last + 1}]]"
    gains = of_row((first, last), dice)
    return {
        "2.a.P": (Choice(right, RIGHT), Choice(slip, Fraction(3, 4))),
        "2.a.K": (gains[0], Choice(row(first, last + 1), RIGHT), gains[1]),
    }


def motion(values: Values, dice: random.Random) -> dict[str, tuple[Choice, ...]]:
    """Question 3: Φ of the eigenvalues −a and −b by residues; x is its first column."""
    a, b = values["3.a"], values["3.b"]

    def entries(write: Callable[[Fraction], str], sign: str = "-") -> list[str]:
        scale = 1 / (b - a)
        weights = ((b, -a), (1, -1), (-a * b, a * b), (-a, b))
        terms = [(write(first * scale), write(second * scale)) for first, second in weights]
        return [f"({first}) e^({sign}{a} t) + ({second}) e^({sign}{b} t)" for first, second in terms]

    def matrix(of: list[str]) -> str:
        return f'"[[{of[0]}, {of[1]}], [{of[2]}, {of[3]}]]"'

    def column(of: list[str]) -> str:
        return f'"[{of[0]}, {of[2]}]"'

    write = dice.choice([number, decimal])
    slip = [*entries(write)[:3], f"{entries(write)[3]} + t"]
    return {
        "3.a": (
            Choice(matrix(entries(write)), RIGHT),
            Choice(matrix(entries(number, "")), NOTHING, sign=True),
            Choice(matrix(slip), Fraction(3, 4)),
        ),
        "3.b": (Choice(column(entries(write)), RIGHT), Choice(column(entries(number, "")), NOTHING, sign=True)),
    }


def step(values: Values, dice: random.Random) -> dict[str, tuple[Choice, ...]]:
    """Question 4: y = (c/a)(1 − e^(−at))."""
    a, c = values["4.a"], values["4.c"]
    write = dice.choice([number, decimal])
    forms = [f'"({write(c / a)}) (1 - e^(-{a} t))"', f'"{write(c / a)} - {write(c / a)} exp(-{a} t)"']
    verdicts = (Choice(dice.choice(["asymptotically stable", "stable"]), RIGHT), Choice("unstable", NOTHING))
    return {
        "4.a": verdicts,
        "4.b": (Choice(dice.choice(forms), RIGHT), Choice(f'"({c / a}) (1 - e^({a} t))"', NOTHING, sign=True)),
    }


def observer(values: Values, dice: random.Random) -> dict[str, tuple[Choice, ...]]:
    """Question 5: the gain of the observer."""
    return {"5.a": of_row(injection(values), dice)}


SHARES: Mapping[str, tuple[str, int]] = {
    "1.a": ("1.a", 8), "1.b": ("1.b", 12), "2.a.P": ("2.a", 10), "2.a.K": ("2.a", 10), "3.a": ("3.a", 15),
    "3.b": ("3.b", 10), "4.a": ("4.a", 5), "4.b": ("4.b", 10), "5.a": ("5.a", 20),
}  # fmt: skip
"""The part to which an answer belongs, and its marks in the exam."""
NAMES = {
    "1.a": "controllable",
    "1.b": "K",
    "2.a.P": "P",
    "2.a.K": "K",
    "3.a": "Phi",
    "3.b": "x",
    "4.a": "verdict",
    "4.b": "y",
    "5.a": "L",
}
"""What an answer is called in an answer file."""


def sat(name: str, variant: int, values: Values, skill: float, dice: random.Random) -> Student:
    """A student of some skill, who answers each question rightly with that chance, else errs, guesses, or leaves it."""
    student = Student(name, variant, earned=dict.fromkeys((part for part, _ in SHARES.values()), Fraction(0)))
    choices: dict[str, tuple[Choice, ...]] = {}
    for question in (placement, regulator, motion, step, observer):
        choices |= question(values, dice)
    for answer in ANSWERS:
        chosen = written(student, answer, choices[answer], skill, dice)
        if chosen is None:
            continue
        part, marks = SHARES[answer]
        student.answers[answer] = chosen.text
        student.earned[part] += marks * chosen.share
        student.review = student.review or chosen.review
        if chosen.sign:
            student.signs.append(answer)
    return student


def written(
    student: Student, answer: str, choices: tuple[Choice, ...], skill: float, dice: random.Random
) -> Choice | None:
    """What a student writes for an answer, None for nothing. K is made from the P that was written."""
    if answer == "2.a.K" and "2.a.P" in student.answers:
        slipped = student.earned["2.a"] not in (0, 10)
        right, follows, sign = choices
        return dice.choices([follows if slipped else right, sign], [skill + 0.2, 0.8 - skill])[0]
    if answer == "2.a.K":
        choices = (choices[0], choices[2])
    draw = dice.random()
    if draw < skill:
        return choices[0]
    if draw < skill + 0.7 * (1 - skill):
        return dice.choice(choices[1:])
    return Choice(f'"{dice.choice(NONSENSE)}"', NOTHING, review=True) if draw > 1 - 0.1 * (1 - skill) else None


def answer_file(student: Student) -> str:
    """The file that a student hands in; one that is not readable lacks a bracket."""
    lines = ["exam: ../exam.yaml", f"variant: {student.variant}", f"student: {student.name}", "answers:"]
    for question in range(1, 6):
        parts = sorted({SHARES[answer][0] for answer in student.answers if answer.startswith(f"{question}.")})
        lines += [f"  {question}:"] if parts else []
        for part in parts:
            lines.append(f"    {part.partition('.')[2]}:")
            given = [answer for answer in student.answers if SHARES[answer][0] == part]
            lines += [f"      {NAMES[answer]}: {student.answers[answer]}" for answer in given]
    text = "\n".join(lines) + "\n"
    return text if student.readable else text.replace("answers:", "answers: {1: {a: {controllable: yes}", 1)
