"""Formulas as text: on one line, and drawn in two dimensions."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from solver.formula import vocabulary as v
from solver.formula.terminal import drawn, flat
from solver.formula.terminal.boxes import cells
from solver.formula.terminal.drawing import box as drawn_box
from tests.helpers.formula_trees import TREES

FLAT = {
    r"\chi(\lambda) = \det(\lambda I - A)": "χ(λ) = det(λI − A)",
    r"2e^{-t} - e^{-2t}": "2e⁻ᵗ − e⁻²ᵗ",
    r"e^{\lambda t}\cos(\omega_d t)": "e^(λt) cos(ω_d t)",
    r"\frac{s + 3}{(s + 1)(s + 2)}": "(s + 3)/((s + 1)(s + 2))",
    r"\frac{1}{2}te^{-t}": "(1/2)te⁻ᵗ",
    r"\frac{1}{2} + t\frac{3}{4}, \frac{5}{6}\quad \frac{7}{8}": "1/2 + t(3/4), 5/6  7/8",
    r"\text{slopes:}\quad -20, 0": "slopes:  −20, 0",
    r"\text{if}\quad a - b": "if  a − b",
    r"-\frac{2}{3}": "−2/3",
    r"\frac{a}{2b}": "a/(2b)",
    r"\frac{2a}{b}": "2a/b",
    r"\frac{N}{Rk} + \frac{R}{L_a} + \frac{x^2}{k_1^2} + \frac{1}{\sqrt{2}}": "N/(Rk) + R/Lₐ + x²/k₁² + 1/√2",
    r"\begin{aligned}a &= b \\ &= c \\ d &= e\end{aligned}": "a = b = c; d = e",
    r"\begin{bmatrix}1 & -2 \\ 3 & 4\end{bmatrix}": "[1, −2; 3, 4]",
    r"-2,\; -1 \pm j\sqrt{3}": "−2, −1 ± j√3",
    r"\sqrt{1 - \zeta^2}, \sqrt[3]{x}": "√(1 − ζ²), ³√x",
    r"\sqrt{13}, \sqrt{-x}": "√13, √(−x)",
    r"\sqrt{qr}, \sqrt{2k}, \sqrt{x_1}, \sqrt[4]{q^3}, \sqrt{\omega_n}": "√(qr), √(2k), √x₁, ⁴√(q³), √ωₙ",
    r"\dot{x} = A\,x, \ddot{y}, \hat{\eta}_2": "ẋ = Ax, ÿ, η̂₂",
    r"\dddot{y} + \ddot{y}": "y⃛ + ÿ",
    r"\mathcal{L}^{-1}\{(sI - A)^{-1}\}": "ℒ⁻¹{(sI − A)⁻¹}",
    r"K_{\mathrm{co}}x": "K_co x",
    r"\mathrm{d}t": "dt",
    r"\mathcal{LK}x": "ℒ𝒦x",
    r"\text{asymptotically stable}": "asymptotically stable",
    r"k_1 > 0 \text{ and } k_2 \ge 1": "k₁ > 0 and k₂ ≥ 1",
    r"\left|z\right| < 1": "|z| < 1",
    r"x \in \mathbb{R}^n": "x ∈ ℝⁿ",
    r"A^\top P + PA = -Q": "AᵀP + PA = −Q",
    r"\operatorname{tr} A \cdot 10^{-15}": "tr A · 10⁻¹⁵",
}

DRAWN = {
    r"\frac{s + 3}{s + 1}": ["s + 3", "─────", "s + 1"],
    r"\begin{bmatrix}1 & 0 \\ -2 & 30\end{bmatrix}": ["⎡ 1   0  ⎤", "⎣ −2  30 ⎦"],
    r"\begin{bmatrix}13 & 8\end{bmatrix}": ["[ 13  8 ]"],
    r"A = \begin{bmatrix}a \\ b \\ c\end{bmatrix} + 1": ["    ⎡ a ⎤", "A = ⎢ b ⎥ + 1", "    ⎣ c ⎦"],
    r"e^{\lambda t}": [" λt", "e"],
    r"\left[\begin{array}{c|c}1 & 2 \\ 3 & 4\end{array}\right]": ["⎡1 │ 2⎤", "⎣3 │ 4⎦"],
    r"\left[\begin{array}{c|c}1 & 2 \\ \hline 3 & 40\end{array}\right]": ["⎡1 │ 2 ⎤", "⎢──┼───⎥", "⎣3 │ 40⎦"],
    r"\begin{cases}1 & t \ge 0 \\ 0 & t < 0\end{cases}": ["⎧1  t ≥ 0", "⎩0  t < 0"],
    r"\begin{aligned}a &= b + c \\ &= d\end{aligned}": ["a = b + c", "  = d"],
    r"\begin{aligned}a &= b & c &= d \\ ee &= f & g &= hh\end{aligned}": [" a = b  c = d", "ee = f  g = hh"],
    r"K\frac{s + 3}{s + 1}x": ["  s + 3", "K ───── x", "  s + 1"],
    r"\frac{a}{b}\frac{c}{d}(s + 1)": ["a c", "─ ─ (s + 1)", "b d"],
    r"\frac{a}{b} + \frac{1}{2}": ["a", "─ + 1/2", "b"],
    r"\frac{1}{2}\frac{a}{b}": ["      a", "(1/2) ─", "      b"],
    r"\frac{a}{b}, c": ["a", "─, c", "b"],
    r"\sum_{i=0}^{\infty} x": ["  ∞", "  Σ   x", "i = 0"],
    r"\left(\frac{1}{s}\right)^2": ["   2", "⎛1⎞", "⎜─⎟", "⎝s⎠"],
}


@pytest.mark.parametrize("latex", FLAT)
def test_a_formula_on_one_line(latex):
    assert flat(latex) == FLAT[latex]


@pytest.mark.parametrize("latex", DRAWN)
def test_a_formula_in_two_dimensions(latex):
    assert drawn(latex) == DRAWN[latex]


@pytest.mark.parametrize(
    "latex", [r"\frac{", "}", r"\begin{bmatrix}1", r"\begin{evil}x\end{evil}", r"a & b", "{" * 300]
)
def test_what_is_not_of_the_dialect_is_shown_as_it_stands(latex):
    assert flat(latex) == latex
    assert drawn(latex) == [latex]


PIECES = st.sampled_from(
    [r"\frac{1}{s}", "x", "^", "_", "{", "}", r"\left(", r"\right)", "&", r"\\", r"\begin{bmatrix}", r"\end{bmatrix}",
     "-", r"\sqrt", r"\text", "[", "]", r"\dot", r"\mathcal", "'", r"\xrightarrow", r"\operatorname", " "]
)  # fmt: skip


@given(st.lists(PIECES, max_size=12).map("".join))
def test_no_formula_is_too_odd_to_be_shown(latex):
    assert "\n" not in flat(latex)
    assert all("\n" not in line for line in drawn(latex))


def test_the_lines_of_a_drawing_are_level_with_accents_and_wide_letters():
    assert cells("ẋ̂ = 漢") == 6
    top, bottom = drawn(r"\begin{bmatrix}\hat{\eta} & 1 \\ x & 2\end{bmatrix}")
    assert cells(top) == cells(bottom)


@pytest.mark.parametrize("command", sorted((v.SYMBOLS | v.OPERATORS | v.SPACES | v.FUNCTIONS) - {r"\backslash"}))
def test_every_command_of_the_dialect_is_drawn(command):
    assert "\\" not in flat(f"x {command} y")
    assert len(flat(f"{{{command}}}")) <= 3 or command in v.FUNCTIONS | v.SPACES


@given(TREES)
def test_every_tree_has_lines_of_one_width(tree):
    box = drawn_box(tree, display=True)
    assert len({cells(line) for line in box.lines}) == 1
    assert len(drawn_box(tree, display=False).lines) == 1


@pytest.mark.parametrize("opening", [*v.PAIRS, "|", r"\|", "/"])
def test_every_bracket_is_as_high_as_what_it_encloses(opening):
    lines = drawn(rf"\left{opening}\frac{{a}}{{b}}\right{v.PAIRS.get(opening, opening)}")
    assert len(lines) == 3
    assert all(line[:1].strip() and line[-1:].strip() for line in lines)
    assert len(drawn(rf"\left{opening}a\right.")) == 1
