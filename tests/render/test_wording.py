"""Steps in words: templates found, levels of detail, clear errors, users' templates first and in a sandbox."""

import re

import pytest
import sympy as sp

from solver.derivation import AnswerName, Claim, Step
from solver.derivation.displayed import FIRST_MARK, Displayed, Written
from solver.formula import latex, read
from solver.formula.width import LINE, broken, width
from solver.problem.model import Part
from solver.render.displaying import Displaying, as_numbers
from solver.render.displays import chain, entries, entry_name
from solver.render.latex import formula, tex
from solver.render.numbers import NumberFormat
from solver.render.recording import Recorder
from solver.render.wording import Wording, WordingError
from solver.stated.algebra import difference, product, total
from solver.stated.matrices import determinant, inverse, matrix_of
from solver.symbols import NOTATIONS
from solver.systems import StateSpace, TransferFunction

A = sp.ImmutableMatrix([[0, 1], [-2, -3]])
lamda, s, t = sp.symbols("lamda s t")


@pytest.fixture
def templates(tmp_path):
    folder = tmp_path / "wording" / "demo"
    folder.mkdir(parents=True)
    (folder / "demo.md.jinja").write_text(
        r"""
{% macro levels(v, c) %}
### Level of ${{ v.x|tex }}I - A$
{% if brief %}BRIEF{% endif %}{% if full %}FULL{% endif %}{% if tutor %}TUTOR{% endif %}
{{ claim(c.value, "\\det A") }}
{{ eq("x", v.x, note="\\text{ !}", relation="\\approx") }}
{{ align([["a", v.x], ["b", "c"]]) }}
{{ v.words|plain }} ${{ sym.xdot }}$
{% endmacro %}
{% macro going_on(v, c) %}
### Going on
{{ eq("a", v.x, note="= 2") }}
{{ eq("a", "b", note="> 0") }}
{{ eq("a", "b", note="\\text{ !}") }}
{{ eq("a", "b", holds=false) }}
{% endmacro %}
{% macro untitled(v, c) %}
no title
{% endmacro %}
{% macro undefined(v, c) %}
### Undefined {{ v.nothing }}
{% endmacro %}
{% macro bad_math(v, c) %}
### Bad
$\input{x}$
{% endmacro %}
{% macro escape(v, c) %}
### Escape {{ v.x.__class__.__mro__ }}
{% endmacro %}
""",
        encoding="utf-8",
    )
    return tmp_path


def step(kind, detail="brief", steps=()):
    made = Step(
        kind,
        claims={"value": Claim(determinant(A), sp.Integer(2))},
        detail=detail,
        steps=steps,
        x=lamda,
        words="*<b>*",
    )
    made.wording = "demo/demo"
    return made


def test_a_note_that_states_something_goes_on_with_the_last_side(templates):
    displayed = Wording(templates=templates).word(step("going_on")).displayed
    written = [[getattr(side, "latex", side) for side in each.sides] for each in displayed]
    assert written[0][0] == "a"
    assert written[0][-1].endswith(" = 2")
    assert written[1:] == [["a", "b > 0"], ["a", "b"]]
    assert displayed[0].sides[-1].values == (lamda,)


def test_a_macro_words_a_step(templates):
    worded = Wording(templates=templates).word(step("levels"))
    assert worded.title == r"Level of $\lambda I - A$"
    assert "FULL" in worded.markdown
    assert "$$\n\\det A = \\det\\begin{bmatrix}0 & 1 \\\\ -2 & -3\\end{bmatrix} = 2\n$$" in worded.markdown
    assert r"x \approx \lambda \text{ !}" in worded.markdown
    assert "a &= \\lambda \\\\\nb &= c" in worded.markdown
    assert r"\*\<b\>\* $\dot{x}$" in worded.markdown
    assert "\n\n\n" not in worded.markdown


@pytest.mark.parametrize(("detail", "words"), [("brief", "BRIEF"), ("full", "FULL"), ("tutor", "FULLTUTOR")])
def test_levels_of_detail(templates, detail, words):
    wording = Wording(detail=detail, templates=templates)
    assert words in wording.word(step("levels")).markdown.split("\n")
    inner = step("levels", steps=(step("levels", "full"), step("levels", "tutor")))
    assert len(wording.word(inner).steps) == {"brief": 0, "full": 1, "tutor": 2}[detail]


