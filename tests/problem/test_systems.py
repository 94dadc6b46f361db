from __future__ import annotations

import pytest
import sympy as sp

from solver.systems import StateSpace, TransferFunction

s, z = sp.symbols("s z")
three_quarters = sp.Rational(3, 4)
M = sp.ImmutableMatrix


@pytest.fixture
def system(read):
    return lambda text: read(f"system: {{{text}}}\nfind: {{a: stability}}\n").system


@pytest.fixture
def transfer(read):
    return lambda text: read(f"system: {{{text}}}\nfind: {{a: realization}}\n").system


@pytest.fixture
def wrong(complaints):
    return lambda text: complaints(f"system: {{{text}}}\nfind: {{a: stability}}\n")


def test_a_state_space_system_with_everything(system):
    assert system(
        "A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0], D: 5, initial_state: [1/2, -0.25], states: [x1, v_c], "
        "inputs: u, outputs: [y]"
    ) == StateSpace(
        A=M([[0, 1], [-2, -3]]),
        B=M([0, 1]),
        C=M([[1, 0]]),
        D=M([[5]]),
        x0=M([sp.Rational(1, 2), sp.Rational(-1, 4)]),
        state_names=("x1", "v_c"),
        input_names=("u",),
        output_names=("y",),
    )


@pytest.mark.parametrize(
    ("text", "name", "matrix"),
    [
        ("A: -2", "A", M([[-2]])),
        ("A: [-2]", "A", M([[-2]])),
        ("A: [[-2]]", "A", M([[-2]])),
        ("A: -2, B: 1, C: 3, D: 4", "D", M([[4]])),
        ("A: -2, B: 1, C: 3", "D", M([[0]])),
        ("A: -2, B: 1", "D", None),
        ("A: -2, C: 1", "B", None),
        ("A: -2, initial_state: 7", "x0", M([[7]])),
        ("A: [[1, 2], [3, 4]], B: [5, 6]", "B", M([[5], [6]])),
        ("A: [[1, 2], [3, 4]], B: [[5], [6]]", "B", M([[5], [6]])),
        ("A: [[1, 2], [3, 4]], B: [[5, 6], [7, 8]]", "B", M([[5, 6], [7, 8]])),
        ("A: [[1, 2], [3, 4]], C: [5, 6]", "C", M([[5, 6]])),
        ("A: [[1, 2], [3, 4]], C: [[5, 6]]", "C", M([[5, 6]])),
        ("A: [[1, 2], [3, 4]], B: [[1, 2], [3, 4]], C: [1, 0]", "D", M([[0, 0]])),
        ("A: [[1, 2], [3, 4]], B: [[1, 2], [3, 4]], C: [1, 0], D: 0", "D", M([[0, 0]])),
        ("A: [[1, 2], [3, 4]], B: [[1, 2], [3, 4]], C: [1, 0], D: [5, 6]", "D", M([[5, 6]])),
        ("A: [[1, 2], [3, 4]], B: [1, 0], C: [[1, 2], [3, 4]], D: [5, 6]", "D", M([[5], [6]])),
        ("A: [[0.1, 1e-3], [3/4, '3/4']]", "A", M([[sp.Rational(1, 10), sp.Rational(1, 1000)], [three_quarters] * 2])),
        ("A: [[sqrt(2), exp(1)], [pi, 2j]]", "A", M([[sp.sqrt(2), sp.E], [sp.pi, 2 * sp.I]])),
        ("matrix: [[1, 2]]", "A", None),
    ],
)  # fmt: skip
def test_shapes_of_matrices(system, complaints, text, name, matrix):
    if text.startswith("matrix"):
        assert complaints(f"system: {{{text}}}\nfind: {{a: stability}}\n") == [
            "2:11-20 stability needs A; the matrix is not square"
        ]
    else:
        assert getattr(system(text), name) == matrix


def test_numbers_are_exact(system):
    entry = system("A: 0.1").A[0, 0]
    assert entry == sp.Rational(1, 10)
    assert entry.is_Rational


def test_symbols_are_real_unless_said_otherwise(read):
    problem = read("assume: {a: positive, n: integer, c: complex, b: negative, d: nonzero}\n"
                   "system: {A: [[a, b, c], [d, n, f], [0, 0, omega_n]]}\nfind: {a: stability}\n")  # fmt: skip
    a, b, c, d, n, f, w = (problem.symbols[name] for name in ("a", "b", "c", "d", "n", "f", "omega_n"))
    assert (a.is_positive, b.is_negative, c.is_complex, c.is_real, d.is_nonzero, d.is_real) == (
        True, True, True, None, True, True)  # fmt: skip
    assert (n.is_integer, f.is_real, f.is_positive, w.is_real) == (True, True, None, True)
    assert problem.system.A.free_symbols == {a, b, c, d, n, f, w}


