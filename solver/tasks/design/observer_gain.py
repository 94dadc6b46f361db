"""The gain L that gives A − LC the eigenvalues asked for, for a pair (A, C) of blocks that go by other names."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from solver.arithmetic.equations import eliminated
from solver.arithmetic.factors import factors_multiplied
from solver.arithmetic.products import multiplied
from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, power, product, total
from solver.stated.matrices import determinant
from solver.tasks.design.comparison import compared
from solver.tasks.design.frames import expansion_of, unknown_gains
from solver.words import Phrase, Reason

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol


@dataclass(frozen=True)
class Pair:
    """The matrices of an error equation e' = (A − LC) e and how they are called on the page."""

    A: ImmutableMatrix
    C: ImmutableMatrix
    A_name: str
    C_name: str
    discrete: bool

    @property
    def n(self) -> int:
        """The order of the error equation."""
        return int(self.A.rows)

    @property
    def variable(self) -> Symbol:
        """The variable of polynomials: s, or z in discrete time."""
        return sp.Symbol("z" if self.discrete else "s")

    def observability_matrix(self) -> ImmutableMatrix:
        """C, CA, …, CAⁿ⁻¹ under each other."""
        return sp.ImmutableMatrix(exact.controllability_matrix(self.A.T, self.C.T).T)


@dataclass(frozen=True)
class Gain:
    """The gain L (n×p), the polynomial det(xI − A + LC), and its roots that no gain moves.

    `chosen`: the error matrix was chosen, and L found from it.
    """

    L: ImmutableMatrix
    polynomial: Expr
    fixed: tuple[Expr, ...]
    chosen: bool = False


@lemma("observer_gain")
def gain_of(pair: Pair, poles: Sequence[Expr]) -> Derivation[Gain]:
    """Observability of the pair, the desired polynomial, and L by comparing coefficients or by a choice of A − LC.

    `poles` are all n, or only those of the observable part; what is not observable keeps its eigenvalues.
    """
    hidden = yield from _what_is_seen(pair)
    desired = yield from _desired(pair, poles, hidden)
    chosen = pair.C.rows > 1 and not hidden and len(exact.independent_columns(pair.C)) == pair.n
    if chosen:
        L = yield from _by_choice(pair, poles)
    elif pair.C.rows == 1:
        L = yield from _by_coefficients(pair, pair.C, pair.A, desired, hidden)
    else:
        L = yield from _by_one_combination(pair, desired, hidden)
    if not chosen:
        yield _tested(pair, L, desired)
    return Gain(L, desired, tuple(hidden), chosen)


def _tested(pair: Pair, L: ImmutableMatrix, desired: Expr) -> Step:
    """The error matrix with the gain found, and its polynomial."""
    seen = exact.multiply(L, pair.C)
    error = sp.ImmutableMatrix(pair.A - seen)
    return Step(
        "gain",
        claims={
            "error": Claim(difference(pair.A, product(L, pair.C)), error, "matrix of the error equation"),
            "polynomial": Claim(determinant(_pencil(error, pair.variable)), desired, "its characteristic polynomial"),
        },
        pair=pair,
        L=L,
        steps=multiplied(L, pair.C, seen) if pair.n > 1 else (),
    )


def _pencil(M: ImmutableMatrix, x: Symbol) -> ImmutableMatrix:
    return sp.ImmutableMatrix(x * sp.eye(M.rows) - M)


