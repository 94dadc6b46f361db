"""The colours of drawings, on paper and in the dark, and what else tells curves apart: dashes and signs."""

from __future__ import annotations

PAPER, INK, SOFT, GRID, FILL, AREA = "#ffffff", "#222222", "#6b7280", "#e3e3e3", "#eef3f9", "#dcebdd"

COLOURS = ("#1f5fa8", "#c2410c", "#15803d", "#7e22ce", "#a16207", "#0e7490", "#be123c", "#4d4d4d")
"""Dark enough on white to be told apart; each has a dash or a sign of its own too."""

DARK = {
    PAPER: "#15171c", INK: "#e4e2dc", SOFT: "#9aa1ac", GRID: "#333842", FILL: "#232a36", AREA: "#1f3526",
    "#1f5fa8": "#86b5f5", "#c2410c": "#ff9f6b", "#15803d": "#6fd08f", "#7e22ce": "#cf9dff", "#a16207": "#e5c15c",
    "#0e7490": "#5fd0e6", "#be123c": "#ff93a6", "#4d4d4d": "#c3c3c3",
}  # fmt: skip
"""What each colour is in the dark."""

SIGNS = {"cross": "x", "ring": "o", "square": "s", "diamond": "D"}
"""Signs of roots: as matplotlib names them. Only the cross is no outline."""


def dark_style() -> str:
    """Return the style sheet by which a drawing changes its colours in the dark; paper is always light."""
    rules = "".join(
        f'[style*="{side}: {light}"]{{{side}:{dark} !important}}'
        for light, dark in DARK.items()
        for side in ("fill", "stroke")
    )
    return f"<style>@media screen and (prefers-color-scheme: dark){{{rules}}}</style>"
