"""Lemmas: where the eigenvalues lie, what that means inside and from input to output."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, power, product, quotient, total
from solver.stated.matrices import inverse
from solver.tasks.figures import plane, roots

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

    from solver.systems import StateSpace

STABLE, MARGINAL, UNSTABLE = "asymptotically stable", "marginally stable", "unstable"


@lemma("location")
def location_of(A: ImmutableMatrix, *, discrete: bool) -> Derivation[exact.Location]:
    """Re λ < 0 (discrete: |λ| < 1) for each eigenvalue; those on the boundary by their eigenvectors."""
    found = exact.location(A, discrete=discrete)
    claims = _measures(found, discrete=discrete)
    yield Step(
        "location",
        claims=claims,
        unclaimed="" if claims else "the signs are read off",
        placed=found.placed,
        approximations=[_approximation(each.measure) for each in found.placed],
        real=[not each.root.value.has(sp.I) for each in found.placed],
        pairs=_pairs(found),
        discrete=discrete,
        figures=plane(
            "Where the eigenvalues lie",
            roots("eigenvalues", found.spectrum.eigenvalues),
            discrete=discrete,
            stable=True,
        ),
    )
    if found.verdict is None:
        yield from depends_on_parameters(A, discrete=discrete)
    yield from critical_eigenvalues(A, found, discrete=discrete)
    return found


def _measures(found: exact.Location, *, discrete: bool) -> dict[str, Claim]:
    """The real part of a complex eigenvalue as half the sum with its conjugate, |λ|² as their product."""
    claims: dict[str, Claim] = {}
    for i, each in enumerate(found.placed, 1):
        value = each.root.value
        if each.measure is None or not value.has(sp.I):
            continue
        conjugate = each.root.sigma - (value - each.root.sigma)
        if discrete:
            claims[f"modulus{i}"] = Claim(product(value, conjugate), power(each.measure, 2), "the squared modulus")
        else:
            claims[f"real{i}"] = Claim(quotient(total(value, conjugate), 2), each.measure, "the real part")
    return claims


def _approximation(measure: Any) -> Any:
    """A decimal for an irrational number, to see its sign."""
    exactly = measure is None or measure.is_Rational or measure.is_Float or measure.free_symbols
    return None if exactly else sp.Float(sp.N(measure, 20), 15)


def _pairs(found: exact.Location) -> list[tuple[Any, Any]]:
    """Quadratic factors whose roots may be real or complex, and where the roots are."""
    lamda = sp.Symbol("lamda")
    undecided = {each.root.value: each.position for each in found.placed if each.measure is None}
    return [
        (factor.polynomial(lamda), undecided[factor.roots[0].value])
        for factor in found.spectrum.factors
        if factor.roots[0].value in undecided
    ]


@lemma("location")
def critical_eigenvalues(A: ImmutableMatrix, found: exact.Location, *, discrete: bool) -> Derivation[None]:
    """On the boundary a multiple eigenvalue needs as many eigenvectors as its multiplicity."""
    if any(each.position == 1 for each in found.placed):
        return
    for space in found.critical:
        vectors = sp.ImmutableMatrix(sp.Matrix.hstack(*(chain[0] for chain in space.chains)))
        pencil = exact.pencil(A, space.root.value)
        zero = sp.ImmutableMatrix(sp.zeros(*vectors.shape))
        yield Step(
            "critical",
            claims={"kernel": Claim(product(pencil, vectors), zero, r"$(\lambda I - A)\nu = 0$")},
            value=space.root.value,
            pencil=pencil,
            vectors=vectors,
            columns=[vectors[:, [i]] for i in range(vectors.cols)],
            algebraic=space.algebraic,
            geometric=space.geometric,
            rank=A.rows - space.geometric,
            discrete=discrete,
        )


@lemma("location")
def depends_on_parameters(A: ImmutableMatrix, *, discrete: bool) -> Derivation[None]:
    """The verdict is not the same for all values of the parameters: say when it is asymptotic stability."""
    condition = exact.stable_where(A, discrete=discrete)
    if condition is sp.true:
        raise Unsolved("stability/signs_not_found")
    yield Step(
        "depends",
        unclaimed="the condition is derived and checked by the task `stability_range`",
        condition=condition,
        never=condition is sp.false,
    )
    if condition is sp.false:
        raise Unsolved("stability/never_stable")
    parts = condition.args if isinstance(condition, sp.And) else (condition,)
    raise Unsolved("stability/depends_on_parameters", conditions=parts)


@lemma("external_stability")
def external_stability_of(system: StateSpace, verdict: str) -> Derivation[bool | None]:
    """BIBO stability: the poles that C (sI − A)⁻¹ B keeps must be inside; None where parameters decide."""
    if verdict == STABLE:
        yield Step("follows", unclaimed="a consequence of asymptotic stability", discrete=system.discrete)
        return True
    if system.B is None and system.C is None:
        yield Step("all_states", unclaimed="nothing is hidden: every eigenvalue is a pole", discrete=system.discrete)
        return False
    identity = sp.ImmutableMatrix(sp.eye(system.order))
    B, C = (identity if M is None else M for M in (system.B, system.C))
    x = sp.Symbol("z" if system.discrete else "s")
    G = exact.transfer_matrix(system.A, B, C, sp.ImmutableMatrix(sp.zeros(C.rows, B.cols)), x)
    pencil = difference(product(x, identity), system.A)
    yield Step(
        "transfer",
        claims={"G": Claim(product(C, inverse(pencil), B), G.matrix, "the transfer matrix")},
        missing="B" if system.B is None else "C" if system.C is None else "",
        identity=identity,
        x=x,
        G=G.matrix[0, 0] if G.matrix.shape == (1, 1) else G.matrix,
    )
    c = sp.Poly(G.pole_polynomial.as_expr(), x).all_coeffs()
    stable = exact.is_stable_polynomial(c, discrete=system.discrete) if len(c) > 1 else True
    yield Step(
        "poles",
        unclaimed="the poles are read off the denominators",
        poles=G.poles,
        cancelled=G.cancelled,
        stable=stable,
        discrete=system.discrete,
    )
    return stable
