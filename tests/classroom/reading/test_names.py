"""Labels before values, words for verdicts, units behind numbers, conditions."""

import pytest
import sympy as sp

from solver.classroom.reading.expected import Expected
from solver.classroom.reading.names import names_for
from solver.problem.source import Fault
from solver.tasks import catalogue
from tests.helpers.reading import K, a, b, read

M = sp.ImmutableMatrix


def expected(task, name):
    return Expected.of(name, catalogue()[task].answers)


@pytest.mark.parametrize(
    ("label", "said"),
    [("K =", False), ("K_f =", False), ("K_{f} :=", False), ("'K: '", False), ("k =", True), ("K_1 =", False),
     ("gain =", True), ("the gain K ==", True)],
)  # fmt: skip
def test_a_label_is_left_out_and_said_where_it_is_not_the_answers_own(label, said):
    text = f"'{label[1:-1]} [1, 2]'" if label.startswith("'") else f"{label} [1, 2]"
    found = read(text, M([[a, b]]), expected("pole_placement", "K"))
    assert (found.value, found.respelt) == (M([[1, 2]]), said)


@pytest.mark.parametrize("label", ["L", "A", "polynomial", "closed_loop_A", r"\hat{p}", "p"])
def test_a_label_of_something_else_is_refused(label):
    with pytest.raises(Fault, match="it is labelled"):
        read(f"{label} = [1, 2]", M([[a, b]]), expected("pole_placement", "K"))


@pytest.mark.parametrize(
    ("text", "value", "said"),
    [
        ("stable focus.", "stable focus", False),
        ("Stable_Focus", "stable focus", False),
        ("a stable spiral", "stable focus", True),
        ("saddle point", "saddle", True),
        ("the origin is a saddle", "saddle", True),
        ("centre", "center", True),
        ("stabiler Strudel", "stable focus", True),
        ("shear", "shear", False),
    ],
)
def test_a_word_of_the_answers_list_is_read(text, value, said):
    found = read(text, "stable focus", expected("phase_portrait", "kind"))
    assert (found.value, found.respelt) == (value, said)


@pytest.mark.parametrize("text", ["critically damped", "Critical damping.", "kritisch gedämpft"])
def test_a_word_that_means_another_elsewhere_is_read_by_the_answers_list(text):
    found = read(text, "undamped", expected("second_order_parameters", "damping"))
    assert found.value == "critically damped"


@pytest.mark.parametrize("text", ["δ'(t) + 2δ(t)", "2 delta(t) + delta'(t)", r"2\delta(t) + \delta'(t)",
                                  "DiracDelta(t, 1) + 2 DiracDelta(t)"])  # fmt: skip
def test_the_derivative_of_an_impulse_is_read(text):
    t = sp.Symbol("t")
    ours = sp.DiracDelta(t, 1)
    assert read(text, ours, expected("inverse_laplace_transform", "f")).value == ours + 2 * sp.DiracDelta(t)


@pytest.mark.parametrize("text", ["focus", "stable", "banana", "a", "stable unstable node"])
def test_words_that_are_not_clear_are_refused(text):
    with pytest.raises(Fault):
        read(text, "stable focus", expected("phase_portrait", "kind"))


@pytest.mark.parametrize("text", ["unstable.", "Not stable", "instabil", "The system is unstable"])
def test_unstable_has_many_words(text):
    assert read(text, "unstable", expected("stability", "verdict")).value == "unstable"


def test_every_word_of_our_own_is_in_the_list_of_its_answer():
    for task in catalogue().values():
        for answer in task.answers.values():
            for word in answer.words:
                assert read(word, word, Expected.of(answer.name, task.answers)).value == word


@pytest.mark.parametrize(
    ("text", "value"),
    [("yes", True), ("Yes.", True), ("yes, rank 2", True), ("no, rank 1 < 2", False),
     ("not completely controllable", False), ("ja", True), ("wahr", True), ("controllable", True), ("no", False),
     ("nein", False), ("falsch", False), ("not controllable", False),
     ("uncontrollable", False), ("nicht controllable", False)],
)  # fmt: skip
def test_yes_and_no_are_read_in_many_words(text, value):
    assert read(text, True, expected("controllability", "controllable")).value is value


