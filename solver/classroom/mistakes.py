"""What went wrong, in words: the usual mistakes are run through the question; said only where one gives the very value.

A mistake is words and the values it leads to: our answer transformed (a sign, a transpose), an intermediate result, or
the answer to a question that was changed as the mistake changes it (poles with the wrong sign, Aᵀ for A).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import islice, permutations
from typing import Any

import sympy as sp

from solver.classroom.judging import STRANGE, Question, entrywise, is_scalar, judge
from solver.classroom.values import Submitted
from solver.classroom.verdicts import Verdict
from solver.derivation import PartResult, Unsolved
from solver.engine import given_of, solve_part
from solver.lazy import exact
from solver.problem.model import Part
from solver.systems import StateSpace

MOST_PERMUTATIONS = 24

COUNTS = ("rank", "orders", "right_half_plane_roots")
"""Answers that many mistakes lead to; yes or no, and words, are others. That one does so says nothing."""


@dataclass(frozen=True)
class Case:
    """One wrong value: the part, its question, the answer's name, our value and results."""

    part: Part
    question: Question
    name: str
    ours: Any
    results: Sequence[PartResult]
    earlier: Mapping[str, PartResult]


Values = Iterator[Any]


def what_went_wrong(
    part: Part,
    question: Question,
    name: str,
    submitted: Submitted,
    results: Sequence[PartResult],
    earlier: Mapping[str, PartResult],
) -> str:
    """Return the mistake that leads to the value, in words (Markdown); "" where none of the usual ones does."""
    if name in COUNTS or isinstance(question.ours.get(name), bool | str):
        return ""
    case = Case(part, question, name, question.ours.get(name), results, earlier)
    if not _telling(submitted.value):
        return ""
    for words, values in TRANSFORMED:
        if any(_reproduces(submitted, value) for value in _careful(values, case)):
            return words
    for words, holds in ALIKE:
        if _holds(holds, submitted, case.ours):
            return words
    for words, change in CHANGED:
        if _answers_changed(case, submitted, change):
            return words
    return ""


def _telling(value: Any) -> bool:
    """Whether a mistake would hardly give the value by chance, as it would yes, no, or a rank."""
    if isinstance(value, list):
        return bool(value) and not isinstance(value[0], bool | str)
    return isinstance(value, sp.MatrixBase) or (is_scalar(value) and not value.is_Integer)


def _reproduces(submitted: Submitted, value: Any) -> bool:
    """Whether the submitted value is this one, entry by entry, to the digits written."""
    if isinstance(value, list) and len(value) != len(submitted.value):
        return False
    return _right(entrywise(submitted, value))


def _right(entries: Any) -> bool:
    if isinstance(entries, list):
        return bool(entries) and all(map(_right, entries))
    return bool(entries == Verdict.CORRECT)


def _careful(values: Callable[[Case], Iterable[Any]], case: Case) -> Iterator[Any]:
    """Yield the values of a mistake that can be made here."""
    try:
        yield from values(case)
    except (*STRANGE, exact.NotExact):  # the mistake has no meaning for this kind of value
        return


def _negative(case: Case) -> Values:
    if isinstance(case.ours, list):
        yield [-item for item in case.ours]
    elif isinstance(case.ours, sp.MatrixBase | sp.Expr):
        yield -case.ours


def _transposed(case: Case) -> Values:
    if isinstance(case.ours, sp.MatrixBase):
        yield case.ours.T


def _reversed(case: Case) -> Values:
    """The entries of a row or column from the last to the first."""
    M = case.ours
    if isinstance(M, sp.MatrixBase) and 1 in M.shape:
        yield sp.ImmutableMatrix(*M.shape, list(reversed(M.flat())))


def _reordered(case: Case) -> Values:
    """Rows or columns in another order."""
    M = case.ours
    if isinstance(M, sp.MatrixBase) and 1 not in M.shape:
        for order in islice(permutations(range(M.rows)), MOST_PERMUTATIONS):
            yield M.extract(list(order), list(range(M.cols)))
        for order in islice(permutations(range(M.cols)), MOST_PERMUTATIONS):
            yield M.extract(list(range(M.rows)), list(order))


def _half(case: Case) -> Values:
    if isinstance(case.ours, sp.MatrixBase | sp.Expr):
        yield case.ours / 2


