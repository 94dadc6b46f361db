"""The usual terms for the words of verdicts, English and German, each with the word that our lists have for it."""

from __future__ import annotations

import re
from collections.abc import Callable

ABBREVIATIONS: tuple[tuple[re.Pattern[str], str | Callable[[re.Match[str]], str]], ...] = tuple(
    (re.compile(pattern), words)
    for pattern, words in (
        (r"(?<![\w.])(?:[gG]\.? ?)?a\. ?s\.(?!\w)", "asymptotically stable"),
        (r"^\s*G?AS\s*$", "asymptotically stable"),
        (r"(?<![\w.])m\. ?s\.(?!\w)", "marginally stable"),
        (r"(?i)(?<![\w.])(?:as|asymp|asympt|exp)\.(?= ?sta)", "asymptotically"),
        (r"(?i)\bpos(?:itiv)?\.\s*", "positive "),
        (r"(?i)\bneg(?:ativ)?\.\s*", "negative "),
        (r"(?i)\b(semi)?-?def\.(?=\s|$)", lambda found: f"{(found[1] or '').lower()}definite"),
        (r"(?i)\b(semi)-(?=definit)", r"\1"),
        (r"(?i)\b(un|over|under)(?:-(?=\w)| (?=damped))", r"\1"),
        (r"(?i)\s*\(?\b(?:spiral(?:l)?ing )?(?:inwards?|einwärts)\b\)?", " stable"),
        (r"(?i)\s*\(?\b(?:spiral(?:l)?ing )?(?:outwards?|auswärts)\b\)?", " unstable"),
        (r"(?i)[,(]?\s*\b(?:i\.? ?s\.? ?l\b\.?|in the sense of (?:lyapunov|ljapunov|liapunov))\)?", ""),
    )
)
"""Short forms of words, and what is said with them that changes nothing."""
IGNORED = {"a", "an", "the", "is", "it", "system", "equilibrium", "point", "matrix", "this", "plant", "ein", "eine",
           "das", "der", "die", "ist", "origin", "loop", "closed", "only", "nur", "globally", "global",
           "circuit", "schaltung", "regelkreis", "strecke"}  # fmt: skip