def test_a_bare_matrix(read):
    system = read("system: {matrix: [[1, 2, 3], [4, 5, 6]]}\nfind: {a: subspaces}\n").system
    assert system == StateSpace(M([[1, 2, 3], [4, 5, 6]]), bare=True)


def test_discrete_time_and_its_sampling_period(system):
    found = system("time: discrete, A: [[1, T], [0, 1]], sample_time: 0.1")
    assert (found.discrete, found.sample_time) == (True, sp.Rational(1, 10))
    assert not system("time: continuous, A: 1").discrete


def test_k_is_a_parameter_in_continuous_time_only(system, wrong):
    assert str(system("A: [[0, 1], [-k, 0]]").A[1, 0]) == "-k"
    assert wrong("time: discrete, A: [[0, 1], [-k, 0]]") == [
        "1:40-41 'k' cannot stand here: k counts the samples in discrete time"
    ]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("A: [1, 2]", ["1:13-19 A must be a list of rows, such as [[1, 2], [3, 4]]"]),
        ("A: [[1, 2], [3, 4, 5]]", ["1:22-31 A has 2 rows, row 2 has 3 entries"]),
        ("A: [[1, 2, 3], [4, 5]]", ["1:14-23 A has 2 rows, row 1 has 3 entries"]),
        ("A: [[1, 2, 3], [4, 5, 6]]", ["1:13-35 A must be square, it is 2×3"]),
        ("A: [[1, 2], 3]", ["1:22-23 row 2 of A must be a list like the other rows"]),
        ("A: [[]]", ["1:13-17 A is empty"]),
        ("A: [[1, 2], [3, 4]], B: [1, 2, 3]", ["1:34-43 B must have 2 rows like A, it has 3"]),
        ("A: [[1, 2], [3, 4]], B: 1", ["1:34-35 B must have 2 rows like A, it has 1"]),
        ("A: [[1, 2], [3, 4]], B: [[1, 2], [3]]", ["1:43-46 B has 2 rows, row 2 has 1 entry"]),
        ("A: [[1, 2], [3, 4]], C: [[1], [2]]", ["1:34-44 C must have 2 columns like A, it has 1"]),
        ("A: [[1, 2], [3, 4]], C: [1, 2, 3]", ["1:34-43 C must have 2 columns like A, it has 3"]),
        ("A: [[1, 2], [3, 4]], initial_state: [1]", ["1:46-49 initial_state must have 2 rows like A, it has 1"]),
        ("A: [[1, 2], [3, 4]], initial_state: [[1, 2]]", ["1:46-54 initial_state must have 2 rows like A, it has 1"]),
        ("A: 1, B: 1, C: 1, D: [1, 2]", ["1:31-37 D must have 1 column (outputs × inputs), it has 2"]),
        ("A: 1, D: 1", ["1:16-17 D needs both B and C"]),
        ("A: 1, B: 1, C: 1, D: [[1], [2]]", ["1:31-41 D must have 1 row (outputs × inputs), it has 2"]),
        ("A: [[s, z], [t, lambda]]", [
            "1:15-16 's' cannot stand here: s is the variable of the Laplace transform",
            "1:18-19 'z' cannot stand here: z is the variable of the z-transform",
            "1:23-24 't' cannot stand here: t is the time",
            "1:26-32 'lambda' cannot stand here: λ stands for eigenvalues",
        ]),
        ("A: [[inf, 1/0], [NaN, .inf]]", [
            "1:15-18 a finite value is expected here",
            "1:22-23 division by zero",
            "1:27-30 'NaN' cannot stand here: it is not a number",
            "1:32-33 the character . has no meaning in an expression",
        ]),
        ("A: [[1/2x, '2 +'], [x'', ±1]]", None),
        ("A: 1, sample_time: 1", ["1:16-27 sample_time needs time: discrete beside it"]),
        ("A: 1, time: discrete, sample_time: -1", ["1:45-47 sample_time must be positive"]),
        ("A: 1, time: discrete, sample_time: 0", ["1:45-46 sample_time must be positive"]),
        ("A: 1, states: [x, y]", ["1:24-30 1 state but 2 names"]),
        ("A: [[1, 2], [3, 4]], states: [x, x]", ["1:43-44 the name 'x' is given twice"]),
        ("A: 1, inputs: [2u]", None),
        ("A: [" + ", ".join(["[" + ", ".join("1" * 13) + "]"] * 13) + "]",
         ["1:13-546 A is 13×13; at most 12 rows and columns can be read"]),
    ],
)  # fmt: skip
def test_what_is_wrong_with_a_system_is_said_at_its_place(wrong, text, expected):
    found = wrong(text)
    assert found if expected is None else found == expected


