"""The usual mistakes of any task: the names by which a problem says what they cost, and the words of a sheet.

What leads to them is told in `solver.classroom.mistakes`. Several may go by one name: they cost the same.
"""

from __future__ import annotations

from solver.derivation.mistakes import Slip
from solver.words import Phrase

SIGN = Slip("sign", "the sign is reversed")
SIGN_OF_ENTRY = Slip("sign", "the sign of an entry is reversed")
SIGNS_OF_ENTRIES = Slip("sign", "the signs of some entries are reversed")
TRANSPOSED = Slip("transposed", "it is transposed: rows and columns are exchanged")
REVERSED = Slip("reversed", "the entries stand in reverse order")
ROWS_IN_ORDER = Slip("order", "rows or columns stand in another order")
ITEMS_IN_ORDER = Slip("order", "the values are right, but stand in another order")
WRITTEN_AS_ROWS = Slip("rows", "the vectors stand in the rows; they are the columns of the matrix")
WRITTEN_AS_COLUMNS = Slip("rows", "the vectors stand in the columns; they are the rows of the matrix")
MULTIPLICITY = Slip("multiplicity", "each value counts as often as its multiplicity")
HALF = Slip("factor", "a factor 2 is missing")
DOUBLE = Slip("factor", "it is twice what it should be: a factor ½ is missing")
UPSIDE_DOWN = Slip("exchanged", "numerator and denominator are exchanged")
WITHOUT_POWER = Slip("power", "the factor $t$ (or $k$) of a repeated eigenvalue is missing")
EXPONENTS = Slip("exponents", "the sign of the exponents is reversed")
DEGREES = Slip("degrees", "an angle is in degrees where radians are meant")
WITHOUT_A_TERM = Slip("term", "a term is missing")
INTERMEDIATE = Slip("intermediate", "it is an intermediate result: the last step is missing")
CUT_OFF = Slip("rounding", "the last digit is cut off, not rounded")
POLES_REVERSED = Slip("poles_sign", "the poles have the wrong sign")
POLES_SQUARED = Slip("poles_squared", "the poles are squared")
WITHOUT_D = Slip("without_D", "$D$ is forgotten")
A_TRANSPOSED = Slip("A_transposed", "$A$ is transposed")
B_REVERSED = Slip("B_sign", "$B$ has the wrong sign")
OTHER_TIME = Slip("time", "it is right for the other kind of time, discrete or continuous")

USUAL = (
    SIGN, SIGN_OF_ENTRY, SIGNS_OF_ENTRIES, TRANSPOSED, REVERSED, ROWS_IN_ORDER, ITEMS_IN_ORDER, WRITTEN_AS_ROWS,
    WRITTEN_AS_COLUMNS, MULTIPLICITY, HALF, DOUBLE, UPSIDE_DOWN, WITHOUT_POWER, EXPONENTS, DEGREES, WITHOUT_A_TERM,
    INTERMEDIATE, CUT_OFF, POLES_REVERSED, POLES_SQUARED, WITHOUT_D, A_TRANSPOSED, B_REVERSED, OTHER_TIME,
)  # fmt: skip


def of_another_answer(name: str) -> Slip:
    """The value of another answer to the same question, which may be found before this one or after it."""
    return Slip(INTERMEDIATE.name, Phrase("it is the value of another answer, {name}", name=name))
