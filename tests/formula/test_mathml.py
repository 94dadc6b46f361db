r"""Formulas as MathML: the structure of what is drawn, and what is refused."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import pytest
from hypothesis import given
from hypothesis import strategies as st

from solver.formula import MathProblem, find_problem, latex
from solver.formula import vocabulary as v
from solver.formula.mathml import mathml
from solver.formula.nodes import Row
from tests.helpers.formula_trees import TREES

ELEMENTS = set("math mrow mi mn mo mtext mspace mfrac msqrt mroot msub msup msubsup munder mover munderover".split())
ELEMENTS |= set("mstyle mtable mtr mtd".split())
CHILDREN = {
    **dict.fromkeys(("msub", "msup", "mfrac", "mroot", "munder", "mover"), 2),
    **dict.fromkeys(("msubsup", "munderover"), 3),
    **dict.fromkeys(("mi", "mn", "mo", "mtext", "mspace"), 0),
}
"""Elements with a fixed number of children."""

ATTRIBUTES = set(
    "stretchy fence movablelimits accent accentunder displaystyle lspace rspace width linethickness".split()
)
ATTRIBUTES |= set("linethickness form mathvariant scriptlevel style display alttext".split())


def shape(latex: str, display: bool = True) -> str:
    """Return the formula without `<math>`, without its outermost row, with `<mi>x</mi>` written as x."""
    markup = mathml(latex, display).markup
    markup = re.sub(r"^<math[^>]*>|</math>$", "", markup)
    markup = re.sub(r'<m[ino](?: mathvariant="normal")?>([^<>]+)</m[ino]>', r"\1", markup)
    return re.sub(r"^<mrow>(.*)</mrow>$", r"\1", markup)


def tree(latex: str, display: bool = False) -> ElementTree.Element:
    """Return the formula as XML; what is not well-formed raises."""
    return ElementTree.fromstring(mathml(latex, display).markup)  # noqa: S314 - written by the code under test


def text(latex: str) -> str:
    return "".join(tree(latex).itertext())


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"\frac{a}{b}", "<mfrac>ab</mfrac>"),
        (r"\sqrt{2}", "<msqrt>2</msqrt>"),
        (r"\sqrt[3]{x}", "<mroot>x3</mroot>"),
        (r"x_{1}^{2}", "<msubsup>x12</msubsup>"),
        (r"\lambda", "λ"),
        (r"\sim\;\le\;\implies", '∼<mspace width="0.278em"></mspace>≤<mspace width="0.278em"></mspace>⇒'),
        (r"A^\top", "<msup>A⊤</msup>"),
        (r"\boxed{x}", '<mrow style="border:1px solid;padding:0.25em 0.4em">x</mrow>'),
        (r"\mathrm{rank}", "rank"),
    ],
)
def test_structure(latex: str, expected: str) -> None:
    assert shape(latex) == expected


def test_a_relation_between_words_keeps_its_space() -> None:
    """A row of text and one operator is an operator itself in MathML Core, with the space around the row."""
    assert shape(r"\text{verdict} = \text{stable}") == "verdict=stable"
    assert "<mtext>is</mtext>" in shape(r"x \text{is} = y")


def test_a_formula_carries_its_source_and_says_whether_it_is_displayed() -> None:
    assert mathml("a <\n b", True).markup.startswith('<math display="block" alttext="a &lt; b">')


@pytest.mark.parametrize(
    ("latex", "left", "right"),
    [(r"\begin{bmatrix}1\end{bmatrix}", "[", "]"), (r"\begin{pmatrix}1\end{pmatrix}", "(", ")"),
     (r"\begin{vmatrix}1\end{vmatrix}", "|", "|"), (r"\begin{Bmatrix}1\end{Bmatrix}", "{", "}"),
     (r"\left[\begin{matrix}1\end{matrix}\right]", "[", "]")],
)  # fmt: skip
def test_brackets_stretch_with_their_matrix_and_with_nothing_else(latex: str, left: str, right: str) -> None:
    fences = '<mo stretchy="true" fence="true" form="{}">{}</mo>'
    row = f"<mrow>{fences.format('prefix', left)}<mtable><mtr><mtd><mn>1</mn></mtd></mtr></mtable>"
    assert f"{row}{fences.format('postfix', right)}</mrow>" in mathml(rf"\frac{{1}}{{2}} {latex}^{{-1}} x").markup


def cells(latex: str) -> list[list[str]]:
    table = next(tree(latex).iter("mtable"))
    return [["".join(cell.itertext()) for cell in row] for row in table]


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"\begin{bmatrix} a & b \\ c & \end{bmatrix}", [["a", "b"], ["c", ""]]),
        (r"\begin{bmatrix} a & \\ & \end{bmatrix}", [["a", ""], ["", ""]]),
        (r"\begin{bmatrix} a \\ b \\ \end{bmatrix}", [["a"], ["b"]]),
        (r"\begin{bmatrix} {c} & [1] \\ {[2]} & {l} \end{bmatrix}", [["c", "[1]"], ["[2]", "l"]]),
        (r"\begin{array}{c|cc} a & b & c \\ d & e \end{array}", [["a", "b", "c"], ["d", "e", ""]]),
        (r"\begin{aligned} a &= b \\ &= c \end{aligned}", [["a", "=b"], ["", "=c"]]),
        (r"\begin{cases} 0 & t < 0 \\ 1 & t \ge 0 \end{cases}", [["0", "t<0"], ["1", "t≥0"]]),
        (r"\begin{array}{c|c} \hline s^{2} & 1 \\ s & \\ \hline \end{array}", [["s2", "1"], ["s", ""]]),
    ],
)  # fmt: skip
def test_no_cell_of_a_table_is_lost(latex: str, expected: list[list[str]]) -> None:
    assert cells(latex) == expected


def test_lines_of_an_array_are_borders_of_its_cells() -> None:
    table = next(tree(r"\begin{array}{|cc|c} 1&2&3\\ \hline 4&5&6 \\ \hline \end{array}").iter("mtable"))
    styles = [[cell.get("style", "") for cell in row] for row in table]
    assert ["border-right" in style for style in styles[0]] == [False, True, False]
    assert ["border-left" in style for style in styles[1]] == [True, False, False]
    assert all("border-top" in style and "border-bottom" in style for style in styles[1])
    assert not any("border-top" in style or "border-bottom" in style for style in styles[0])


def test_equations_are_aligned_at_their_signs() -> None:
    markup = mathml(r"\begin{aligned} a &= b & c &= d \end{aligned}").markup
    styles = re.findall(r'<mtd style="([^"]*)">', markup)
    assert [style.split(";")[0] for style in styles] == ["text-align:right", "text-align:left"] * 2
    assert all("text-align:-webkit-right" in style for style in styles[::2])  # Chromium moves nothing for `right`
    assert ["padding-left:2em" in style for style in styles] == [False, False, True, False]


@pytest.mark.parametrize(
    ("latex", "forms"),
    [
        ("-1", ["prefix"]), ("x - 1", [None]), ("x = -1", ["prefix"]), ("(-1)", ["prefix"]), ("(a) - 1", [None]),
        (r"a, -b", ["prefix"]), (r"\lvert x \rvert - 1", [None]), (r"\lvert -1 \rvert", ["prefix"]),
        (r"\begin{bmatrix} -1 & a - b \end{bmatrix}", ["prefix", None]), (r"e^{-t}", ["prefix"]),
        (r"1 + \cdots - 2", [None]),
        (r"x' - 1", [None]), (r"a \; - b", [None]), (r"\frac{-1}{2} - 3", ["prefix", None]),
        (r"\sin - x", ["prefix"]),
        (r"\begin{aligned} x &= 1 \\ &- 2 \end{aligned}", [None]), (r"\left[ -1 \right] - 2", ["prefix", None]),
    ],
)  # fmt: skip
def test_a_sign_is_prefix_or_binary(latex: str, forms: list[str | None]) -> None:
    minus = [mo for mo in tree(latex).iter("mo") if mo.text == "−"]
    assert [mo.get("form") for mo in minus] == forms


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"2\cos t", "2_cos_t"), (r"\sin(t)", "sin(t)"), (r"e^{t}\sin^{2} t", "et_sin2_t"),
        (r"a + \sin t", "a+sin_t"),
        (r"\operatorname{adj}(A)\det A", "adj(A)_det_A"), (r"\det\begin{bmatrix}1\end{bmatrix}", "det_[1]"),
        (r"\operatorname{rank} A", "rank_A"), (r"\lim_{t \to 0} f", "limt→0_f"), (r"\ln -x", "ln−x"),
    ],
)  # fmt: skip
def test_names_of_functions_keep_their_distance(latex: str, expected: str) -> None:
    drawn = tree(latex, True)
    for space in drawn.iter("mspace"):
        assert space.get("width") == "0.167em"
        space.text = "_"
    assert "".join(drawn.itertext()) == expected


@pytest.mark.parametrize("name", [r"\lim", r"\max", r"\sup", r"\det", r"\sum", r"\prod"])
def test_limits_stand_below_in_display_style(name: str) -> None:
    drawn = tree(rf"\left( {name}_{{i}} x_{{i}} \right)", True)
    assert [base[0].get("movablelimits") for base in drawn.iter("munder")] == ["true"]
    assert len(list(drawn.iter("msub"))) == 1


def test_limits_of_an_integral_stand_beside_it() -> None:
    assert shape(r"\int_0^\infty") == "<msubsup>∫0∞</msubsup>"


@pytest.mark.parametrize(
    ("latex", "expected"),
    [(r"\mathbf{x}", "𝐱"), (r"\mathbf{AB}", "𝐀𝐁"), (r"\mathbf{\Phi}", "𝚽"), (r"\boldsymbol{\xi}", "𝝃"),
     (r"\mathbb{R}", "ℝ"), (r"\mathbb R", "ℝ"), (r"\mathcal{L}", "ℒ"), (r"\mathcal C", "𝒞"), (r"\mathbf{0}", "𝟎"),
     (r"\mathfrak{g}", "𝔤"), (r"\mathcal{Z}^{-1}", "𝒵−1")],
)  # fmt: skip
def test_shapes_of_letters_are_characters(latex: str, expected: str) -> None:
    assert text(latex) == expected


@pytest.mark.parametrize(
    ("latex", "upright"),
    [(r"\Phi", "Φ"), (r"\mathrm{d}", "d"), (r"\mathrm{d\alpha}", "dα"), (r"\infty", "∞"), (r"\partial", "∂"),
     (r"\alpha", ""), (r"\ell", "")],
)  # fmt: skip
def test_letters_that_are_upright(latex: str, upright: str) -> None:
    letters = [mi for mi in tree(latex + " t").iter("mi") if mi.get("mathvariant") == "normal"]
    assert "".join(letter.text or "" for letter in letters) == upright


@pytest.mark.parametrize("latex", [r"\pm", r"\leq", r"\langle", r"\Rightarrow", r"\mapsto", r"\perp", r"\times"])
def test_operators_are_operators(latex: str) -> None:
    assert len(list(tree(f"a {latex} b").iter("mo"))) == 1


@pytest.mark.parametrize(
    "latex", [r"\dot{x}", r"\ddot{x}", r"\dddot{x}", r"\hat{x}", r"\tilde{x}", r"\bar{x}", r"\vec{x}", r"\dot{\hat{x}}"]
)
def test_accents(latex: str) -> None:
    assert mathml(latex).markup.split(">", 1)[1].startswith('<mover accent="true">')


def test_letters_under_a_wide_accent_or_over_a_line_keep_their_dots() -> None:
    assert text(r"\hat{ij}")[:2] == "ij"
    assert text(r"\underline{i}")[0] == "i"


def test_a_letter_under_an_accent_loses_its_dot() -> None:
    assert text(r"\dot{i}") == "𝚤˙"


def test_primes_stand_after_their_letter() -> None:
    assert text("x''(t) + x_1'") == "x″(t)+x1′"
    assert "msup" not in mathml("x''(t) + x_1'").markup


@pytest.mark.parametrize("latex", [r"|x|", r"\lvert x \rvert", r"\left| x \right|"])
def test_bars_open_and_close(latex: str) -> None:
    bars = [mo.get("form") for mo in tree(latex).iter("mo")]
    assert bars == ["prefix", "postfix"]


@pytest.mark.parametrize("command", sorted((v.SYMBOLS | v.OPERATORS | v.SPACES | v.FUNCTIONS) - {r"\backslash"}))
def test_every_command_of_the_dialect_is_drawn(command: str) -> None:
    assert "\\" not in text(rf"x {command} y")


@pytest.mark.parametrize("command", sorted(v.ACCENTS | v.ALPHABETS | v.TEXTS | {r"\sqrt"}))
def test_every_command_with_one_argument_is_drawn(command: str) -> None:
    drawn = text(rf"{command}{{x}}")
    assert drawn
    assert "\\" not in drawn


@pytest.mark.parametrize("command", sorted(v.FRACTIONS | v.STACKS))
def test_every_command_with_two_arguments_is_drawn(command: str) -> None:
    assert sorted(text(rf"{command}{{x}}{{y}}").strip("()")) == ["x", "y"]


@pytest.mark.parametrize("name", sorted(v.ENVIRONMENTS))
def test_every_environment_of_the_dialect_is_drawn(name: str) -> None:
    columns = "{cc}" if name == "array" else ""
    assert cells(rf"\begin{{{name}}}{columns} a & b \\ c & \end{{{name}}}") == [["a", "b"], ["c", ""]]


@pytest.mark.parametrize(
    "attack",
    ["<svg/onload=alert(1)>", "</math><script>alert(1)</script>", "<!--", "&lt;b&gt;", "a\" onclick=\"b", "]]>"],
)  # fmt: skip
@pytest.mark.parametrize("place", [r"\text{%s}", r"\textbf{%s}", r"\mathrm{x}\text{%s}", "x %s", r"\operatorname{%s}"])
def test_text_cannot_become_markup(attack: str, place: str) -> None:
    try:
        drawn = tree(place % attack)
    except MathProblem:
        return
    check(drawn)
    assert "<" not in re.sub(r"</?m[a-z]+( [a-z]+=\"[^\"<>]*\")*>", "", mathml(place % attack).markup)


def check(drawn: ElementTree.Element) -> None:
    """Every element is one of MathML Core's, with the children and the attributes that it may have."""
    for element in drawn.iter():
        assert element.tag in ELEMENTS
        assert set(element.attrib) <= ATTRIBUTES
        assert len(element) == CHILDREN.get(element.tag, len(element))