SYNONYMS = {
    **dict.fromkeys(("spiral", "spirale", "foyer", "strudel", "strudelpunkt", "fokus", "brennpunkt"), "focus"),
    **dict.fromkeys(("centre", "vortex", "wirbel", "wirbelpunkt", "zentrum"), "center"),
    **dict.fromkeys(("nodal", "knoten", "knotenpunkt", "noeud", "nœud"), "node"),
    **dict.fromkeys(("sattel", "sattelpunkt", "selle", "col"), "saddle"),
    **dict.fromkeys(("stern", "sternknoten"), "star"),
    **dict.fromkeys(("improper", "entarteter", "ausgearteter"), "degenerate"),
    **dict.fromkeys(("scherung", "scherströmung"), "shear"),
    **dict.fromkeys(("sink", "senke", "attractive", "attracting"), "stable"),
    **dict.fromkeys(("stabil", "stabile", "stabiler", "stabiles"), "stable"),
    **dict.fromkeys(("source", "quelle", "repelling", "repulsive", "instable"), "unstable"),
    **dict.fromkeys(("instabil", "instabile", "instabiler", "instabiles"), "unstable"),
    **dict.fromkeys(("asymptotic", "asymptotisch", "asymp", "exponentially", "exponentiell"), "asymptotically"),
    **dict.fromkeys(("asymptotiquement", "asympt", "strictly"), "asymptotically"),
    **dict.fromkeys(("asymptotischer", "asymptotisches", "exponential"), "asymptotically"),
    **dict.fromkeys(("marginal", "critically", "neutrally"), "marginally"),
    **dict.fromkeys(("kritisch", "critical"), "critically"),
    **dict.fromkeys(("gedämpft", "damping"), "damped"),
    "ungedämpft": "undamped", "unterdämpft": "underdamped", "überdämpft": "overdamped",
    **dict.fromkeys(("grenzstabil", "grenzstabiler"), "marginally stable"),
    "stability": "stable", "stabilität": "stable", "instability": "unstable", "instabilität": "unstable",
    "borderline": "marginally", "elliptic": "",
    "nicht": "not", "aber": "but", "ljapunow": "lyapunov", "posdef": "positive definite", "positiv": "positive",
    "negativ": "negative", "definit": "definite", "semidefinit": "semidefinite", "indefinit": "indefinite",
}  # fmt: skip
PHRASES = {
    "stable but not asymptotically stable in sense": "marginally stable",
    "stable but not asymptotically stable": "marginally stable",
    "stable but not asymptotically": "marginally stable",
    "stable not asymptotically stable": "marginally stable",
    "stable not asymptotically": "marginally stable",
    "lyapunov stable but not asymptotically stable": "marginally stable",
    "not stable": "unstable",
    **dict.fromkeys(("line of fixed points", "line of equilibrium points"), "line of equilibria"),
    **dict.fromkeys(("every", "all points are fixed points"), "all points are equilibria"),
    **dict.fromkeys(("unstable saddle", "hyperbolic saddle"), "saddle"),
    **dict.fromkeys(("no damped", "without damped", "not damped", "keine dämpfung", "ohne dämpfung"), "undamped"),
    **{f"{weak} {end}": end for weak in ("weak", "schwaches") for end in ("minimum", "maximum")},
    **dict.fromkeys(("schwach damped", "lightly damped", "weakly damped", "schwingfall"), "underdamped"),
    **dict.fromkeys(("unterkritisch damped", "unterkritisch", "periodisch damped", "schwingfähig"), "underdamped"),
    "schwingungsfähig": "underdamped",
    **dict.fromkeys(("stark damped", "heavily damped", "strongly damped", "kriechfall"), "overdamped"),
    **dict.fromkeys(("überkritisch damped", "überkritisch", "aperiodisch damped"), "overdamped"),
    **dict.fromkeys(("aperiodischer grenzfall", "aperiodic limit", "limit of aperiodicity"), "critically damped"),
}
"""What is said in several words, where it is all that is said."""
PARTS = {"proper node": "star", "star node": "star", "asymptotically stable": "stable"}
"""Words beside others, where the list of the answer does not have them."""
ADJECTIVES = {
    "controllable": ("c c", "steuerbar", "commandable", "contrôlable"),
    "observable": ("beobachtbar",),
    "stabilizable": ("stabilisierbar",),
    "detectable": ("detektierbar", "entdeckbar"),
    "diagonalizable": ("diagonalisierbar",),
    "feasible": ("possible", "möglich", "machbar", "erfüllbar", "decouplable", "can be decoupled", "entkoppelbar"),
    "stable": (
        "asymptotically stable",
        "stabil",
        "asymptotisch stabil",
        "asympt stable",
        "asympt stabil",
        "as stable",
        "exponentially stable",
        "exponentiell stabil",
    ),
    "bibo stable": ("stable", "stabil", "bibo stabil", "bibo"),
}
"""Other words for what an answer is called that is yes or no."""
NEGATIONS = ("not ", "nicht ", "non ", "non-", "un", "in", "im", "non", "nicht")
LABELS = {
    "A_{d}": ("Phi", "Φ"), "B_{d}": ("Gamma", "Γ", "H"), "damping_ratio": ("D", "d", "xi", "ξ"),
    "controllability_matrix": ("P", "Q", "M", "U", "S"), "observability_matrix": ("Q", "M", "N", "O"),
    "closed_loop_A": ("A - b k^T", "A - bk", "A - B k^T"), "error_A": ("A - l c^T", "A - lc"),
    "k_I": ("K_i", "K_I", "k_i"), "critical_value": ("K", "k"), "S": ("S_K^T", "S^T"),
    "natural_frequency": ("omega", "ω", "w"), "phase_margin": ("PM", "Phi", "Φ"),
    "gain_margin": ("GM", "A_R", "k_R", "g_m", "G_m", "K_g"),
    "gain_margin_db": ("GM", "A_R", "k_R", "g_m", "G_m", "K_g"),
    "system_type": ("N", "n", "ν", "nu", "l"), "gain": ("K", "k", "k_0", "K_0"),
    "dc_gain": ("K", "k", "K_0", "K_s", "V", "V_0"),
}  # fmt: skip
"""What an answer is called too, by its name or its symbol, where this is what another one is called elsewhere."""
NOUNS = {"nullstellen": "zeros", "nullstelle": "zeros", "zero": "zeros", "pole": "poles", "polstellen": "poles",
         "eigenwerte": "eigenvalues", "moden": "modes", "mode": "modes", "ausnahmen": "exceptions",
         "exception": "exceptions", "lösungen": "solutions", "solution": "solutions"}  # fmt: skip
"""Nouns after no or keine, with the word in the name of the answer."""
