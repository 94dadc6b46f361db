"""Formulas put together: brackets as high as what stands in them."""

import pytest

from solver.formula import latex, read
from solver.formula.building import (
    THIN_SPACE,
    as_factor,
    is_atom,
    is_matrix,
    is_negative,
    is_sum,
    joined,
    over,
    parenthesized,
    power,
    row,
    separated,
    summed,
    without_sign,
)
from solver.formula.nodes import Operator


@pytest.mark.parametrize(
    ("latex", "tall"),
    [
        ("a + b", False),
        (r"\frac{a}{b} + 1", True),
        (r"\begin{bmatrix}1\end{bmatrix}", True),
        (r"\left( a \right) + 1", True),
        ("(a + b) c", False),
        (r"\sum_{i} a", True),
    ],
)
def test_brackets_are_tall_around_what_is_tall(latex, tall):
    assert parenthesized(read(latex)).tall is tall


def written(*formulas):
    return [read(each) for each in formulas]


@pytest.mark.parametrize(
    ("factors", "product"),
    [
        (("2", "x"), "2x"),
        (("2", "3"), r"2 \cdot 3"),
        (("x", "3"), r"x \cdot 3"),
        (("2", "3^{2}"), r"2 \cdot 3^{2}"),
        (("2", r"\frac{1}{3}"), r"2 \cdot \frac{1}{3}"),
        (("x", r"\frac{1}{3}"), r"x\frac{1}{3}"),
        ((r"\frac{1}{2}", r"\frac{1}{3}"), r"\frac{1}{2} \cdot \frac{1}{3}"),
        ((r"\frac{1}{2}", r"\frac{x}{3}"), r"\frac{1}{2}\frac{x}{3}"),
        (("x^{2}", r"\frac{1}{3}"), r"x^{2} \cdot \frac{1}{3}"),
        (("x", r"\sqrt[3]{2}"), r"x \cdot \sqrt[3]{2}"),
        (("x", r"\sqrt{2}"), r"x\sqrt{2}"),
        ((r"\mathrm{ab}", "x"), r"\mathrm{ab}\,x"),
        (("x", r"\mathrm{ab}"), r"x\mathrm{ab}"),
        ((r"\mathrm{a}", r"\mathrm{b}"), r"\mathrm{a}\,\mathrm{b}"),
        ((r"\frac{1}{2}", r"\mathrm{b}"), r"\frac{1}{2}\,\mathrm{b}"),
        (("x_{12}", r"\mathrm{b}"), r"x_{12}\,\mathrm{b}"),
        ((r"\lambda", r"\lambda"), r"\lambda \cdot \lambda"),
        (("x_1", "x_1", "x_2"), r"x_1 \cdot x_1x_2"),
        (("(a + b)", "(a + b)"), "(a + b)(a + b)"),
    ],
)
def test_factors_side_by_side(factors, product):
    assert latex(joined(written(*factors))) == latex(read(product))


@pytest.mark.parametrize(
    ("terms", "total"),
    [
        (("a", "-b", "c"), "a - b + c"),
        (("-a", "b"), "-a + b"),
        ((), "0"),
        (("-a",), "-a"),
        (("a", "-b - c"), "a - b - c"),
    ],
)
def test_terms_with_their_signs(terms, total):
    assert latex(summed(written(*terms))) == total


@pytest.mark.parametrize(
    ("formula", "atom", "matrix", "total", "negative"),
    [
        ("x", True, False, False, False),
        ("x_{1}", True, False, False, False),
        ("x^{2}", False, False, False, False),
        ("x'", False, False, False, False),
        ("12", True, False, False, False),
        (r"\mathrm{ab}", True, False, False, False),
        (r"\mathbf{a}", False, False, False, False),
        ("xy", False, False, False, False),
        ("a + b", False, False, True, False),
        ("-a", False, False, True, True),
        (r"a \otimes b", False, False, True, False),
        ("(a + b)", False, False, False, False),
        (r"\begin{bmatrix}1\end{bmatrix}", False, True, False, False),
        (r"2\begin{bmatrix}1\end{bmatrix}", False, False, False, False),
    ],
)
def test_what_a_formula_is(formula, atom, matrix, total, negative):
    tree = read(formula)
    assert (is_atom(tree), is_matrix(tree), is_sum(tree), is_negative(tree)) == (atom, matrix, total, negative)
    assert latex(as_factor(tree)) == (f"({formula})" if total else formula)


@pytest.mark.parametrize(
    ("base", "result"),
    [
        ("x", "x^{k}"),
        ("x_{1}", "x_{1}^{k}"),
        ("x^{2}", r"\left(x^{2}\right)^{k}"),
        ("xy", "(xy)^{k}"),
        ("-2", "(-2)^{k}"),
        (r"\begin{bmatrix}1\end{bmatrix}", r"\begin{bmatrix}1\end{bmatrix}^{k}"),
    ],
)
def test_powers(base, result):
    assert latex(power(read(base), read("k"))).replace(r"\left", "").replace(r"\right", "") == latex(
        read(result)
    ).replace(r"\left", "").replace(r"\right", "")


def test_rows_put_together():
    assert joined([row(), row("x")]) == row("x")
    assert latex(without_sign(read("-ab"))) == "ab"
    assert latex(over(read("a"), read("b"))) == r"\frac{a}{b}"
    assert latex(separated(written("a", "b", "c"), Operator(","), THIN_SPACE)) == latex(read(r"a,\,b,\,c"))
    assert latex(row("a", read("b"), Operator("+"), "c")) == "ab + c"
