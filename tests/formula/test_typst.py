r"""Formulas as typst: what is written, and that typst takes all of it and does what is meant."""

from __future__ import annotations

import re
from collections import Counter

import pytest
from hypothesis import given

from solver.formula import read
from solver.formula import vocabulary as v
from solver.formula.building import walk
from solver.formula.nodes import Number, Row
from solver.formula.reader import DEEPEST
from solver.formula.typst import PRELUDE, typst
from tests.helpers.formula_trees import TREES
from tests.helpers.tried import tried


def compiled(*formulas: Row) -> bytes:
    """Return the PDF of formulas, each displayed and in a line; what typst does not take raises."""
    from typst import compile as typeset  # noqa: PLC0415 - not installed everywhere

    shown = [f'#math.equation(alt: "x", ${typst(each, in_line=line)}$)' for each in formulas for line in (False, True)]
    head = f'#set document(title: "x")\n#set text(font: "New Computer Modern")\n{PRELUDE}'
    return typeset("\n\n".join((head, *shown)).encode(), format="pdf", ignore_system_fonts=True, pdf_standards=["ua-1"])


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        ("x_{1} + 2x", r"attach(x, b: 1)\+2 x"),
        (r"-\frac{a}{b}", "−frac(a, b)"),
        (r"a = -b", r'a\=class("unary", −)b'),
        (r"\dfrac{1}{2}", "display(frac(1, 2))"),
        (r"\sqrt{2}\sqrt[3]{x}", "sqrt(2)root(3, x)"),
        (r"s \cdot s", "s · s"),
        (r"x'_{1}", "attach(x, b: 1, tr: primes(#1))"),
        (r"\begin{bmatrix} 1 & 2 \\ 3 & \end{bmatrix}", 'display(mat(delim: #("[", "]"), 1, 2; 3, ""))'),
        (r"\begin{aligned} a &= b \\ &= c \end{aligned}", r"a & \=b \  & \=c"),
        (r"\text{if } t", '"if "t'),
        (r"\mathrm{rank}\,A", '"rank"#h(0.167em)A'),
        (r"\mathcal{L}\{f\}", r'cal(L)class("opening", \{)f class("closing", \})'),
        (r"\operatorname{adj} A", 'op("adj")A'),
        (r"\lim_{s \to 0}", 'attach(op("lim", limits: #true), b: s→0)'),
        (r"\left. f\right|_{0}", r'attach(lr(#h(0pt)f class("closing", \|)), b: 0)'),
        (r"|x|^{2}", r'class("opening", \|)x class("closing", attach(scripts(class("closing", \|)), t: 2))'),
        (r"\dot{x}", r'accent(x, #"\u{0307}")'),
        (r"\boxed{x}", "framed(x)"),
        (r"a, b; c", r"a\,b\;c"),
    ],
)
def test_what_is_written(latex, expected):
    assert typst(read(latex)) == expected


@pytest.mark.usefixtures("typst")
def test_all_of_the_dialect_is_typeset():
    leaves = sorted(v.LETTERS | v.RELATIONS | v.BINARY | v.LARGE | v.FUNCTIONS | v.PUNCTUATION | v.SPACES)
    formulas = [f"a {leaf} b_{{{leaf}}}" for leaf in leaves]
    formulas += [rf"\left{left} x \right{right}" for left, right in v.PAIRS.items()]
    formulas += [rf"{command}{{ab1}}" for command in sorted(v.ACCENTS | v.ALPHABETS)]
    formulas += [rf"{command}{{a}}{{b,c}}" for command in sorted(v.FRACTIONS | v.STACKS)]
    formulas += [rf"{command}{{words, (and) more: it's}}" for command in sorted(v.TEXTS)]
    formulas += [rf"\begin{{{name}}} a \\ b \end{{{name}}}" for name in v.ENVIRONMENTS if name != "array"]
    formulas += [
        r"\begin{array}{|rc|l|} \hline a & b & c \\ \hline & x & \\ \hline \end{array}",
        "".join(v.GREEK_LETTERS),
    ]
    assert compiled(*map(read, formulas)).startswith(b"%PDF")


@pytest.mark.usefixtures("typst")
def test_the_deepest_formula_is_typeset():
    deep = DEEPEST - 2
    nested = [r"\frac{1}{" * deep + "x" + "}" * deep, r"\left(" * deep + "x" + r"\right)" * deep]
    nested += ["x^{" * deep + "x" + "}" * deep, r"\sqrt{" * deep + "x" + "}" * deep]
    nested += [r"\begin{bmatrix}" * (deep // 2) + "x" + r"\end{bmatrix}" * (deep // 2)]
    assert compiled(*map(read, nested))


@pytest.mark.usefixtures("typst")
@tried(40)
@given(TREES, TREES, TREES)
def test_any_trees_are_typeset(one, another, third):
    assert compiled(one, another, third)


@given(TREES)
def test_no_number_is_lost_or_added(tree):
    code = r'#\w+\([^)]*\)|#\d[\w.%]*|#"[^"]*"|[hv]line: \([^)]*\)|stroke: 0.5pt|#0.8em'
    written = re.sub(r"#text\(weight: 700, (\"[^\"]*\")\)", r"\1", typst(tree))
    numbers = "".join(each.digits for each in walk(tree) if isinstance(each, Number))
    found = re.sub(code, "", written)
    assert Counter(re.findall(r"\d", found)) == Counter(re.findall(r"\d", numbers))


@given(TREES)
def test_only_what_is_meant_is_code(tree):
    """Without its strings, nothing is left that typst could run: calls of functions of formulas, gaps, and signs."""
    written = re.sub(r'"(?:\\.|[^"\\])*"', "", typst(tree))
    escaped = re.sub(r"\\.", "", written)
    assert set(re.findall(r"#\w*", escaped)) <= {"#", "#h", "#text", "#true", "#none", "#1", "#2", "#3", "#0", "#0em"}
    assert not set("$@<>[]{}`_^*~'").intersection(escaped)
