"""The usual terms for verdicts and counts, English and German."""

import pytest
import sympy as sp

from solver.classroom.reading.expected import Expected
from solver.problem.source import Fault
from solver.tasks import catalogue
from tests.helpers.marked import marked
from tests.helpers.reading import a, read


def expected(task, name):
    return Expected.of(name, catalogue()[task].answers)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("stable", "asymptotically stable"),
        ("Stabil.", "asymptotically stable"),
        ("exponentially stable", "asymptotically stable"),
        ("globally asymptotically stable", "asymptotically stable"),
        ("stable but not asymptotically stable", "marginally stable"),
        ("stabil, aber nicht asymptotisch stabil", "marginally stable"),
        ("Lyapunov stable but not asymptotically stable", "marginally stable"),
        ("nicht stabil", "unstable"),
        ("The circuit is asymptotically stable since Re(λ) < 0.", "asymptotically stable"),
    ],
)
def test_a_verdict_of_stability_in_other_terms(text, value):
    found = read(f"'{text}'", "unstable", expected("stability", "verdict"))
    assert (found.value, found.respelt) == (value, True)


@pytest.mark.parametrize(
    "text", ["Lyapunov stable", "not asymptotically stable", "nicht asymptotisch stabil", "stable or unstable"]
)
def test_a_verdict_of_stability_that_is_not_clear_is_refused(text):
    with pytest.raises(Fault):
        read(text, "unstable", expected("stability", "verdict"))


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("spiral sink", "stable focus"),
        ("spiral source", "unstable focus"),
        ("nodal sink", "stable node"),
        ("nodal source", "unstable node"),
        ("asymptotically stable focus", "stable focus"),
        ("stabiler Fokus", "stable focus"),
        ("stabiler Knoten", "stable node"),
        ("unstable proper node", "unstable star"),
        ("stable star node", "stable star"),
        ("stable improper node", "stable degenerate node"),
        ("instabiler Sattel", "saddle"),
        ("Wirbelpunkt", "center"),
        ("line of fixed points", "line of equilibria"),
        ("every point is an equilibrium", "all points are equilibria"),
    ],
)
def test_a_kind_of_phase_portrait_in_other_terms(text, value):
    assert read(text, "stable focus", expected("phase_portrait", "kind")).value == value


@pytest.mark.parametrize("text", ["sink", "source", "spiral", "stable center", "not a stable focus"])
def test_a_kind_of_phase_portrait_that_is_not_clear_is_refused(text):
    with pytest.raises(Fault):
        read(text, "stable focus", expected("phase_portrait", "kind"))


@pytest.mark.parametrize(
    ("task", "name", "text", "value"),
    [
        ("controllability", "controllable", "vollständig steuerbar", True),
        ("controllability", "controllable", "nicht vollständig steuerbar", False),
        ("controllability", "controllable", "controllable, since rank 2", True),
        ("observability", "observable", "beobachtbar", True),
        ("observability", "observable", "nicht beobachtbar", False),
        ("stability", "bibo_stable", "stable", True),
        ("stability", "bibo_stable", "instabil", False),
        ("model_matching", "feasible", "infeasible", False),
        ("model_matching", "feasible", "impossible", False),
        ("eigenstructure", "diagonalizable", "nicht diagonalisierbar", False),
    ],
)
def test_the_adjective_of_an_answer_is_yes(task, name, text, value):
    assert read(f"'{text}'", True, expected(task, name)).value is value


@pytest.mark.parametrize("text", ["controllable, but not observable", "partially controllable", "beobachtbar"])
def test_an_adjective_of_something_else_is_refused(text):
    with pytest.raises(Fault, match="yes or no"):
        read(f"'{text}'", True, expected("controllability", "controllable"))


@pytest.mark.parametrize(
    ("text", "value"),
    [("2 in the right half plane", 2), ("two roots in the open right half-plane", 2), ("none", 0), ("keine", 0),
     ("no roots in the right half plane", 0), ("zwei Nullstellen in der rechten Halbebene", 2), ("2 RHP poles", 2)],
)  # fmt: skip
def test_a_count_in_words(text, value):
    assert read(text, sp.Integer(5), expected("routh_hurwitz", "right_half_plane_roots")).value == value


@pytest.mark.parametrize(
    "text", ["2 in the left half plane", "two in the left half plane, none in the right", "2 on the imaginary axis"]
)
def test_a_count_of_something_else_is_refused(text):
    with pytest.raises(Fault):
        read(f"'{text}'", sp.Integer(2), expected("routh_hurwitz", "right_half_plane_roots"))


@pytest.mark.parametrize(
    ("text", "verdict"),
    [("full rank", "correct"), ("voller Rang", "correct"), ("2 (full)", "correct"), ("rank 2", "correct"),
     ("1", "wrong"), ("1 (full)", "not judged"), ("not full rank", "not judged")],
)  # fmt: skip
@pytest.mark.parametrize("part", ["a", "b"])
def test_a_full_rank_is_as_great_as_the_question_allows(part, text, verdict):
    problem = """
system: {A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0]}
find: {a: controllability, b: {task: fundamental_subspaces, matrix: [[1, 0, 0], [0, 1, 0]]}}
"""
    assert marked(problem, f"answers:\n  {part}:\n    rank: {text}\n")[part].answers["rank"].verdict == verdict


def test_a_full_rank_of_an_unknown_size_is_refused():
    with pytest.raises(Fault, match="which number"):
        read("full rank", sp.Integer(2), expected("controllability", "rank"))


@pytest.mark.parametrize(
    ("text", "value"), [("rank 3, so observable", True), ("rank 2, hence not observable", False), ("rank 3, so", None)]
)
def test_a_conclusion_counts_not_what_it_comes_from(text, value):
    asked = expected("observability", "observable")
    if value is None:
        with pytest.raises(Fault):
            read(f"'{text}'", True, asked)
    else:
        assert read(f"'{text}'", True, asked).value is value


def test_sign_changes_are_roots_in_the_right_half_plane_only():
    assert read("2 sign changes", sp.Integer(1), expected("routh_hurwitz", "right_half_plane_roots")).value == 2
    with pytest.raises(Fault):
        read("2 sign changes", sp.Integer(1), expected("routh_hurwitz", "imaginary_axis_roots"))


@pytest.mark.parametrize("text", ["no zeros", "none", "keine Nullstellen", "there are no finite zeros", "No zeros."])
def test_no_zeros_is_an_empty_list(text):
    assert read(text, [a], expected("transfer_function", "zeros")).value == []


@pytest.mark.parametrize("text", ["no poles", "no real zeros"])
def test_nothing_of_something_else_is_no_empty_list(text):
    with pytest.raises(Fault, match="has no meaning here"):
        read(text, [a], expected("transfer_function", "zeros"))


@pytest.mark.parametrize(
    "text",
    [
        "yes, it is unobservable", "No: observable", "not observable: yes", "unobservable: no", "'rank = n'", "M = n",
        "observable, rank 2 → not observable",
    ],
)  # fmt: skip
def test_yes_and_no_at_once_is_neither(text):
    with pytest.raises(Fault):
        read(f"'{text}'" if "'" not in text else text, True, expected("observability", "observable"))


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Observable since rank = n", True),
        ("observable = yes", True),
        ("The system is: observable", True),
        ("det ≠ 0 → observable", True),
        ("rank 1 => not observable", False),
        ("No: the last column is zero", False),
        ("not completely state observable", False),
    ],
)
def test_a_property_with_what_it_follows_from(text, value):
    assert read(f"'{text}'", True, expected("observability", "observable")).value is value
