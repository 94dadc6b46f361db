"""State feedback of an estimate, step by step: the gain, the closed loop, the separation principle, the compensator."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.arithmetic.exactness import where_exact
from solver.arithmetic.fractions_of_systems import fraction_multiplied_out
from solver.arithmetic.products import multiplied
from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.derivation.figures import Diagram
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated import Stated
from solver.stated.algebra import difference, product, total
from solver.stated.matrices import determinant, inverse, partitioned
from solver.tasks import figures
from solver.tasks.design.frames import characteristic
from solver.tasks.design.placement import place
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

    from solver.derivation.figures import Motion
    from solver.tasks.design.plants import Plant


@dataclass(frozen=True)
class Design:
    """A gain with the characteristic polynomial it gives and its roots (None where they have no usable form)."""

    gain: ImmutableMatrix
    polynomial: Expr
    eigenvalues: list[Expr] | None


@dataclass(frozen=True)
class Compensator:
    """ζ' = F ζ + G y, u = −H ζ − E y: what stands between y and u; `products` are those in F, G and E worked out."""

    F: ImmutableMatrix
    G: ImmutableMatrix
    H: ImmutableMatrix
    E: ImmutableMatrix
    products: tuple[Step, ...] = ()


def given_design(loop: ImmutableMatrix, gain: ImmutableMatrix, x: Symbol) -> Design:
    """The design of a gain that is given: `loop` is the matrix that it makes."""
    polynomial = exact.faddeev_leverrier(loop).characteristic_polynomial(x)
    try:
        return Design(gain, polynomial, exact.spectrum(loop).eigenvalues)
    except exact.NotExact:
        return Design(gain, polynomial, None)


@lemma("output_feedback")
def feedback_of(plant: Plant, poles: Sequence[Expr] | None, K: ImmutableMatrix | None) -> Derivation[Design]:
    """The state feedback K: given, or found for the poles; entries that move nothing are set to zero."""
    x = plant.variable
    if K is None:
        placed = yield from place(plant.A, plant.B, list(poles or ()), "coefficient_matching", x=x)
        K = sp.ImmutableMatrix(placed.K.subs(dict.fromkeys(placed.free, 0)).applyfunc(exact.tidy))
        listed = [*(poles or ()), *(placed.fixed if len(poles or ()) < plant.n else ())]
        return Design(K, placed.polynomial, listed)
    loop = tidied(plant.A - plant.B * K)
    design = given_design(loop, K, x)
    yield Step(
        "given_feedback",
        claims={
            "loop": Claim(difference(plant.A, product(plant.B, K)), loop, "$A - B K$"),
            "polynomial": Claim(characteristic(loop, x), design.polynomial, "polynomial of the state feedback"),
        },
        K=K,
        x=x,
    )
    return design


@lemma("output_feedback")
def given_observer_of(
    A: ImmutableMatrix, C: ImmutableMatrix, L: ImmutableMatrix, x: Symbol, *, reduced: bool
) -> Derivation[Design]:
    """The error of an observer whose gain L is given; A and C are A22 and A12 for one of reduced order."""
    error = tidied(A - L * C)
    design = given_design(error, L, x)
    yield Step(
        "given_observer",
        claims={
            "error": Claim(difference(A, product(L, C)), error, "matrix of the error"),
            "polynomial": Claim(characteristic(error, x), design.polynomial, "polynomial of the error"),
        },
        L=L,
        x=x,
        reduced=reduced,
    )
    return design


def tidied(M: Any) -> ImmutableMatrix:
    """The matrix with its entries in the form shown."""
    return sp.ImmutableMatrix(sp.Matrix(M).applyfunc(exact.tidy))


@lemma("output_feedback")
def full_loop_of(plant: Plant, control: Design, observer: Design) -> Derivation[ImmutableMatrix]:
    """The closed loop in (x, x − x̂)."""
    A, B, C, K, L, n = plant.A, plant.B, plant.C, control.gain, observer.gain, plant.n
    loop, coupling, error = tidied(A - B * K), tidied(B * K), tidied(A - L * C)
    whole = sp.ImmutableMatrix(sp.Matrix([[loop, coupling], [sp.zeros(n), error]]))
    yield Step(
        "full_loop",
        claims={
            "loop": Claim(difference(A, product(B, K)), loop, "$A - B K$"),
            "coupling": Claim(product(B, K), coupling, "$B K$"),
            "error": Claim(difference(A, product(L, C)), error, "$A - L C$"),
        },
        figures=(
            *_diagram(plant, "observer_feedback", "State feedback of the estimate of an observer."),
            *_motion(whole, plant, K),
        ),
        whole=partitioned(whole, (n,), (n,)),
        discrete=plant.discrete,
    )
    return whole


