"""Lemma: linear difference equations run through by hand, sample by sample."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, total
from solver.tasks.transforms.transformed_samples import given_values
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr

    from solver.tasks.transforms.difference_question import Question

MOST_WRITTEN_OUT = 12
"""So many samples are written out one by one."""


def run_of(asked: Question, count: int) -> exact.Run:
    """The values of the unknowns at k < `count`, each from the ones before. Raises NotExact where that cannot be."""
    operators = asked.written
    latest = exact.latest_samples(operators)
    tops = [high for _, high in operators.spans.values()]
    first = asked.moved or 0

    def input_at(name: str, k: int) -> Expr:
        found: Expr = exact.value_of_pieces(asked.pieces[name], asked.k, k) if k >= 0 else sp.S.Zero
        return found

    def rest_at(rest: Expr, k: int) -> Expr:
        found: Expr = sp.S.Zero if asked.at_rest and k < 0 else rest.subs(asked.k, k)
        return found

    return exact.run_through(latest, asked.start, input_at, rest_at, (first, count - min(tops)))


@lemma("recursion")
def by_recursion(asked: Question) -> Derivation[tuple[Expr, ...]]:
    """The first values of the first unknown."""
    yield _latest(asked)
    run = run_of(asked, asked.terms)
    yield Step("start", unclaimed="what is given", given=given_values(asked), at_rest=asked.at_rest,
               detail="brief")  # fmt: skip
    yield _written_out(asked, run)
    yield _table(asked, run)
    name = asked.model.unknowns[0]
    return tuple(run.values.get((name, k), sp.S.Zero) for k in range(asked.terms))


def _latest(asked: Question) -> Step:
    """The equations solved for their latest samples, at the time of these."""
    operators, model = asked.written, asked.model
    back = -max(high for _, high in operators.spans.values())
    claims, rows = {}, []
    latest = exact.latest_samples(operators.later(back))
    values = {}
    for each in latest:
        terms = [_times(c, model.symbol(jet)) for jet, c in {**each.samples, **each.inputs}.items()]
        terms += [each.rest] if each.rest != 0 else []
        rows.append((model.symbol(each.jet), total(*terms) if terms else sp.S.Zero))
        values[model.symbol(each.jet)] = sp.Add(
            *(c * model.symbol(jet) for jet, c in {**each.samples, **each.inputs}.items()), each.rest
        )
    for i, row in enumerate(operators.later(back).rows, 1):
        left = sp.Add(*(c * model.symbol(jet) for jet, c in row.unknowns.items()))
        right = sp.Add(*(c * model.symbol(jet) for jet, c in row.inputs.items()), row.rest)
        claims[f"row{i}"] = Claim(left.xreplace(values), right, "solved for the latest sample")
    return Step("latest", claims=claims, rows=rows, several=len(rows) > 1, moved=back != 0)


def _times(c: Expr, symbol: Any) -> Any:
    return symbol if c == 1 else product(c, symbol) if c.is_Add else c * symbol


def _written_out(asked: Question, run: exact.Run) -> Step:
    """The samples one by one, with the numbers put in."""
    claims: dict[str, Claim] = {}
    rows: list[tuple[Any, int, str, bool]] = []
    for i, ((name, at), products, value) in enumerate(run.steps):
        if not 0 <= at < asked.terms or len(rows) >= MOST_WRITTEN_OUT:
            continue
        terms = [x if c == 1 else product(c, x) for c, x in products]
        stated = total(*terms) if terms else sp.S.Zero
        claims[f"sample{i}"] = Claim(stated, value, Phrase("the sample {name}", name=f"{name}({at})"))
        rows.append((sp.Symbol(name), at, f"sample{i}", stated != value))
    return Step("written_out", claims=claims, unclaimed="" if claims else "nothing to be worked out", detail="full",
                rows=rows)  # fmt: skip


def _table(asked: Question, run: exact.Run) -> Step:
    """The values in a table, with the inputs."""
    first = min([0, *(m for _, m in asked.start)]) if not asked.at_rest else 0
    columns = list(range(first, asked.terms))
    rows: list[tuple[Any, list[Any]]] = [
        (sp.Symbol(name), [_input(asked, name, k) for k in columns]) for name in asked.model.inputs
    ]
    rows += [(sp.Symbol(name), [run.values.get((name, k)) for k in columns]) for name in asked.model.unknowns]
    return Step("table", unclaimed="worked out before", columns=columns, rows=rows)


def _input(asked: Question, name: str, k: int) -> Expr:
    found: Expr = exact.value_of_pieces(asked.pieces[name], asked.k, k) if k >= 0 else sp.S.Zero
    return found
