"""Steps in words: the macro of a step's kind, in `templates/wording/<folder>/<file>.md.jinja`, writes Markdown.

A macro is called with the step's values `v` and claims `c`; its first line, `### `, is the title. It can use

- `brief`, `full`, `tutor`: the level of detail (`full` holds at the levels full and tutor, `brief` only at brief),
- `value|tex`: a value as LaTeX, in the problem's number format; `value|latex`: the same as text to be compared or
  changed, the value behind it forgotten; `value|alone|tex`: a matrix of one entry as a number, as all displays have it;
  `operation|operation`: a row operation; `text|plain`: words of a user, with Markdown's signs made harmless,
- `eq(a, b, ...)`: the display a = b = ...; texts are LaTeX as it stands, anything else is printed as by `tex`,
  with `holds=false`: an equality that the text itself calls false, or that holds in one case only,
- `claim(c.name, prefix)`: both sides of a claim as a display; `align([[a, b], [c, d]])`: equations under each other,
- `pieces([[name, value], ...])`: `name = value` for all that are not none; `fraction(p, q)`: p over q as it stands;
- `supposed(x, value)`: the formula x = value in a line, which is supposed and not claimed;
- `stands("A", value)`: nothing is shown; from here on the name stands for another value, as the text says; without
  a value: for the one that is displayed next,
- `sym.Phi`, `sym.xdot`, ...: the symbols of the notation.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

from jinja2 import TemplateError, TemplateNotFound, TemplateSyntaxError

from solver.derivation import AnswerEquations, AnswerName, Step
from solver.derivation.displayed import Displayed
from solver.derivation.figures import Figure, worded_figure
from solver.formula import MathProblem, latex
from solver.formula.nodes import Row
from solver.markup import math_problems
from solver.messages import Messages
from solver.notation import answer_symbol
from solver.problem.model import Chain, Display, Part
from solver.render.displaying import Displaying, word_of
from solver.render.equations import formula_of
from solver.render.latex import DEFAULT, answer_formula, formula
from solver.render.listed import equations_that_are_zero, told_behind
from solver.render.macros import Macros, environment_of, macros_of
from solver.render.numbers import NumberFormat
from solver.stated.algebra import quotient
from solver.symbols import COURSE, NOTATIONS
from solver.systems import System
from solver.words import ENGLISH, Reason

LEVELS = ("brief", "full", "tutor")


class WordingError(Exception):
    """A template is missing or wrong; the message names it and the macro."""


@dataclass(frozen=True, slots=True)
class WordedStep:
    """A step in words: title and body are Markdown with `$math$`; `step` is the data it was made from.

    `displayed` are the formulas in them, in the order of reading.
    """

    title: str
    markdown: str
    steps: tuple[WordedStep, ...]
    step: Step
    figures: tuple[Figure, ...] = ()
    displayed: tuple[Displayed, ...] = ()

    def walk(self) -> Iterator[WordedStep]:
        """This step and all its substeps, in the order of reading."""
        yield self
        for step in self.steps:
            yield from step.walk()


@dataclass(frozen=True)
class Wording:
    """How a solution is worded: numbers, level of detail, a folder of templates that come first, notation, language."""

    numbers: NumberFormat = DEFAULT
    detail: str = "full"
    templates: Path | None = None
    notation: str = COURSE
    language: str = ENGLISH

    @staticmethod
    def of(display: Display, detail: str = "full", templates: Path | None = None) -> Wording:
        """Return the wording that a problem asks for."""
        return Wording(NumberFormat.of(display), detail, templates, display.notation, display.language)

    def words(self, steps: Iterable[Step]) -> tuple[WordedStep, ...]:
        """Word those steps that are shown at this level of detail, with their substeps."""
        return tuple(self.word(step) for step in steps if self.shows(step))

    def shows(self, step: Step) -> bool:
        """Whether the step is shown at this level of detail."""
        return LEVELS.index(step.detail) <= LEVELS.index(self.detail)

    def word(self, step: Step) -> WordedStep:
        """Word a step. Raises WordingError if its macro is missing or wrong."""
        marked = self._marked(step.wording, step.kind, dict(step.values), dict(step.claims))
        displayed = tuple(self._macros.recorder.displayed(marked))
        heading, _, body = self._macros.recorder.expanded(marked).strip().partition("\n")
        if not heading.startswith("### "):
            raise WordingError(f"{_place(step.wording, step.kind)} must begin with the title: ### ...")
        title, markdown = heading.removeprefix("### ").strip(), _tidy(body)
        for _, message in [*math_problems(title), *math_problems(markdown)]:
            raise WordingError(f"{_place(step.wording, step.kind)}: {message}")
        figures = tuple(worded_figure(each, self.say) for each in step.figures)
        return WordedStep(title, markdown, self.words(step.steps), step, figures, displayed)

    def question(self, part: Part, *, loops: Iterable[str] = (), asked: Iterable[AnswerName] = ()) -> str:
        """Return the question of a part in Markdown: its own prompt, or the task's.

        `loops` are the lemmas that close a loop around the system before the question is asked, which is then said too.
        `asked` are the answers that the file asks for.
        """
        if part.prompt:
            return part.prompt.strip()
        options = {**part.options, "methods": part.methods if part.names_methods else ()}
        words = self._macro(f"{part.task}/question", "question", part.system, options)
        said = "".join(self._macro(f"lemmas/{loop}", "loop_of", part.system, options) for loop in loops)
        named = [(self._symbol_in_words(answer), self.say(answer.doc)) for answer in asked]
        said += self._macro("lemmas/asked", "asked", named) if named else ""
        return _tidy(f"{words.strip()}\n{said.strip()}")

    def _symbol_in_words(self, answer: AnswerName) -> str:
        """Return the symbol of an answer, empty where it has a word in place of one."""
        symbol = self.symbol(answer)
        return "" if word_of(symbol) else symbol

    def given(self, system: System) -> str:
        """Return what is given about a system in Markdown."""
        return _tidy(self._macro(f"systems/{system.kind}", "given", system))

    def conditions(self, assumed: Mapping[str, Sequence[Any]], chains: Sequence[Chain]) -> str:
        """Return what is given about the parameters in Markdown; empty where that is nothing.

        `assumed` has symbols by the word for what is assumed of them, `chains` are the conditions.
        """
        return _tidy(self._macro("lemmas/conditions", "conditions", assumed, chains)) if assumed or chains else ""

    def special(self, macro: str, *arguments: Any) -> str:
        """Return what is said of special values of parameters: a macro of `lemmas/special_cases`."""
        return _tidy(self._macro("lemmas/special_cases", macro, *arguments))

    def tex(self, value: Any) -> str:
        """Return a value as LaTeX."""
        return latex(self.formula(value))

    def formula(self, value: Any) -> Row:
        """Return the formula of a value."""
        return formula(value, self.numbers)

    def answer(self, value: Any) -> str:
        """Return the value of an answer as LaTeX, with its decimals beside it where the format says `both`."""
        return latex(self._answer(value))

    def _answer(self, value: Any) -> Row:
        return answer_formula(self.say(value) if isinstance(value, str) else value, self.numbers)

    def symbol(self, answer: AnswerName) -> str:
        """Return the LaTeX symbol of an answer."""
        return self.say(answer_symbol(answer.name, answer.symbol, self.notation))

    def reason(self, reason: Reason | None) -> str:
        """Return a reason in words, empty for none."""
        return "" if reason is None else self.messages.reason(reason)

    def say(self, phrase: str) -> str:
        """Return a phrase (a title, a label, a word of a verdict) in the language."""
        return self.messages.say(phrase)

    @cached_property
    def messages(self) -> Messages:
        """How reasons and phrases are worded."""
        return Messages(self.templates, self.language, self.notation)

    def _macro(self, wording: str, name: str, *arguments: Any) -> str:
        return self._macros.recorder.expanded(self._marked(wording, name, *arguments))

    def _marked(self, wording: str, name: str, *arguments: Any) -> str:
        """Return what a macro writes, with marks for the values and displays in it (see `recording`)."""
        place = _place(wording, name)
        self._macros.recorder.begin()
        try:
            found = [getattr(module, name) for module in self._modules(wording) if hasattr(module, name)]
            if not found:
                raise WordingError(f"{place} is missing; write {{% macro {name}(…) %}} there")
            return str(found[0](*arguments))
        except TemplateNotFound as error:
            raise WordingError(f"{place} is missing: there is no such file") from error
        except TemplateSyntaxError as error:
            raise WordingError(f"{place}, line {error.lineno}: {error.message}") from error
        except (
            TemplateError,
            MathProblem,
            TypeError,
            ValueError,
            ArithmeticError,
            LookupError,
            AttributeError,
        ) as error:
            raise WordingError(f"{place}: {error}") from error

    def load(self, wording: str) -> None:
        """Compile a file of macros before it is needed; raises Jinja's `TemplateError`."""
        self._modules(wording)

    def _modules(self, wording: str) -> list[Any]:
        """Return the macros of a file as attributes, those of the language before the English ones."""
        modules, files = self._macros.modules, self.messages.files(wording)
        for file in files:
            if file not in modules:
                try:
                    modules[file] = environment_of(self.templates).get_template(file).make_module(self._names)
                except TemplateNotFound:
                    if file == files[-1]:
                        raise
                    modules[file] = None  # the language has no file of its own
        return [modules[file] for file in files if modules[file] is not None]

    @cached_property
    def _macros(self) -> Macros:
        return macros_of(self)

    @cached_property
    def _displaying(self) -> Displaying:
        return Displaying(self._macros.recorder, self.formula)

    @cached_property
    def _names(self) -> dict[str, Any]:
        """What macros can use."""
        level, shown = LEVELS.index(self.detail), self._displaying
        return {
            **{"brief": level == 0, "full": level >= 1, "tutor": level >= 2},
            **{"eq": shown.eq, "claim": shown.claim, "align": shown.align, "sym": NOTATIONS[self.notation]},
            **{"say": self.say, "tex": shown.tex, "latex": self.tex, "operation": shown.operation},
            **{"pieces": shown.pieces, "fraction": quotient, "stands": shown.stands, "supposed": shown.supposed},
        }

    def chain(self, displayed: Displayed) -> str:
        """Return a display a = b = ... that was worded, as LaTeX."""
        return latex(self._displaying.again(displayed))

    def equation(self, symbol: str, value: Any, *, narrow: bool = False, zero: bool = False) -> str:
        """Return an answer as `symbol = value`, or `word: value`, laid out for a page; a matrix by entry if narrow.

        What is `zero` is told so, each expression of a list on a line of its own.
        """
        if zero and isinstance(value, list | tuple):
            return latex(equations_that_are_zero(value, self._answer))
        word = word_of(symbol)
        if word:
            return latex(told_behind(word, value, self._answer, narrow=narrow))
        shown = self.answer(value) if isinstance(value, str) else value  # words, not LaTeX
        return latex(self._displaying.laid_out([symbol, shown], self._answer, narrow=narrow))

    def equations(
        self,
        equations: AnswerEquations,
        values: Mapping[str, Any],
        *,
        discrete: bool,
        moved: Any = None,
        narrow: bool = False,
    ) -> str:
        """Return answers as equations; empty where they are too wide to be read so."""
        spelt = replace(equations, lines=tuple(each.spelled(self.notation) for each in equations.lines))
        found = formula_of(spelt, values, self.formula, discrete=discrete, moved=moved, narrow=narrow)
        return latex(found) if found is not None else ""


def _place(wording: str, macro: str) -> str:
    return f"the macro {macro!r} of templates/wording/{wording}.md.jinja"


def _tidy(markdown: str) -> str:
    """Return Markdown without blanks at line ends and with at most one empty line in a row."""
    lines = [line.rstrip() for line in markdown.strip().split("\n")]
    kept = [line for i, line in enumerate(lines) if line or lines[i - 1]]
    return "\n".join(kept)
