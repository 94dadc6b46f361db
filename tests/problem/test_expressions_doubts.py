"""What has two readings: refused without a decision, read as decided with one."""

import pytest
import sympy as sp

from solver.problem.expressions import Doubt, ExpressionError, Names, parse_alternatives, parse_written

s, t = sp.symbols("s t")
w, T = sp.symbols("w T", real=True)
d = sp.Symbol("d", real=True)
NAMES = Names({"w": w, "T": T}, {"s": s, "t": t}, {}, {}, open=True)


def readings(text, decimals=None):
    """The values of a text where every doubt is decided with no, and with yes."""
    return [parse_written(text, NAMES, decimals or {}, lambda _, yes=yes: yes)[0][0] for yes in (False, True)]


@pytest.mark.parametrize(
    ("text", "otherwise", "value"),
    [
        ("1/2 t", t / 2, 1 / (2 * t)),
        ("1/2 e^(-t)", sp.exp(-t) / 2, sp.exp(t) / 2),
        ("3/2 w t", 3 * w * t / 2, 3 / (2 * w * t)),
        ("e^-2 t", sp.exp(-2) * t, sp.exp(-2 * t)),
        ("e^-2 w t", sp.exp(-2) * w * t, sp.exp(-2 * w * t)),
        ("e^2 t sin 3t", sp.exp(2) * t * sp.sin(3 * t), sp.exp(2 * t) * sp.sin(3 * t)),
        ("e^-2(t - 1)", sp.exp(-2) * (t - 1), sp.exp(-2 * (t - 1))),
        ("sin t/2", sp.sin(t) / 2, sp.sin(t / 2)),
        ("sin t^2", sp.sin(t) ** 2, sp.sin(t**2)),
        ("cos 2*t", sp.cos(2) * t, sp.cos(2 * t)),
        ("cos 2(t - 1)", sp.cos(2) * (t - 1), sp.cos(2 * t - 2)),
        ("sqrt 3 t", sp.sqrt(3) * t, sp.sqrt(3 * t)),
    ],
)
def test_what_is_in_doubt_is_read_as_decided_and_refused_where_nobody_decides(text, otherwise, value):
    assert readings(text) == [otherwise, value]
    with pytest.raises(ExpressionError):
        parse_alternatives(text, NAMES)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("cos 2t + 1", sp.cos(2 * t) + 1),
        ("2 cos w t e^(-t) sin 3t", 2 * sp.cos(w * t) * sp.exp(-t) * sp.sin(3 * t)),
        ("exp -2t", sp.exp(-2 * t)),
        ("e^-2t sin 3t", sp.exp(-2 * t) * sp.sin(3 * t)),
        ("sqrt 3/2", sp.sqrt(3) / 2),
        ("sqrt 3 j", sp.sqrt(3) * sp.I),
        ("sin^2(t) + cos² t", sp.sin(t) ** 2 + sp.cos(t) ** 2),
        ("ln 2", sp.log(2)),
        ("e^-2 e^-t", sp.exp(-2) * sp.exp(-t)),
        ("1/2*t", t / 2),
    ],
)
def test_what_has_one_reading_is_not_in_doubt(text, value):
    def never(doubt):
        raise AssertionError(doubt)

    assert parse_written(text, NAMES, {}, never)[0][0] == value


@pytest.mark.parametrize("text", ["sin^-1(t)", "sin^t(t)", "cos", "cos )", "sqrt +", "exp -", "sin e^t cos"])
def test_what_is_no_argument_is_refused(text):
    with pytest.raises(ExpressionError):
        parse_written(text, NAMES, {}, lambda _: True)


def test_many_signs_of_an_argument_are_bounded():
    with pytest.raises(ExpressionError, match="nested deeper"):
        parse_written("sin " + "-" * 100 + "t", NAMES, {}, lambda _: True)


def test_a_decimal_has_its_symbol_wherever_it_stands():
    ((value, form),) = parse_written("e^-2.5 t + (0.5)", NAMES, {3: d, 12: T}, lambda doubt: doubt is Doubt.EXPONENT)
    assert value == sp.exp(sp.Rational(-5, 2) * t) + sp.Rational(1, 2)
    assert form == sp.exp(-d * t) + T
