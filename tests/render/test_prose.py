"""Markdown with formulas to HTML and LaTeX: right, and harmless whatever is written."""

import re
from html.parser import HTMLParser

import pytest
from hypothesis import given
from hypothesis import strategies as st

from solver.markup import math_problems
from solver.render import tex_text
from solver.render.prose import inline_html, inline_latex, plain, to_html, to_latex, to_text
from solver.render.tex_text import escaped


def draw(formula, displayed):
    return f"<math>{'block' if displayed else 'inline'}:{len(formula)}</math>"


def test_problems_are_found_at_their_place_in_a_text():
    text = "Let $x$ be\n\n$$\ny = \\input{a}\n$$\n\nand $x$ and $z^$ too."
    problems = math_problems(text)
    assert [text[offset:][:6] for offset, _ in problems] == ["\\input", "$ too."]


def test_markdown_becomes_html():
    html = to_html(
        "# Plant\n\nThe *matrix* $A$:\n\n$$\nA = 1\n$$\n\n1. **one**\n2. `two`\n\n|a|b|\n|-|-|\n|$x$|2|\n", draw
    )
    for part in (
        "<h3>Plant</h3>",
        '<em>matrix</em> <span class="glued"><math>inline:1</math>:</span>',
        "<math>block:5</math>",
        "<ol>",
        "<code>two",
    ):
        assert part in html
    assert "<td><math>inline:1</math></td>" in html


def test_a_formula_between_two_dollars_is_displayed_within_a_sentence_too():
    assert "<math>block:1</math>" in to_html("so that $$x$$ holds", draw)
    assert "<math>inline:1</math>" in to_html("so that $x$ holds", draw)


@pytest.mark.parametrize("markdown", ["$$\nx\n\ny\n$$", "costs 2$x$", "$x$3 or", "<b>x</b> and <i>y</i>"])
def test_what_is_no_formula_and_no_markdown_stays_text(markdown):
    html = to_html(markdown, draw)
    assert "<math>" not in html
    assert "<b>" not in html


def test_what_follows_a_displayed_formula_is_no_label_of_it():
    assert "(a)" in to_html("$$\nx\n$$ (a)", draw)


def test_a_title_has_no_paragraph():
    assert inline_html("Eigenvector for $x$", draw) == "Eigenvector for <math>inline:1</math>"
    assert inline_latex("50 % of $x$") == r"50 \% of $x$"


def test_markdown_becomes_latex():
    latex = to_latex("The *matrix* $A$:\n\n$$\nA = 1\n$$\n\n- **one**\n- `t_wo`\n\n|a|b|\n|-|-:|\n|$x$|2 %|\n")
    for part in (r"\emph{matrix} $A$", r"\display{A = 1}", r"\item{} \textbf{one}", r"\texttt{t\_wo}", r"$x$ & 2 \%"):
        assert part in latex
    assert r"\begin{tabular}{lr}" in latex


def test_lines_of_code_keep_their_indent_in_latex():
    assert to_latex("```\nif x:\n    y\n```") == (
        "\\begin{quote}\n\\texttt{\\null if~x:}\\\\\n\\texttt{\\null ~~~~y}\n\\end{quote}"
    )


def test_a_formula_is_displayed_in_the_paragraph_that_leads_to_it():
    latex = to_latex("So\n\n$$\nA = 1\n$$\n\nand\n\nthen\n\n$$\nB = 2\n$$\n")
    assert latex == "So\n\\display{A = 1}\nand\n\nthen\n\\display{B = 2}"


HOSTILE = [
    "<script>alert(1)</script>",
    "</script><svg onload=alert(1)>",
    "<img src=x onerror=alert(1)>",
    "![x](http://evil.example/a.png)",
    "[x](javascript:alert(1))",
    "[x](data:text/html,<script>alert(1)</script>)",
    "[x](JAVASCRIPT:alert(1))",
    "<javascript:alert(1)>",
    "$</math><script>alert(1)</script>$",
    "$\\text{<script>}$",
    "`<script>`",
    "    <script>indented</script>",
    "&lt;script&gt;&#60;script&#62;",
    "$ unbalanced",
    "\\input{/etc/passwd} ^^5cinput{x} \\csname x\\endcsname % # ~ & _ { }",
    "$$\n\\input{x}\n$$",
    "[a]: javascript:x\n\n[a]",
    "-" * 3 + "\n" + "> " * 30 + "deep",
    "- " * 30 + "deep",
    "|a|\n|-|\n|[x]|",
    "\u202eevil\u202c \u0000 \ufeff 中文 🙂 ħ é e\u0301",
]

TEXT_TAGS = "p em strong code pre ol ul li blockquote div table thead tbody tr th td hr br a math".split()
ALLOWED_TAGS = {*TEXT_TAGS, *(f"h{n}" for n in range(1, 7))}


