"""The quadratic formula with its numbers: what the lines show is what numpy finds."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.arithmetic.quadratics import quadratic_formula, roots_of_squares
from solver.numeric import check_steps
from solver.render.wording import Wording
from tests.helpers.asking import ask, system

TUTOR = Wording(detail="tutor")
X = sp.Symbol("lamda")


def displayed(steps):
    return "\n".join(f"{each.title}\n{each.markdown}" for each in TUTOR.words(steps))


def of_roots(one, other):
    """The lines for (x − one)(x − other)."""
    return quadratic_formula(X, sp.expand(-one - other), sp.expand(one * other), [one, other])


def test_the_numbers_stand_in_the_formula():
    root = sp.sqrt(926) * sp.I
    shown = displayed(of_roots(-6 + root, -6 - root))
    assert r"-\frac{b}{2} \pm \sqrt{\frac{b^{2}}{4} - c} = -6 \pm \sqrt{36 - 962} = -6 \pm \sqrt{-926}" in shown
    assert r"= -6 + j\sqrt{926},\; -6 - j\sqrt{926}" in shown


def test_a_formula_without_linear_term_is_a_square_root():
    shown = displayed(of_roots(sp.sqrt(12) * sp.I, -sp.sqrt(12) * sp.I))
    assert r"\lambda = \pm\sqrt{-12} = 2j\sqrt{3},\; -2j\sqrt{3}" in shown
    assert "\\frac{b}{2}" not in shown


def test_the_letters_of_the_formula_are_not_those_of_the_parameters():
    c, k, m = sp.symbols("c k m", positive=True)
    shown = displayed(quadratic_formula(X, c / m, k / m, list(sp.roots(X**2 + c / m * X + k / m, X))))
    assert r"-\frac{b}{2}" not in shown
    assert r"-\frac{c}{2m} \pm \sqrt{\frac{c^{2}}{4m^{2}} - \frac{k}{m}}" in shown


@given(st.integers(-9, 9).filter(bool), st.integers(-40, 40))
def test_the_radicand_is_that_of_numpys_roots(b, c):
    (step,) = quadratic_formula(X, sp.Integer(b), sp.Integer(c), list(sp.roots(X**2 + b * X + c, X)))
    radicand = step.claims["radicand"].right
    assert np.allclose(-b / 2 + np.sqrt(complex(radicand)) * np.array([1, -1]), np.roots([1, b, c])) or np.allclose(
        -b / 2 - np.sqrt(complex(radicand)) * np.array([1, -1]), np.roots([1, b, c])
    )


def test_a_complex_root_of_a_square_is_squared():
    half = sp.sqrt(2) / 2
    roots = [half * (1 + sp.I), -half * (1 + sp.I), half * (1 - sp.I), half * (sp.I - 1)]
    steps = roots_of_squares(X, [sp.I, -sp.I], [sp.expand(each) for each in roots])
    assert [step.kind for step in steps] == ["square_of_root", "square_of_root"]
    assert all(check.status == "passed" for check in check_steps(steps))
    squares = r"\left(\frac{\sqrt{2}}{2}\right)^{2} - \left(\frac{\sqrt{2}}{2}\right)^{2}"
    assert squares + r" + 2 \cdot \frac{\sqrt{2}}{2}\frac{\sqrt{2}}{2}j = j" in displayed(steps)


@pytest.mark.parametrize("last", [[-1, 0, 0, 0], [-1, 0, 3, 0], [-4, 0, -2, 0], [-6, 0, -5, 0]])
def test_eigenvalues_of_even_polynomials_are_verified_with_their_lines(last):
    result = ask("eigenstructure", system([[0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1], last]))
    lines = [line for step in result.steps for line in step.steps if "quadratics" in line.wording]
    values = [complex(root) for line in lines for root in line.values["roots"] if line.values["x"] == X]
    assert result.status == "verified"
    of_numpy = np.roots([1, 0, -last[2], 0, -last[0]])
    assert np.allclose(np.sort_complex(np.round(values, 9)), np.sort_complex(np.round(of_numpy, 9)))
