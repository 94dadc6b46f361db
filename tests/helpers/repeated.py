"""How much of a page is told twice: sentences and lines of formulas that stand above word for word.

Titles, questions and what a part's first method finds are what they are: two parts may ask the same of two systems, and
both answers are asked for. Clauses that only lead from one formula to the next are no content.
"""

from collections.abc import Iterator

from solver.document.model import Document, Work
from solver.render.markdown import markdown_of
from solver.render.pointing import unlinked

CLAUSE = 40
"""Characters below which words lead on and tell nothing by themselves."""

FORMULA = 20
"""Characters of LaTeX below which a formula is a name and a number."""


def repeated(document: Document) -> tuple[float, list[str]]:
    """Return the percentage of a page's text that is told twice, and what is."""
    told: set[str] = set()
    twice: list[str] = []
    for line in (line for part in document.shown for line in _lines(part)):
        twice += [line] if line in told else []
        told.add(line)
    return 100 * sum(map(len, twice)) / len(markdown_of(document)), twice


def _lines(part: Work) -> Iterator[str]:
    """Yield what a part tells line by line, the answers of a further method among it."""
    texts = [each.markdown for step in part.steps for each in step.walk()]
    texts += [] if part.again else [part.given]
    texts += [f"$$\n{answer.shown}\n$$" for answer in part.boxed if part.again]
    for text in texts:
        for number, block in enumerate(unlinked(text).split("$$")):
            least = FORMULA if number % 2 else CLAUSE
            yield from (line.strip() for line in block.split("\n") if len(line.strip()) >= least)
