"""Smith's form of a polynomial matrix: by elementary operations, or by minors where those grow long."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby, pairwise
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product, quotient, total
from solver.stated.matrices import determinant
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

MOST_MINORS = 9
"""So many minors of one order are written out."""


@dataclass(frozen=True, slots=True)
class Shown:
    """A stage as it is shown: the matrix after it has the name `name` with a number, the one before it another."""

    stage: exact.SmithStage
    number: int
    before: str
    after: str
    divisions: tuple[str, ...]

    @property
    def kind(self) -> str:
        """What is done."""
        return self.stage.kind

    @property
    def scaled(self) -> bool:
        """Whether the row of the pivot is multiplied too."""
        return hasattr(self.stage.operations[-1], "factor")

    @property
    def exchanged(self) -> bool:
        """Whether lines are exchanged."""
        return not hasattr(self.stage.operations[0], "factor")


@lemma("smith")
def smith_form_of(
    M: ImmutableMatrix, x: Symbol, name: str, found: exact.SmithForm | None = None
) -> Derivation[exact.SmithForm]:
    """The form with the operations that lead to it, those for one pivot together; the matrix is called by a name.

    Where it is `found` already, on the way to something else, no exceptions are told.
    """
    form = found or exact.smith_form(M, x)
    by_minors = form.is_long
    yield Step("sought", detail="full", unclaimed="what is done and why", name=name, M=M, by_minors=by_minors)
    if by_minors:
        yield from _by_minors(form, M, name)
    else:
        yield from _by_operations(form, M, name)
    yield _factors(form, () if found else exact.changed_where(form), by_minors=by_minors)
    if not by_minors and form.left is not None and form.right is not None:
        yield _unimodular(form, M, name, form.left, form.right)
    return form


def _by_operations(form: exact.SmithForm, M: ImmutableMatrix, name: str) -> Iterator[Step]:
    number = 0
    rounds = {k: list(stages) for k, stages in groupby(form.stages or (), key=lambda stage: stage.k)}
    for k in range(form.rank):
        claims: dict[str, Claim] = {}
        shown = []
        for stage in rounds.get(k, ()):
            number += 1
            shown.append(_shown(stage, number, name, claims))
        yield Step(
            "pivot",
            claims=claims,
            unclaimed="" if claims else "nothing is to be done",
            k=k + 1,
            last=k + 1 == form.rank,
            left=min(form.shape) - k - 1,
            name=name,
            x=form.variable,
            e=form.invariants[k].as_expr(),
            stages=shown,
            start=M if number == len(shown) else None,
        )


def _shown(stage: exact.SmithStage, number: int, name: str, claims: dict[str, Claim]) -> Shown:
    """The stage, with what is claimed of it added: the matrices that do the operations, and each division."""
    factors = [stage.left] if any(each.line == "R" for each in stage.operations) else []
    factors += [stage.before]
    factors += [stage.right] if any(each.line == "C" for each in stage.operations) else []
    says = Phrase("operation {number}", number=number)
    claims[f"done{number}"] = Claim(product(*factors), stage.after, says)
    divisions = []
    for i, each in enumerate(stage.divisions, 1):
        p, d, q, r = each.expressions
        if each.divisor.degree() > 0:
            left, right = (difference(p, product(q, d)), r) if q.is_number else (p, total(product(q, d), r))
            claims[key := f"division{number}_{i}"] = Claim(left, right, Phrase("division by the pivot"))
            divisions.append(key)
    before = f"{name}_{{{number - 1}}}" if number > 1 else name
    return Shown(stage, number, before, f"{name}_{{{number}}}", tuple(divisions))


def _by_minors(form: exact.SmithForm, M: ImmutableMatrix, name: str) -> Iterator[Step]:
    """The gcds of the minors of each order."""
    x = form.variable
    divisors = exact.determinantal_divisors(M, x)
    for k in range(1, min(M.shape) + 1):
        minors = exact.minors_in_factors(M, x, k)
        listed = minors if len(minors) <= MOST_MINORS else ()
        claims = {
            f"minor{i}": Claim(determinant(each.matrix) if k > 1 else each.matrix[0, 0], each.value, Phrase("minor"))
            for i, each in enumerate(listed, 1)
        }
        divisor = exact.in_factors(divisors[k - 1]) if k <= len(divisors) else sp.S.Zero
        yield Step("minors", claims=claims, unclaimed="" if claims else "there are too many to be written out", k=k,
                   name=name, x=x, minors=listed, number=len(minors), divisor=divisor,
                   factored=k == 1 and all(each.matrix[0, 0] == each.value for each in minors))  # fmt: skip
    claims = {}
    for k, (before, d) in enumerate(pairwise([divisors[0].one, *divisors]), 1):
        stated = quotient(exact.in_factors(d), exact.in_factors(before)) if k > 1 else exact.in_factors(d)
        claims[f"factor{k}"] = Claim(stated, exact.in_factors(form.invariants[k - 1]), Phrase("invariant factor"))
    yield Step("quotients", claims=claims, x=x)


def _factors(form: exact.SmithForm, exceptions: Sequence[Expr], *, by_minors: bool) -> Step:
    """The invariant factors; the quotient of each by the one before it has no remainder."""
    listed = [exact.in_factors(e) for e in form.invariants]
    claims = {}
    for k, (one, following) in enumerate(pairwise(form.invariants), 1):
        if one.degree() > 0:
            whole = exact.in_factors(following.quo(one))
            claims[f"divides{k}"] = Claim(quotient(listed[k], listed[k - 1]), whole, Phrase("divisibility"))
    for k, (e, factored) in enumerate(zip(form.invariants, listed, strict=True), 1):
        if e.as_expr() != factored and not by_minors:
            claims[f"factored{k}"] = Claim(e.as_expr(), factored, Phrase("in factors"))
    return Step("factors", claims=claims, unclaimed="" if claims else "the factors were found above",
                x=form.variable, factors=listed, form=form.form, rank=form.rank,
                most=min(form.shape), ones=all(each == 1 for each in listed[:-1]), by_minors=by_minors,
                exceptions=exceptions, general=form.is_general)  # fmt: skip


def _unimodular(form: exact.SmithForm, M: ImmutableMatrix, name: str, U: ImmutableMatrix, V: ImmutableMatrix) -> Step:
    """The operations on rows carried out on the identity, and those on columns."""
    claims = {
        "form": Claim(product(U, M, V), form.form, Phrase("all operations together")),
        "left": Claim(determinant(U), _constant(U, form.variable), Phrase("a unimodular matrix")),
        "right": Claim(determinant(V), _constant(V, form.variable), Phrase("a unimodular matrix")),
    }
    return Step("unimodular", detail="tutor", claims=claims, U=U, V=V, M=M, name=name)


def _constant(unimodular: ImmutableMatrix, x: Symbol) -> Expr:
    """The determinant, which is that at x = 0."""
    found: Any = sp.factor(exact.determinant(sp.ImmutableMatrix(unimodular.xreplace({x: sp.S.Zero}))))
    return found
