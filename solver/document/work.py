"""One part by one method in words: its steps, answers and checks, as every format shows them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

from solver.derivation import Check, CheckStatus, Status
from solver.derivation.figures import Drawing


@dataclass(frozen=True, slots=True)
class Reference:
    """Where something stands on the page: the steps with these numbers in the part that has this anchor.

    `place` says it in words (Markdown): "(d), steps 1–4".
    """

    part: str
    numbers: tuple[int, ...]
    place: str

    @property
    def anchor(self) -> str:
        """The name for links of the first of the steps, or of the part where there are none."""
        return step_anchor(self.part, self.numbers[0]) if self.numbers else self.part


def step_anchor(part: str, number: int) -> str:
    """Return the name for links to a step of the part that has this anchor."""
    return f"{part}-step-{number}"


@dataclass(frozen=True, slots=True)
class WorkStep:
    """A step in words: title and text are Markdown; its values by name, as sympy reads them back.

    `covers` are the numbers by which checks cite it, counted among all steps of the part, shown or not. On a page
    `refers` says where the steps stand that it takes the place of, `pictured` where its figures do.
    """

    kind: str
    title: str
    markdown: str
    steps: tuple[WorkStep, ...] = ()
    figures: tuple[Drawing, ...] = ()
    values: Mapping[str, str] = field(default_factory=dict)
    covers: tuple[int, ...] = ()
    refers: tuple[Reference, ...] = ()
    pictured: tuple[Reference, ...] = ()

    def walk(self) -> Iterator[WorkStep]:
        """This step and all its substeps, in the order of reading."""
        yield self
        for step in self.steps:
            yield from step.walk()


@dataclass(frozen=True, slots=True)
class WorkAnswer:
    """One answer: its name, LaTeX of its symbol and value (no dollar signs), its meaning; `value` as sympy reads it.

    The value of a program is its data.

    `equation` is LaTeX of symbol = value laid out for a page: broken over lines, or entry by entry, where it is wide.
    `narrow` is the same entry by entry in any case. `marks` is what it earns, as text, or "" where that is not said.
    `numeric` are its numbers in nested lists, a complex one as [re, im], where it has no symbols. `given` tells that it
    is what the question gives, such as the weights of a regulator, and is no news. `asked` tells that it is asked for;
    of another one, which was found on the way, a page may say in which step it `stands`. `derived` is LaTeX of
    symbol = formula = value, which a key shows. `told` are the kinds of steps that tell it in another
    form. `instead` names the answers in whose place a page shows this one, which
    is their equations and no answer by itself.
    """

    name: str
    symbol: str
    tex: str
    doc: str
    value: Any
    equation: str
    narrow: str = ""
    marks: str = ""
    numeric: Any = None
    given: bool = False
    asked: bool = True
    stands: Reference | None = None
    derived: str = ""
    told: tuple[str, ...] = ()
    instead: tuple[str, ...] = ()

    @property
    def shown(self) -> str:
        """LaTeX of what a page shows."""
        return self.derived or self.equation


@dataclass(frozen=True, slots=True)
class CheckRow:
    """One line of the table of checks: `claim`, `oracle`, `reason` are Markdown, numbers LaTeX or "" for none.

    The equalities of one step are one line: `residual` and `tolerance` are then those nearest to failing.
    """

    claim: str
    oracle: str
    residual: str
    tolerance: str
    status: CheckStatus
    reason: str = ""


@dataclass(frozen=True, slots=True)
class Work:
    """One part by one method.

    `question` and `given` are Markdown; `again` tells that they stand above, with another method. `marks` is a number
    as text, or "" where the file gives none; `out_of` what the part counts for. `reason` (Markdown) says why a part is
    not verified, `unchecked` how many checks could not be made, and why. `rows` is the table of checks, `checks` each
    of them. `symbols` are the free names of answers and steps, `functions` those of signals v(t) in answers, `system`
    is what is asked about, as sympy reads it. `fault` is what is wrong with the templates, where the part could not be
    worded. `cases` are the solutions for special values of the parameters, each with its `case`, as `a = 3`; they stand
    after it among the parts of the document. `label` is the part's name in print, where that is not its key in the
    file. On a page `same` is the method above that has found the same answers. `equations` are answers told together.
    """

    id: str
    task: str
    method: str
    title: str
    method_title: str
    source: str
    marks: str
    question: str
    given: str
    again: bool
    steps: tuple[WorkStep, ...]
    answers: tuple[WorkAnswer, ...]
    rows: tuple[CheckRow, ...]
    status: Status
    reason: str
    unchecked: str = ""
    out_of: float = 1
    checks: tuple[Check, ...] = ()
    symbols: tuple[str, ...] = ()
    functions: tuple[str, ...] = ()
    system: Mapping[str, str] = field(default_factory=dict)
    fault: str = ""
    case: str = ""
    cases: tuple[Work, ...] = ()
    label: str = ""
    same: Reference | None = None
    equations: tuple[WorkAnswer, ...] = ()

    @property
    def letter(self) -> str:
        """What the part is called in print: (a), (b)."""
        return self.label or self.id

    @property
    def found(self) -> tuple[WorkAnswer, ...]:
        """What a page shows: the answers that the question does not give, some of them together as equations."""
        together = {name: each for each in self.equations for name in each.instead}
        alone = (together.get(answer.name, answer) for answer in self.answers if not answer.given)
        return tuple(_each_once([*alone, *(each for each in self.equations if not each.instead)]))

    @property
    def boxed(self) -> tuple[WorkAnswer, ...]:
        """The answers found that are not only pointed at."""
        return () if self.same else tuple(answer for answer in self.found if answer.stands is None)

    @property
    def noted(self) -> tuple[tuple[Reference, tuple[WorkAnswer, ...]], ...]:
        """The steps of this part where answers stand that were found on the way, with these."""
        found: dict[Reference, tuple[WorkAnswer, ...]] = {}
        for answer in self.found:
            if answer.stands is not None and answer.stands.part == self.anchor:
                found[answer.stands] = (*found.get(answer.stands, ()), answer)
        return tuple(found.items())

    @property
    def named_method(self) -> str:
        """The title of the method where it says more than that of the part, and may be said."""
        method = self.method_title
        return "" if self.title == method or self.title.endswith((f": {method}", f", {method}")) else method

    @property
    def anchor(self) -> str:
        """A name for links to the part, unique on the page: letters, digits and hyphens."""
        return _part_anchor(self.id, self.method, self.case)


@lru_cache(maxsize=1024)
def _part_anchor(name: str, method: str, case: str) -> str:
    """Return the name for links to a part; pages ask for it again and again."""
    words = f"part-{name}-{method}{case and '-'}{case}".replace("_", "-").lower()
    return "".join(letter for letter in words if letter.isascii() and (letter.isalnum() or letter == "-"))


def _each_once(answers: Iterable[WorkAnswer]) -> Iterator[WorkAnswer]:
    """Yield each answer where it occurs first."""
    told: list[WorkAnswer] = []
    for answer in answers:
        if not any(answer is each for each in told):
            told.append(answer)
            yield answer
