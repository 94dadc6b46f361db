"""Signal-flow graphs: textbook results by both methods, random graphs against linear equations, faults in place."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.derivation import Status
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.systems import SignalFlow
from solver.systems.signal_flow import Branch
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected
from tests.helpers.marked import verdict

s = sp.Symbol("s")
G1, G2, G3, G4, G5, G6, H1, H2, H3 = sp.symbols("G1:7 H1:4", real=True)
METHODS = ("mason", "elimination")


def graph(*branches, output="y"):
    return SignalFlow(tuple(Branch(a, b, sp.sympify(gain)) for a, b, gain in branches), "r", output)


NESTED = graph(
    ("r", "a", 1), ("a", "b", G1), ("b", "c", G2), ("c", "y", G3), ("c", "b", -H1), ("y", "a", -H2)
)  # fmt: skip
APART = graph(
    ("r", "a", G1), ("a", "b", G2), ("b", "y", G3), ("r", "c", G4), ("c", "d", G5), ("d", "y", G6),
    ("b", "a", -H1), ("d", "c", -H2),
)  # fmt: skip
FORWARD = graph(("r", "e", 1), ("e", "x", G1), ("x", "y", G2), ("y", "e", -H1), ("r", "x", G3), ("r", "y", G4))
OWN = graph(("r", "x", G1), ("x", "x", H1), ("x", "y", G2), ("y", "y", H2), ("y", "x", -H3))
PARALLEL = graph(("r", "e", 1), ("e", "y", G1), ("e", "y", G2), ("y", "e", -1))
NUMBERS = graph(("r", "e", 1), ("e", "u", 10 * (s + 1) / s), ("u", "y", 1 / (s + 2)), ("y", "e", -1), ("r", "u", 3))

TEXTBOOK = [
    (NESTED, G1 * G2 * G3 / (1 + G2 * H1 + G1 * G2 * G3 * H2), (1, 2, 0)),
    (
        APART,
        (G1 * G2 * G3 * (1 + G5 * H2) + G4 * G5 * G6 * (1 + G2 * H1)) / ((1 + G2 * H1) * (1 + G5 * H2)),
        (2, 2, 1),
    ),
    (FORWARD, (G1 * G2 + G3 * G2 + G4) / (1 + G1 * G2 * H1), (3, 1, 0)),
    (OWN, G1 * G2 / (1 - H1 - H2 + G2 * H3 + H1 * H2), (1, 3, 1)),
    (PARALLEL, (G1 + G2) / (1 + G1 + G2), (1, 1, 0)),
    (NUMBERS, (13 * s + 10) / (s**2 + 12 * s + 10), (2, 1, 0)),
]


LOOP = graph(("r", "a", G1), ("a", "b", G2), ("b", "a", H1), ("b", "y", G3), ("y", "y", H2))


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    ("system", "above", "below"),
    [
        (LOOP, G1 * G2 * G3, 1 - G2 * H1 - H2 + G2 * H1 * H2),
        (FORWARD, G1 * G2 + G2 * G3 + G4, 1 + G1 * G2 * H1),
    ],
)
def test_the_transfer_function_has_the_signs_of_the_determinant(system, above, below, method):
    result = ask("block_diagram_reduction", system, method)
    found = sp.fraction(result.answers["G"])
    assert found == (above, sp.expand(below))


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(("system", "wanted", "counts"), TEXTBOOK)
def test_results_of_the_textbooks(system, wanted, counts, method):
    result = ask("block_diagram_reduction", system, method)
    assert result.status is Status.VERIFIED
    assert sp.cancel(sp.together(result.answers["G"] - wanted)) == 0
    if method == "mason":
        (apart,) = (step.values["rows"] for step in result.steps if step.kind == "apart")
        assert (len(result.answers["forward_paths"]), len(result.answers["loops"]), len(apart)) == counts


def test_the_steps_of_both_methods():
    kinds = [step.kind for step in ask("block_diagram_reduction", APART, "mason").steps]
    assert kinds == ["graph", "paths", "loops", "apart", "determinant", "cofactors", "transfer"]
    result = ask("block_diagram_reduction", NESTED, "elimination")
    assert [step.kind for step in result.steps] == ["graph", "equations", *["eliminate"] * 3, "last"]
    drawn = [step for first in result.steps for step in first.walk() if step.figures]
    assert len(drawn) == 4


@st.composite
def graphs(draw):
    """A path from r to y with branches anywhere, gains small numbers or rational in s."""
    names = ["r", *(f"x{i}" for i in range(draw(st.integers(1, 3)))), "y"]
    gains = st.sampled_from([1, -1, 2, -3, 1 / (s + 1), -2 / s, (s + 1) / (s + 4)])
    edges = {(a, b): draw(gains) for a, b in pairwise(names)}
    for _ in range(draw(st.integers(0, 4))):
        pair = (draw(st.sampled_from(names)), draw(st.sampled_from(names[1:])))
        edges.setdefault(pair, draw(gains))
    return graph(*((a, b, gain) for (a, b), gain in edges.items()))


@settings(max_examples=25)
@given(graphs())
def test_random_graphs_are_solved_as_numpy_does(system):
    results = [ask("block_diagram_reduction", system, method) for method in METHODS]
    at = 0.37 + 0.81j
    names = list(system.nodes)
    M = np.eye(len(names), dtype=complex)
    for each in system.branches:
        M[names.index(each.target), names.index(each.source)] -= complex(each.gain.subs(s, at))
    singular = abs(np.linalg.det(M)) < 1e-9
    for result in results:
        assert result.status is (Status.UNSOLVED if singular else Status.VERIFIED) or "itself" in str(result.reason)
        if result.status is Status.VERIFIED:
            y = np.linalg.solve(M, np.eye(len(names))[names.index("r")])[names.index("y")]
            assert complex(result.answers["G"].subs(s, at)) == pytest.approx(y)


def test_corrupted_answers_are_rejected():
    right = ask("block_diagram_reduction", APART, "mason").answers
    assert not rejected("block_diagram_reduction", APART, dict(right))
    for name, values in {
        "G": [right["G"] + 1, -right["G"], right["G"].subs(H1, -H1)],
        "determinant": [right["determinant"] - G2 * G5 * H1 * H2, -right["determinant"]],
        "forward_paths": [right["forward_paths"][:1], [-right["forward_paths"][0], right["forward_paths"][1]]],
        "loops": [[], [*right["loops"], right["loops"][0]], [-each for each in right["loops"]]],
    }.items():
        for value in values:
            assert rejected("block_diagram_reduction", APART, {name: value}), (name, value)


def test_what_is_no_graph_to_be_solved_is_said():
    result = ask("block_diagram_reduction", graph(("r", "x", 1), ("x", "x", 1), ("x", "y", 1)), "mason")
    assert result.status is Status.UNSOLVED
    assert "ill-posed" in str(result.reason)


def test_other_tasks_take_a_graph_as_a_transfer_function():
    assert ask("transfer_function", NUMBERS).answers["G"] == sp.cancel((13 * s + 10) / (s**2 + 12 * s + 10))
    assert ask("stability", NUMBERS, "routh").answers["verdict"] == "asymptotically stable"
    hidden = graph(("r", "x", (s - 1) / (s + 2)), ("x", "y", 1 / (s - 1)))
    assert ask("stability", hidden, "routh").answers["verdict"] == "unstable"


PAPER = """\
system:
  signal_flow: [[r, a, G1], [a, b, G2], [b, y, G3], [b, a, -H1], [y, y, -H2]]
  input: r
  output: y