def _motion(whole: ImmutableMatrix, plant: Plant, K: ImmutableMatrix) -> tuple[Motion, ...]:
    """x, the error and u while the estimate begins at zero."""
    n, x0 = plant.n, figures.start_of(None, plant.n)
    caption = Phrase(r"From $x(0) = {x0}$, the estimate from $\hat{{x}}(0) = 0$", x0=figures.column(x0))
    control = figures.inputs(sp.ImmutableMatrix(sp.Matrix.hstack(-K, K)))
    panels = (figures.states(n, 2 * n), figures.errors(n, 2 * n), control)
    start = sp.ImmutableMatrix(sp.Matrix.vstack(x0, x0))
    return figures.motion(caption, whole, start, *panels, discrete=plant.discrete)


def _diagram(plant: Plant, name: str, caption: str) -> tuple[Diagram, ...]:
    """The block diagram; none where the input acts on the output directly, which it does not show."""
    discrete = {"plant": "x(k+1)=Ax(k)+Bu(k)", "integrator": "z^{-1}"} if plant.discrete else {}
    return (Diagram(caption, name, {"L": r"\sym{L}", "K": r"\sym{K}", **discrete}),) if plant.plain else ()


@lemma("output_feedback")
def reduced_loop_of(
    plant: Plant, parts: exact.Partition, control: Design, observer: Design
) -> Derivation[ImmutableMatrix]:
    """The closed loop in (η₁, η₂, η₂ − η̂₂)."""
    K, p, n = control.gain, parts.p, plant.n
    S1, S2 = sp.ImmutableMatrix(parts.T[:, :p]), sp.ImmutableMatrix(parts.T[:, p:])
    A11, A12, A21, A22, B1, B2 = parts.blocks.values()
    yield Step(
        "split",
        claims={
            "KS1": Claim(product(K, S1), tidied(K * S1), "$K S_1$"),
            "KS2": Claim(product(K, S2), tidied(K * S2), "$K S_2$"),
        },
        S1=S1,
        S2=S2,
        plain=plant.plain,
    )
    J = tidied(A22 - observer.gain * A12)
    claims: dict[str, Claim] = {}
    for i, (row, B) in enumerate((((A11, A12), B1), ((A21, A22), B2)), 1):
        for j, (block, S) in enumerate(zip(row, (S1, S2), strict=True), 1):
            stated: Stated = difference(block, product(B, K, S))
            claims[f"A{i}{j}"] = Claim(stated, tidied(block - B * K * S), f"$A_{{{i}{j}}} - B_{i} K S_{j}$")
    for i, B in ((1, B1), (2, B2)):
        claims[f"B{i}"] = Claim(product(B, K, S2), tidied(B * K * S2), f"$B_{i} K S_2$")
    upper = sp.Matrix([[claims["A11"].right, claims["A12"].right], [claims["A21"].right, claims["A22"].right]])
    right = sp.Matrix([[claims["B1"].right], [claims["B2"].right]])
    whole = sp.ImmutableMatrix(sp.Matrix([[upper, right], [sp.zeros(n - p, n), J]]))
    yield Step(
        "reduced_loop",
        claims={**claims, "J": Claim(difference(A22, product(observer.gain, A12)), J, "$J$")},
        figures=_diagram(plant, "reduced_observer_feedback", "State feedback with an observer of reduced order."),
        whole=partitioned(whole, (p, n), (p, n)),
        discrete=plant.discrete,
    )
    return whole


@lemma("output_feedback")
def separation_of(whole: ImmutableMatrix, plant: Plant, control: Design, observer: Design) -> Derivation[None]:
    """The polynomial of the whole is the product of the two that were designed."""
    x = plant.variable
    pencil = exact.pencil(whole, x)
    both = product(control.polynomial, observer.polynomial)
    yield Step(
        "separation",
        claims={"polynomial": Claim(determinant(pencil), both, "separation principle")},
        x=x,
        control=control.eigenvalues,
        observer=observer.eigenvalues,
        reduced=whole.rows < 2 * plant.n,
    )


