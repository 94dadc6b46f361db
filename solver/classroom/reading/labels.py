r"""What stands before a value and names it: K = [13, 8], G(s) = 1/s, λ_1 = -1, \chi(\lambda) = ….

The answer's own name, or one that nobody else has, is left out. What names another answer of the task, or a quantity of
the field with a letter of its own, L before a K, makes the value unreadable: it may have been meant for another place.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from solver.classroom.reading.brackets import enclosed, split
from solver.classroom.reading.list_texts import with_every_index, with_named_conjugates
from solver.classroom.reading.matrix_formulas import is_gain_at_zero, is_sampled, is_similar
from solver.classroom.reading.terms import LABELS
from solver.derivation import AnswerName
from solver.problem.expressions.notation import FUNCTIONS, GREEK
from solver.symbols import NOTATIONS

_LABEL = re.compile(r"^\s*((?:[^=<>≤≥≠!:≈\[\]]|\[[kn]\]){1,80}?)\s*(?::=|==|=(?!>)|≈|≅|:(?!\d))\s*([^=].*)$", re.DOTALL)
_NAME = re.compile(
    r"\\?[^\W\d](?:[\w\s\\{},%*'′](?<![²³⁴⁵⁶⁷⁸⁹]))*(?:\^\*)?\s*(?:\([^()=]*\))?|\|.*\||\w+\[[kn]\]|[A-Z]\w*(?:\(\w\))?\s*/\s*[A-Z]\w*(?:\(\w\))?",
    re.DOTALL,
)
_RANGE = re.compile(
    r"\s*[,;]?\s*(?:\b(?:for all|für alle)\s+[tkn]\s*\.?$"
    r"|\(?(?:\\quad\s*|\\text\{[^{}]*\}\s*|for|für|if|where|when|with|wenn)?\s*"
    r"\b(?:[tkn]\s*(?:>=?|≥|\\geq?\b)\s*0|[kn]\s*=\s*0\s*,\s*1\s*(?:,\s*2\s*)?,?\s*(?:\.{3}|…|\\l?dots))\s*\)?\s*[.$]?\s*$)"
)
_MULTIPLE = re.compile(
    r"^(.*?[^\s(,+*/=−-])\s*"
    r"(?:\(?\s*(?:(?:is|ist)\s+(?:an?|eine?)\s+)?(?:double(?: root| pole| zero| eigenvalue)?|twice"
    r"|doppelt(?:er? (?:pol|eigenwert|nullstelle))?|zweifach|triple|dreifach|repeated twice"
    r"|once|simple|einfach"
    r"|(?:with |mit |of )?(?:(?:algebraic|alg\.?|algebraische?) )?"
    r"(?:(?:mult(?:iplicity|\.)?|vielfachheit|vfh\.?|a\.?\s?[mv]\.?|order|ordnung)\s*(?:=|of)?|[mνμ]\s*=)\s*(\d{1,2}))"
    r"|\(\s*(\d{1,2})[ -]?(?:times|fold|x|×|mal|fach))\s*\)?$",
    re.IGNORECASE,
)
_INVERTED = re.compile(r"\s*[UR]\w*(?:\(\w\))?\s*/\s*[YXE]")
MOST_TIMES = 24
_NUMBERED = re.compile(r"((?:(?![₀-₉])[^\W\d_])+)_?(\d|[₀-₉])")
_BELOW = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
SUBSCRIPTS = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")
_INDEX = re.compile(r"(\d+)\D*$")
_SHARED = re.compile(
    r"([^\W\d](?:(?![₀-₉])[^\W\d_])*)_?\{?([\d₀-₉](?:[,/]\s*_?[\d₀-₉])+)\}?\s*=\s*([^=]*?)"
    r"(?=[,;]\s*[^\W\d]\w*\{?\d*(?:[,/]\s*[\d₀-₉])*\}?\s*=|\s*$)"
)
_TWO = re.compile(r"±|∓|\\pm|\\mp|\+\s*/?\s*[-−]")
_MARKS = re.compile(r"(?<=[A-Za-z])[~\u0302\u0303\u0304](?=\w?\s*=)")
"""Ã and Ā for the A of other coordinates."""
_COLUMNS = re.compile(r"^\s*\[[^\[\]=]*\]\s*=\s*(?=\[)")
_MEMBER = re.compile(r"\s*\\?[^\W\d]\w*\s*(?:∈|\\in\b|\bin\b)\s*(?=\\?[{\[])")
_ARGUMENT = re.compile(r"\([stzk]\)\s*$")
_SYMBOL = re.compile(r"\\sym\{(\w+)\}")
_CHANGES = re.compile(
    r"\s*(?:inv|pinv|sqrt|norm|abs|trace|transpose|log|ln|exp(?!\((?:A\s*[*·]?\s*[tT]|t\s*[*·]?\s*A)\)))\s*\("
    r"|\s*(?:log|ln|exp|sqrt)\s+[^\W\d]"
)
_DEFINED = re.compile(
    r"(?:[A-Za-z][\w.]*|\\?lim\w*|lim_?\(.*\)\s*\w*)\s*\(.*\)'?|adj\s*/\s*det|\|.*\||[\[({].*[\])}]|e\^[({]\s*A\s*t\s*[)}]"
    r"|\(\s*[sz]\s*I\s*-\s*A\s*\)\s*\^[({]?-1[)}]?|(?:∂|d\s?)\w+\s*/\s*(?:∂|d\s?)\w+|lim[\W_].*\)|[A-Za-z]_?∞"
    r"|e\^[({]?\s*A\s*[)}]?|A\^[({]?\w+[)}]?|[ΣP∑(\\].*(?:Δ|\\Delta).*/\s*(?:Δ|\\Delta)"
)
_NAMES = re.compile(r"[\[({]\s*[^\W\d]\w*(?:\s*[,;\s]\s*[^\W\d]\w*)+\s*[\])}]")
_LIMIT = re.compile(r"\\?lim[\W_].*\)|[A-Za-z]_?∞|1\s*/\s*\|[A-Z]\w*\(.*\)\|")
_ARGUMENTS = re.compile(r"(?<=[\w}*'])\s*\(([^()=]*)\)$")
_VARIABLE = re.compile(r"\\?[^\W\d_]\w{0,6}")
_OF_A = re.compile(r"(?=.*(?<![A-Za-z])A(?![A-Za-z]))[\d\s+*/^(){}·−AIest-]+")
"""What is found from A: e^(-2t) (A + 3I) - e^(-3t) (A + 2I), A^2 + 3A + 2I."""
_FOUND_BY = re.compile(
    r"\s*(?:\w+\.)*\\?(?:adj|inv|det|expm|exp(?=\(A\W*t\))|charpoly|poly|minreal|tf|ss2tf|step|lim)\b"
)
_TIMES_VARIABLE = re.compile(r"[-−]?\s*[sztk]\s*[*·]?\s*(?=[^\W\d_]\w*\s*\()")
_DERIVED = re.compile(r"['′’]|dot\b|\\d+ot|[\u0307\u0308ẋẍẏÿḟġḣṁṅȯṗṙṡṫẇżḞĠḢṖẊẎẌŸ]")
_SIMILAR = re.compile(r"\s*(?:(?:T\s*\^[({]?-1[)}]?|inv\(T\)|T\s*\\)\s*\*?\s*(?:A\s*\*?\s*T|B)|C\s*\*?\s*T)\s*")
_PRODUCT = re.compile(r"[A-Z][\w\s^({})+*·-]*")
_WORDS = re.compile(r"[^\W\d]\w*")
_DENIES = re.compile(r"\b(?:not|no|nicht|kein\w*|never|for|für|if|wenn|unless)\b", re.IGNORECASE)
_DECORATION = re.compile(r"\\(?:text|mathrm|mathcal|operatorname|bar|hat|tilde|left|right|mathbf)\b|[\\${}_\s*^]")
_GREEK = {**GREEK, "lambda": "lamda"}


class ForeignLabelError(Exception):
    """A value is labelled as another one than is asked for."""


class Labels:
    """The labels of one answer, among those of its task."""

    def __init__(self, answer: AnswerName | None = None, others: Iterable[AnswerName] = ()) -> None:
        self.name = answer.name if answer else ""
        self.own = _spellings(answer) if answer else set()
        self.others = {each for other in others for each in _spellings(other)} - self.own

    def before(self, text: str) -> tuple[str, str]:
        """Return what stands before a value as its label, where that is not the answer's own name, and the value."""
        found = _LABEL.match(text)
        return ("", text) if found is None or _normal(found[1]) in self.own else (found[1], found[2].strip())

    def without(self, text: str) -> tuple[str, bool]:
        """Return a text without its label, and whether that was a label of another spelling than the answer's.

        Raises ForeignLabelError.
        """
        text = _MARKS.sub("", text) if "=" in text else text
        if found := _COLUMNS.match(text):  # [B AB] = [1 2; 3 4]
            return text[found.end() :], True
        found = _LABEL.match(text)
        if found is None or "=" in found[2].strip("= ") or enclosed(text.strip(), "{}"):
            return text, False
        label = _normal(found[1])
        if is_similar(found[1]):
            return found[2].strip(), True
        if _DENIES.search(found[1]) or _CHANGES.match(found[1]):
            raise ForeignLabelError(f"it is not clear what {found[1].strip()} says of it")
        if found[1].startswith("lambda "):  # a function of Python
            return text, False
        if label in self.own:
            return found[2].strip(), False
        if _INVERTED.match(found[1]) and self.name not in ("controller", "compensator"):
            raise ForeignLabelError(
                f"it is labelled {found[1].strip()}, and {self.name or 'the output over the input'} is asked for"
            )
        quantity = _is_quantity(label) and not _ARGUMENT.search(found[1])  # C(s) is a function, and no matrix C
        foreign = label in self.others or (quantity and _letter(label) not in map(_letter, self.own))
        if self.name and foreign:
            raise ForeignLabelError(f"it is labelled {found[1].strip()}, and {self.name} is asked for")
        return (found[2].strip(), True) if _NAME.fullmatch(found[1].strip()) else (text, False)

    def is_own(self, text: str) -> bool:
        """Whether a text is what the answer is called."""
        return _normal(text) in self.own

    def may_define(self, text: str) -> bool:
        """Whether a text beside a sign = may be what the answer is called or how it is found, and no multiple of it."""
        if (
            any(each.fullmatch(text) for each in (_NAME, _NAMES, _LIMIT))
            or _normal(text) in self.own
            or is_similar(text)
            or (self.name == "A" and is_sampled(text))
        ):
            return True
        if self.name == "dc_gain" and (found := is_gain_at_zero(text)) is not None:
            return found
        if _CHANGES.match(text):
            return False
        if _OF_A.fullmatch(text) and "a" not in map(str.lower, self.own):
            return True
        letters = {_letter(each).lower() for each in self.own}
        if letters & {_letter(_normal(each)).lower() for each in re.findall(r"[^\W\d_]+", text)}:
            return False
        return (_DEFINED.fullmatch(text) or _PRODUCT.fullmatch(text)) is not None

    def is_of_others(self, text: str) -> bool:
        """Whether a formula has names, and none of them may be what the answer is called."""
        if self.name == "dc_gain" and is_gain_at_zero(text) is not None:
            return False
        words = [each for each in _WORDS.findall(text) if each not in ("π", "pi")]
        names = {_normal("omega" if each[0] == "w" else each) for each in words} - self.others
        if not names:
            return bool(words)
        letters = {_letter(each).lower() for each in self.own}
        return bool(names) and not {_letter(each).lower() for each in names if each not in FUNCTIONS} & letters