@pytest.mark.parametrize(
    ("kind", "message"),
    [
        (
            "absent",
            "the macro 'absent' of templates/wording/demo/demo.md.jinja is missing; write {% macro absent(…) %} there",
        ),
        ("untitled", "must begin with the title"),
        ("undefined", "nothing"),
        ("bad_math", r"\input is not known"),
        ("escape", "__class__"),
    ],
)
def test_errors_in_templates_name_the_place(templates, kind, message):
    with pytest.raises(WordingError, match=re.escape(message)):
        Wording(templates=templates).word(step(kind))


def test_a_missing_file_and_a_syntax_error_name_the_place(templates):
    missing = step("levels")
    missing.wording = "demo/other"
    with pytest.raises(WordingError, match="no such file"):
        Wording(templates=templates).word(missing)
    (templates / "wording" / "demo" / "broken.md.jinja").write_text("{% macro a(v, c) %}\n{{ v. }}", encoding="utf-8")
    missing.wording = "demo/broken"
    with pytest.raises(WordingError, match="line 2"):
        Wording(templates=templates).word(missing)


def test_a_question_is_the_prompt_or_comes_from_the_template(templates):
    plant = StateSpace(A)
    assert Wording().question(Part("a", "demo", ("demo",), plant, prompt=" Find $x$. ")) == "Find $x$."
    (templates / "wording" / "demo" / "question.md.jinja").write_text(
        "{% macro question(system, options) %}\nOrder {{ system.order }}, {{ options.terms }} terms.\n{% endmacro %}",
        encoding="utf-8",
    )
    part = Part("a", "demo", ("demo",), plant, {"terms": 3})
    assert Wording(templates=templates).question(part) == "Order 2, 3 terms."


def test_a_long_sum_is_broken_before_signs_between_terms_and_not_before_the_sign_of_one():
    first = "abcdefgh" * 8
    lines = [latex(line) for line in broken(read(f"x = -{first} + {first} - {first}"), 68.0)]
    assert [line[:5].replace(" ", "") for line in lines] == ["x=-", "+abcd", "-abcd"]
    assert [latex(line) for line in broken(read("a - b"), 68.0)] == ["a - b"]


def test_a_chain_with_a_wide_first_side_goes_on_below_indented():
    wide = read(" + ".join(["abcdefghij"] * 7))
    laid_out = latex(chain([wide, read("b"), read("c")]))
    assert laid_out.count(r"&\quad = ") == 2
    assert latex(chain([wide, read("b")], note=read(r"\text{end}"))).endswith("\\text{end}\n\\end{aligned}")


def test_what_is_given_is_shown():
    given = Wording().given(StateSpace(A, B=sp.ImmutableMatrix([0, 1]), D=sp.ImmutableMatrix([[0]])))
    assert "A = " in given
    assert "B = " in given
    assert "D = " not in given
    G = TransferFunction(sp.ImmutableMatrix([[1 / (s + 1)]]), ((sp.Integer(1),),), ((s + 1,),), s)
    assert r"G(s) = \frac{1}{s + 1}" in Wording().given(G)


def test_notations_have_the_same_symbols_and_change_answers():
    assert {frozenset(table) for table in NOTATIONS.values()} == {frozenset(NOTATIONS["course"])}
    K = AnswerName("K", r"\sym{K}", "")
    assert (Wording().symbol(K), Wording(notation="ogata").symbol(K)) == ("K_f", "K")
    assert Wording(notation="ogata").symbol(AnswerName("A", r"\bar{A}", "")) == r"\bar{A}"  # a task's own symbol


def test_a_long_chain_is_aligned_at_its_signs():
    assert latex(chain([read("a"), read("b"), read("c")])) == "a = b = c"
    long_side = read(" + ".join(["xyz" * 6] * 12))
    laid_out = latex(chain([read("a"), read("b"), long_side], note=read(r"\text{end}")))
    assert laid_out.startswith("\\begin{aligned}\na &= b")
    assert laid_out.endswith("\\text{end}\n\\end{aligned}")
    (table,) = read(laid_out).items
    assert all(width(line) < 1.2 * LINE for row in table.rows for line in row)


def test_a_chain_does_not_show_a_side_twice():
    assert latex(chain(list(map(read, ["a", "b", "b", "c"])))) == "a = b = c"
    assert latex(chain([read("b"), read("b")])) == "b = b"