def full_compensator(plant: Plant, K: ImmutableMatrix, L: ImmutableMatrix) -> tuple[Compensator, dict[str, Claim]]:
    """x̂' = (A − BK − LC + LDK) x̂ + L y, u = −K x̂, and the claim of its matrix."""
    A, B, C, D = plant.A, plant.B, plant.C, plant.D
    F = tidied(A - B * K - L * C + L * D * K)
    stated = difference(difference(A, product(B, K)), product(L, C))
    if not plant.plain:
        stated = total(stated, product(L, D, K))
    claims = {"F": Claim(stated, F, "matrix of the compensator")}
    products = _multiplied(B, K) + _multiplied(L, C)
    return Compensator(F, L, K, sp.ImmutableMatrix(sp.zeros(K.rows, C.rows)), products), claims


def reduced_compensator(
    plant: Plant, parts: exact.Partition, K: ImmutableMatrix, matrices: tuple[ImmutableMatrix, ...]
) -> tuple[Compensator, dict[str, Claim]]:
    """ω' = J ω + N y + M u with u = −K S₂ ω − K (S₁ + S₂L)(y − Du), solved for u; raises Unsolved if that cannot be."""
    L, J, N, M = matrices
    p, D = parts.p, plant.D
    H, E = tidied(K * parts.T[:, p:]), tidied(K * (parts.T[:, :p] + parts.T[:, p:] * L))
    claims = {"E": Claim(product(K, total(parts.T[:, :p], product(parts.T[:, p:], L))), E, "$K (S_1 + S_2 L)$")}
    if not plant.plain:
        W = sp.ImmutableMatrix(sp.eye(K.rows) - E * D)
        if exact.determinant(W) == 0:
            raise Unsolved("observers/not_well_posed")
        back = exact.inverse(W)
        claims["solved"] = Claim(inverse(difference(sp.eye(K.rows), product(E, D))), back, "solved for $u$")
        H, E = tidied(back * H), tidied(back * E)
    F, G = tidied(J - M * H), tidied(N - M * E)
    claims["F"] = Claim(difference(J, product(M, H)), F, "matrix of the compensator")
    claims["G"] = Claim(difference(N, product(M, E)), G, "its input matrix")
    whole = tidied(parts.T[:, :p] + parts.T[:, p:] * L)
    products = _multiplied(K, whole) + _multiplied(M, H) + _multiplied(M, E) if plant.plain else ()
    return Compensator(F, G, H, E, products), claims


@where_exact
def _multiplied(left: ImmutableMatrix, right: ImmutableMatrix) -> tuple[Step, ...]:
    return multiplied(left, right, tidied(left * right))


@lemma("output_feedback")
def compensator_of(
    plant: Plant, found: Compensator, claims: dict[str, Claim], *, reduced: bool
) -> Derivation[ImmutableMatrix]:
    """The transfer matrix −(H (xI − F)⁻¹ G + E) from y to u (m×p)."""
    x, F, G, H, E = plant.variable, found.F, found.G, found.H, found.E
    yield Step(
        "compensator_equations",
        claims=claims,
        steps=found.products,
        found=found,
        plain=plant.plain,
        reduced=reduced,
        discrete=plant.discrete,
    )
    minus_H, minus_E = sp.ImmutableMatrix(-H), sp.ImmutableMatrix(-E)
    matrix: ImmutableMatrix = exact.transfer_matrix(F, G, minus_H, minus_E, x).matrix
    shown = matrix[0, 0] if matrix.shape == (1, 1) else matrix
    pencil = difference(product(x, sp.ImmutableMatrix(sp.eye(F.rows))), F)
    stated = product(minus_H, inverse(pencil), G)
    if not E.is_zero_matrix:
        stated = difference(stated, E)
    chi = exact.faddeev_leverrier(F).characteristic_polynomial(x)
    yield Step(
        "compensator",
        claims={
            "determinant": Claim(characteristic(F, x), chi, "denominator of the compensator"),
            "G": Claim(stated, shown, "transfer function from y to u"),
        },
        steps=fraction_multiplied_out(x, (F, G, minus_H, minus_E)),
        x=x,
        F=F,
        direct=not E.is_zero_matrix,
        unstable=_unstable(chi, x, discrete=plant.discrete),
        reduced=reduced,
    )
    return matrix


def _unstable(chi: Expr, x: Symbol, *, discrete: bool) -> bool:
    """Whether a polynomial in numbers has a root outside the stable region (known for sure)."""
    if chi.free_symbols - {x}:
        return False
    roots = [complex(root) for root in sp.Poly(chi, x).nroots(n=15, maxsteps=200)]
    return any(abs(root) > 1 + 1e-9 if discrete else root.real > 1e-9 for root in roots)