def changes(label: str) -> bool:
    """Whether a label begins with a function that makes another quantity of what it names: exp(…), abs(…)."""
    return _CHANGES.match(label) is not None


def of_another_argument(text: str, *, of_a_variable: bool, at_its_end: bool) -> bool:
    """Whether a text is labelled y(2t), G(-s), y'(t) or s G(s), or y(0) where the end is asked for."""
    found = _LABEL.match(text)
    if found is None or not (of_a_variable or at_its_end) or _FOUND_BY.match(found[1]) or _OF_A.fullmatch(found[1]):
        return False
    label = found[1].strip()
    argument = _ARGUMENTS.search(label)
    if at_its_end:
        return label.startswith("y") and argument is not None and argument[1].strip() in ("0", "0+", "0⁺")
    changed = _TIMES_VARIABLE.match(label) or _DERIVED.search(label)
    return bool(changed) or (argument is not None and _VARIABLE.fullmatch(argument[1].strip()) is None)


def without_range(text: str) -> str:
    """Return a function of time without "for t >= 0" behind it."""
    return _RANGE.sub("", text)


def without_labels(items: Sequence[str]) -> tuple[list[str], bool]:
    """Return the items of a list without labels, λ_1 = -1, in the order of their indices where each has one of its own.

    Also tells whether there were any.
    """
    written, items = items, [each for item in items for each in _repeated(item)]
    matches = [_LABEL.match(item) for item in items]
    found = [match if match and _is_label(match[1]) else None for match in matches]
    if not any(found):
        return items, len(items) > len(written)
    named = [
        (each[1].strip(), each[2].strip()) if each else ("", item) for each, item in zip(found, items, strict=True)
    ]
    values = _without_own_names(named)
    indices = [_INDEX.search(match[1]) if match else None for match in found]
    numbers = [int(index[1]) for index in indices if index]
    if len(numbers) == len(items) == len(set(numbers)):
        values = [value for _, value in sorted(zip(numbers, values, strict=True))]
    return values, True


