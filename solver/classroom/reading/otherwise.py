"""Other texts for a value that cannot be read as it stands, or has another shape than is asked for.

Nothing that is read already comes here, so no value loses the reading that it has. What a text may say otherwise stands
in a table, by the kind of the answer that is asked for; what comes first is tried first.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from typing import Any

import sympy as sp

from solver.classroom.reading import list_texts, matrix_remarks, matrix_texts, remarks
from solver.classroom.reading.brackets import closed
from solver.classroom.reading.control_laws import coefficients_of, controller_of, gain_of, law_of
from solver.classroom.reading.expected import Expected
from solver.classroom.reading.first_values import with_first_values
from solver.classroom.reading.inverses import with_inverses
from solver.classroom.reading.latex import NotReadableError, is_latex, translated
from solver.classroom.reading.likeness import has_step, is_of_time
from solver.classroom.reading.names import symbols_of
from solver.classroom.reading.piecewise import as_steps
from solver.classroom.reading.polynomials import of_named_coefficients, variable_of
from solver.classroom.reading.printed import in_rows
from solver.classroom.reading.sentences import as_equation, concluded, premise, with_true_signs, without_words

Kind = Callable[[Any, Expected], bool]
"""Whether an answer is of a kind, by our own and by what is known of it."""
Way = Callable[[str, Any, Expected], str]
"""A text put otherwise; "" or the same text where it says nothing of the kind."""

_HIDDEN = (
    re.compile(r"\s+(?:is|are|ist|sind) (?:uncontrollable|not controllable|nicht steuerbar|hidden)\s*\.?$"),
    re.compile(r"\s+(?:is|are|ist|sind) (?:unobservable|not observable|nicht beobachtbar|hidden)\s*\.?$"),
)
_ALL_BUT = re.compile(
    r"^\s*(?:it is |the (?:system|pair|plant) is |das system ist )?(?:completely )?"
    r"(?:controllable|observable|steuerbar|beobachtbar)\s+(?:for|für)\s+(?:all|every|any|alle)(?: real| reellen)?"
    r"(?: values of)?(?:\s+[^\W\d]\w*)?\s*,?\s*(?:except(?: for)?|but|other than|außer|bis auf)\s+",
    re.IGNORECASE,
)
_FOR = re.compile(r"^\s*(?:only |nur )?(?:for|if|when|für|wenn)\s+(?=[^\W\d]\w*\s*=)")
_AT_INFINITY = re.compile(
    r"\s*(?:,|;|and|und|\+)\s*(?:one|two|three|an?(?:other)?|\d|eine?|zwei|drei)?\s*(?:more )?(?:zeros?|nullstellen?)?"
    r"\s*(?:at|im|in|bei)\s+(?:infinity|∞|unendlichen|unendlich)\s*\.?$"
)
_LOST = re.compile(
    r"^\s*(?:it is |the (?:system|pair|plant) is |das system ist )?"
    r"(?:not (?:completely )?(?:controllable|observable)|uncontrollable|unobservable|nicht (?:steuerbar|beobachtbar))"
    r"\s+(?:exactly )?(?:for|if|when|iff|für|wenn)\s+",
    re.IGNORECASE,
)
_ONLY = re.compile(r"\s*,?\s+\(?(?:only|nur)\)?\s*\.?\s*$")
_CONSTANTS_FIRST = re.compile(r"^[^:]*:\s*(?=[^\W\d]\w*(?:\([tk]\))?\s*=)")
"""C1 = 5, C2 = -3: before the solution."""


def other_texts(text: str, ours: Any, expected: Expected) -> Iterator[str]:
    """Yield what a text may say otherwise; each is still to be read, and to have the shape of ours."""
    if "for all" in text and expected.name != "values":
        return
    if _is_function_of_time(ours, expected) and (steps := as_steps(text)):
        yield steps
    if is_latex(text):
        try:
            text = translated(text)
        except NotReadableError:
            return
        yield text
    for is_of_kind, ways in _TABLE:
        if not is_of_kind(ours, expected):
            continue
        for way in ways:
            if (other := way(text, ours, expected)) and other != text:
                yield other


def _any(_ours: Any, _expected: Expected) -> bool:
    return True


def _named(*names: str) -> Kind:
    return lambda _, expected: expected.name in names


def _is_list(ours: Any, _: Expected) -> bool:
    return isinstance(ours, list | sp.Set)


def _is_plain_list(ours: Any, _: Expected) -> bool:
    return isinstance(ours, list)


def _are_angles(ours: Any, expected: Expected) -> bool:
    return _is_list(ours, expected) and expected.unit == "°"


def _are_numbers(ours: Any, expected: Expected) -> bool:
    numbers = isinstance(ours, sp.Expr | list) and not symbols_of(ours) and not _are_mappings(ours, expected)
    return numbers and not expected.count


def _are_mappings(ours: Any, _: Expected) -> bool:
    return isinstance(ours, list) and bool(ours) and isinstance(ours[0], Mapping)


def _is_matrix(ours: Any, _: Expected) -> bool:
    return isinstance(ours, sp.MatrixBase)


def _is_polynomial(ours: Any, _: Expected) -> bool:
    return variable_of(ours) is not None


def _is_space(_: Any, expected: Expected) -> bool:
    return expected.name.endswith("_space")


def _are_values(ours: Any, expected: Expected) -> bool:
    return _is_list(ours, expected) and not _are_mappings(ours, expected)


def _are_vectors(ours: Any, expected: Expected) -> bool:
    return _is_matrix(ours, expected) and bool(expected.vectors or expected.name.endswith("_space"))


def _is_row_or_column(ours: Any, expected: Expected) -> bool:
    return _is_matrix(ours, expected) and 1 in ours.shape


def _is_square(ours: Any, expected: Expected) -> bool:
    return _is_matrix(ours, expected) and ours.rows == ours.cols


def _is_function_of_time(ours: Any, expected: Expected) -> bool:
    return is_of_time(ours, expected.name) and not _is_matrix(ours, expected)


def _is_signal(ours: Any, expected: Expected) -> bool:
    return is_of_time(ours, expected.name) or expected.name in ("f", "y")


def _is_optimal(ours: Any, expected: Expected) -> bool:
    return expected.name in ("u", "x", "costates", "P", "K") and not has_step(ours)


def _is_mapping(ours: Any, _: Expected) -> bool:
    return isinstance(ours, Mapping)


def _is_of_z(ours: Any, _: Expected) -> bool:
    return "z" in {symbol.name for symbol in symbols_of(ours)}


def _are_modes(_: Any, expected: Expected) -> bool:
    return expected.name.endswith("_modes")


def _text(put: Callable[[str], str]) -> Way:
    """What depends on nothing but the text."""
    return lambda text, _ours, _expected: put(text)


def _shape(put: Callable[[str, Any], str]) -> Way:
    """What depends on the text and on our own matrix."""
    return lambda text, ours, _expected: put(text, ours)


def _transform(text: str, ours: Any, expected: Expected) -> str:
    kind = "f" if _is_function_of_time(ours, expected) else expected.name
    return remarks.without_region(remarks.without_transformed(text, kind))


def _printed(text: str, ours: Any, _: Expected) -> str:
    return in_rows(text, ours.shape if isinstance(ours, sp.MatrixBase) else (max(len(ours), 1), 1))


def _modes(text: str, _: Any, expected: Expected) -> str:
    return _HIDDEN[expected.name.startswith("un") and "obs" in expected.name].sub("", text)


def _values_when_lost(text: str) -> str:
    return _FOR.sub("", _ALL_BUT.sub("", _LOST.sub("", text)))


def _finite(text: str) -> str:
    return _AT_INFINITY.sub("", text)


def _solution(text: str) -> str:
    return _CONSTANTS_FIRST.sub("", text)


def _without_only(text: str) -> str:
    return _ONLY.sub("", text)


def _bare(text: str, _: Any, expected: Expected) -> str:
    return without_words(text, expected.name, count=expected.count)


_TABLE: tuple[tuple[Kind, tuple[Way, ...]], ...] = (
    (_any, (_text(remarks.of_equation), _transform)),
    (_are_angles, (_text(list_texts.behind_angles_of_all),)),
    (
        _is_list,
        (
            _text(remarks.behind_equation),
            _text(list_texts.behind_call),
            _text(list_texts.with_conjugates),
            _text(list_texts.with_multiplicities),
            _text(list_texts.each_so_often),
            _text(list_texts.without_kind_of_all),
            _text(list_texts.one_after_another),
            _text(list_texts.between_bars),
            _text(list_texts.of_both_signs),
            _text(matrix_remarks.entries_behind_names),
        ),
    ),
    (_is_plain_list, (_printed,)),
    (_are_mappings, (_text(list_texts.joined_alternatives), _text(list_texts.as_point))),
    (_is_signal, (_text(with_first_values),)),
    (_is_optimal, (_text(remarks.without_horizon),)),
    (_is_mapping, (_text(matrix_remarks.entries_behind_names),)),
    (_named("solution"), (_text(_solution),)),
    (_named("coefficients"), (_text(coefficients_of),)),
    (_named("K"), (_text(gain_of),)),
    (_named("controller"), (_text(controller_of),)),
    (_named("u"), (_text(law_of),)),
    (_are_vectors, (_text(matrix_texts.without_factors), _text(matrix_texts.both_vectors))),
    (
        _is_matrix,
        (
            _printed,
            _shape(matrix_texts.with_named),
            _text(matrix_remarks.without_remark),
            _text(matrix_remarks.entries_concluded),
            _text(matrix_remarks.entries_behind_names),
            _text(matrix_remarks.with_entries),
            _text(matrix_remarks.with_matrices),
            _text(with_inverses),
        ),
    ),
    (_is_space, (_text(matrix_remarks.of_letters),)),
    (_named("A", "C"), (_text(matrix_remarks.of_states),)),
    (_named("B", "D"), (_text(matrix_remarks.of_inputs),)),
    (_named("jordan_form"), (_text(matrix_remarks.with_blocks),)),
    (_is_polynomial, (_text(of_named_coefficients),)),
    (_is_row_or_column, (_shape(matrix_texts.alike),)),
    (
        _is_square,
        (_shape(matrix_texts.symmetric), _shape(matrix_remarks.mirrored), _shape(matrix_texts.with_identities)),
    ),
    (_is_of_z, (_text(remarks.without_sample_time),)),
    (_are_modes, (_modes,)),
    (_named("zeros"), (_text(_finite),)),
    (_named("values"), (_text(_values_when_lost),)),
    (_are_values, (_text(list_texts.joined_sets),)),
    (_are_numbers, (_text(remarks.without_words_in_brackets),)),
    (
        _any,
        (
            _text(_without_only),
            _text(closed),
            _text(with_true_signs),
            _text(as_equation),
            _text(concluded),
            _text(premise),
            _bare,
        ),
    ),
)
