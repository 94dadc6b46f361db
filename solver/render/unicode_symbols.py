"""What the commands of our LaTeX dialect are in Unicode."""

from __future__ import annotations

_GREEK_NAMES = [
    "alpha",
    "beta",
    "gamma",
    "delta",
    "epsilon",
    "zeta",
    "eta",
    "theta",
    "iota",
    "kappa",
    "lambda",
    "mu",
    "nu",
    "xi",
    "omicron",
    "pi",
    "rho",
    "varsigma",
    "sigma",
    "tau",
    "upsilon",
    "phi",
    "chi",
    "psi",
    "omega",
]
GREEK = {f"\\{name}": chr(0x3B1 + index) for index, name in enumerate(_GREEK_NAMES)}
GREEK |= {command[0] + command[1].upper() + command[2:]: letter.upper() for command, letter in GREEK.items()}
GREEK |= {r"\varphi": "φ", r"\varepsilon": "ε", r"\vartheta": "ϑ", r"\phi": "φ"}

SYMBOLS = {
    **GREEK,
    **{r"\infty": "∞", r"\ldots": "…", r"\cdots": "⋯", r"\dots": "…", r"\vdots": "⋮", r"\ddots": "⋱", r"\int": "∫"},
    **{r"\sum": "Σ", r"\prod": "Π", r"\partial": "∂", r"\nabla": "∇", r"\ell": "ℓ", r"\top": "⊤", r"\prime": "′"},
    **{r"\forall": "∀", r"\exists": "∃", r"\emptyset": "∅", r"\circ": "∘", r"\dagger": "†", r"\Re": "Re", r"\Im": "Im"},
    **{r"\%": "%", r"\_": "_", r"\&": "&", r"\#": "#", r"\$": "$", "~": " ", "'": "′", r"\lvert": "|", r"\rvert": "|"},
}
BINARY = {
    **{"+": "+", "-": "−", r"\pm": "±", r"\mp": "∓", r"\cdot": "·", r"\times": "×", r"\ast": "∗", r"\cup": "∪"},
    **{r"\cap": "∩", r"\setminus": "∖", r"\oplus": "⊕", r"\otimes": "⊗", r"\wedge": "∧", r"\vee": "∨"},
}
RELATIONS = {
    **{"=": "=", "<": "<", ">": ">", r"\le": "≤", r"\leq": "≤", r"\ge": "≥", r"\geq": "≥", r"\ne": "≠", r"\neq": "≠"},
    **{r"\approx": "≈", r"\equiv": "≡", r"\sim": "∼", r"\to": "→", r"\rightarrow": "→", r"\Rightarrow": "⇒"},
    **{r"\iff": "⇔", r"\Leftrightarrow": "⇔", r"\implies": "⇒", r"\in": "∈", r"\notin": "∉", r"\subset": "⊂"},
    **{r"\ll": "≪", r"\gg": "≫", r"\mid": "|", r"\mapsto": "↦", r"\longrightarrow": "⟶", ":": ":", r"\leftarrow": "←"},
    **{r"\succ": "≻", r"\succeq": "⪰", r"\prec": "≺", r"\preceq": "⪯", r"\propto": "∝", r"\perp": "⊥"},
}
OPERATORS = {
    f"\\{name}": name
    for name in [
        "sin",
        "cos",
        "tan",
        "sinh",
        "cosh",
        "tanh",
        "cot",
        "sec",
        "csc",
        "coth",
        "arcsin",
        "arccos",
        "arctan",
        "exp",
        "ln",
        "log",
        "det",
        "dim",
        "ker",
        "max",
        "min",
        "sup",
        "inf",
        "lim",
        "gcd",
        "arg",
        "deg",
    ]
}
SPACES = {r"\,": "", r"\;": " ", r"\:": " ", r"\!": "", r"\ ": " ", r"\quad": "  ", r"\qquad": "    ", r"\>": " "}
DELIMITERS = {
    **{r"\{": "{", r"\}": "}", r"\lbrace": "{", r"\rbrace": "}", r"\lvert": "|", r"\rvert": "|", r"\vert": "|"},
    **{r"\|": "‖", r"\lVert": "‖", r"\rVert": "‖", r"\langle": "⟨", r"\rangle": "⟩", r"\lfloor": "⌊"},
    **{r"\rfloor": "⌋", r"\lceil": "⌈", r"\rceil": "⌉", r"\lbrack": "[", r"\rbrack": "]"},
}
ACCENTS = {
    **{r"\dot": "\u0307", r"\ddot": "\u0308", r"\dddot": "\u20db", r"\hat": "\u0302", r"\widehat": "\u0302"},
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
