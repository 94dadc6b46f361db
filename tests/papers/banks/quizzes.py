"""A bank of questions made by hand, with each kind of field, hostile texts, a picture, and variants."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction

from solver.papers.export.quiz import (
    Asked,
    Choice,
    Content,
    Essay,
    Fixed,
    Group,
    Heading,
    Item,
    Number,
    Picture,
    Quiz,
    Text,
    Wrong,
)  # fmt: skip
from solver.problem.images import Image

HOSTILE = "</p><script>alert(1)</script> ]]> & \"quoted\" 'too' 😀 {~=#} $$ \\( \\["
DRAWING = Image(
    "image/svg+xml", b'<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><path d="M0 0h9"/></svg>'
)
SIGN = "The law is $u = -K x$: look at the sign."
STATEMENT = """\
The plant has $x_1 < x_2$ and

$$A = \\begin{bmatrix} 0 & 1 \\\\ -2 & -3 \\end{bmatrix}$$

| gain | value |
|------|------:|
| $k$  | 2     |

1. one, see [above](#question)
2. `two` and [the web](https://example.org/?a=1&b=2)

> quoted, ![a plant](plant.svg)
"""


def number(key, value, tolerance="0", *wrong):
    """Return a field; wrong values are (value, share, hint)."""
    slips = tuple(Wrong(Decimal(each), Decimal(tolerance), Fraction(share), hint) for each, share, hint in wrong)
    return Number(key, f"entry {key}", Decimal(value), Decimal(tolerance), Fraction(1), value, slips)


def content(text=STATEMENT, hostile=HOSTILE):
    """Return content with all that content may have."""
    plain = hostile.replace("[", "\\[").replace("`", "").replace("$", "\\$")
    blocks = (Heading("Given $x_1$"), Text(text), Text(plain), Picture(DRAWING, hostile, "Fig. $a^2$"))
    return Content(blocks, {"plant.svg": DRAWING})


GAIN = Asked(
    "K", "K", "the gain of the feedback u = −Kx", "Whole numbers.", Fraction(4),
    ((number("k-1-1", "4", "0", ("-4", "1/2", SIGN)), number("k-1-2", "3", "0", ("-3", "1/2", SIGN), ("8", "0", "no"))),
     (number("k-2-1", "0"), number("k-2-2", "-12"))),
    grid=True,
)  # fmt: skip
POLES = Asked(
    "poles", "p", "the poles", "In ascending order.", Fraction(1),
    ((Fixed("p_1 ="), number("p-1", "-1.06066", "0.005")), (Fixed("p_2 ="), number("p-2", "0.33", "0.005")),
     (Fixed("p_3 ="), number("p-3", "1.2", "0.05", ("2.4", "0", "")))),
)  # fmt: skip
STABLE = Asked(
    "stable", r"\text{stable}", "whether it is stable", "", Fraction(1),
    ((Fixed(r"\text{stable} ="), Choice("stable", "stable", ("yes", "no & <never>"), 1, Fraction(1))),),
)  # fmt: skip
MARGIN = Asked(
    "margin", "g", "the gain margin", "", Fraction(1),
    ((Fixed("g ="), number("g", "999999")),),
)  # fmt: skip
FRACTION = Asked(
    "G", "G", "the transfer function", "The denominator is monic.", Fraction(3),
    ((Fixed("G(s) ="), number("n-0", "1.5", "0.05", ("2.5", "1/3", "twice")), Fixed("/(s^2 +"),
      number("d-1", "3.2", "0.05", ("3.9", "1/3", "twice")), Fixed("s +"), number("d-0", "2"), Fixed(")")),),
    whole=True,
)  # fmt: skip
CONTROLLABLE = Asked(
    "controllable", "c", "whether it is controllable", "", Fraction(5),
    ((Fixed("c ="), Choice("c", "c", ("yes", "no"), 0, Fraction(5))),),
)  # fmt: skip
KEY = Essay((("T", "a matrix that makes it diagonal"),), content("T = ..."), {"T": "there are many"})


def item(identifier, answers=(), essay=None, variant="", marks=None):
    """Return an item with the marks of its answers."""
    total = sum((asked.marks for asked in answers), Fraction(0)) if marks is None else Fraction(marks)
    told = f"1 <b> ]]> & {identifier}"
    return Item(identifier, told, content(), content("worked"), total, tuple(answers), essay, ("tag",), variant)


def quiz(variants=("1", "2")):
    """Return a quiz: a question in variants with two parts, and one that is the same in all."""
    parts = (
        ("a", [item(f"place-a-{v}", (GAIN, POLES, STABLE, MARGIN, FRACTION), None, v) for v in variants]),
        ("b", [item(f"place-b-{v}", (), KEY, v, 5) for v in variants]),
    )
    groups = [Group(("Final", "1. Regulator", part), tuple(items)) for part, items in parts]
    fixed = Group(("Final", "2. Fixed", "a"), (item("fixed-a", (CONTROLLABLE,)),))
    return Quiz(f"Final {HOSTILE}", "EE & 451", "en", (*groups, fixed))


def single_questions(variants=("1", "2", "3")):
    """Return a quiz whose questions have one field each."""
    items = tuple(item(f"one-a-{v}", (CONTROLLABLE,), None, v) for v in variants)
    essays = tuple(item(f"two-a-{v}", (), KEY, v, 5) for v in variants)
    return Quiz("Short", "", "de", (Group(("Short", "1. One", "a"), items), Group(("Short", "2. Two", "a"), essays)))