def test_twelve_states_can_be_read(system):
    assert system("A: [" + ", ".join(["[" + ", ".join("1" * 12) + "]"] * 12) + "]").order == 12


def test_a_part_may_have_its_own_system(read):
    problem = read(
        "find:\n  a: {task: stability, system: {A: 1}}\n  b: {task: stability, system: {A: 2, time: discrete}}\n"
    )
    assert [part.system.A[0, 0] for part in problem.parts] == [1, 2]
    assert [part.own_system for part in problem.parts] == [True, True]
    assert problem.system is None
    assert problem.parts[1].system.discrete


@pytest.mark.parametrize(
    ("given", "above", "below"),
    [
        ("transfer_function: (s + 1)/(s (s + 3)(s^2 + 2s + 2))", s + 1, s * (s + 3) * (s**2 + 2 * s + 2)),
        ("transfer_function: 1/(s (0.5s + 1))", 1, s * (s / 2 + 1)),
        ("transfer_function: 5/(s + 1)^2", 5, (s + 1) ** 2),
        ("transfer_function: {zeros: [-1], poles: [-2, -3], gain: 5}", 5 * (s + 1), (s + 2) * (s + 3)),
    ],
)
def test_factors_stay_as_they_were_given(transfer, given, above, below):
    found = transfer(given)
    assert found.written == (above, below)
    assert found.denominators[0][0] == sp.expand(below)


@pytest.mark.parametrize(
    "given", ["transfer_function: 1/(s^2 + s)", "transfer_function: 1/(s + 1)", "transfer_function: 1/(s(s + 1) + 2)"]
)
def test_what_was_given_multiplied_out_has_no_factors(transfer, given):
    assert transfer(given).written is None


@pytest.mark.parametrize(
    ("text", "G"),
    [
        ("transfer_function: 1/s", 1 / s),
        ("transfer_function: (2s^3+5s^2+3s+1)/(4s^4+2s^2+3s+6)",
         (2 * s**3 + 5 * s**2 + 3 * s + 1) / (4 * s**4 + 2 * s**2 + 3 * s + 6)),
        ("transfer_function: (s+1)(s+2)/((s+1)(s+3))", (s + 2) / (s + 3)),
        ("transfer_function: (s^2+3s+2)/(s^2+4s+3)", (s + 2) / (s + 3)),
        ("transfer_function: 1/(s+1) + 1/(s+2)", (2 * s + 3) / (s**2 + 3 * s + 2)),
        ("transfer_function: 0", sp.Integer(0)),
        ("transfer_function: 0.5", sp.Rational(1, 2)),
        ("transfer_function: s/(s + sqrt(2))", s / (s + sp.sqrt(2))),
        ("transfer_function: (s^2 - 2)/(s + sqrt(2))^2", (s - sp.sqrt(2)) / (s + sp.sqrt(2))),
        ("transfer_function: {zeros: [-1], poles: [-2, -3 ± 2j], gain: 5}",
         5 * (s + 1) / ((s + 2) * (s**2 + 6 * s + 13))),
        ("transfer_function: {poles: [0, 0]}", 1 / s**2),
        ("transfer_function: {zeros: -1, poles: [-1, -2]}", 1 / (s + 2)),
        ("transfer_function: {numerator: [1, 3], denominator: [1, 3, 2]}", (s + 3) / (s**2 + 3 * s + 2)),
        ("transfer_function: {numerator: [0, 0, 1], denominator: [1, 0]}", 1 / s),
        ("transfer_function: {numerator: 2, denominator: [1, 0.5]}", 4 / (2 * s + 1)),
    ],
)  # fmt: skip
def test_a_transfer_function_in_its_spellings(transfer, text, G):
    found = transfer(text)
    assert isinstance(found, TransferFunction)
    assert (found.matrix.shape, found.variable) == ((1, 1), s)
    assert sp.cancel(found.matrix[0, 0] - G, extension=True) == 0
    p, q = (sp.Poly(each, s).degree() for each in sp.fraction(found.matrix[0, 0]))
    assert (p, q) == tuple(sp.Poly(each, s).degree() for each in sp.fraction(sp.cancel(G, extension=True)))


def test_a_transfer_function_with_parameters(read):
    problem = read("parameters: {m: 2}\nsystem: {transfer_function: 1/(m s^2 + d s + k)}\nfind: {a: realization}\n")
    d, k = (problem.symbols[name] for name in "dk")
    assert sp.expand(1 / problem.system.matrix[0, 0]) == 2 * s**2 + d * s + k


def test_a_transfer_function_in_discrete_time(transfer, complaints):
    found = transfer("time: discrete, transfer_function: 1/(z - 0.5)")
    assert (found.variable, found.discrete) == (z, True)
    assert sp.cancel(found.matrix[0, 0] - 2 / (2 * z - 1)) == 0
    assert complaints("system: {time: discrete, transfer_function: 1/s}\nfind: {a: realization}\n") == [
        "1:47-48 's' cannot stand here: in discrete time a transfer function is written in z"
    ]


