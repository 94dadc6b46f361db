"""The words and signs of the notation, as tables: functions, constants, Greek letters, look-alikes, limits."""

from __future__ import annotations

MAX_CHARACTERS = 2000
MAX_TOKENS = 600
MAX_DEPTH = 40
MAX_DIGITS = 40
MAX_POWER_OF_TEN = 30
MAX_NAME = 40
MAX_PRIMES = 8

FUNCTIONS = {
    name: name
    for name in (
        *("sqrt", "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh"),
        *("abs", "step", "delta", "inv"),
    )
} | {"ln": "log"}
"""Functions of one argument: as written, and the name they have in the syntax tree."""

CONSTANTS = frozenset({"pi", "e", "j", "inf"})
"""Names with a value of their own, unless the problem declares them."""

GREEK = {
    letter: name
    for name, letters in {
        **{"alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "εϵ", "zeta": "ζ", "eta": "η"},
        **{"theta": "θϑ", "iota": "ι", "kappa": "κ", "lamda": "λ", "mu": "μµ", "nu": "ν", "xi": "ξ"},
        **{"pi": "π", "rho": "ρ", "sigma": "σ", "tau": "τ", "upsilon": "υ", "phi": "φϕ", "chi": "χ", "psi": "ψ"},
        **{"omega": "ω", "Gamma": "Γ", "Delta": "Δ∆", "Theta": "Θ", "Lambda": "Λ", "Xi": "Ξ", "Pi": "Π"},
        **{"Sigma": "Σ", "Upsilon": "Υ", "Phi": "Φ", "Psi": "Ψ", "Omega": "ΩΩ"},
    }.items()
    for letter in letters
}
"""Greek letters and the names they stand for (`lamda` is sympy's spelling; `lambda` is read as it)."""

GREEK_NAMES = frozenset(GREEK.values()) | {"omicron"}

OPERATORS = {sign: sign for sign in "+-*/^()=,±'"} | {
    **{"−": "-", "·": "*", "⋅": "*", "×": "*", "∗": "*", "∕": "/", "÷": "/"},
    **{"′": "'", "’": "'", "″": "''", "‴": "'''"},
}
"""Signs and the operator they stand for (a double prime is two)."""

SUPERSCRIPTS = {"⁰": "0", "¹": "1", "²": "2", "³": "3", "⁴": "4", "⁵": "5", "⁶": "6", "⁷": "7", "⁸": "8", "⁹": "9"} | {
    "⁻": "-"
}

SPACES = frozenset(" \t\r\n\u00a0\u2009\u202f")

INSTEAD = {
    "[": "( )",
    "]": "( )",
    "{": "( )",
    "}": "( )",
    "|": "abs(...)",
    "√": "sqrt(...)",
    "∞": "inf",
    "–": "-",
    "—": "-",
    "ˆ": "^",
    "½": "1/2",
    "¼": "1/4",
    "¾": "3/4",
    '"': "two apostrophes, as in x''",
    "\\": "plain notation, as in a/b and sqrt(x)",
    "$": "the expression without $",
    "∓": "±",
    "°": "the angle in radians, as in 30 pi/180",
    "%": "the fraction, as in 14/100",
    ".": "a digit before or after the point, as in 0.5",
    "!": "the number itself",
    "_": "a letter before the underscore, as in k_1",
    "₀": "x0 or x_0",
    "₁": "x1 or x_1",
    "₂": "x2 or x_2",
    "₃": "x3 or x_3",
    "ẋ": "x'",
    "ẍ": "x''",
    "ẏ": "y'",
}
"""Characters that are not read, and what may be written instead."""

OTHER_FUNCTIONS = {
    **{"arcsin": "asin", "arccos": "acos", "arctan": "atan", "atan2": "atan(y/x)", "log10": "log(x)/log(10)"},
    **{"lg": "log(x)/log(10)", "sec": "1/cos(x)", "csc": "1/sin(x)", "cot": "1/tan(x)", "root": "sqrt"},
    **{"heaviside": "step", "unitstep": "step", "unit_step": "step", "dirac": "delta", "diracdelta": "delta"},
    **{"impulse": "delta", "absolute": "abs", "pow": "x^n"},
}
"""Names (in lower case) under which functions are known elsewhere, and how they are written here."""

OTHER_CONSTANTS = {"oo": "inf", "infinity": "inf", "infty": "inf", "Inf": "inf", "PI": "pi", "zoo": "", "nan": ""}
"""Names that must not become symbols by themselves, and what was meant."""

RESERVED = frozenset({"Symbol", "Integer", "Float", "Rational", "Function", "Matrix"})
"""Names that a result, read back by sympy, would not show as symbols; Python's keywords are refused likewise."""
