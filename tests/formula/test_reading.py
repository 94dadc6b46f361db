r"""Formulas read into trees: the dialect, what is refused and where, and trees written back as LaTeX."""

from __future__ import annotations

import inspect

import pytest
from hypothesis import given
from hypothesis import strategies as st

from solver.formula import MathProblem, find_problem, latex, nodes, read
from solver.formula.mathml.drawing import drawn
from solver.formula.nodes import (
    Accent,
    Fenced,
    Fraction,
    Function,
    Node,
    Number,
    Operator,
    Root,
    Row,
    Scripts,
    Space,
    Stacked,
    Styled,
    Symbol,
    Table,
    Text,
)
from solver.formula.reader import DEEPEST
from solver.formula.reading import LONGEST
from solver.formula.terminal.drawing import box
from solver.formula.width import width
from tests.helpers.formula_trees import TREES, anew

GOOD = [
    "{[0, 1)}" * 50,
    "(1, 2] + " * 30,
    r"\frac{1}{2}x^{2}",
    r"\frac12",
    "x''",
    r"\left.x\right|_{t=0}",
    r"\begin{bmatrix}1 & 2 \\ 3 & 4\end{bmatrix}^{-1}",
    r"\begin{array}{c|c}a & b\end{array}",
    r"\begin{cases}1 & \text{if } t > 0 \\ 0 & \text{else}\end{cases}",
    r"\begin{aligned}a &= b \\ &\quad + c\end{aligned}",
    r"\mathcal{L}^{-1}\left\{\frac{1}{s}\right\}",
    r"\sqrt[3]{2} \le \infty",
    r"\dot{\hat{x}} = A\hat{x} + Bu",
    r"\int_{0}^{\infty} e^{-st}\,dt",
    "λ + Φ",
    r"\operatorname{adj}(sI - A)",
]

BAD = [
    (r"\input{/etc/passwd}", 0),
    ("x^^5cinput", 1),
    (r"a\csname input\endcsname", 1),
    (r"\write18{id}", 0),
    (r"\def\x{\x\x}", 0),
    (r"\loop\iftrue\repeat", 0),
    (r"\href{javascript:alert(1)}{x}", 0),
    (r"\begin{verbatim}x\end{verbatim}", 0),
    ("50% of x", 2),
    ("a#b", 1),
    ("a~b", 1),
    (r"\text{a $b$}", 5),
    (r"\text{<svg/onload=alert(1)>}", 5),
    ("{a", 0),
    ("a}", 1),
    (r"\left(a", 0),
    (r"a\right)", 1),
    ("a & b", 2),
    (r"a \\ b", 2),
    ("x^2^3", 3),
    ("x^", 2),
    (r"\frac{1}", 8),
    (r"\sqrt", 5),
    (r"\begin{bmatrix}1", 0),
    (r"\begin{bmatrix}1 \\ [2pt] 3\end{bmatrix}", 20),
    (r"\begin{cases}1 & 2 & 3\end{cases}", 19),
    ("\\", 0),
    ("é", 0),
    ("", 0),
    ("{" * 200 + "}" * 200, 40),
    ("x" * 60_000, 0),
    ("(" * 200 + ")" * 200, 40),
    ("x_1_2", 3),
    ("x^{2}'", 5),
    (r"\frac\frac12 3", 5),
    (r"\frac 1.5 }", 10),
    (r"\frac 123 }", 10),
    (r"x^1.5 }", 6),
    (r"\begin{matrix}a & {b & c}\end{matrix}", 21),
]


@pytest.mark.parametrize("formula", GOOD)
def test_formulas_of_the_dialect_are_read_and_written_back(formula: str) -> None:
    tree = read(formula)
    assert anew(latex(tree)) == tree


@pytest.mark.parametrize(("formula", "offset"), BAD, ids=lambda item: repr(item)[:30])
def test_other_formulas_are_refused_at_their_place(formula: str, offset: int) -> None:
    with pytest.raises(MathProblem) as problem:
        read(formula)
    assert problem.value.offset == offset
    assert problem.value.message


X, Y, ONE, TWO = Symbol("x"), Symbol("y"), Number("1"), Number("2")


@pytest.mark.parametrize(
    ("formula", "items"),
    [
        ("2x", (TWO, X)),
        ("λ", (Symbol(r"\lambda"),)),
        ("x_1", (Scripts(X, ONE),)),
        ("x_{1}^2", (Scripts(X, Row((ONE,)), TWO),)),
        ("x^12", (Scripts(X, None, ONE), TWO)),
        (r"\frac12.5", (Fraction(ONE, TWO), Operator("."), Number("5"))),
        ("x_1''", (Scripts(X, ONE, None, 2),)),
        ("(x)^2", (Scripts(Fenced("(", Row((X,)), ")"), None, TWO),)),
        ("[0, 1)", (Operator("["), Number("0"), Operator(","), ONE, Operator(")"))),
        (r"\left.x\right|", (Fenced(".", Row((X,)), "|", tall=True),)),
        (r"\operatorname{adj} x", (Function("adj", named=True), X)),
        (r"\sqrt[3]{x}\, y", (Root(Row((X,)), Row((Number("3"),))), Space(r"\,"), Y)),
        ("{x}y", (Row((X,)), Y)),
        (r"\begin{array}{c|c} \hline x & 1 \\ \hline \end{array}",
         (Table("array", ((Row((X,)), Row((ONE,))),), "c|c", (0, 1)),)),
    ],
)  # fmt: skip
def test_trees(formula: str, items: tuple[Node, ...]) -> None:
    assert read(formula) == Row(items)
    assert anew(latex(Row(items))) == Row(items)