@pytest.mark.parametrize("text", ["2", "maybe", "observable"])
def test_what_is_neither_yes_nor_no_is_refused(text):
    with pytest.raises(Fault, match="yes or no"):
        read(text, True, expected("controllability", "controllable"))


@pytest.mark.parametrize(
    ("text", "value"), [("2 rad/s", 2), ("2", 2), ("2.5 1/s", "5/2"), ("2 rad/sec", 2), ("2 s^-1", 2)]
)
def test_the_unit_of_an_answer_is_left_out(text, value):
    assert read(text, sp.Integer(3), expected("desired_poles", "natural_frequency")).value == sp.Rational(value)


@pytest.mark.parametrize(
    ("task", "name", "text", "value"),
    [
        ("step_specifications", "peak_time", "785 ms", sp.Rational(785, 1000)),
        ("step_specifications", "peak_time", "pi/4 ms", sp.pi / 4000),
        ("step_specifications", "peak_time", "0.5 min", sp.Integer(30)),
        ("desired_poles", "natural_frequency", "2 Hz", 4 * sp.pi),
        ("desired_poles", "natural_frequency", "60 rpm", 2 * sp.pi),
        ("stability_margins", "phase_margin", "1.5 rad", 270 / sp.pi),
    ],
)
def test_another_unit_of_the_kind_is_converted(task, name, text, value):
    assert read(text, sp.Integer(3), expected(task, name)).value == value


@pytest.mark.parametrize("text", ["none", "does not exist", "-", "no crossover", "oo", "infinity", "unendlich", "∞"])
def test_a_crossover_that_is_none_is_infinite(text):
    assert read(f'"{text}"', sp.oo, expected("stability_margins", "phase_crossover")).value == sp.oo


@pytest.mark.parametrize("text", ["2 deg", "2 s", "2 rad", "2°", "2 dB"])
def test_another_unit_is_refused(text):
    with pytest.raises(Fault, match="the unit"):
        read(text, sp.Integer(3), expected("desired_poles", "natural_frequency"))


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("K ∈ (0, 6)", sp.And(K > 0, K < 6)),
        ("K in [0; 6)", sp.And(K >= 0, K < 6)),
        ("K ∈ ]0, inf[", sp.And(K > 0)),
        ("And(K > 0, K < 6)", sp.And(K > 0, K < 6)),
        ("Or(K < 0, K > 6)", sp.Or(K < 0, K > 6)),
        (r"0 < K \leq 6", sp.And(K > 0, K <= 6)),
        (r"$K > 0 \land K < 6$", sp.And(K > 0, K < 6)),
        ("'K > 0, K < 6'", sp.And(K > 0, K < 6)),
        ("0 < K < 6.", sp.And(K > 0, K < 6)),
        ("K < √3", sp.sqrt(3) > K),
    ],
)
def test_conditions_are_read_as_ranges_and_in_latex(text, value):
    assert sp.simplify_logic(read(text, sp.Lt(a, b)).value) == sp.simplify_logic(value)


def test_an_interval_alone_is_that_of_the_one_parameter():
    assert {each.canonical for each in read("(0, 6]", K > 0).value.args} == {K > 0, K <= 6}
    assert {each.canonical for each in read("K ∈ (0, 6]", K > 0).value.args} == {K > 0, K <= 6}
    with pytest.raises(Fault):
        read("(0, 6]", sp.Lt(a, b))


def test_several_names_before_a_sign_have_it_each():
    assert read("'a, b > 0'", sp.Lt(a, b)).value == sp.And(a > 0, b > 0)


def test_the_samples_k_is_the_problems_own_where_it_gives_it_a_value():
    values = {"k": sp.Integer(20)}
    assert "k" not in names_for({}, values, {}, discrete=False).variables
    assert "k" in names_for({}, values, {}, discrete=True).variables
