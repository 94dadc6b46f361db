"""Every answer of every task: ours is right however it is written, a changed one is wrong unless it is still right.

What is still right is decided without the program's oracles: by the definition, with numpy (`defining`), or by being
the same value at random numbers.
"""

import random
import zlib
from functools import cache

import pytest
import sympy as sp
from sympy.core.function import AppliedUndef

from solver.classroom.judging.verdict import judge
from solver.classroom.reading.expected import Expected
from solver.classroom.reading.values import Reader
from solver.classroom.submitted import Submitted
from solver.derivation import Status
from solver.problem.source import Source
from solver.problem.yaml_tree import parse_yaml
from tests.helpers.defining import still_right
from tests.helpers.marked import marker
from tests.helpers.solved import EXAMPLES, PROBLEMS, by_problem, solution_of
from tests.helpers.students import mutants, rounded, written

QUICK = EXAMPLES[::10]
MODELLING = ("equations_of_motion", "state_space_model", "equilibrium_points", "linearization", "solve_equations")
MODELS = [path for path in PROBLEMS if path not in EXAMPLES and any(t in path.read_text("utf-8") for t in MODELLING)]
MOST = 3
"""Changed values of each answer that are tried."""

SETS = {"conditions", "points", "solutions"}
"""Lists in which an item may stand twice."""

DEFINED = {("stability", "array"), ("bode", "corner_frequencies")}
"""Answers that are not free and have more than one right value."""

UP_TO_A_CONSTANT = {"potential", "lagrangian"}

SCALABLE = {"equations", "riccati_equations"}
"""Lists of expressions that are zero: any factor is right."""

UNDECIDED = (
    "together",
    "is judged with",
    "as a whole",
    "not among the answers",
    "coincide",
    "only equations",
    "cannot decide",
    "too few digits",
    "without the solutions",
    "no symplectic pencil",
)
"""Why a changed value may stay unjudged: it means nothing alone, or our own check does not decide about it either."""


@cache
def questions(path):
    """(id, part, question) of the parts of an example that are verified."""
    solution = solution_of(path)
    desk = marker(solution)
    earlier = {name: results[0] for name, results in desk.results.items()}
    return [
        (part, desk.question_of(part, earlier, desk.ours(part.id)), desk.reader(part, desk.ours(part.id)).names)
        for part in solution.problem.parts
        if desk.results[part.id][0].status is Status.VERIFIED
    ]


def read(part, question, names, name, value):
    node = parse_yaml(Source("answers.yaml", f"x: {written(value)}"))["x"]
    expected = Expected.of(name, question.task.answers, question.given)
    known = expected if expected.signals else None  # labels and units are tried elsewhere
    return Reader(names, discrete=part.system.discrete).read(node, question.ours[name], known)


def chance(*of):
    return random.Random(zlib.crc32(repr(of).encode()))  # noqa: S311 - nothing secret


@pytest.mark.parametrize(**by_problem(EXAMPLES, QUICK, of=4))
def test_our_own_answers_are_right_alone_together_and_rounded(path):
    for part, question, names in questions(path):
        together = {}
        for name, value in question.ours.items():
            together[name] = read(part, question, names, name, value)
            for submitted in (together[name], *(read(part, question, names, name, each) for each in _rounded(value))):
                verdict = judge(question, {name: submitted})[name]
                assert verdict.verdict == "correct", (part.id, name, submitted.value, verdict.reason)
        found = judge(question, together)
        assert {str(each.verdict) for each in found.values()} <= {"correct"}, (part.id, found)


def _rounded(value):
    rough = rounded(value)
    return [] if rough is None else [rough]


@pytest.mark.parametrize(**by_problem(EXAMPLES, QUICK, of=4))
def test_a_changed_answer_is_wrong_unless_it_is_still_right(path):
    changed_answers_are_wrong(path)


@pytest.mark.parametrize(**by_problem(MODELS, [], of=16))
def test_a_changed_answer_about_a_model_is_wrong_unless_it_is_still_right(path):
    changed_answers_are_wrong(path, MODELLING)


def changed_answers_are_wrong(path, tasks=()):
    for part, question, _ in questions(path):
        if tasks and part.task not in tasks:
            continue
        for name, ours in question.ours.items():
            tried = list(mutants(ours))
            few = 2 if part.task in ("response", "stability_range") else MOST
            for what, value in chance(path.stem, part.id, name).sample(tried, min(few, len(tried))):
                changed = list(value) if isinstance(value, tuple) else value
                verdict = judge(question, {name: Submitted(changed, changed)})[name]
                if verdict.verdict == "not judged":
                    assert any(words in verdict.reason for words in UNDECIDED), (part.id, name, what, verdict.reason)
                    continue
                right = is_right(part, question, name, ours, changed, what)
                if right is not None:
                    assert (verdict.verdict == "correct") is right, (part.id, part.task, name, what, ours, changed)


