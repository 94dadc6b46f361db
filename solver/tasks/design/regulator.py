"""The problem that a regulator and a Kalman filter share: a plant and weights, written for one or for the other."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from solver.derivation import Refusal
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated import Stated
from solver.stated.algebra import product, total
from solver.stated.matrices import inverse
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

REGULATING = ("equations", "choice", "stable_half", "solve", "decimal_solution")
"""Steps that earn the marks of an optimal gain, by any method of solving the Riccati equation."""


@dataclass(frozen=True)
class Regulator:
    """AᵀP + PA − P B R⁻¹ Bᵀ P + Q = 0 with A n×n, B n×m, Q n×n, R m×m; for a filter A and B stand for Aᵀ and Cᵀ.

    In discrete time it is P = Q + AᵀPA − AᵀPB (R + BᵀPB)⁻¹ BᵀPA.
    Symbols that are weights by themselves are positive here: `plain` leads back to the symbols of the problem. `N`
    (n×m) weighs products in the cost, xᵀQx + 2xᵀNu + uᵀRu; `completed` says that A and Q stand for those without.
    """

    A: ImmutableMatrix
    B: ImmutableMatrix
    Q: ImmutableMatrix
    R: ImmutableMatrix
    dual: bool
    plain: Mapping[Symbol, Symbol]
    N: ImmutableMatrix | None = None
    completed: bool = False
    discrete: bool = False

    @staticmethod
    def of(A: Any, B: Any, Q: Any, R: Any, *, N: Any = None, dual: bool = False, discrete: bool = False) -> Regulator:
        """Return the problem, with weights taken as positive."""
        positive = {s: sp.Symbol(s.name, positive=True) for s in own_weights(Q, R) if not s.is_positive}
        A, B, Q, R = (sp.ImmutableMatrix(M.xreplace(positive)) for M in (A, B, Q, R))
        N = N if N is None else sp.ImmutableMatrix(N.xreplace(positive))
        plain = {new: old for old, new in positive.items()}
        return Regulator(A, B, Q, R, dual, plain, N, discrete=discrete)

    def without_products(self) -> Regulator:
        """Return the problem of v = u + R⁻¹Nᵀx: A − B R⁻¹ Nᵀ and Q − N R⁻¹ Nᵀ, with the same P."""
        if self.N is None:
            return self
        A, Q = exact.completed_square(self.A, self.B, self.Q, self.R, self.N)
        return replace(self, A=A, Q=Q, N=None, completed=True)

    def restored(self, value: Any) -> Any:
        """Return a result in the symbols of the problem."""
        if isinstance(value, list):
            return [self.restored(each) for each in value]
        return value.xreplace(self.plain) if self.plain and hasattr(value, "xreplace") else value

    @property
    def Bt(self) -> ImmutableMatrix:
        """Bᵀ."""
        return sp.ImmutableMatrix(self.B.T)

    def linear_part(self, P: Any) -> Stated:
        """AᵀP + PA + Q as stated; discrete: Q + AᵀPA."""
        At = sp.ImmutableMatrix(self.A.T)
        if self.discrete:
            return total(self.Q, product(At, P, self.A))
        return total(product(At, P), product(P, self.A), self.Q)

    def quadratic_part(self, P: Any) -> Stated:
        """P B R⁻¹ Bᵀ P as stated; discrete: AᵀPB (R + BᵀPB)⁻¹ BᵀPA."""
        if self.discrete:
            return product(sp.ImmutableMatrix(self.A.T), P, self.B, self.gain_of(P))
        return product(P, self.B, inverse(self.R), self.Bt, P)

    def weight_of(self, P: Any) -> Any:
        """What is inverted in the gain: R, or in discrete time R + BᵀPB as stated."""
        return total(self.R, product(self.Bt, P, self.B)) if self.discrete else self.R

    def gain_of(self, P: Any) -> Stated:
        """R⁻¹ (BᵀP + Nᵀ) as stated; discrete: (R + BᵀPB)⁻¹ (BᵀPA + Nᵀ)."""
        factors = (self.Bt, P, self.A) if self.discrete else (self.Bt, P)
        if self.N is None:
            return product(inverse(self.weight_of(P)), *factors)
        return product(inverse(self.weight_of(P)), total(product(*factors), sp.ImmutableMatrix(self.N.T)))

    @property
    def names(self) -> dict[str, Any]:
        """The letters of the plant as LaTeX: what stands for A, its transpose, B, its transpose, and for Q."""
        kind = {"dual": self.dual, "discrete": self.discrete}
        if self.dual:
            return {"A": "A^{T}", "At": "A", "B": "C^{T}", "Bt": "C", "Q_name": "Q", **kind}
        A, Q = (rf"\bar{{{name}}}" if self.completed else name for name in "AQ")
        return {"A": A, "At": f"{A}^{{T}}", "B": "B", "Bt": "B^{T}", "Q_name": Q, **kind}


def unknown_matrix(n: int) -> ImmutableMatrix:
    """The symmetric matrix of p11, p12, … (with an underscore between the indices from n = 10 on)."""
    between = "" if n < 10 else "_"
    return sp.ImmutableMatrix(n, n, lambda i, j: sp.Symbol(f"p{min(i, j) + 1}{between}{max(i, j) + 1}"))


def own_weights(*matrices: Any) -> set[Symbol]:
    """Return the symbols whose sign the weights fix: the only unknown factor of an entry on the diagonal."""
    found: set[Symbol] = set()
    for M in matrices:
        for i in range(min(M.shape)):
            found |= _sign_carriers(M[i, i])
    return found


def _sign_carriers(entry: Expr) -> set[Symbol]:
    """The one symbol of undecided sign in a product whose other factors are positive."""
    unknown = []
    for base, exponent in entry.as_powers_dict().items():
        if base.is_positive:
            continue
        if not base.is_Symbol or base.is_positive is False or not exponent.is_Integer:
            return set()
        if exponent % 2:
            unknown.append(base)
    return set(unknown) if len(unknown) == 1 else set()


def given_or_identity(weight: ImmutableMatrix | None, size: int) -> ImmutableMatrix:
    """Return a weight, or the identity matrix where none is given."""
    return weight if weight is not None else sp.ImmutableMatrix(sp.eye(size))


def faulty_weights(
    Q: ImmutableMatrix | None, R: ImmutableMatrix | None, own: str = "Q", *, discrete: bool = False
) -> Iterable[Refusal]:
    """Yield what is wrong with the weights Q (by the name `own`) and R as the file gives them.

    In discrete time R may be singular: R + BᵀPB has to be positive definite.
    """
    if Q is not None and Q.rows == Q.cols:
        if Q != Q.T:
            yield own, Reason("regulators/not_symmetric", {"name": own})
        elif not is_semidefinite(Q):
            yield own, Reason("regulators/not_semidefinite", {"name": own, "word": definiteness_word(Q)})
    if R is not None and R.rows == R.cols:
        if R != R.T:
            yield "R", Reason("regulators/not_symmetric", {"name": "R"})
        elif discrete and not is_semidefinite(R):
            yield "R", Reason("regulators/not_semidefinite", {"name": "R", "word": definiteness_word(R)})
        elif not discrete and definiteness_word(R) not in {None, "positive definite"}:
            yield "R", Reason("regulators/not_definite", {"name": "R", "word": definiteness_word(R)})


def is_semidefinite(Q: ImmutableMatrix) -> bool:
    """Whether a symmetric matrix may be positive semidefinite: as its parameters are, or but for its rounding."""
    word = definiteness_word(Q)
    return word in {None, "positive definite", "positive semidefinite"} or exact.negative_by_rounding(Q) is not None


def definiteness_word(M: Any) -> str | None:
    """Return of what definiteness a symmetric matrix is; None where parameters decide."""
    try:
        word: str | None = exact.definiteness(sp.ImmutableMatrix(M))
    except exact.NotExact:
        return None
    return word
