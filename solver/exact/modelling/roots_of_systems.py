"""All real solutions of a system of equations in some unknowns, with the moves that find them.

Each equation is written as a product; the one that is easiest to solve is solved, case by case, and what it says is put
into the others. Polynomials that resist are triangulated by a Gröbner basis; what is left is searched in a box.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import mpmath
import sympy as sp

from solver.exact.linear_algebra.fields import NotExact
from solver.exact.modelling.branches import Box, Branch, Move, Outcome, Point, Roots, integer_names
from solver.exact.modelling.cases import allowed, cleared, put_in, settled, with_outcome
from solver.exact.modelling.evaluation import evaluator, vanishes
from solver.exact.modelling.factors_of_equations import factored
from solver.exact.modelling.families import family, in_order, put_together
from solver.exact.modelling.rules_of_equations import CIRCLE, CURVE, DIVISION, Rule, rule_for
from solver.exact.modelling.searched_roots import newton_roots, roots_between
from solver.exact.modelling.triangulation import triangulated

MAX_BRANCHES = 200
DEFAULT_BOX = (sp.Integer(-100), sp.Integer(100))
NEAR_INTEGERS = range(-3, 4)
MAX_SEARCHED = 4
"""The most unknowns that are searched for together."""


def real_solutions(
    equations: Sequence[Any], unknowns: Sequence[sp.Symbol], between: Box | None = None, taken: Iterable[str] = (),
    wanted: Sequence[sp.Symbol] | None = None, known: Point | None = None,
) -> Roots:  # fmt: skip
    """Return all real solutions of expressions that are zero; raises NotExact.

    `between` are the intervals in which roots are searched that no formula gives; `taken` are names that whole numbers
    must not have. `wanted` are the unknowns that points tell, where that is not all of them; `known` values of some.
    """
    names = {s.name for e in equations for s in e.free_symbols} | {x.name for x in unknowns} | set(taken)
    solver = _Solver(tuple(unknowns), between or {}, list(integer_names(names)))
    put = known or {}
    equations = [put_in(e, put) for e in equations]
    divisors = [factored(e).divisor for e in equations]
    solver.solve(
        Branch(tuple(equations), found=dict(put), nonzero=tuple(d for d in divisors if d.free_symbols & set(unknowns)))
    )
    shown = tuple(unknowns if wanted is None else wanted)
    ends = [end for end in solver.ends if not solver.searched or _within(end[0], between or {})]
    families = [family(point, shown, needs, solver.names) for point, needs in ends]
    ordered = in_order(put_together(families, solver.names))
    points = tuple(dict(zip(shown, f.values, strict=True)) for f in ordered)
    return Roots(points, tuple(solver.moves), tuple(f.needs for f in ordered), tuple(solver.searched), solver.certain)


def _within(point: Point, box: Box) -> bool:
    """Whether no coordinate that is a number is outside the limits that are given for it."""
    limits = [(point[x], *ends) for x, ends in box.items() if x in point and not point[x].free_symbols]
    return all(bool(low <= value) and bool(value <= high) for value, low, high in limits)


class _Solver:
    def __init__(self, unknowns: tuple[sp.Symbol, ...], box: Box, names: list[sp.Symbol]) -> None:
        self.unknowns = unknowns
        self.box = box
        self.names = names
        self.moves: list[Move] = []
        self.ends: list[tuple[Point, tuple[Any, ...]]] = []
        self.searched: list[Mapping[Any, Any]] = []
        self.certain = True
        self.branches = 0

    def solve(self, branch: Branch) -> None:
        """Follow a case to its ends."""
        self.branches += 1
        if self.branches > MAX_BRANCHES:
            raise NotExact("solutions/too_many_cases")
        left = self._left(branch)
        if left is None:
            return
        if not left.equations:
            self._end(left)
            return
        for each in self._next(left):
            self.solve(each)

    def _open(self, branch: Branch) -> set[Any]:
        return {x for x in self.unknowns if x not in branch.found}

    def _note(self, branch: Branch, kind: str, **values: Any) -> None:
        self.moves.append(Move(kind, branch.case, values))

    def _left(self, branch: Branch) -> Branch | None:
        """The case without equations that hold; None where one cannot hold."""
        kept = []
        for e in branch.equations:
            parts = factored(e)
            if parts.is_zero or (not e.free_symbols & self._open(branch) and vanishes(e)):
                continue
            if not any(f.free_symbols & self._open(branch) for f in parts.factors):
                if e.free_symbols and vanishes(e):
                    continue
                self._note(branch, "contradiction", equation=e, factors=[f for f in parts.factors if f.free_symbols])
                return None
            if e not in kept:
                kept.append(e)
        return replace(branch, equations=tuple(kept))

    # ---- one move ----

    def _next(self, branch: Branch) -> Iterator[Branch]:
        unknowns = self._open(branch)
        n = self.names[len(branch.integers)]
        plans = []
        for e in branch.equations:
            factors = [f for f in factored(e).factors if f.free_symbols & unknowns]
            rules = [rule_for(f, unknowns, n) for f in factors]
            cost = max((rule.cost if rule else 99) for rule in rules) + (len(factors) > 1) * 2.5
            plans.append((cost, len(factors), sp.count_ops(e), e, factors, rules))
        best = min(plans, key=lambda plan: plan[:3])
        polynomial = None if branch.eliminated or best[0] < DIVISION else self._triangular(branch, unknowns)
        if polynomial is not None:
            yield polynomial
        elif best[1] > 1 and self._worth_splitting(best):
            yield from self._product(branch, best[3], best[4])
        elif best[5][0] is not None and len(best[5]) == 1 and best[0] < (CURVE if self._square(branch) else 99):
            yield from self._applied(branch, best[3], best[4][0], best[5][0])
        elif split := next((plan for plan in plans if plan[1] > 1), None):
            yield from self._product(branch, split[3], split[4])
        else:
            yield from self._search(branch, unknowns)

    @staticmethod
    def _worth_splitting(plan: Any) -> bool:
        return all(rule is not None for rule in plan[5]) and plan[0] < CIRCLE + 2.5

    def _square(self, branch: Branch) -> bool:
        return len(branch.equations) >= len(self._open(branch))

    def _product(self, branch: Branch, e: Any, factors: list[Any]) -> Iterator[Branch]:
        parts = factored(e)
        written = [parts.constant, *(f**k for f, k in zip(parts.factors, parts.powers, strict=True)), 1 / parts.divisor]
        self._note(branch, "product", equation=e, factors=factors, written=[w for w in written if w != 1])
        rest = tuple(each for each in branch.equations if each != e)
        for i, f in enumerate(factors, 1):
            yield replace(branch, equations=(f, *rest), case=(*branch.case, i))

    def _applied(self, branch: Branch, e: Any, factor: Any, rule: Rule) -> Iterator[Branch]:
        rest = tuple(each for each in branch.equations if each != e)
        several = len(rule.outcomes) > 1
        cases = [(*branch.case, i) if several else branch.case for i in range(1, len(rule.outcomes) + 1)]
        inside = replace(branch, equations=rest)
        after = [with_outcome(replace(inside, case=case), o) for case, o in zip(cases, rule.outcomes, strict=True)]
        known = (*rest, *rule.outcomes[0].equations) if rule.outcomes else ()
        first = after[0] if len(after) == 1 else None
        changed = [each for each in first.equations if each not in known] if first else []
        self._note(branch, rule.kind, equation=e, factor=factor, outcomes=rule.outcomes, changed=changed,
                   **rule.values)  # fmt: skip
        for each, outcome, case in zip(after, rule.outcomes, cases, strict=True):
            if each is None:
                self._note(replace(branch, case=case), "sign", put=outcome.put)
            else:
                yield each

    # ---- polynomials ----

    def _triangular(self, branch: Branch, unknowns: set[Any]) -> Branch | None:
        """A Gröbner basis in place of several polynomials; None where they are none, or too large."""
        whole = [p for e in branch.equations for p in [sp.Mul(*(f for f in factored(e).factors))]]
        polynomials = [p for p in whole if p.is_polynomial(*unknowns)]
        if len(polynomials) < 2:
            return None
        inside = [x for x in self.unknowns if x in unknowns and any(p.has(x) for p in polynomials)]
        basis = triangulated(polynomials, inside)
        if basis is None or set(basis) == set(polynomials):
            return None
        others = tuple(e for e, p in zip(branch.equations, whole, strict=True) if p not in polynomials)
        self._note(branch, "triangular", equations=polynomials, basis=basis, order=inside)
        return replace(branch, equations=(*basis, *others), eliminated=True)

    # ---- search ----

    def _search(self, branch: Branch, unknowns: set[Any]) -> Iterator[Branch]:
        asked = {s for e in branch.equations for s in e.free_symbols}
        inside = [x for x in self.unknowns if x in asked & unknowns]
        if parameters := sorted(asked - unknowns, key=str):
            raise NotExact("solutions/needs_numbers", symbols=parameters, equations=list(branch.equations))
        if len(branch.equations) < len(inside):
            raise NotExact("solutions/curve", equations=list(branch.equations), unknowns=inside)
        if len(inside) > MAX_SEARCHED:
            raise NotExact("solutions/too_many_unknowns", unknowns=inside)
        box = {x: self.box.get(x, DEFAULT_BOX) for x in inside}
        self.searched.append({**box, **{x: ends for x, ends in self.box.items() if x in branch.found}})
        limits = [tuple(evaluator(end, [])(mpmath.mp, []) for end in box[x]) for x in inside]
        functions = [cleared(e) for e in branch.equations]
        certain = True
        if len(inside) == 1:
            roots, certain = roots_between(functions[0], inside[0], *limits[0])
            found = [[root] for root in roots]
        else:
            found = newton_roots(functions[: len(inside)], inside, limits)
        certain = certain and len(inside) == 1
        self.certain = self.certain and certain
        values = [dict(zip(inside, root, strict=True)) for root in found]
        self._note(branch, "search", equations=list(branch.equations), unknowns=inside, box=box, found=values,
                   certain=certain, default=[x for x in inside if x not in self.box])  # fmt: skip
        for i, put in enumerate(values, 1):
            case = (*branch.case, i) if len(values) > 1 else branch.case
            own = replace(branch, equations=branch.equations[len(inside) :], case=case)
            after = with_outcome(own, Outcome(put))
            if after is not None and allowed(branch, put):
                yield after

    # ---- the end of a case ----

    def _end(self, branch: Branch) -> None:
        put = dict(branch.found)
        kept = []
        for need in branch.needs:
            now = need.xreplace(put)
            if now == sp.false:
                return
            if now != sp.true:
                kept.append(now)
        for e in branch.nonzero:
            kept += self._apart(e.xreplace(put), branch.integers)
        point = {x: settled(put.get(x, x)) for x in self.unknowns}
        self._note(branch, "point", point=point, needs=kept, free=[x for x in self.unknowns if point[x] == x])
        self.ends.append((point, tuple(kept)))

    def _apart(self, e: Any, integers: Sequence[Any]) -> list[Any]:
        """What must hold so that an expression does not vanish, where it may."""
        open_ = {*self.unknowns, *integers}
        if not e.free_symbols & open_ or not factored(e).factors:
            return []
        if e.free_symbols <= set(integers) and len(integers) == 1:
            (n,) = integers
            return [sp.Ne(n, i, evaluate=False) for i in NEAR_INTEGERS if vanishes(e.xreplace({n: sp.Integer(i)}))]
        return [sp.Ne(f, 0) for f in factored(e).factors if f.free_symbols & open_ and not f.is_nonzero]