find:
  a: block_diagram_reduction
"""


@pytest.mark.parametrize(
    ("name", "value", "said"),
    [
        ("G", "G1 G2 G3/((1 + G2 H1)(1 + H2))", ""),
        ("G", "G1 G2 G3/(1 + G2 H1 + H2)", "do not touch are missing"),
        ("G", "G1 G2 G3", "loops are left out"),
        ("determinant", "1 - G2 H1 - H2 + G2 H1 H2", "wrong sign"),
        ("loops", "[-G2 H1, -H2]", ""),
    ],
)
def test_marking(name, value, said):
    found = verdict(PAPER, "a", name, f'"{value}"')
    assert found.verdict == ("wrong" if said else "correct")
    assert said in str(found.reason)


@pytest.mark.parametrize(
    ("branches", "ends", "said"),
    [
        ("[[r, e, 1], [e, y, G], [y, r, -1]]", "r y", "a branch leads into the input r"),
        ("[[r, e, 1], [e, yy, G]]", "r y", "there is no node y"),
        ("[[r, e, 1], [y, e, G]]", "r y", "no branches lead from the input r to y"),
        ("[[r, e, 1, 2], [e, y, G]]", "r y", "a branch is [from, to, gain]"),
        ("[[r, e, 1], [e, y, 0]]", "r y", "adds nothing"),
        ("[[r, G, 1], [G, y, G]]", "r y", "stands in a gain"),
        ("[[r, s, 1], [s, y, G]]", "r y", "cannot be a node"),
    ],
)
def test_faults_stand_at_their_place(branches, ends, said):
    start, end = ends.split()
    text = (
        f"system:\n  signal_flow: {branches}\n  input: {start}\n  output: {end}\nfind:\n  a: block_diagram_reduction\n"
    )
    with pytest.raises(InputError) as caught:
        read_problem(Source("a.yaml", text), catalogue())
    assert said in str(caught.value)
    assert "^" in str(caught.value)


def test_a_block_may_be_named_as_a_function():
    text = PAPER.replace("G1]", "G1(s)]").replace("-H1]", '"-H1(s)"]')
    (part,) = read_problem(Source("a.yaml", text), catalogue()).parts
    assert [each.gain for each in part.system.branches][:1] == [G1]