def _what_is_seen(pair: Pair) -> Derivation[list[Expr]]:
    """The observability matrix of the pair; returns the eigenvalues that no gain moves."""
    A, C, n = pair.A, pair.C, pair.n
    O, p = pair.observability_matrix(), pair.C.rows
    claims = {
        f"row{k}": Claim(
            product(C, power(A, k)), O[k * p : (k + 1) * p, :], Phrase("block row {k} of the matrix", k=k + 1)
        )
        for k in range(1, n)
    }
    det, exceptions = None, []
    if p == 1:
        det = exact.determinant(O)
        claims["determinant"] = Claim(determinant(O), det, "determinant of the observability matrix")
        exceptions = exact.vanishing_factors(det)
    parts = exact.observable_decomposition(A, None, C)
    yield Step(
        "pair",
        claims=claims,
        unclaimed="" if claims else "the matrix is C itself",
        pair=pair,
        matrix=O,
        det=det,
        rank=parts.orders[0],
        exceptions=exceptions,
    )
    if parts.trivial:
        return []
    N, block, modes = parts.bases[1], parts.block(1, 1), parts.hidden_modes
    yield Step(
        "hidden",
        claims={
            "unseen": Claim(product(C, N), sp.ImmutableMatrix(sp.zeros(p, N.cols)), "these directions leave no trace"),
            "invariant": Claim(product(A, N), product(N, block), "and are never left"),
        },
        pair=pair,
        N=N,
        block=block,
        modes=modes,
        undecided=any(decays(mode, discrete=pair.discrete) is None for mode in modes),
    )
    require_decay(modes, (pair.A_name, pair.C_name), discrete=pair.discrete)
    return list(modes)


def require_decay(modes: Sequence[Expr], pair: tuple[str, ...], *, discrete: bool) -> None:
    """Raise Unsolved where an unobservable mode does not decay; `pair` names its matrices, () is the plant's own."""
    growing = next((mode for mode in modes if decays(mode, discrete=discrete) is False), None)
    if growing is not None:
        raise Unsolved("observers/error_grows", pair=pair, mode=growing, discrete=discrete)


def number_fault(poles: Sequence[Expr], own: int, seen: int, outputs: int = 0) -> Reason | None:
    """What is wrong with the number of poles; right are `own`, the order of the observer, and the `seen` among them.

    The order is n, less the number of `outputs` where these are measured states.
    """
    if len(poles) in (own, seen):
        return None
    numbers = {"given": len(poles), "order": own, "seen": seen, "outputs": outputs}
    return Reason("observers/number_of_poles", numbers)


def decays(mode: Expr, *, discrete: bool) -> bool | None:
    """Whether e^{λt} (λᵏ) goes to zero; None where parameters leave it open."""
    real, imaginary = exact.complex_parts(mode)
    size = sp.expand(real**2 + imaginary**2 - 1) if discrete else sp.expand(real)
    if size.free_symbols:
        sign = exact.sign_of(size)
        return None if sign is None else sign < 0
    return bool(size != 0 and sp.N(size, 30) < 0)


def _desired(pair: Pair, poles: Sequence[Expr], hidden: Sequence[Expr]) -> Derivation[Expr]:
    """Π (x − pᵢ), with the eigenvalues that stay where they are."""
    x = pair.variable
    added = list(hidden) if len(poles) < pair.n else []
    roots = [*poles, *added]
    polynomial: Expr = exact.polynomial_in(x, exact.monic(roots))
    factors = (power(x - root, roots.count(root)) for root in dict.fromkeys(roots))
    claim = Claim(product(*factors), polynomial, "desired characteristic polynomial")
    lines = factors_multiplied(x, roots)
    yield Step("desired", claims={"polynomial": claim}, pair=pair, poles=list(poles), added=added, steps=lines)
    return polynomial


