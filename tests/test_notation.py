"""Symbols of quantities in texts, as a notation spells them."""

import pytest

from solver.notation import answer_symbol, spelled


@pytest.mark.parametrize(
    ("text", "course", "ogata"),
    [
        (r"$A - B\sym{K}$", r"$A - BK_f$", r"$A - BK$"),
        (r"$\sym{damping_ratio}$", r"$\xi$", r"$\zeta$"),
        (r"$\sym{damping_ratio}t$", r"$\xi t$", r"$\zeta t$"),
        (r"$\sym{damping_ratio}2$", r"$\xi2$", r"$\zeta2$"),
        (r"$\sym{K}x$ and $\sym{L}y$", r"$K_fx$ and $L_cy$", r"$Kx$ and $K_ey$"),
        (r"$\sym{Phi}x$", r"$\Phi(t)x$", r"$\Phi(t)x$"),
        ("nothing", "nothing", "nothing"),
    ],
)
def test_a_symbol_is_spelled_as_in_the_notation_and_a_command_ends_before_a_letter(text, course, ogata):
    assert (spelled(text, "course"), spelled(text, "ogata")) == (course, ogata)


def test_an_answer_has_the_symbol_declared_or_that_of_its_name_or_none():
    assert answer_symbol("K", r"\sym{L}", "ogata") == r"\sym{L}"
    assert (answer_symbol("K", "", "course"), answer_symbol("K", "", "ogata")) == ("K_f", "K")
    assert answer_symbol("verdict", "", "course") == ""
