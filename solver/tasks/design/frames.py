"""How a placement is written down: for a state feedback, or transposed for an observer."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from solver.arithmetic.determinants import expanded, first_line
from solver.derivation import Claim, Step, Unsolved
from solver.lazy import sympy as sp
from solver.stated import Stated
from solver.stated.algebra import difference, product
from solver.stated.matrices import determinant
from solver.tasks.linear_algebra.characteristic_polynomial import coefficients_of_companion
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol


@dataclass(frozen=True)
class Frame:
    """How formulas for (A, b, k) are written: as they are, or transposed (`dual`) for an observer of (A, C).

    `several`: one input stands for several. `shifted`: A is the loop with a preliminary gain. `partial`: A is a part.
    `augmented`: A and B are those of the plant with integrators. `current`: C A stands in the place of C.
    """

    dual: bool = False
    several: bool = False
    shifted: bool = False
    partial: bool = False
    augmented: bool = False
    current: bool = False

    def shown(self, M: ImmutableMatrix) -> ImmutableMatrix:
        """Return M as it is written: transposed in the dual."""
        return sp.ImmutableMatrix(M.T) if self.dual else sp.ImmutableMatrix(M)

    def times(self, *factors: Any) -> Stated:
        """State the product of factors that are `shown` already; the dual turns their order round."""
        return product(*self.ordered(*factors))

    def ordered(self, *factors: Any) -> tuple[Any, ...]:
        """Return factors in the order in which they are written."""
        return factors[::-1] if self.dual else factors

    def part(self) -> Frame:
        """Return the frame for the controllable (observable) part."""
        return replace(self, partial=True)

    def reduced(self, *, shifted: bool) -> Frame:
        """Return the frame for one input in place of several."""
        return replace(self, shifted=shifted)


@dataclass(frozen=True)
class Wanted:
    """What is asked of a gain beside poles: the `row` K (one input) with its `unknowns`, for coefficient matching.

    `coefficients` of the desired polynomial may stand in place of the poles (of a controllable pair).
    """

    row: ImmutableMatrix | None = None
    unknowns: Sequence[Symbol] = ()
    coefficients: Sequence[Expr] = ()


@dataclass(frozen=True)
class Pair:
    """A pair (A, b), and what det(xI − A + bk) is to be: coefficients, highest power first, and the poles asked for."""

    frame: Frame
    A: ImmutableMatrix
    b: ImmutableMatrix
    x: Symbol
    desired: Sequence[Expr]
    poles: Sequence[Expr] = ()

    @property
    def flags(self) -> dict[str, Any]:
        """What the wording of a step needs to name the matrices."""
        frame = self.frame
        names = {"dual": frame.dual, "several": frame.several, "shifted": frame.shifted, "part": frame.partial}
        return {**names, "augmented": frame.augmented, "current": frame.current, "x": self.x}

    @property
    def unknowns(self) -> tuple[Symbol, ...]:
        """k1 … kn (l1 … ln in the dual); other letters where the plant or the poles use these."""
        return unknown_gains((self.A, self.b), self.poles, dual=self.frame.dual)


def unknown_gains(plant: Sequence[Any], poles: Sequence[Any], *, dual: bool = False) -> tuple[Symbol, ...]:
    """Return k1 … kn (l1 … ln in the dual); other letters where the plant or the poles use these."""
    return free_symbols((*plant, *poles), plant[0].rows, ("l", "h", "g") if dual else ("k", "kappa", "h"))


def free_symbols(used: Sequence[Any], count: int, letters: Sequence[str]) -> tuple[Symbol, ...]:
    """Return symbols of a letter with numbers from 1: the first of the letters of which none is used already."""
    taken = {str(symbol) for each in used for symbol in each.free_symbols}
    for letter in letters:
        names = [f"{letter}{i}" for i in range(1, count + 1)]
        if not taken & set(names):
            break
    return tuple(sp.Symbol(name) for name in names)


@dataclass(frozen=True)
class Placement:
    """What a placement gives: `K` (m×n; the observer gain n×p in the dual), the loop A − BK (A − LC), polynomials.

    `gain_polynomial` is det(sI − A + BK) in the unknown entries, where coefficient matching of one input formed it.
    `free` are symbols in K that may take any value; `fixed` the eigenvalues that no gain moves; `conditions` are
    equations for the unknowns.
    """

    K: ImmutableMatrix
    loop: ImmutableMatrix
    polynomial: Expr
    gain_polynomial: Expr | None = None
    fixed: list[Expr] = field(default_factory=list)
    free: tuple[Symbol, ...] = ()
    conditions: tuple[Any, ...] = ()


def characteristic(A: Any, x: Symbol, n: int = 0) -> Stated:
    """det(xI − A) as stated; n is the size of an A that is stated itself."""
    return determinant(difference(product(x, sp.ImmutableMatrix(sp.eye(n or A.rows))), A))


def expansion_of(A: ImmutableMatrix, x: Symbol, polynomial: Expr) -> tuple[dict[str, Claim], tuple[Step, ...]]:
    """The first line of the expansion of det(xI − A), as a claim, and what is between it and the polynomial.

    Neither where A is a companion matrix, of which it is read off.
    """
    if coefficients_of_companion(A):
        return {}, ()
    pencil = sp.ImmutableMatrix(x * sp.eye(A.rows) - A)
    claim = Claim(determinant(pencil), first_line(pencil), Phrase("the determinant expanded"))
    return {"stated": claim}, expanded(pencil, polynomial, x)


def linear_factors(x: Symbol, roots: Sequence[Expr]) -> Stated:
    """Π (x − root) as stated."""
    return product(*(x - root for root in roots))


def movable_poles(
    poles: Sequence[Expr], fixed: Sequence[Expr], n: int, *, dual: bool = False, all_needed: bool = False
) -> list[Expr]:
    """Return the poles to be placed: all given, or of n given those that are left without the fixed modes.

    `all_needed`: fewer than n would not do.
    """
    if len(poles) < n:
        return list(poles)
    left = list(poles)
    for mode in fixed:
        found = next((pole for pole in left if same_number(pole, mode)), None)
        if found is None:
            raise Unsolved("placement/fixed_mode", mode=mode, dual=dual, all_needed=all_needed)
        left.remove(found)
    return left


def same_number(a: Any, b: Any) -> bool:
    """Whether two numbers or expressions are equal; decimals to 12 digits."""
    gap = sp.expand(a - b)
    if gap == 0 or gap.free_symbols:
        return bool(gap == 0)
    return bool(abs(complex(sp.N(gap, 30))) < 1e-12 * (1 + abs(complex(sp.N(a, 30)))))
