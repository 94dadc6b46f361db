"""What the commands of our LaTeX dialect are in Unicode."""

from __future__ import annotations

_GREEK_NAMES = (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho varsigma sigma tau "
    "upsilon phi chi psi omega"
).split()
GREEK = {f"\\{name}": chr(0x3B1 + index) for index, name in enumerate(_GREEK_NAMES)}
GREEK |= {command[0] + command[1].upper() + command[2:]: letter.upper() for command, letter in GREEK.items()}
GREEK |= {r"\varphi": "φ", r"\varepsilon": "ε", r"\vartheta": "ϑ", r"\phi": "φ"}

CHARACTERS = {
    **GREEK,
    **{r"\infty": "∞", r"\ldots": "…", r"\cdots": "⋯", r"\dots": "…", r"\vdots": "⋮", r"\ddots": "⋱", r"\int": "∫"},
    **{r"\sum": "Σ", r"\prod": "Π", r"\partial": "∂", r"\nabla": "∇", r"\ell": "ℓ", r"\top": "⊤", r"\prime": "′"},
    **{r"\forall": "∀", r"\exists": "∃", r"\emptyset": "∅", r"\varnothing": "∅", r"\circ": "∘", r"\dagger": "†"},
    **{r"\bot": "⊥", r"\angle": "∠", r"\neg": "¬", r"\lnot": "¬", r"\hbar": "ℏ", r"\iint": "∬", r"\oint": "∮"},
    **{r"\varpi": "ϖ", r"\varrho": "ϱ", r"\backslash": "\\"},
    **{"-": "−", r"\pm": "±", r"\mp": "∓", r"\cdot": "·", r"\times": "×", r"\ast": "∗", r"\cup": "∪", r"\cap": "∩"},
    **{r"\setminus": "∖", r"\oplus": "⊕", r"\ominus": "⊖", r"\otimes": "⊗", r"\wedge": "∧", r"\vee": "∨", r"\div": "÷"},
    **{r"\land": "∧", r"\lor": "∨", r"\star": "⋆", r"\bullet": "•"},
    **{r"\le": "≤", r"\leq": "≤", r"\ge": "≥", r"\geq": "≥", r"\ne": "≠", r"\neq": "≠", r"\colon": ":", r"\ni": "∋"},
    **{r"\approx": "≈", r"\equiv": "≡", r"\sim": "∼", r"\simeq": "≃", r"\cong": "≅", r"\to": "→", r"\rightarrow": "→"},
    **{r"\Rightarrow": "⇒", r"\iff": "⇔", r"\Leftrightarrow": "⇔", r"\implies": "⇒", r"\Leftarrow": "⇐", r"\gets": "←"},
    **{r"\leftarrow": "←", r"\leftrightarrow": "↔", r"\longrightarrow": "⟶", r"\mapsto": "↦", r"\triangleq": "≜"},
    **{r"\in": "∈", r"\notin": "∉", r"\subset": "⊂", r"\subseteq": "⊆", r"\supset": "⊃", r"\supseteq": "⊇"},
    **{r"\ll": "≪", r"\gg": "≫", r"\mid": "|", r"\parallel": "∥", r"\perp": "⊥", r"\propto": "∝", r"\succ": "≻"},
    **{r"\prec": "≺", r"\{": "{", r"\}": "}", r"\lbrace": "{", r"\rbrace": "}", r"\lbrack": "[", r"\rbrack": "]"},
    **{r"\lvert": "|", r"\rvert": "|", r"\vert": "|", r"\|": "‖", r"\Vert": "‖", r"\lVert": "‖", r"\rVert": "‖"},
    **{r"\langle": "⟨", r"\rangle": "⟩", r"\lfloor": "⌊", r"\rfloor": "⌋", r"\lceil": "⌈", r"\rceil": "⌉"},
}
"""Commands that are drawn neither as their name nor as themselves."""

SPACES = {r"\;": " ", r"\:": " ", r"\ ": " ", r"\quad": "  ", r"\qquad": "    ", r"\enspace": " "}
ACCENTS = {
    **{
        r"\dot": "\u0307",
        r"\ddot": "\u0308",
        r"\dddot": "\u20db",
        r"\check": "\u030c",
        r"\underline": "\u0332",
        r"\hat": "\u0302",
        r"\widehat": "\u0302",
    },
    **{r"\tilde": "\u0303", r"\widetilde": "\u0303", r"\bar": "\u0304", r"\overline": "\u0304", r"\vec": "\u20d7"},
}
SUPERSCRIPTS = dict(
    zip("0123456789+-−=()nijktTxyzabcdefghlmoprsuvw*′⊤ABDEGHIJKLMNOPRUW",
        "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁻⁼⁽⁾ⁿⁱʲᵏᵗᵀˣʸᶻᵃᵇᶜᵈᵉᶠᵍʰˡᵐᵒᵖʳˢᵘᵛʷ*′ᵀᴬᴮᴰᴱᴳᴴᴵᴶᴷᴸᴹᴺᴼᴾᴿᵁᵂ", strict=True)
)  # fmt: skip
SUBSCRIPTS = dict(zip("0123456789+-−=(),aehijklmnoprstuvx", "₀₁₂₃₄₅₆₇₈₉₊₋₋₌₍₎‚ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ", strict=True))

_PLACED_ELSEWHERE = dict(zip("BEFHILMR", "ℬℰℱℋℐℒℳℛ", strict=True))
_CAPITALS = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
SCRIPT = {letter: _PLACED_ELSEWHERE.get(letter, chr(0x1D49C + index)) for index, letter in enumerate(_CAPITALS)}
BLACKBOARD = dict(zip("CHNPQRZ", "ℂℍℕℙℚℝℤ", strict=True))
LETTERS = {r"\mathcal": SCRIPT, r"\mathbb": BLACKBOARD}