def is_right(part, question, name, ours, value, what):
    """Whether a changed value is still right; None where only the solver's own oracles could tell."""
    if name in SCALABLE and ("halved" in what or "reversed" in what):
        return True
    if what == "an item twice" and name in SETS and part.task not in ("lqr", "kalman_filter"):
        return True
    if name == "critical_gains" and what == "an item twice":
        return None  # that of a pair may be told for each of its poles
    if name in UP_TO_A_CONSTANT and isinstance(value, sp.Expr):
        return not sp.expand(value - ours).free_symbols  # up to a constant
    if question.task.answers[name].is_free(question.given) or (part.task, name) in DEFINED:
        return True if same(ours, value) else still_right(part.task, name, question.given, ours, value)
    if part.task == "parameter_condition" and any(str(x) == "n" for each in ours for x in each.free_symbols):
        return None  # n stands for any whole number: −πn are the same values
    if name == "condition":
        return False if value in (sp.true, sp.false) and ours not in (sp.true, sp.false) else None
    return same(ours, value)


def same(ours, value):
    """Whether two values are the same at two sets of random numbers; lists in any order."""
    if isinstance(ours, list | tuple):
        return isinstance(value, list | tuple) and len(ours) == len(value) and _same_items(list(ours), list(value))
    if isinstance(ours, sp.MatrixBase):
        both = isinstance(value, sp.MatrixBase) and ours.shape == value.shape
        return both and all(same(a, b) for a, b in zip(ours.flat(), value.flat(), strict=True))
    if isinstance(ours, sp.Expr) and isinstance(value, sp.Expr):
        late = ours.has(sp.Heaviside) or value.has(sp.Heaviside)  # some points must be behind the last step
        return all(_close(ours, value, seed) for seed in range(1, 20 if late else 4))
    if isinstance(ours, sp.Rel) and isinstance(value, sp.Rel):
        return bool(ours.canonical == value.canonical)
    return ours == value


def _same_items(ours, value):
    for item in ours:
        partner = next((i for i, other in enumerate(value) if same(item, other)), None)
        if partner is None:
            return False
        del value[partner]
    return True


def _moved(value):
    """A value with functions of time in the place of its signals."""
    waves = value.replace(lambda each: isinstance(each, AppliedUndef), lambda each: sp.sin(2 * each.args[0] + 1))
    return waves.doit() if waves.has(sp.Integral, sp.Derivative) else waves


def _close(a, b, seed):
    a, b = _moved(a), _moved(b)
    draw = random.Random(seed)  # noqa: S311
    symbols = sorted(a.free_symbols | b.free_symbols, key=str)
    at = {symbol: sp.Rational(draw.randint(11, 97), 31) for symbol in symbols}
    at |= {symbol: seed * number for symbol, number in at.items() if symbol.name == "t"}
    at |= {symbol: sp.Integer(seed - 1) for symbol in at if symbol.name == "k" and not symbol.is_positive}
    if sp.oo in (a, b) or -sp.oo in (a, b):
        return bool(a == b)
    difference = sp.N((a - b).xreplace(at), 40, maxn=200)
    known = 1e-15 if (a - b).has(sp.Float) else 1e-35
    return bool(abs(difference) <= known * max(1, abs(sp.N(a.xreplace(at), 40))))


@pytest.mark.parametrize(**by_problem(EXAMPLES, QUICK, of=4))
def test_among_right_answers_a_changed_one_does_not_pass(path):
    for part, question, _ in questions(path):
        if len(question.ours) < 2 or part.task == "response":
            continue
        right = {name: _submitted(value) for name, value in question.ours.items()}
        name = chance(path.stem, part.id).choice(sorted(right))
        tried = list(mutants(question.ours[name]))
        what, value = chance(path.stem, part.id, name).choice(tried or [("none", question.ours[name])])
        found = judge(question, {**right, name: _submitted(value)})
        if is_right(part, question, name, question.ours[name], _submitted(value).value, what) is False:
            assert any(each.verdict != "correct" for each in found.values()), (part.id, name, what, value)


def _submitted(value):
    value = list(value) if isinstance(value, tuple) else value
    return Submitted(value, value)


X = sp.Symbol("x", real=True)


def odd(value):
    """Values that no student should submit, of the kind of a value."""
    if isinstance(value, str):
        return ["nonsense", ""]
    if isinstance(value, sp.MatrixBase):
        filled = [sp.ImmutableMatrix(*value.shape, lambda *_, x=x: x) for x in (0, X, sp.oo, sp.I, 10**25)]
        shapes = [(value.rows + 1, value.cols), (value.rows, value.cols + 1), (1, 1), (value.rows, 0)]
        return filled + [sp.ImmutableMatrix(sp.ones(*shape)) for shape in shapes]
    if isinstance(value, list | tuple):
        inner = odd(value[0])[:4] if value else []
        return [[], [X], [sp.oo], [sp.I], *([item] * len(value) for item in inner)]
    if isinstance(value, sp.Expr):
        return [X, sp.oo, sp.zoo, sp.I, sp.Integer(10) ** 25, 1 / X, sp.sqrt(-X), sp.Symbol("s") / sp.Symbol("t")]
    return []


@pytest.mark.parametrize(**by_problem(EXAMPLES, QUICK, of=4))
def test_an_odd_value_gets_a_verdict(path):
    for part, question, _ in questions(path):
        for name, ours in question.ours.items():
            tried = odd(ours)
            for value in chance(path.stem, part.id, name).sample(tried, min(2, len(tried))):
                verdict = judge(question, {name: Submitted(value, value)})[name]
                infinite = "oo" in str(value) or "zoo" in str(value)
                assert verdict.verdict in ("correct", "wrong", "not judged")
                assert verdict.verdict == "wrong" or not infinite or value == ours, (part.id, name, value)
