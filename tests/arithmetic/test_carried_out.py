"""At tutor no line leaves a reader with a pen alone: inverses, eliminations and substitutions are carried out."""

import pytest
import sympy as sp

from solver.derivation import Status
from solver.render.wording import Wording
from solver.systems import TransferFunction
from tests.helpers.asking import ask, system

TUTOR = Wording(detail="tutor")
A = sp.Symbol("A")
THREE = system([[0, 1, 0], [0, 0, 1], [-6, -11, -6]])
OSCILLATING = system([[0, 1], [-5, -2]])
s = sp.Symbol("s")


def page(task, plant, method, **options):
    result = ask(task, plant, method, **options)
    assert result.status is Status.VERIFIED, result.reason
    return "\n".join(f"{each.title}\n{each.markdown}" for step in TUTOR.words(result.steps) for each in step.walk())


def one_over(D):
    return TransferFunction(sp.ImmutableMatrix([[1 / D]]), ((sp.S.One,),), ((sp.expand(D),),), s)


@pytest.mark.parametrize(
    ("task", "method", "options"),
    [("state_transition_matrix", "modal", {}), ("matrix_function", "modal", {"function": A**5})],
)
@pytest.mark.parametrize(
    ("plant", "lines"),
    [
        (THREE, ["The cofactors", r"V^{-1} = \frac{1}{\det V}\operatorname{adj} V = \frac{1}{2}"]),
        (OSCILLATING, [r"V^{-1} = \frac{1}{-1 - 2j - (-1 + 2j)}"]),
    ],
)
def test_the_modal_matrix_is_inverted_by_its_cofactors(task, method, options, plant, lines):
    shown = page(task, plant, method, **options)
    for line in lines:
        assert line in shown


def test_lyapunovs_equation_of_six_unknowns_is_solved_by_elimination():
    shown = page("stability", THREE, "lyapunov")
    assert "one unknown after the other is eliminated" in shown
    assert r"(6):\quad p_{33} &= \frac{13}{120}" in shown
    assert "Row operations" not in shown


def test_what_a_division_leaves_is_factored_by_sum_and_product():
    shown = page("eigenstructure", THREE, "")
    assert "$-2$ and $-3$ have the sum $-5$ and the product $6$" in shown


@pytest.mark.parametrize(
    ("method", "above", "below"),
    [
        ("tustin", r"\frac{1}{4}(z + 1)^{2} = \frac{1}{4}z^{2}", r"\frac{3}{2}(z - 1)(z + 1)"),
        ("backward_euler", "z^{2}", "(z - 1)^{2} + 3(z - 1)z + 2z^{2} = 6z^{2} - 5z + 1"),
    ],
)  # fmt: skip
def test_a_substituted_rule_is_multiplied_out(method, above, below):
    shown = page("discretization", one_over((s + 1) * (s + 2)), method, sample_time=sp.Integer(1))
    assert "Multiplied by" in shown
    assert above in shown
    assert below in shown


def test_nothing_is_multiplied_where_nothing_has_to_be_cleared():
    assert "Multiplied by" not in page("discretization", one_over(s + 1), "forward_euler", sample_time=sp.Integer(1))


def test_a_value_at_a_frequency_is_put_in_and_its_size_is_the_product_of_those_of_the_factors():
    shown = page("frequency_response", one_over((s + 1) * (s + 2) * (s + 3)), "", frequency=sp.Integer(2))
    assert "(2j)^{3} + 6(2j)^{2} + 11 \\cdot 2j + 6 = -18 + 14j" in shown
    assert r"\frac{1}{2.2361 \cdot 2.8284 \cdot 3.6056} = " in shown
    assert r"\angle(1 + 2j) = \arctan(2) = 63.435" in shown