def _double(case: Case) -> Values:
    if isinstance(case.ours, sp.MatrixBase | sp.Expr):
        yield case.ours * 2


def _without_multiplicity(case: Case) -> Values:
    if isinstance(case.ours, list):
        yield list(dict.fromkeys(case.ours))


def _without_factor_t(case: Case) -> Values:
    """The powers of t (or k) before an exponential left out: e^{λt} for t e^{λt}, or the whole term."""
    for x in (sp.Symbol("t"), sp.Symbol("k")):
        if x in case.ours.free_symbols:
            yield _map(case.ours, partial(_drop_powers, x=x, keep=True))
            yield _map(case.ours, partial(_drop_powers, x=x, keep=False))


def _drop_powers(expression: sp.Expr, x: sp.Symbol, *, keep: bool) -> sp.Expr:
    terms = []
    for term in sp.Add.make_args(sp.expand(expression)):
        powers = [factor for factor in sp.Mul.make_args(term) if factor.as_base_exp()[0] == x]
        terms.append(term / sp.Mul(*powers) if keep else (sp.Integer(0) if powers else term))
    return sp.Add(*terms)


def _exponent_reversed(case: Case) -> Values:
    t = sp.Symbol("t")
    if t in case.ours.free_symbols:
        yield _map(case.ours, lambda entry: entry.xreplace({t: -t}))


def _plus_for_minus(case: Case) -> Values:
    """A + BK for A − BK, A + LC for A − LC."""
    A = case.question.given.system.A
    if case.name in ("closed_loop_A", "error_A") and case.ours.shape == A.shape:
        yield 2 * A - case.ours


def _other_solution(case: Case) -> Values:
    """A solution of the Riccati equation that is not the stabilising one."""
    if case.name == "P":
        yield from (P for P in case.question.ours.get("solutions", ()) if case.ours != P)


def _gain_of_other_solution(case: Case) -> Values:
    """K = R⁻¹ Bᵀ P, L = P Cᵀ R⁻¹ of a P that is not the stabilising one."""
    plant, R = case.question.given.system, case.question.given.options.get("R")
    for P in case.question.ours.get("solutions", ()):
        if case.name == "K":
            weight: Any = R or case.question.ours["R"]
            yield sp.ImmutableMatrix(weight.inv() * plant.B.T * P)
        elif case.name == "L":
            yield sp.ImmutableMatrix(P * plant.C.T * (R or sp.eye(plant.C.rows)).inv())


def _minus_determinant(case: Case) -> Values:
    """det(A − λI), which is −det(λI − A) for odd n."""
    if case.part.task == "characteristic_polynomial" and case.question.given.system.A.rows % 2:
        yield -case.ours


def _stacked(case: Case) -> Values:
    """B, AB, … one below the other; C, CA, … beside each other."""
    plant = case.question.given.system
    if case.name == "controllability_matrix":
        yield sp.ImmutableMatrix.vstack(*(plant.A**i * plant.B for i in range(plant.order)))
    elif case.name == "observability_matrix":
        yield sp.ImmutableMatrix.hstack(*(plant.C * plant.A**i for i in range(plant.order)))


def _diagonal_entries(case: Case) -> Values:
    """The diagonal of A for its eigenvalues."""
    if case.name == "eigenvalues" and case.part.task in ("eigenstructure", "stability", "phase_portrait"):
        yield list(case.question.given.system.A.diagonal())


def _entry_by_entry(case: Case) -> Values:
    """A function of a matrix taken of each of its entries."""
    A = case.question.given.system.A
    if case.part.task == "state_transition_matrix" and not case.question.given.system.discrete:
        yield sp.ImmutableMatrix(A.applyfunc(lambda entry: sp.exp(entry * sp.Symbol("t"))))
    elif case.part.task == "matrix_function":
        function = case.question.given.function
        yield sp.ImmutableMatrix(A.applyfunc(lambda entry: function.xreplace({sp.Symbol("A"): entry})))


def _upside_down(case: Case) -> Values:
    """Numerator and denominator exchanged."""
    if case.name in ("G", "compensator") and is_scalar(case.ours):
        yield 1 / case.ours