@pytest.mark.parametrize(
    ("typed", "written"),
    [
        (r"\lambda I-A", r"\lambda I - A"), ("a=-b", "a = -b"), ("x(1,2)", "x(1, 2)"), ("K_{1,2}", "K_{1,2}"),
        (r"\sin(t)\cos t", r"\sin(t)\cos t"), (r"a\text{ or }b", r"a \text{ or } b"), ("z:1", "z: 1"),
        (r"\left(\pi\right)x", r"\left(\pi\right)x"), (r"\sqrt x", r"\sqrt x"), (r"1,\;2", r"1,\; 2"),
        (r"\begin{aligned}a&=b\\&=c\end{aligned}", "\\begin{aligned}\na &= b \\\\\n&= c\n\\end{aligned}"),
    ],
)  # fmt: skip
def test_a_tree_is_written_with_the_blanks_of_a_person(typed: str, written: str) -> None:
    assert latex(read(typed)) == written


@given(TREES)
def test_what_is_written_is_read_again(tree: Row) -> None:
    assert anew(latex(tree)) == tree


@given(st.text(max_size=30) | st.text(r"{}^_&\()[]'.0x ", max_size=40))
def test_any_text_is_read_or_refused_at_a_place_in_it(formula: str) -> None:
    problem = find_problem(formula)
    if problem is None:
        assert anew(latex(read(formula))) == read(formula)
    else:
        assert 0 <= problem[0] <= len(formula)
        assert problem[1]


def test_a_tree_is_remembered_when_it_is_written_unless_it_is_too_deep_to_be_read() -> None:
    tree = Row((X, Operator("+"), Number("31415")))
    assert read(latex(tree)) is tree
    for _ in range(DEEPEST):
        tree = Row((Root(tree),))
    assert find_problem(latex(tree)) is not None


def test_trees_that_visitors_have_seen_equal_those_that_none_has() -> None:
    seen, unseen = (Row((X, Scripts(Y, Row((X,))))) for _ in range(2))
    assert width(seen) == width(unseen)
    assert latex(seen) == latex(seen)
    assert (seen, hash(seen), repr(seen)) == (unseen, hash(unseen), repr(unseen))


@pytest.mark.parametrize("opening", ["{", "(", r"\left(", r"\sqrt{", "x^{", r"\frac1{", r"\begin{matrix}", r"\hat{x_{"])
def test_deep_nesting_is_refused(opening: str) -> None:
    problem = find_problem(opening * (LONGEST // len(opening)))
    assert problem is not None
    assert problem[0] <= (DEEPEST + 1) * len(opening)


@pytest.mark.parametrize("piece", ["x^12", "1.5", "''", "(", ")", "a & ", "{} ", "x_1^2'"])
def test_a_huge_formula_is_read_in_one_pass(piece: str) -> None:
    """Every token is looked at a bounded number of times, however long the formula is."""
    formula = r"\begin{aligned}" + piece * (40_000 // len(piece))
    assert find_problem(formula) is not None


def test_every_kind_of_node_is_known_to_the_visitors() -> None:
    """`Visitor` has a method for each kind of node, and each of our visitors has them all."""
    kinds = {kind for _, kind in inspect.getmembers(nodes, inspect.isclass) if issubclass(kind, Node)}
    methods = {each.name for each in _visited()}
    names = {kind.__name__.lower() for kind in kinds - {Node, nodes.Shared}}
    assert names == methods == set(nodes.Visitor.__abstractmethods__)


class _Name:
    """Answers any question with the name of the method that was asked."""

    def __init__(self, name: str) -> None:
        self.name = name

    def __getattr__(self, name: str) -> object:
        return lambda _node: _Name(name)


def _visited() -> list[_Name]:
    samples = [X, ONE, Operator("+"), Function("sin"), Text("a"), Space(r"\,"), Row(), Fraction(X, X), Root(X),
               Scripts(X), Fenced("(", Row(), ")"), Table("matrix", ((Row(),),)), Accent(r"\dot", X),
               Stacked(r"\overset", X, X), Styled(r"\mathrm", X)]  # fmt: skip
    return [sample.accept(_Name("")) for sample in samples]  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "around", [r"\sqrt{%s}", r"\frac{x_{%s}}{1}", r"\left(%s\right)^{2}", r"\begin{bmatrix}%s\end{bmatrix}"]
)
def test_what_is_as_deep_as_allowed_is_drawn_by_all(around: str) -> None:
    formula = "x"
    while find_problem(around.replace("%s", formula)) is None:
        formula = around.replace("%s", formula)
    tree = read(formula)
    assert anew(latex(tree)) == tree
    assert drawn(tree).width > 0
    assert box(tree, display=True).width > 0
    assert width(tree) > 0
