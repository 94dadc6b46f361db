"""The class of the benchmark: what it takes for right the program finds, and a small class is marked as it must be."""

from fractions import Fraction

import pytest
import yaml

import solver
from benchmarks.class_of_sixty import Play
from benchmarks.simulated_class import ANSWERS, NAMES, QUESTIONS, SHARES, Student, answer_file, numbers, sat

DEFAULTS = {"1.a": 2, "1.b": 3, "1.p": -4, "2.q": 9, "2.v": 10, "3.a": 1, "3.b": 3, "4.a": 1, "4.c": 2}
DEFAULTS |= {"5.a": 2, "5.b": 1, "5.p": -6}
VALUES = {name: Fraction(value) for name, value in DEFAULTS.items()}


class Dice:
    """Draws that always fall in the same way."""

    def __init__(self, drawn):
        self.drawn = drawn

    def random(self):
        return self.drawn

    def choice(self, among):
        return among[0]

    def choices(self, among, _weights):
        return [among[0]]


@pytest.mark.parametrize(("file", "part", "names"), [
    ("placement.yaml", "1.b", ["K"]), ("regulator.yaml", "2.a", ["P", "K"]), ("observer.yaml", "5.a", ["L"]),
])  # fmt: skip
def test_the_right_numbers_are_those_of_the_program(file, part, names):
    solved = solver.solve(QUESTIONS[file]).answers[part.partition(".")[2]]
    assert [int(each) for name in names for each in solved[name]] == numbers(VALUES)[part]


def test_a_student_who_knows_all_earns_all_and_one_who_knows_nothing_nothing():
    best = sat("A", 1, VALUES, 1.0, Dice(0.5))
    assert (best.total, list(best.answers)) == (100, list(ANSWERS))
    blank = sat("B", 1, VALUES, 0.0, Dice(0.8))
    assert (blank.total, blank.answers) == (0, {})
    guessing = sat("C", 1, VALUES, 0.0, Dice(0.95))
    assert guessing.total == 10  # K is made by a rule of its own: here it is right
    assert guessing.review


def test_a_file_has_each_answer_in_its_place_and_one_that_is_not_readable_is_no_yaml():
    student = sat("A", 2, VALUES, 1.0, Dice(0.5))
    told = yaml.safe_load(answer_file(student))
    assert (told["variant"], told["student"]) == (2, "A")
    for answer in ANSWERS:
        question, part = SHARES[answer][0].split(".")
        assert NAMES[answer] in told["answers"][int(question)][part]
    student.readable = False
    with pytest.raises(yaml.YAMLError):
        yaml.safe_load(answer_file(student))


@pytest.mark.slow
def test_a_small_class_is_marked_as_it_must_be_and_a_wrong_truth_is_seen(tmp_path):
    play = Play(tmp_path, 8)
    play.write_exam()
    play.solve("exam", "exam.yaml", "-o", "build/")
    play.hand_in()
    play.mark()
    play.compare()
    assert play.faults == []
    play.mend()
    play.compare()
    assert play.faults == []
    play.students[0].earned["1.b"] += 1
    play.students.append(Student("A stranger", 1))
    play.compare()
    assert [fault.partition(":")[0] for fault in play.faults] == [
        "other students in the table than were read", "Student 01, 1.b", "Student 01, total",
    ]  # fmt: skip
