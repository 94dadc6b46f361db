"""Expressions as they are written elsewhere, in our notation: √3, cos2t, j2, u(t), x₁, 20 %, p_21, exp{-t}, Sin[t].

A table of patterns for what means the same in every problem, and rules for names, which mean what the problem says.
Only text is changed; what it means is left to our parser.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable
from math import factorial

import sympy as sp

from solver.classroom.reading.angles import with_one_argument
from solver.classroom.reading.brackets import matching
from solver.classroom.reading.choices import Choices
from solver.classroom.reading.derivatives import only_entry, with_derivatives, with_variations
from solver.classroom.reading.latex import NotReadableError, is_latex, translated
from solver.classroom.reading.real_parts import with_real_parts
from solver.classroom.reading.spelling import respelled
from solver.problem.expressions import ExpressionError, Names
from solver.problem.expressions.notation import CONSTANTS, FUNCTIONS
from solver.problem.expressions.tokens import Kind, tokenize
from solver.problem.expressions.vocabulary import as_product, pieces_of

_SUBSCRIPTS = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")
_FRACTIONS = {"½": "1/2", "¼": "1/4", "¾": "3/4", "⅓": "1/3", "⅔": "2/3", "⅕": "1/5", "⅙": "1/6", "⅛": "1/8"}
_RAISED = "⁺⁻⁰¹²³⁴⁵⁶⁷⁸⁹⁽⁾ᵃᵇᶜᵈᵉᶠᵍʰⁱʲᵏˡᵐⁿᵒᵖʳˢᵗᵘᵛʷˣʸᶻᵅᵝᵟ"
_LOWERED = str.maketrans(_RAISED + "·⋅˙", "+-0123456789()abcdefghijklmnoprstuvwxyzαβδ...")
_FUNCTION = "|".join(
    sorted((each for each in FUNCTIONS if each not in ("step", "delta", "inv")), key=len, reverse=True)
)
_BARE_CALL = re.compile(rf"(?<![A-Za-z_])(?:{_FUNCTION})(?![\w(])(?!\s*\()")
_POLAR = re.compile(r"((?:(?<![A-Za-z_])e\s*\^|\bexp)\s*\()\s*±\s*([ij])(?![A-Za-z_])\s*\*?")
_LIST = re.compile(r"(?<![A-Za-z])\[\s*[-+−]?[\d.]+\s+[-+−√\d.]*[\d.]+\s*\]")
_DOUBLET = (
    r"(?<!\w)d\s*(?:δ|delta)\s*(?:\(\s*t\s*\))?\s*/\s*d\s*t(?!\w)"
    r"|(?<!\w)(?:dirac|delta)\(\s*1\s*,\s*t\s*\)|(?<!\w)delta_dot\s*\(\s*t\s*\)"
)
_DOTTED = "ȧḃċḋėḟġḣṁṅȯṗṙṡṫẇẋẏżȦḢṀṄȮṖṘṠṪẊẎŻ"
_STEPS = ("u", "σ", "sigma", "θ", "theta", "ε", "epsilon", "H", "Θ", "Theta", "us", "u_s")
"""Names of the unit step."""
_RESERVED = re.compile(r"(?:(?<=[-+−*/(\d])|(?<=[-+−*/(\d]\s)|^)(as|is|in|if|or)(?=\s*(?:[-+−*/)^²³]|$))")
"""Products of two letters that are words of Python: a s in s^2 + as + K."""

Change = str | Callable[[re.Match[str]], str]

TABLE: tuple[tuple[re.Pattern[str], Change], ...] = tuple(
    (re.compile(pattern), change)
    for pattern, change in (
        (r"^\s*[=≈]\s*", ""),
        (r"[^\W\d_]\u0308|[ẍẅẗÿẌŸ]", lambda found: f"{unicodedata.normalize('NFD', found[0])[0]}''"),
        (
            r"[^\W\d_]\u0307|[ȧḃċḋėḟġḣṁṅȯṗṙṡṫẇẋẏżȦḢṀṄȮṖṘṠṪẊẎŻ]",
            lambda found: f"{unicodedata.normalize('NFD', found[0])[0]}'",
        ),
        (r"([^\W\d_])(['′]{1,3})_?(\{\d\}|\(\d\)|\d(?!\d)|[₀-₉])", r"\1\3\2"),  # ẍ_1 is x_1''
        (r"([^\W\d_])[({](\d)[)}](['′]{1,3})", r"\1\2\3"),
        (r"[ℯℊⅆⅇⅈⅉ\U0001d400-\U0001d7ff\uff01-\uff5e]", lambda found: unicodedata.normalize("NFKC", found[0])),
        (
            rf"\^?(?=[{_RAISED}·]*[{_RAISED[14:]}])[{_RAISED}](?:[{_RAISED}]|[·⋅˙](?=[{_RAISED}]))*",
            lambda found: f"^({found[0].lstrip('^').translate(_LOWERED)})",
        ),  # e⁻²ᵗ
        (r"%(?=(?:e|pi|i|phi)(?![A-Za-z0-9_]))", ""),  # %e of Maxima
        (r"(?<=[\d)π])\s*rad(?=\s*[)\]}])", ""),  # sin(2t - 2.03 rad)
        (r"\\?\[(?:ExponentialE|ImaginaryI|ImaginaryJ)\]", lambda found: "e" if "E" in found[0][4:] else "j"),
        (r"\+\s*/\s*[-−]|[-−]\s*/\s*\+|∓", "±"),  # +/- for ±
        (r"[—–‒]", "-"),
        (r"[•∙˙]", "*"),
        (r"⁄|(?<=\d)//(?=\d)", "/"),
        (r"√\s*(\d+(?:\.\d+)?)(?=\s+\w)", r" sqrt(\1)"),  # √3 t: the space ends the root
        (r"√", " sqrt "),
        (r"\b(?:np|numpy|math|cmath|sp|sympy)\.(?=[A-Za-z])", ""),  # np.exp(-t)
        (r"∠\s*(±?)\s*([-+]?[\d.]+(?:e\d)?\s*°?|\([^()]*\)|[-+]?atan\([^()]*\))", r"*e^(\1j*\2)"),  # 2∠30°
        (r"\b(?:Rational|Fraction)\s*\(\s*([-+]?\d+)\s*,\s*(\d+)\s*\)", r"(\1/\2)"),
        (r"\b(?:S|Integer)\s*\(\s*([-+]?\d+)\s*\)", r"(\1)"),
        (r"(\d+(?:\.\d+)?(?:e\d)?)\s*(?:°|deg(?:rees?)?\b)", r"(\1*pi/180)"),  # cos(4t - 161.6 deg)
        (r"(?<![\w.])(\d{1,9})\s?(?=[½¼¾⅓⅔⅕⅙⅛])([½¼¾⅓⅔⅕⅙⅛])", lambda found: f"({found[1]}+{_FRACTIONS[found[2]]})"),
        (r"(?<![\w.)])(\d)!(?!=)", lambda found: str(factorial(int(found[1])))),
        (r"½", "(1/2)"),
        (r"¼", "(1/4)"),
        (r"¾", "(3/4)"),
        (r"⅓", "(1/3)"),
        (r"⅔", "(2/3)"),
        (r"⅕", "(1/5)"),
        (r"⅙", "(1/6)"),
        (r"⅛", "(1/8)"),
        (_DOUBLET, "delta'(t)"),
        (r"(?:δ|(?<![A-Za-z_])delta)_\{?([kn])\}?(?!\w)", r"delta(\1)"),
        (r"_?[₀-₉]+", lambda found: f"_{found[0].lstrip('_').translate(_SUBSCRIPTS)}"),  # x₁ for x_1
        (r"_\{\s*(\w+)\s*\}", r"_\1"),  # x_{1}
        (r"_\(\s*(\d+)\s*\)", r"_\1"),
        (r"(?<=\d)\s*[\[(]\s*%\s*[\])]", "%"),  # 9.5 [%]
        (r"(\d+(?:\.\d+)?)\s*(?:%|percent\b|Prozent\b)", r"\1e-2"),
        (r"\.(?=[*/^])", ""),  # MATLAB's 2.*t
        (r"(?<=\d)\.(?![\d.])", ""),  # numpy's 1.
        (r"\bexp\s*\^", "e^"),
        (r"\barc(?=(?:sin|cos|tan)\b)", "a"),
        (r"((?<![A-Za-z_])[a-z]|[)\]])\s+(\d+(?:\.\d+)?\^)", r"\1*\2"),  # k 3^(k-1), (1 + k) 0.5^k, Sqrt[6] 3^(1/4)
        (r"([)\]])\s+(\d+(?:\.\d+)?/)", r"\1*\2"),  # exp(-s) 1/(s + 2)
        (rf"(?<![A-Za-z_])({_FUNCTION})(?=\d)(?!(?:2|10)\s*\()", r"\1 "),  # cos2t, but not log10(t)
        (rf"(?<![A-Za-z_])(?i:({_FUNCTION}))\s*(?=[\[{{(])", lambda found: found[1].lower()),  # Sin[t], exp{-t}
        (r"(?<![\w)\]])([a-zA-Z])\[\s*([kn](?:\s*[-−+]\s*\d+)?)\s*\]", r"\1(\2)"),  # u[n] of a sequence
        (r"\{", "("),
        (r"\}", ")"),
        (r"\[", "("),
        (r"\]", ")"),
        (r"(?<![\w)|])\|([^|]*)\|(?=\s*(?:[-+*/)^]|$))", r"abs(\1)"),
    )
)
"""What is written elsewhere, and what it is called here."""


def plain(text: str, names: Names, choices: Choices) -> str:
    """Return the text of an expression in our notation. Raises NotReadableError for LaTeX that is none."""
    if is_latex(text):
        text = translated(text)
    if _LIST.search(text):
        raise NotReadableError("a list stands where one value is expected")
    text = respelled(text).strip().rstrip(".;").rstrip()
    text = _RESERVED.sub(lambda found: _as_letters(found[1], names), text)
    for pattern, change in TABLE:
        text = pattern.sub(change, text)
    text = with_one_argument(text)
    text = _with_units(_with_steps(_with_polar(_with_signs(text, choices)), names), names)
    text = with_real_parts(text, names, lambda inside: _with_names(inside, names))
    return _with_names(with_derivatives(with_variations(text, names), names), names)


def _as_letters(word: str, names: Names) -> str:
    """The product of the letters of a word, where the problem has the first of them."""
    first, second = word[0], word[1]
    known = first in {**names.symbols, **names.values} and names.declares(second)
    return f"{first} {second}" if known else word


def has_bare_call(text: str) -> bool:
    """Whether a function stands without brackets, cos 2t."""
    return bool(_BARE_CALL.search(text))


def _with_signs(text: str, choices: Choices) -> str:
    """+- may be ± or two signs."""
    pattern = re.compile(r"\+\s?[-−]")
    if not pattern.search(text):
        return text
    return pattern.sub(choices.choose("+-", ("±", "-")), text)


def _with_polar(text: str) -> str:
    """e^(±jφ) as cos φ ± j sin φ."""
    while found := _POLAR.search(text):
        end = matching(text, found.end(1) - 1)
        angle = text[found.end() : end].strip() or "1"
        text = f"{text[: found.start()]}(cos({angle}) ± {found[2]}*sin({angle})){text[end + 1 :]}"
    return text


def _with_steps(text: str, names: Names) -> str:
    """u(t - 2), σ(t), 1(t) as step(t - 2), … where the problem has no such name."""
    declared = {*names.symbols, *names.values, *names.functions}
    declared |= {each.partition("(")[0] for each in names.symbols if "(" in each}  # u(k) of a difference equation
    free = "|".join(name for name in _STEPS if name not in declared)
    call = re.compile(rf"(?:(?<![A-Za-z_])(?:{free})|(?<![\w.])1)\s*\((?=\s*[-−]?\s*(?:\w+\s*[-−]\s*)?([tkn])(?!\w))")
    return call.sub(lambda found: found[0] if _is_parameter(found[1], names) else "step(", text)


def _is_parameter(name: str, names: Names) -> bool:
    """Whether the problem gives the name of a variable of time to something else."""
    return name in names.values or names.symbols.get(name, sp.Symbol(name)) != sp.Symbol(name)


def _with_units(text: str, names: Names) -> str:
    """j2 and i√3 as products, where the problem has no such name."""

    def product(found: re.Match[str]) -> str:
        declared = names.declares(found[0]) or names.declares(f"{found[1]}_{found[2]}") or found[1] in names.symbols
        return found[0] if declared else f"({found[1]}*{found[2]})"

    text = re.sub(r"(?<![\w.])([ijI])\s?(\d+(?:\.\d+)?)(?![.\d^])", product, text)
    return re.sub(rf"(?<![\w.])([ijI])(?=(?:{_FUNCTION})\b)", r"\1 ", text)


def _with_names(text: str, names: Names) -> str:
    """Names as the problem spells them: x_1 for x1, p21 for p12 of a symmetric matrix; te as the product t e."""
    try:
        tokens = tokenize(text)
    except ExpressionError:
        return text  # the parser says what is wrong with it
    pieces, at = [], 0
    for token in tokens:
        if token.kind is not Kind.NAME:
            continue
        name = token.text
        known = names.declares(name) or name in CONSTANTS or name in FUNCTIONS
        meant = name if known else _meant(name, names)
        if meant != name:
            pieces += [text[at : token.at], meant]
            at = token.end
    return "".join([*pieces, text[at:]])


def _meant(name: str, names: Names) -> str:
    """The declared name that an undeclared one stands for, or the product of declared ones."""
    declared = (*names.symbols, *names.values)
    bare = {known.replace("_", "").replace("omega", "w"): known for known in declared}  # wn for omega_n
    bare |= {known.replace("_", ""): known for known in declared}
    squeezed = name.replace("_", "")
    if squeezed in bare:
        return bare[squeezed]
    if found := re.fullmatch(r"([A-Za-z]+)(\d)(\d)", squeezed):
        mirrored = bare.get(f"{found[1]}{found[3]}{found[2]}")
        diagonal = f"{found[1]}11" in bare
        if mirrored and diagonal:
            return mirrored
    if (found := re.fullmatch(r"([a-z])([1-9])", squeezed)) and f"{found[1]}11" in bare:
        upper = sorted(each for each in bare if re.fullmatch(rf"{found[1]}\d\d", each) and each[-2] <= each[-1])
        if int(found[2]) <= len(upper):  # p1, p2, p3 of a symmetric matrix
            return bare[upper[int(found[2]) - 1]]
    if alone := only_entry(name, names.symbols):
        return alone
    if (found := re.fullmatch(rf"({_FUNCTION})([a-zA-Z])", name)) and names.declares(found[2]):
        return f"{found[1]} {found[2]}"
    indexed = re.fullmatch(r"[^\W\d_]{2,}_\d+", name)  # kx_1
    written = squeezed if indexed else name
    meanings = bare | {known: known for known in names.known()}
    factors = " ".join(meanings[piece] for piece in pieces_of(written, set(meanings)))  # p1p2 for p_1 p_2
    return as_product(written, names).replace("*", " ") or factors or name