def _signs(submitted: Submitted, ours: Any) -> int:
    """In how many entries a matrix has the wrong sign; 0 if anything else is wrong."""
    right = entrywise(submitted, ours)
    if not isinstance(ours, sp.MatrixBase) or right is None:
        return 0
    minus = entrywise(submitted, sp.ImmutableMatrix(-ours))
    pairs = [pair for rows in zip(right, minus, strict=True) for pair in zip(*rows, strict=True)]
    return sum(pair[0] != Verdict.CORRECT for pair in pairs) if all(Verdict.CORRECT in pair for pair in pairs) else 0


def _one_sign(submitted: Submitted, ours: Any) -> bool:
    return _signs(submitted, ours) == 1


def _some_signs(submitted: Submitted, ours: Any) -> bool:
    return _signs(submitted, ours) > 1


def _one_unit_off(submitted: Submitted, ours: Any) -> bool:
    """Whether decimals are right but for one unit of the last digit: cut off, not rounded."""
    wider = {symbol: (number, 2 * half) for symbol, (number, half) in submitted.decimals.items()}
    return bool(wider) and _right(entrywise(replace(submitted, decimals=wider), ours))


def _degrees(case: Case) -> Values:
    """Angles in degrees where radians are meant."""
    for angle in (sp.acos, sp.asin, sp.atan):
        if case.ours.has(angle):
            yield case.ours.replace(angle, partial(_in_degrees, angle))


def _in_degrees(angle: Callable[[Any], Any], z: Any) -> Any:
    return angle(z) * 180 / sp.pi


def _intermediate(case: Case) -> Values:
    """A result of one of the steps, of the answer's shape."""
    for result in case.results:
        for step in result.steps:
            for each in step.walk():
                yield from (claim.right for claim in each.claims.values() if _alike(claim.right, case.ours))


def _alike(value: Any, ours: Any) -> bool:
    if isinstance(ours, sp.MatrixBase):
        return isinstance(value, sp.MatrixBase) and value.shape == ours.shape and value != ours
    return is_scalar(ours) and is_scalar(value) and value != ours and not value.is_number


def _map(value: Any, of: Callable[[Any], Any]) -> Any:
    return sp.ImmutableMatrix(value.applyfunc(of)) if isinstance(value, sp.MatrixBase) else of(value)


TRANSFORMED: tuple[tuple[str, Callable[[Case], Iterable[Any]]], ...] = (
    (r"it is $\det(A - \lambda I)$, not $\det(\lambda I - A)$", _minus_determinant),
    ("the sign is reversed", _negative),
    ("numerator and denominator are exchanged", _upside_down),
    ("it is transposed: rows and columns are exchanged", _transposed),
    ("the entries stand in reverse order", _reversed),
    ("each value counts as often as its multiplicity", _without_multiplicity),
    ("$+$ stands where $-$ belongs: the feedback is subtracted", _plus_for_minus),
    ("it solves the Riccati equation, but it is not the stabilising solution", _other_solution),
    ("it comes from a solution of the Riccati equation that is not the stabilising one", _gain_of_other_solution),
    ("$B$, $AB$, … stand beside each other, $C$, $CA$, … one below the other; here it is the reverse", _stacked),
    ("these are the entries on the diagonal of $A$", _diagonal_entries),
    ("the function is taken of each entry; it is a function of the matrix", _entry_by_entry),
    ("a factor 2 is missing", _half),
    ("it is twice what it should be: a factor ½ is missing", _double),
    ("the factor $t$ (or $k$) of a repeated eigenvalue is missing", _without_factor_t),
    ("the sign of the exponents is reversed", _exponent_reversed),
    ("an angle is in degrees where radians are meant", _degrees),
    ("rows or columns stand in another order", _reordered),
    ("it is an intermediate result: the last step is missing", _intermediate),
)

ALIKE: tuple[tuple[str, Callable[[Submitted, Any], bool]], ...] = (
    ("the sign of an entry is reversed", _one_sign),
    ("the signs of some entries are reversed", _some_signs),
    ("the last digit is cut off, not rounded", _one_unit_off),
)


def _holds(holds: Callable[[Submitted, Any], bool], submitted: Submitted, ours: Any) -> bool:
    try:
        return holds(submitted, ours)
    except STRANGE:  # the two can't be compared
        return False


Change = Callable[[Part], Part | None]


