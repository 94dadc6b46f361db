"""Values found by hand or with python-control, which the corpus states beside the question, for any task."""

import itertools

import numpy as np
import sympy as sp

from tests.classroom.corpus.judges.registry import MOMENTS, POINTS, difference, multiset, word
from tests.classroom.corpus.meanings import ImpossibleError, Meaning
from tests.hunt.asked import COMPARED, MEANINGS, NAMES, Point, parsed

LINE = np.arange(-20, 20, 0.0037)
PLANE = tuple(each.ravel() for each in np.meshgrid(np.arange(-4, 8, 0.113), np.arange(-4, 8, 0.097)))


def by_hand(answer: str):
    """The judge of an answer: the numbers agree wherever they are compared; `free` names lists in any order."""

    def judged(point: Point, meant: Meaning):
        if (raw := point.option("hand", {}).get(answer)) is None:
            raise ImpossibleError("nothing found by hand")
        if _is_condition(raw) or isinstance(raw, bool) or _is_word(raw):
            return [word(_same_words(point, raw, meant))]
        compare = multiset if answer in point.option("free", ()) else difference
        ours = Meaning(_texts(raw), np.zeros(0), {})
        known = {str(name): complex(value) for name, value in point.values.items()}
        return [np.ravel(compare(meant(**at), ours(**at))) for at in _places(raw, known)]

    return judged


def _texts(raw):
    return [_texts(each) for each in raw] if isinstance(raw, list) else str(raw)


def _flat(raw):
    return itertools.chain.from_iterable(map(_flat, raw)) if isinstance(raw, list) else iter([str(raw)])


def _is_condition(raw) -> bool:
    return any("<" in each or ">" in each for each in _flat(raw))


def _is_word(raw) -> bool:
    return isinstance(raw, str) and raw.startswith("word ")


def _places(raw, known):
    """Numbers for s, z, t, k and omega; other letters of the value that nobody gave have one each."""
    named = {name for each in _flat(raw) for name in NAMES.findall(each)}
    rest = sorted(named - set(known) - {"s", "z", "t", "k", "omega"})
    others = {name: 0.7 + 0.31 * i for i, name in enumerate(rest) if name not in MEANINGS}
    for i in range(len(POINTS)):
        yield {"s": POINTS[i], "z": POINTS[i], "t": MOMENTS[i], "k": i, "omega": MOMENTS[i], **others, **known}


def _same_words(point: Point, raw, meant: Meaning) -> bool:
    if isinstance(raw, bool):
        return meant.word == str(raw).lower()
    if _is_word(raw):
        return meant.word == raw.removeprefix("word ")
    if not _is_condition(meant.words):
        raise ImpossibleError("no condition")
    names = sorted({name for each in _flat(raw) for name in NAMES.findall(each)} - {"and"})
    at = dict(zip(names, (LINE,) if len(names) == 1 else PLANE, strict=True))
    return int(np.sum(_told(raw, at) != _told(meant.words, at))) <= 1


def _told(words, at) -> np.ndarray:
    """Where any of the conditions holds; all that `and` joins must hold."""
    listed = words if isinstance(words, list) else [words]
    return np.any([np.all([_holds(part, at) for part in each.split(" and ")], axis=0) for each in listed], axis=0)


def _holds(chain: str, at) -> np.ndarray:
    sides = [sp.lambdify(list(at), parsed(side))(*at.values()) for side in COMPARED.split(chain)]
    pairs = zip(sides, COMPARED.findall(chain), sides[1:], strict=False)
    return np.all([a < b if sign.startswith("<") else a > b for a, sign, b in pairs], axis=0)
