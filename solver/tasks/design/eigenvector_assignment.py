"""Assignment of eigenvectors as a lemma: with several inputs a gain can give the closed loop more than its poles.

For each pole λ the attainable eigenvectors v and w = K v solve (λI − A) v + B w = 0 (Moore 1976); the nearest to those
asked for are taken, and K = W V⁻¹.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product
from solver.stated.complex_numbers import conjugate
from solver.stated.matrices import determinant, inverse
from solver.tasks.design.frames import Frame, Placement, movable_poles, same_number
from solver.tasks.design.nearest_eigenvector import degrees_off, nearest_eigenvector_of
from solver.tasks.design.placement import closed_loop_of, desired_polynomial_of
from solver.tasks.structure.hidden_part import hidden_modes_of
from solver.tasks.structure.pairs import Pair

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

    from solver.tasks.needed import WithInput


@dataclass(frozen=True)
class Question:
    """The plant, the n poles, and the wanted eigenvectors as columns in their order (n×n)."""

    plant: WithInput
    poles: Sequence[Expr]
    wanted: ImmutableMatrix

    def like(self, i: int) -> list[int]:
        """The numbers, counted from 1, of the poles equal to pole i."""
        return [j for j, other in enumerate(self.poles, 1) if same_number(other, self.poles[i - 1])]


@dataclass(frozen=True)
class Assigned:
    """An eigenvector v (n×1) that the closed loop gets for a pole, and w = K v (m×1).

    `conjugate_of` is the number of the pole whose vector is conjugate, 0 for a real pole and the first of a pair.
    `degrees` is the angle to the vector asked for: 0 where it is that one, None where parameters decide.
    """

    v: ImmutableMatrix
    w: ImmutableMatrix
    conjugate_of: int = 0
    degrees: Expr | None = None


@lemma("eigenvector_assignment")
def assign_eigenvectors(question: Question, x: Symbol) -> Derivation[tuple[Placement, ImmutableMatrix]]:
    """Find K (m×n) so that A − BK has the poles, and the attainable eigenvectors nearest to those wanted.

    Returns the placement and the eigenvectors as columns (n×n). Raises Unsolved if an uncontrollable mode is not among
    the poles, or if the vectors are dependent; NotExact for decimal poles.
    """
    plant, poles = question.plant, question.poles
    A, B = plant.A, plant.B
    desired = yield from desired_polynomial_of(poles, x)
    fixed = yield from _fixed_modes(plant, poles)
    yield Step("law", unclaimed="a definition", n=plant.order, m=B.cols)
    found: list[Assigned] = []
    while len(found) < plant.order:
        found.append((yield from _assigned(question, found)))
    K = yield from _gain(found)
    polynomial = exact.polynomial_in(x, desired)
    yield from closed_loop_of(Frame(several=True), A, B, K, polynomial, x)
    loop = sp.ImmutableMatrix((A - B * K).applyfunc(exact.tidy))
    V = _joined([each.v for each in found])
    yield from _test(loop, V, poles, found)
    return Placement(K, loop, polynomial, None, fixed), V


@lemma("eigenvector_assignment")
def _fixed_modes(plant: WithInput, poles: Sequence[Expr]) -> Derivation[list[Expr]]:
    """The modes that no input moves; they must be among the poles."""
    if exact.reachable_order(plant.A, plant.B) == plant.order:
        return []
    matrix = exact.controllability_matrix(plant.A, plant.B)
    fixed = yield from hidden_modes_of(Pair(plant.A, plant.B, dual=False, discrete=plant.discrete), matrix)
    if fixed is None:
        raise Unsolved("placement/unknown_fixed_modes")
    movable_poles(poles, fixed, plant.order, all_needed=True)
    return fixed


@lemma("eigenvector_assignment")
def _assigned(question: Question, found: Sequence[Assigned]) -> Derivation[Assigned]:
    """The eigenvector for the next pole: conjugate to an earlier one, or the attainable one nearest to the wanted."""
    i = len(found) + 1
    pole, wanted = question.poles[i - 1], sp.ImmutableMatrix(question.wanted[:, i - 1])
    j = _partner(question.poles, found)
    if j:
        first = found[j - 1]
        v, w = exact.conjugated(first.v), exact.conjugated(first.w)
        claims = {
            "v": Claim(conjugate(first.v), v, "conjugate eigenvector"),
            "w": Claim(conjugate(first.w), w, r"$K \nu$ of the conjugate eigenvector"),
        }
        yield Step("conjugate", claims=claims, i=i, j=j, pole=pole)
        return Assigned(v, w, j, first.degrees)
    plant = question.plant
    nearest = yield from nearest_eigenvector_of(plant.A, plant.B, pole, wanted, i=i, alike=question.like(i))
    return Assigned(nearest.v, nearest.w, 0, degrees_off(nearest))


def _partner(poles: Sequence[Expr], found: Sequence[Assigned]) -> int:
    """The number of the earlier pole that the next is conjugate to, if it has no partner yet; 0 for none."""
    pole = poles[len(found)]
    mirror = exact.conjugated(pole)
    taken = {each.conjugate_of for each in found}
    left = [j for j, each in enumerate(found, 1) if not each.conjugate_of and j not in taken]
    return 0 if mirror == pole else next((j for j in left if same_number(poles[j - 1], mirror)), 0)


@lemma("eigenvector_assignment")
def _gain(found: Sequence[Assigned]) -> Derivation[ImmutableMatrix]:
    """K = W V⁻¹; real and imaginary parts stand in place of a pair of columns, so that everything is real."""
    firsts = {each.conjugate_of for each in found}
    names: list[tuple[str, int]] = []
    columns: list[tuple[ImmutableMatrix, ImmutableMatrix]] = []
    for i, each in enumerate(found, 1):
        if i in firsts:
            names += [("Re", i), ("Im", i)]
            columns += zip(exact.parts_of_columns(each.v), exact.parts_of_columns(each.w), strict=True)
        elif not each.conjugate_of:
            names.append(("", i))
            columns.append((each.v, each.w))
    V, W = (_joined([pair[side] for pair in columns]) for side in (0, 1))
    det = exact.determinant(V)
    claims = {"determinant": Claim(determinant(V), det, "determinant of the eigenvectors")}
    yield Step("modal", claims=claims, V=V, W=W, names=names, complex=len(firsts) > 1)
    if det == 0:
        raise Unsolved("placement/dependent_eigenvectors")
    inverted = exact.inverse(V)
    K = sp.ImmutableMatrix((W * inverted).applyfunc(exact.tidy))
    yield Step(
        "gain",
        claims={
            "inverse": Claim(inverse(V), inverted, "inverse"),
            "gain": Claim(product(W, inverse(V)), K, "gain from eigenvectors"),
        },
        complex=len(firsts) > 1,
    )
    return K


@lemma("eigenvector_assignment")
def _test(
    loop: ImmutableMatrix, V: ImmutableMatrix, poles: Sequence[Expr], found: Sequence[Assigned]
) -> Derivation[None]:
    """(A − BK) V = V Λ, and which vectors are others than asked for."""
    Lambda = sp.ImmutableMatrix(sp.diag(*poles))
    image = sp.ImmutableMatrix((loop * V).applyfunc(exact.tidy))
    yield Step(
        "test",
        claims={
            "loop": Claim(product(loop, V), image, "closed loop times its eigenvectors"),
            "poles": Claim(product(V, Lambda), image, "eigenvectors times poles"),
        },
        V=V,
        Lambda=Lambda,
        names=[("", i) for i, _ in enumerate(found, 1)],
        complex=V.has(sp.I),
        missed=[(i, each.degrees) for i, each in enumerate(found, 1) if each.degrees != 0],
    )


def _joined(columns: Sequence[ImmutableMatrix]) -> ImmutableMatrix:
    return sp.ImmutableMatrix(sp.Matrix.hstack(*(sp.Matrix(each) for each in columns)))