def _option(part: Part, name: str, of: Callable[[Any], Any]) -> Part | None:
    value = part.options.get(name)
    if value is None or not isinstance(value, tuple | sp.MatrixBase):
        return None
    return replace(part, options={**part.options, name: of(value)})


def _system(part: Part, **changes: Any) -> Part | None:
    return replace(part, system=replace(part.system, **changes)) if isinstance(part.system, StateSpace) else None


def _poles_reversed(part: Part) -> Part | None:
    return _option(part, "poles", lambda poles: tuple(-pole for pole in poles))


ABOUT_CHANNELS = ("controllability", "observability", "transfer_function", "pole_placement", "observer", "response")


def _poles_squared(part: Part) -> Part | None:
    return _option(part, "poles", lambda poles: tuple(pole**2 for pole in poles))


def _inputs_for_outputs(part: Part) -> Part | None:
    if part.task not in ABOUT_CHANNELS:
        return None
    B, C = getattr(part.system, "B", None), getattr(part.system, "C", None)
    return None if B is None or C is None or B.cols != C.rows else _system(part, B=C.T, C=B.T)


def _with(part: Part, option: str, word: str) -> Part | None:
    """The question with another word for an option that has one."""
    return None if part.options.get(option) in (None, word) else replace(part, options={**part.options, option: word})


def _weight_reversed(part: Part) -> Part | None:
    return _option(part, "Q", lambda Q: -Q)


def _A_transposed(part: Part) -> Part | None:
    return _system(part, A=part.system.A.T) if isinstance(part.system, StateSpace) else None


def _left_for_right(part: Part) -> Part | None:
    return _A_transposed(part) if part.task == "eigenstructure" else None


def _without_D(part: Part) -> Part | None:
    D = getattr(part.system, "D", None)
    return None if D is None or D.is_zero_matrix else _system(part, D=sp.ImmutableMatrix(sp.zeros(*D.shape)))


def _B_reversed(part: Part) -> Part | None:
    B = getattr(part.system, "B", None)
    return None if B is None else _system(part, B=-B)


def _without_initial_state(part: Part) -> Part | None:
    return _option(part, "initial_state", lambda x0: sp.ImmutableMatrix(sp.zeros(*x0.shape)))


def _other_time(part: Part) -> Part | None:
    return _system(part, discrete=not part.system.discrete)


CHANGED: tuple[tuple[str, Change], ...] = (
    ("the poles have the wrong sign", _poles_reversed),
    ("$D$ is forgotten", _without_D),
    ("the right side has the wrong sign: $-Q$ for $Q$", _weight_reversed),
    ("left and right eigenvectors are exchanged", _left_for_right),
    ("$A$ is transposed", _A_transposed),
    ("$B$ and $C$ are exchanged", _inputs_for_outputs),
    ("it is the observable form", partial(_with, option="form", word="observable")),
    ("it is the controllable form", partial(_with, option="form", word="controllable")),
    (
        "it follows the other convention: coefficients in the first row (column)",
        partial(_with, option="convention", word="first_row"),
    ),
    (
        "it follows the other convention: coefficients in the last row (column)",
        partial(_with, option="convention", word="last_row"),
    ),
    (
        "it follows the other convention: ones below the diagonal",
        partial(_with, option="convention", word="subdiagonal"),
    ),
    (
        "it follows the other convention: ones above the diagonal",
        partial(_with, option="convention", word="superdiagonal"),
    ),
    ("the poles are squared", _poles_squared),
    ("$B$ has the wrong sign", _B_reversed),
    ("the initial state is forgotten", _without_initial_state),
    ("it is right for the other kind of time, discrete or continuous", _other_time),
)


def _answers_changed(case: Case, submitted: Submitted, change: Change) -> bool:
    """Whether the value is a right answer to the changed question."""
    part = change(case.part)
    if part is None:
        return False
    try:
        result = solve_part(replace(part, methods=part.methods[:1]), case.earlier)[0]
        if case.name not in result.answers:
            return False
        given = given_of(part, part.methods[0], case.earlier)
        changed = Question(case.question.task, given, result.answers)
        return judge(changed, {case.name: submitted})[case.name].verdict is Verdict.CORRECT
    except (*STRANGE, exact.NotExact, Unsolved):  # the changed question has no meaning
        return False
