r"""The commands and characters of formulas: a white list, by what they are. TeX never sees anything else.

A black list of commands cannot keep a formula from reading files (`^^5cinput`, `\csname`), so this is a white list.
"""

from __future__ import annotations

import re
from string import ascii_letters


def _commands(words: str) -> frozenset[str]:
    return frozenset(f"\\{word}" for word in words.split())


LETTERS = _commands(
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon phi chi psi "
    "omega varepsilon vartheta varpi varrho varsigma varphi Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega "
    "partial nabla infty forall exists emptyset varnothing ell hbar Re Im top bot angle prime dagger neg lnot "
    "ldots cdots vdots ddots dots backslash"
)
RELATIONS = frozenset("=<>:") | _commands(
    "le leq ge geq ne neq approx equiv sim simeq cong propto ll gg in notin ni subset subseteq supset supseteq perp "
    "parallel mid to gets rightarrow leftarrow Rightarrow Leftarrow leftrightarrow Leftrightarrow longrightarrow "
    "mapsto implies iff prec succ triangleq colon"
)
BINARY = frozenset("+-*") | _commands(
    "pm mp times div cdot ast star circ bullet oplus ominus otimes cup cap setminus wedge vee land lor"
)
LARGE = _commands("sum prod int iint oint")
FUNCTIONS = _commands(
    "sin cos tan cot sec csc arcsin arccos arctan sinh cosh tanh coth exp ln log lg det dim ker max min sup inf "
    "lim deg gcd Pr"
)
PUNCTUATION = frozenset(",;.!?/")
SPACES = _commands("quad qquad enspace thinspace displaystyle textstyle") | {f"\\{sign}" for sign in ",:;! "}
PAIRS = {
    **{"(": ")", "[": "]", r"\{": r"\}", r"\lbrace": r"\rbrace", r"\lbrack": r"\rbrack", r"\langle": r"\rangle"},
    **{r"\lvert": r"\rvert", r"\lVert": r"\rVert", r"\lfloor": r"\rfloor", r"\lceil": r"\rceil"},
}
"""Brackets that open, and what closes them."""

CLOSING = frozenset(PAIRS.values())
BRACKETS = CLOSING | PAIRS.keys()
BARS = frozenset("|") | _commands("vert Vert |")
DELIMITERS = frozenset("/.") | BRACKETS | BARS
r"""What may stand after `\left` and `\right`."""

FRACTIONS = _commands("frac dfrac tfrac binom")
STACKS = _commands("overset underset")
ACCENTS = _commands("dot ddot dddot hat tilde bar vec check widehat widetilde overline underline")
ALPHABETS = _commands("mathrm mathbf mathit mathsf mathtt mathbb mathcal mathfrak boldsymbol boxed")
TEXTS = _commands("text mbox textbf textit textrm operatorname")
TAKES_ARGUMENT = FRACTIONS | STACKS | ACCENTS | ALPHABETS | TEXTS | _commands("sqrt left begin")

MATRICES = ("matrix", "pmatrix", "bmatrix", "Bmatrix", "vmatrix", "Vmatrix", "smallmatrix")
ENVIRONMENTS = {**dict.fromkeys(MATRICES, 30), "cases": 2, "aligned": 12, "array": 1}
"""The environments, with the number of cells that a row may have (of an array as many as its columns say)."""

COLUMNS = re.compile(r"\{([lcr|]{1,40})\}")
WORDS = re.compile(r"\{([A-Za-z0-9 .,;:!?()\[\]+*/='-]*)\}")
ENVIRONMENT = re.compile(r"\{([a-z]+|[BV]matrix)\}")

_TYPED = "αβγδεζηθικλμνξπρστυφχψωΓΔΘΛΞΠΣΦΨΩ"
_TYPED_NAMES = (
    "alpha beta gamma delta varepsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon "
    "varphi chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Phi Psi Omega"
)
GREEK_LETTERS = dict(zip(_TYPED, _TYPED_NAMES.split(), strict=True))
"""Greek letters typed as such; they are letters of a formula too."""

SYMBOLS = frozenset(ascii_letters) | LETTERS | GREEK_LETTERS.keys()
OPERATORS = RELATIONS | BINARY | LARGE | PUNCTUATION | BARS | BRACKETS