def _by_coefficients(
    pair: Pair, c: ImmutableMatrix, A: ImmutableMatrix, desired: Expr, hidden: Sequence[Expr], combined: str = ""
) -> Derivation[ImmutableMatrix]:
    """det(xI − A + lc) with unknown l has the coefficients asked for; returns l (n×1).

    `combined` is the name of A where c is not the C of the pair but a combination of its rows.
    """
    n, x = pair.n, pair.variable
    unknowns = unknown_gains((A, c), (desired,), dual=True)
    l = sp.ImmutableMatrix(unknowns)
    unknown = exact.loop_coefficients(A.T, c.T, sp.ImmutableMatrix([unknowns]), unknowns)[1:]
    error = sp.ImmutableMatrix(A - l * c)
    powers = [(entry, x ** (n - 1 - k)) for k, entry in enumerate(unknown)]
    shown = total(x**n, *(product(entry, power_) for entry, power_ in powers if entry != 0))
    claims, lines = expansion_of(error, x, sp.Add(x**n, *(entry * power_ for entry, power_ in powers)))
    yield Step(
        "unknown",
        claims={
            **claims,
            "error": Claim(difference(A, product(l, c)), error, "error matrix with unknown gain"),
            "polynomial": Claim(determinant(_pencil(error, x)), shown, "its characteristic polynomial"),
        },
        pair=pair,
        combined=combined,
        unknowns=unknowns,
        steps=lines,
    )
    found = compared(unknown, sp.Poly(desired, x).all_coeffs()[1:], unknowns)
    if found.solution.residue:
        raise Unsolved("observers/not_shown", modes=hidden, matrix=pair.A_name)
    values = [exact.tidy(value.subs(dict.fromkeys(unknowns, 0))) for value in found.solution.values]
    yield Step(
        "compare",
        claims={"equations": found.claim(values)},
        equations=found.equations,
        solution=list(zip(unknowns, values, strict=True)),
        free=found.free,
        pair=pair,
        steps=eliminated(found.equations, unknowns, values, found.solution.free),
    )
    return sp.ImmutableMatrix(values)


def _by_choice(pair: Pair, poles: Sequence[Expr]) -> Derivation[ImmutableMatrix]:
    """With independent columns in C any A − LC can be had: L = (A − J) C⁺."""
    J, left = exact.chosen_error_matrix(poles), exact.left_inverse(pair.C)
    L: ImmutableMatrix = exact.multiply(sp.ImmutableMatrix(pair.A - J), left)
    identity = sp.ImmutableMatrix(sp.eye(pair.n))
    plain = identity == pair.C
    stated = difference(pair.A, J) if plain else product(difference(pair.A, J), left)
    yield Step(
        "choice",
        claims={
            "left": Claim(product(left, pair.C), identity, "a left inverse of the output matrix"),
            "gain": Claim(stated, L, "gain for the chosen error matrix"),
        },
        plain=plain,
        pair=pair,
        J=J,
        left=left,
        square=pair.C.rows == pair.n,
    )
    return L


def _by_one_combination(pair: Pair, desired: Expr, hidden: Sequence[Expr]) -> Derivation[ImmutableMatrix]:
    """L = L₀ + l q: one combination q y of the outputs sees as much as all of them, for A − L₀ C."""
    found = exact.direction(pair.A.T, pair.C.T)
    if found is None:
        raise Unsolved("observers/no_single_output")
    q = sp.ImmutableMatrix(found.g.T)
    L0 = None if found.preliminary is None else sp.ImmutableMatrix(found.preliminary.T)
    A0 = pair.A if L0 is None else sp.ImmutableMatrix(pair.A - L0 * pair.C)
    c = exact.multiply(q, pair.C)
    claims = {"row": Claim(product(q, pair.C), c, "the combined output")}
    if L0 is not None:
        claims["shifted"] = Claim(difference(pair.A, product(L0, pair.C)), A0, "error matrix after the first gain")
    yield Step("combination", claims=claims, pair=pair, q=q, L0=L0, A0=A0)
    l = yield from _by_coefficients(pair, c, A0, desired, hidden, pair.A_name if L0 is None else "A_0")
    L = sp.ImmutableMatrix(l * q if L0 is None else L0 + l * q)
    stated = product(l, q) if L0 is None else total(L0, product(l, q))
    yield Step("combined_gain", claims={"gain": Claim(stated, L, "gain of all outputs")}, pair=pair, first=L0)
    return L
