"""A method that is not written as it must be is refused with a message that says what to write."""

import pytest

from solver.derivation import AnswerName, Answers, MistakenDerivation, Step, Task, Unsolved, lemma
from solver.engine import yield_into
from solver.tasks.plant_options import PlantOptions


@lemma("resolvent")
def resolvent_of(given):
    yield Step("resolvent", unclaimed="a lemma of this test")
    return given


def run(derive):
    """Run a function as the only method of a task, to its end."""
    task = Task(
        "demo",
        title="Demo",
        doc="Demo.",
        needs=(),
        options=PlantOptions,
        answers=[AnswerName("K", "K", "the gain"), AnswerName("L", "L", "the other gain")],
    )
    steps = []
    found = yield_into(steps, task.method("by_hand")(derive)(task.given(None, {})))
    return found, [step.wording for step in steps]


def test_a_method_as_it_must_be():
    def derive(given):
        """Two steps, one of a lemma."""
        yield Step("begin", unclaimed="nothing")
        yield from resolvent_of(given)
        return Answers(K=1)

    assert run(derive) == ({"K": 1}, ["demo/by_hand", "lemmas/resolvent"])


def test_an_answer_that_is_not_declared():
    def derive(given):
        yield Step("begin", unclaimed="nothing")
        return Answers(K=1, M=2)

    with pytest.raises(MistakenDerivation, match=r"demo, method by_hand: the answer M is not declared.*one of: K, L"):
        run(derive)


def test_answers_that_are_not_returned():
    def derive(given):
        yield Step("begin", unclaimed="nothing")

    with pytest.raises(MistakenDerivation, match=r"must end in `return Answers\(…\)`, not in None"):
        run(derive)


@pytest.mark.parametrize("kept", [False, True])
def test_a_lemma_without_yield_from(kept):
    def derive(given):
        if kept:
            found = resolvent_of(given)  # noqa: F841 - it is the mistake
        else:
            resolvent_of(given)
        yield Step("begin", unclaimed="nothing")
        return Answers(K=1)

    with pytest.raises(
        MistakenDerivation, match=r"resolvent_of\(…\) was called and not run; write `yield from resolve"
    ):
        run(derive)


def test_a_lemma_lost_by_a_refusal_blames_no_later_method():
    def refused(given):
        resolvent_of(given)
        yield Step("begin", unclaimed="nothing")
        raise Unsolved("demo")

    def derive(given):
        yield Step("begin", unclaimed="nothing")
        return Answers(K=1)

    with pytest.raises(Unsolved):
        run(refused)
    assert run(derive)[0] == {"K": 1}