def _is_label(text: str) -> bool:
    return _NAME.fullmatch(text.strip()) is not None and _DENIES.search(text) is None


def twice_named(items: Sequence[str]) -> str:
    """Return a name with an index that has two values in a list, k1 = 3, k1 = 4; "" where none has."""
    known: dict[str, str] = {}
    for match in filter(None, map(_LABEL.match, items)):
        name, value = match[1].strip(), match[2].strip()
        if _INDEX.search(name) and _NAME.fullmatch(name) and known.setdefault(name, value) != value:
            return name
    return ""


def _without_own_names(named: Sequence[tuple[str, str]]) -> list[str]:
    """Return values with those before them in place of their names: k2 = 2 k1 behind k1 = 3 is 2 (3)."""
    values = list[str]()
    known: list[tuple[re.Pattern[str], str]] = []
    for name, written in named:
        value = written
        for pattern, before in known:
            value = f"({before})".join(pattern.split(value))
        values.append(value)
        if found := _NUMBERED.fullmatch(name):
            letter, index = found[1], found[2].translate(SUBSCRIPTS)
            below = f"(?:{index}|{index.translate(_BELOW)})"
            known.append((re.compile(rf"(?<![^\W\d]){letter}_?{below}(?!\w)"), value))
    return values


def with_own_labels(text: str) -> str:
    """Return a list without "b ∈" before it, and with λ_{1,2} = 3 as λ_1 = λ_2 = 3; where ± says two values, as one.

    A value that is the conjugate of another one, λ_2 = conj(λ_1), is written as a value.
    """
    text = with_every_index(with_named_conjugates(text))

    def each(found: re.Match[str]) -> str:
        name, shared, value = found.groups()
        indices = re.findall(r"\d", shared.translate(SUBSCRIPTS))
        if len(split(value, re.compile("[,;]"))) == len(indices):  # p_{1,2} = -1, -2
            return value
        if _TWO.search(value):
            return f"{name}{indices[0]} = {value}" if len(indices) == 2 else found[0]
        return f"{' = '.join(name + index for index in indices)} = {value}"

    return _SHARED.sub(each, _MEMBER.sub("", text, count=1) if _MEMBER.match(text) else text)