@given(TREES, st.booleans())
def test_every_tree_is_drawn_as_valid_mathml(node: Row, display: bool) -> None:
    check(tree(latex(node), display))


@given(st.text(max_size=30))
def test_any_text_at_all_is_drawn_or_refused(written: str) -> None:
    problem = find_problem(written)
    if problem is None:
        check(tree(written))
    else:
        with pytest.raises(MathProblem, match=re.escape(problem[1])):
            mathml(written)


def test_widths_grow_with_the_formula() -> None:
    widths = [
        mathml(latex).width
        for latex in ("x", "x + 1", r"\frac{x + 1}{2}", r"\begin{bmatrix} x + 1 & x + 1 \end{bmatrix}")
    ]
    assert widths == sorted(widths)
    assert widths[0] == 0.5
    assert mathml(r"\mathrm{co}").width == mathml("c").width + mathml("o").width
    assert mathml(r"\Re").width == mathml("R").width + mathml("e").width


@pytest.mark.parametrize("brackets", [r"\left({}\right)", "({})", r"\left[{}\right.", r"\left\{{{}\right\}}"])
def test_every_bracket_takes_its_width(brackets: str) -> None:
    more = mathml(brackets.format("x")).width - mathml("x").width
    assert more == pytest.approx(0.4 if brackets.endswith(".") else 0.8)