def test_a_transfer_matrix(transfer):
    found = transfer(
        "transfer_matrix: [[1/s, 2], [{poles: [-1]}, {numerator: 1, denominator: [1, 1]}]], inputs: [u, v]"
    )
    assert found.matrix == M([[1 / s, 2], [1 / (s + 1), 1 / (s + 1)]])


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("transfer_function: (s^2+1)/(s+1)",
         ["1:29-42 the transfer function is improper: its numerator has degree 2, its denominator 1"]),
        ("transfer_function: s",
         ["1:29-30 the transfer function is improper: its numerator has degree 1, its denominator 0"]),
        ("transfer_function: {zeros: [1, 2], poles: [3]}",
         ["1:29-56 the transfer function is improper: its numerator has degree 2, its denominator 1"]),
        ("transfer_function: {numerator: [1], denominator: [0, 0]}", ["1:59-65 the denominator is zero"]),
        ("transfer_function: {numerator: [], denominator: [1]}",
         ["1:41-43 numerator has 0 coefficients; 1 to 13 can be read"]),
        ("transfer_function: {numerator: [1], denominator: [" + ", ".join("1" * 14) + "]}",
         ["1:59-101 denominator has 14 coefficients; 1 to 13 can be read"]),
        ("transfer_function: 1/(s - s)", ["1:31-38 division by zero"]),
        ("transfer_function: exp(-s^2)/s",
         ["1:29-40 the exponent of a dead time is a number or name times s: exp(-T s)"]),
        ("transfer_function: 1/(sqrt(s) + 1)", ["1:29-44 a quotient of polynomials in s is expected here"]),
        ("transfer_function: 1/z",
         ["1:31-32 'z' cannot stand here: in continuous time a transfer function is written in s"]),
        ("transfer_function: 1/(s+1)^13", ["1:29-39 the transfer function has order 13; at most 12 can be read"]),
        ("transfer_function: {poles: [-1+j, -2]}", ["1:38-42 the pole -1+j has no conjugate"]),
        ("transfer_function: {zeros: [j], poles: [1, 2]}", ["1:38-39 the zero j has no conjugate"]),
        ("transfer_matrix: [[1/s, 1], [2]]", ["1:38-41 this row has 1 entry, row 1 has 2"]),
        ("transfer_matrix: [[1/s, s], [q', 1]]", None),
        ("transfer_function: 1/s, inputs: [u, v]", ["1:42-48 1 input but 2 names"]),
    ],
)  # fmt: skip
def test_what_is_wrong_with_a_transfer_function_is_said_at_its_place(complaints, text, expected):
    found = complaints(f"system: {{{text}}}\nfind: {{a: realization}}\n")
    assert found if expected is None else found == expected


@pytest.mark.parametrize(
    "text",
    ["1/(a+b+c+d+f+g+h+s)^60", "(a+b+c+d+s)^30/(a-b+c-d+s)^40", "1/(s+a)^12/(s+b)^12/(s+c)^12/(s+d)^12/(s+f)^12"],
)
def test_a_transfer_function_too_large_to_multiply_out_is_refused(complaints, text):
    (found,) = complaints(f"system: {{transfer_function: {text}}}\nfind: {{a: realization}}\n")
    assert "too large" in found or "may have more than" in found


@pytest.mark.parametrize(
    ("text", "numerator", "denominator", "cancelled"),
    [
        ("(s+1)/((s+1)(s+2))", s + 1, s**2 + 3 * s + 2, 1 / (s + 2)),
        ("2(s+1)/(4s^2+12s+8)", 2 * s + 2, 4 * s**2 + 12 * s + 8, 1 / (2 * s + 4)),
        ("-s/(s*(s+5))", -s, s**2 + 5 * s, -1 / (s + 5)),
        ("1/s/(s+1)", 1, s**2 + s, 1 / (s**2 + s)),
        ("2 + 1/(s+1)", 2 * s + 3, s + 1, (2 * s + 3) / (s + 1)),
    ],
)
def test_a_transfer_function_keeps_the_factors_that_cancel(transfer, text, numerator, denominator, cancelled):
    system = transfer(f"transfer_function: '{text}'")
    assert (system.numerators, system.denominators) == (((numerator,),), ((denominator,),))
    assert sp.cancel(system.matrix[0] - cancelled) == 0


def test_the_channels_of_a_transfer_matrix_have_names(transfer):
    system = transfer("transfer_matrix: [[1/s, 2/(s+1)]], inputs: [u, d], outputs: [y]")
    assert (system.input_names, system.output_names) == (("u", "d"), ("y",))