def _repeated(item: str) -> list[str]:
    """An item as often as it says: λ_1 = λ_2 = 3, 3 (double), 3 with multiplicity 2."""
    *names, value = item.split("=")
    if len(names) > 1 and all(_NAME.fullmatch(name.strip()) for name in names):
        return [f"{name} = {value}" for name in names]
    if found := _MULTIPLE.match(item):
        times = int(found[2] or found[3] or _times(found[0].rstrip(" )").lower()))
        return [found[1]] * min(times, MOST_TIMES)
    return [item]


def _times(said: str) -> int:
    """How often a value counts that is said to be double, triple or simple."""
    return 1 if said.endswith(("once", "simple", "einfach")) else 3 if said.endswith(("triple", "dreifach")) else 2


def _spellings(answer: AnswerName) -> set[str]:
    """The names and symbols of an answer, in all notations."""
    found = _SYMBOL.search(answer.symbol)
    names = [found[1], *(table[found[1]] for table in NOTATIONS.values() if found[1] in table)] if found else [""]
    symbols = [answer.symbol.replace(found[0], name) if found else answer.symbol for name in names]
    also = (*LABELS.get(answer.name, ()), *LABELS.get(answer.symbol, ()))
    return {_normal(each) for each in (answer.name, *symbols, *also) if each}


def _is_quantity(label: str) -> bool:
    return any(label in map(_normal, pair) for table in NOTATIONS.values() for pair in table.items())


def _normal(label: str) -> str:
    """A label without what decorates it, its argument and its index: K_{f}(t) is Kf, λ_{1,2} is lamda."""
    bare = _DECORATION.sub("", label.replace("−", "-"))
    bare = "".join(_GREEK.get(sign, sign) for sign in bare).replace("lambda", "lamda")
    bare = re.sub(r"\([a-zA-Z]\)$|(?<=[A-Za-z])\([a-z]{4,5}\)$", "", bare)
    return re.sub(r"(?<=\D)[\d,%]+$|(?<=.)i$", "", bare)


def _letter(label: str) -> str:
    """The letter of a label, Latin or Greek by its name."""
    return next((name for name in _GREEK.values() if label.startswith(name)), label[:1])
