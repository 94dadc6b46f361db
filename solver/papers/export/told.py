"""The texts of a question for a learning system: what a paper asks, the worked solution, the key of an essay.

Each part stands alone there, so nothing refers to what another part tells: what it needs of an earlier one is asked
again with it.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from solver.derivation.figures import Drawing
from solver.document.model import Document, Work, WorkStep
from solver.document.once import told_once
from solver.papers.export.quiz import Block, Content, Heading, Picture, Text
from solver.problem.images import Image
from solver.problem.model import Part, Problem
from solver.render import pictures
from solver.render.pointing import agreeing, noting, picturing, referring, unlinked
from solver.render.prose import plain
from solver.words import Phrase

NUMBERS = (
    "Write numbers with a decimal point: whole ones as they are, others to {digits} significant digits and one decimal "
    "place at least, without fractions, roots or letters."
)
EARLIER = "Part ({letter}), from which this part goes on, asks:"
TOGETHER = "What is asked here:"


def question_of(paper: Document, problem: Problem, part: Part, last: Sequence[str]) -> Content:
    """Return the question of a part as a paper has it, with the problem and the parts it goes on from; `last` ends it.

    `last` are paragraphs of Markdown.
    """
    works = {work.id: work for work in paper.parts if not work.case and not work.again}
    say = paper.messages.say
    texts = [paper.statement, paper.given]
    for earlier in _sources(problem, part):
        work = works[earlier]
        texts += [f"*{say(Phrase(EARLIER, letter=plain(work.letter)))}*", work.question, work.given]
    work = works[part.id]
    if len(texts) > 2:
        texts.append(f"*{say(TOGETHER)}*")
    texts += [work.question, work.given]
    if work.named_method:
        texts.append(f"*{say('Method:')} {plain(work.method_title)}*")
    return Content(tuple(Text(each) for each in [*texts, *last] if each.strip()), paper.images)


def _sources(problem: Problem, part: Part) -> list[str]:
    """Return the earlier parts that a part goes on from, those that they go on from among them, in order."""
    parts, found = {each.id: each for each in problem.parts}, set[str]()
    left = list(part.sources)
    while left:
        name = left.pop()
        if name not in found:
            found.add(name)
            left += parts[name].sources
    return [each.id for each in problem.parts if each.id in found and each.id != part.id]


def solution_of(document: Document, part: str) -> Content:
    """Return the worked solution of a part by all its methods, as a page has it."""
    works = told_once([work for work in document.parts if work.id == part], document.messages.say)
    several = len(works) > 1
    blocks = [block for work in works for block in _solution(document, work, headed=several)]
    return Content(tuple(blocks), document.images)


def _solution(document: Document, work: Work, *, headed: bool) -> Iterator[Block]:
    say = document.messages.say
    if headed:
        yield Heading(plain(work.named_method or work.title))
    if work.case:
        yield from _texts(work.question, work.given)
    level = 2 if headed else 1
    yield from _steps(work.steps, level, document)
    if work.boxed or work.same or work.noted:
        yield Heading(say("Answer"), level)
    for answer in work.boxed:
        yield Text(f"$$\n{answer.shown}\n$$")
    if work.same:
        yield Text(agreeing(work.same, say))
    if work.noted:
        yield Text(noting(work, say))


def _steps(steps: Sequence[WorkStep], level: int, document: Document, *, numbered: bool = True) -> Iterator[Block]:
    say = document.messages.say
    for number, step in enumerate(steps, 1):
        yield Heading(f"{number}. {step.title}" if numbered else step.title, level)
        yield from _texts(referring(step, say) if step.refers else "", unlinked(step.markdown))
        yield from (Text(picturing(each, say)) for each in step.pictured)
        yield from map(_picture, step.figures)
        yield from _steps(step.steps, level + 1, document, numbered=False)


def _picture(drawing: Drawing) -> Picture:
    """Return a figure as a drawing."""
    image = Image("image/svg+xml", pictures.svg_of(drawing).encode())
    return Picture(image, pictures.words_of(drawing), drawing.caption)


def _texts(*texts: str) -> Iterator[Text]:
    yield from (Text(each) for each in texts if each.strip())


def key_of(key: Document, part: str, names: Collection[str]) -> Content:
    """Return the lines that earn the marks of some answers of a part, and these with their marks."""
    say, blocks = key.messages.say, list[Block]()
    for work in (each for each in key.parts if each.id == part and not each.again):
        for step in work.steps:
            blocks += [Heading(step.title), *_texts(step.markdown)]
        blocks.append(Heading(say("Answer")))
        for answer in work.boxed:
            if answer.name in names or set(answer.instead) & set(names):
                marks = (
                    f"\n\n({answer.marks} {say('mark' if answer.marks == '1' else 'marks')})" if answer.marks else ""
                )
                blocks.append(Text(f"$$\n{answer.shown}\n$$" + marks))
    return Content(tuple(blocks), key.images)