class Tags(HTMLParser):
    def __init__(self):
        super().__init__()
        self.seen = []

    def handle_starttag(self, tag, attrs):
        self.seen.append((tag, dict(attrs)))


def assert_harmless_html(html):
    parser = Tags()
    parser.feed(html)
    for tag, attributes in parser.seen:
        assert tag in ALLOWED_TAGS, html
        assert set(attributes) <= {"href", "style", "start", "class", "title", "tabindex"}, html
        assert attributes.get("href", "#").lower().startswith(("#", "http://", "https://", "mailto:")), html


FORBIDDEN_TEX = (r"\input", r"\csname", r"\write", "^^", r"\def", r"\read")


@pytest.mark.parametrize("text", HOSTILE, ids=lambda text: repr(text)[:30])
def test_hostile_text_is_shown_not_run(text):
    assert_harmless_html(to_html(text, draw))
    assert not any(word in to_latex(text) for word in FORBIDDEN_TEX)


SIGNS = "$ $$ <script> </p> [a]( javascript: ) ` * | \\ ^^5c \\input{x} { } & % x^2 \\frac{1}{2} < ! ]".split()
BLOCKS = ["\n\n", "# ", "- ", "> ", "1. "]
FRAGMENTS = st.lists(st.one_of(st.sampled_from(SIGNS + BLOCKS), st.text(max_size=4)), max_size=12).map("".join)


@given(FRAGMENTS)
def test_any_mixture_is_harmless(text):
    assert_harmless_html(to_html(text, draw))
    assert not any(word in to_latex(text) for word in FORBIDDEN_TEX)
    for offset, message in math_problems(text):
        assert 0 <= offset <= len(text)
        assert message


@given(st.text(max_size=30))
def test_plain_text_stays_as_it_is(text):
    words = " ".join(text.replace("\x00", "").split())
    html = inline_html(plain(words), draw)
    parser = Tags()
    parser.feed(html)
    assert not parser.seen


OUR_COMMANDS = {
    "ensuremath",
    *(name for name in re.findall(r"\\\\([A-Za-z]+)", repr(tex_text.SPECIAL | tex_text.MATH))),
}


@given(st.text(max_size=30))
def test_text_for_tex_holds_no_command_but_ours(text):
    latex = escaped(text)
    assert "^^" not in latex
    assert set(re.findall(r"\\([A-Za-z]+)", latex)) <= OUR_COMMANDS
    assert "\\" not in re.sub(r"\\([A-Za-z]+|[{}$&%#_])", "", latex)


def test_names_keep_their_accents_and_other_scripts_are_named():
    assert escaped("Ångström, Łukasz, Gökçe e\u0301") == "Ångström, Łukasz, Gökçe é"
    assert escaped("λ ≤ 5 %") == r"\ensuremath{\lambda} \ensuremath{\le} 5 \%"
    assert escaped("\u4e2d") == "[cjk unified ideograph-4e2d]"
    assert escaped("Mª, Nº 1, ™") == "Mª, Nº 1, ™"


def test_no_font_joins_signs_to_others():
    assert escaped("a -- b --- c") == "a -{}- b -{}-{}- c"
    assert escaped("y'' + 3y' = 1, ,,ja``, ?`") == "y'{}' + 3y' = 1, ,{},ja`{}`, ?{}`"


def test_what_stands_above_or_below_the_line_does_not_fall_to_it():
    assert escaped("2e⁻ˢ, Aᵀ, x² + xₖ₊₁") == (
        r"2e\ensuremath{^{-s}}, A\ensuremath{^{T}}, x\ensuremath{^{2}} + x\ensuremath{_{k+1}}"
    )


@pytest.mark.parametrize(
    ("markdown", "html"),
    [
        ("If $x$, then", '<p>If <span class="glued"><M>x</M>,</span> then</p>'),
        ("so ($y$).", '<p>so <span class="glued">(<M>y</M>).</span></p>'),
        ("$a$ ($b$) $c$", '<p><M>a</M> <span class="glued">(<M>b</M>)</span> <M>c</M></p>'),
        ("$a$, ($b$", '<p><span class="glued"><M>a</M>,</span> <span class="glued">(<M>b</M></span></p>'),
        ("- $z$; see", '<ul>\n<li><span class="glued"><M>z</M>;</span> see</li>\n</ul>'),
        ("no formula, here.", "<p>no formula, here.</p>"),
        ("$a$ , apart", "<p><M>a</M> , apart</p>"),
    ],
)  # fmt: skip
def test_punctuation_stays_on_the_line_of_its_formula(markdown, html):
    for _ in range(2):  # the tokens are kept for other formats
        assert to_html(markdown, lambda formula, _: f"<M>{formula}</M>").strip() == html
    assert "glued" not in to_latex(markdown)
    assert to_text(markdown, 80).count(",") == markdown.count(",")