def test_a_sum_is_broken_only_outside_of_brackets():
    matrix = tex(sp.Matrix(2, 6, lambda i, j: s + 10**6 + i + j))
    formula = read(f"{matrix} - {matrix} + (a - b)")
    lines = broken(formula, LINE)
    assert [latex(line)[0] for line in lines[1:]] == ["-", "+"]
    assert tuple(item for line in lines for item in line.items) == formula.items


def test_a_product_of_matrices_is_broken_before_a_matrix():
    matrix = tex(sp.Matrix(2, 6, lambda i, j: s + 10**6 + i + j))
    first, second = broken(read(f"{matrix}{matrix}"), LINE)
    assert latex(first) == matrix
    assert latex(second) == rf"\cdot {matrix}"


def test_a_matrix_too_wide_to_be_read_is_listed_by_entries():
    wide = sp.ImmutableMatrix(3, 3, lambda i, j: sum((i + j + 2) ** n * sp.exp(-n * t) for n in range(1, 6)))
    answer = Wording().equation(r"\Phi(t)", wide)
    assert answer.startswith("\\begin{aligned}\n\\Phi_{11}(t) &= ")
    assert answer.count("&= ") == 9
    read(answer)
    assert "bmatrix" in Wording().equation(r"\Phi(t)", sp.eye(3))
    assert latex(entry_name(read("J = V"), "12")) == r"\left[J = V\right]_{12}"
    assert "v_{2} &= b" in latex(entries(read("v"), [], [[read("a")], [read("b")]]))


def test_a_matrix_of_one_entry_alone_on_a_side_is_a_number():
    one = sp.ImmutableMatrix([[sp.Symbol("a") + 1]])
    assert Wording().equation("K", one) == "K = a + 1"
    assert Wording().equation("K", [one, one]).count("bmatrix") == 4  # in a list they stay matrices


def test_number_formats_reach_the_templates(templates):
    half = Step("levels", claims={"value": Claim(sp.S.Half, sp.S.Half)}, x=sp.S.Half, words="")
    half.wording = "demo/demo"
    assert "0.5" in Wording(NumberFormat("decimal"), templates=templates).word(half).markdown


def test_what_a_macro_displays_is_known_as_values(templates):
    worded = Wording(NumberFormat("decimal"), templates=templates).word(step("levels"))
    title, claimed, approximate, first, second, _ = worded.displayed
    assert title.sides == (Written(f"{chr(FIRST_MARK)}I - A", (lamda,)),)
    assert claimed == Displayed((Written(r"\det A"), determinant(A), sp.Integer(2)))
    assert approximate == Displayed((Written("x"), lamda), r"\approx")
    assert (first, second) == (Displayed((Written("a"), lamda)), Displayed((Written("b"), Written("c"))))


def test_arithmetic_with_matrices_of_one_entry_is_that_of_numbers():
    M = [sp.ImmutableMatrix([[each]]) for each in (-2, 3, 5)]
    shown = Displaying(Recorder(), formula)
    text = shown.laid_out(["J", difference(M[0], product(M[1], M[2]))], formula)
    assert latex(text) == r"J = -2 - 3 \cdot 5"
    kept = difference(M[0], product(sp.ImmutableMatrix([[1, 2]]), sp.ImmutableMatrix([1, 2])))
    assert "bmatrix" in latex(shown.laid_out(["J", kept], formula))


def test_a_matrix_of_one_entry_among_factors_and_terms_is_a_number():
    column, row = sp.ImmutableMatrix([9, 12]), sp.ImmutableMatrix([[0, 5]])

    def one(number):
        return sp.ImmutableMatrix([[number]])

    wording = Wording()
    for stated, shown in (
        (difference(column, product(column, one(0))), r" - \begin{bmatrix}9 \\ 12\end{bmatrix} \cdot 0"),
        (product(one(2), row), r"2\begin{bmatrix}0 & 5\end{bmatrix}"),
        (difference(product(row, column), one(180)), r"\end{bmatrix} - 180"),
        (inverse(difference(product(sp.Symbol("s"), one(1)), one(-3))), "(s"),
        (matrix_of([[total(12, product(5, 12))]]), r"12 + 5 \cdot 12"),
    ):
        tex = wording.tex(as_numbers(stated))
        assert shown in tex
        assert r"\begin{bmatrix}2" not in tex
    assert r"\begin{bmatrix}3\end{bmatrix}" in wording.tex(as_numbers(determinant(one(3))))
