"""A matrix printed by another program is read as itself; whatever is typed ends in a value or a fault."""

import time

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy.printing.mathematica import mathematica_code
from sympy.printing.octave import octave_code

from solver.classroom.reading.latex import NotReadableError, translated
from solver.classroom.reading.names import names_for
from solver.classroom.reading.values import Reader
from solver.problem.nodes import Place, ScalarNode
from solver.problem.source import Fault

t, s = sp.symbols("t s")
a = sp.Symbol("a", real=True)
M = sp.ImmutableMatrix

numbers = st.fractions(-50, 50, max_denominator=20).map(lambda x: sp.Rational(x.numerator, x.denominator))
entries = st.one_of(
    numbers,
    st.sampled_from([a, a - 1, sp.exp(-2 * t), sp.exp(-t) * sp.cos(3 * t), sp.sqrt(3), 1 / (s + 1), s**2 + a, t * a]),
)


@st.composite
def matrices(draw, of=entries):
    rows, columns = draw(st.integers(1, 3)), draw(st.integers(1, 3))
    return M(rows, columns, draw(st.lists(of, min_size=rows * columns, max_size=rows * columns)))


def read(text, ours):
    names = names_for({"a": a}, {}, {}, False)
    return Reader(names).read(ScalarNode(Place(), text), ours)


WRITERS = {
    "sympy": str,
    "lists": lambda matrix: str(matrix.tolist()),
    "MATLAB": octave_code,
    "Mathematica": mathematica_code,
    "LaTeX": sp.latex,
    "LaTeX, bmatrix": lambda matrix: sp.latex(matrix, mat_delim="", mat_str="bmatrix"),
    "rows on lines": lambda matrix: "\n".join(", ".join(map(str, matrix.row(i))) for i in range(matrix.rows)),
}


@pytest.mark.parametrize("writer", WRITERS)
@settings(max_examples=25, deadline=None)
@given(matrix=matrices())
def test_a_matrix_written_by_a_program_is_read_as_itself(writer, matrix):
    found = read(WRITERS[writer](matrix), matrix)
    assert found.others == ()
    assert (found.value - matrix).applyfunc(sp.expand).is_zero_matrix


@settings(max_examples=25, deadline=None)
@given(matrix=matrices(st.integers(-99, 99)))
def test_a_matrix_printed_by_numpy_is_read_as_itself(matrix):
    array = np.array(matrix.tolist(), dtype=int)
    for text in (str(array), repr(array), f"np.{array.astype(float)!r}", str(array.astype(float))):
        assert read(text, matrix).value == matrix


@settings(max_examples=40, deadline=None)
@given(st.lists(st.integers(-99, 99), min_size=2, max_size=5))
def test_numbers_between_spaces_are_as_many_as_they_are(values):
    text = " ".join(map(str, values))
    ours = M([[a] * len(values)])
    assert list(read(f"[{text}]", ours).value) == values
    assert read(f"[{text}]", [a] * len(values)).value == values


PIECES = st.sampled_from(
    ["[", "]", "{", "}", "(", ")", ",", ";", " ", "\n", "'", "=", ":", "±", "+-", "√", "e^-2", "t", "1/2", "sin",
     "cos2", "j2", "u(", "\\frac", "\\begin{bmatrix}", "&", "\\\\", "\\end{bmatrix}", "$", "^", "_", "np.array(",
     "Matrix(", "tf(", "%", "1,5", "9e30", "...", "T", "∈", "<", "K", "_{1}", "\\sqrt[", "**", "x'", "½", "|"]
)  # fmt: skip


def outcome(text, ours):
    """What is read, or the message of the fault."""
    names = names_for({"a": a}, {}, {}, False)
    try:
        return str(Reader(names, decimal_comma=True).read(ScalarNode(Place(), text), ours).value)
    except Fault as fault:
        return fault.diagnostics[0].message


KINDS = [a, s**2 + a, [a, a], M([[a, t]]), sp.Lt(a, 1), True, "stable", {a: t}]


@settings(max_examples=300, deadline=None)
@given(st.lists(PIECES, max_size=14).map("".join), st.sampled_from(KINDS))
def test_whatever_is_typed_is_a_value_or_a_fault(text, ours):
    assert outcome(text, ours) == outcome(text, ours) != ""


SLOW = {"list": [a, a], "polynomial": s**2 + 1}


@pytest.mark.parametrize(
    "text",
    [
        "[" * 5000, "(" * 5000, "{" * 5000, "\\frac" * 4000, "\\sqrt{" * 3000, "{" * 3000 + "}" * 3000, "[1 " * 4000,
        "1;" * 9000, "1 -a " * 3000, "\\begin{bmatrix}" * 1000, "tf(" * 4000, "u(t)" * 4000, "√" * 9000, "+-" * 9000,
        "KroneckerDelta(" * 1300, "x''" * 5000, "cos2" * 4000, "a = " * 4000, "1,5;" * 4000, "Matrix(" * 2000,
        "9" * 19000, "9^9^9^9", "[9^9^9^9]", "tf([" + "1 " * 5000 + "], 1)", "_{" * 5000, "|" * 9000, "'" * 9000,
    ],
    ids=lambda text: text[:8],
)  # fmt: skip
@pytest.mark.parametrize(
    "ours",
    [pytest.param(a, id="value"), pytest.param(M([[a, t]]), id="matrix"),
     *(pytest.param(each, id=name, marks=pytest.mark.slow) for name, each in SLOW.items())],
)  # fmt: skip
def test_a_hostile_text_is_refused_in_little_time(text, ours):
    start = time.process_time()
    with pytest.raises((Fault, RecursionError)):
        read(text, ours)
    assert time.process_time() - start < 5


def test_latex_is_bounded_in_depth():
    with pytest.raises(NotReadableError, match="nested deeper"):
        translated("\\sqrt{" * 40)
