"""Is the system stable? By its eigenvalues, by Lyapunov's equation, by the Routh array."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from solver.derivation import (
    AnswerName,
    Answers,
    Attempt,
    Claim,
    Derivation,
    Given,
    Refusal,
    Step,
    Task,
    Unsolved,
    option,
)
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.options.flag import Flag
from solver.options.matrix import MatrixOf
from solver.stated.algebra import power, product
from solver.tasks import consequences, meanings, mistakes
from solver.tasks.form_meanings import first_routh_entry
from solver.tasks.linear_algebra.characteristic_polynomial import factors_of
from solver.tasks.linear_algebra.eigenstructure import eigenvalues_of
from solver.tasks.plant_options import LoopOptions
from solver.tasks.stability import checks
from solver.tasks.stability.lyapunov_equation import function_of, is_positive_definite, lyapunov_solution_of
from solver.tasks.stability.routh_array import Tabled, routh_array_of
from solver.tasks.stability.verdicts import (
    MARGINAL,
    STABLE,
    UNSTABLE,
    critical_eigenvalues,
    depends_on_parameters,
    external_stability_of,
    location_of,
)
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

    from solver.systems import StateSpace, System


@dataclass(frozen=True, kw_only=True)
class StabilityOptions(LoopOptions):
    """Lyapunov's equation."""

    Q: ImmutableMatrix | None = option(
        MatrixOf("n", "n"), "right side −Q of Lyapunov's equation (default I)", methods=("lyapunov",)
    )
    dual: bool = option(Flag(), "A P + P Aᵀ = −Q instead of Aᵀ P + P A = −Q", methods=("lyapunov",))


stability: Task[StateSpace, StabilityOptions] = Task(
    "stability",
    title="Stability",
    doc="Stability of the free motion (internal), and from input to output (BIBO).",
    needs=("A",),
    options=StabilityOptions,
    answers=[
        AnswerName(
            "verdict",
            r"\text{verdict}",
            "the free motion",
            principal=True,
            words=("asymptotically stable", "marginally stable", "unstable"),
            earned=("spectrum", "solution", "minors", "array", "sign_changes"),
        ),
        AnswerName("bibo_stable", r"\text{BIBO stable}", "whether bounded inputs give bounded outputs", optional=True),
        AnswerName("eigenvalues", r"\lambda_i", "the eigenvalues, with multiplicity", optional=True, numbered=True),
        AnswerName("P", "P", "the solution of Lyapunov's equation", ("lyapunov",), optional=True),
        AnswerName("array", r"\text{array}", "the Routh array, its shorter rows filled up with zeros", ("routh",)),
        AnswerName(
            "right_half_plane_roots",
            r"n_{+}",
            "the number of eigenvalues with positive real part (in discrete time: outside the unit circle)",
            ("routh",),
            count=True,
        ),
    ],
)

checks.register(stability)

BOUNDARY = 1e-20
"""A real part of that size, of 30 digits, is zero."""


@stability.refusal
def is_no_right_side(system: System, options: StabilityOptions) -> Iterable[Refusal]:
    """Q must be symmetric and positive semidefinite, not zero."""
    Q = options.Q
    if Q is None or Q.rows != Q.cols or Q.rows != getattr(system, "order", Q.rows):
        return
    if Q != Q.T:
        yield "Q", Reason("stability/weight_not_symmetric")
    elif Q.is_zero_matrix:
        yield "Q", Reason("stability/weight_zero")
    elif exact.definiteness(Q) not in (None, "positive definite", "positive semidefinite"):
        yield "Q", Reason("stability/weight_not_definite")


@stability.method("eigenvalues", title="Eigenvalues", source="Lecture note, section 1.15")
def by_eigenvalues(given: Given[StateSpace, StabilityOptions]) -> Derivation[Answers]:
    """Asymptotically stable if and only if Re λ < 0 (discrete: |λ| < 1) for every eigenvalue."""
    A, discrete = given.system.A, given.system.discrete
    yield from eigenvalues_of(A)
    found = yield from location_of(A, discrete=discrete)
    chained = [space.root.value for space in found.critical if space.geometric < space.algebraic]
    yield Step(
        "verdict",
        unclaimed="a consequence of where the eigenvalues lie; the answer has a check of its own",
        verdict=found.verdict,
        outside=any(each.position == 1 for each in found.placed),
        chained=chained,
        discrete=discrete,
        exceptions=found.spectrum.exceptions if found.critical else (),
    )
    return (yield from _answers(given, str(found.verdict)))


@stability.method("lyapunov", title="Lyapunov's equation", source="Lecture note, equation (1.15.2)")
def by_lyapunov(given: Given[StateSpace, StabilityOptions]) -> Derivation[Answers]:
    """P of AᵀP + PA = −Q is positive definite if and only if A is asymptotically stable (Q > 0)."""
    A, discrete, dual = given.system.A, given.system.discrete, bool(given.options.dual)
    Q = given.options.Q if given.options.Q is not None else sp.ImmutableMatrix(sp.eye(A.rows))
    decisive = yield from _right_side(A, Q, dual=dual)
    P = yield from lyapunov_solution_of(A, Q, dual=dual, discrete=discrete)
    verdict, semidefinite = "", exact.definiteness(Q) != "positive definite"
    facts: dict[str, Any] = {"discrete": discrete, "dual": dual, "semidefinite": semidefinite}
    if P is not None:
        definite = yield from is_positive_definite(P)
        if definite is None:
            yield from depends_on_parameters(A, discrete=discrete)
        verdict = (STABLE if definite else UNSTABLE) if decisive else ""
    if verdict:
        claims = {} if P is None else function_of(P, Q)
        yield Step("verdict", claims=claims, unclaimed="" if claims else "Lyapunov's theorem", decisive=True,
                   verdict=verdict, **facts)  # fmt: skip
        yield from _confirmation(A)
    else:
        yield from eigenvalues_of(A)
        found = yield from location_of(A, discrete=discrete)
        verdict = str(found.verdict)
        yield Step("verdict", unclaimed="by the eigenvalues", decisive=False, verdict=verdict, **facts)
    return (yield from _answers(given, verdict, **({} if P is None else {"P": P})))


def _right_side(A: ImmutableMatrix, Q: ImmutableMatrix, *, dual: bool) -> Derivation[bool]:
    """Whether the sign of P decides: Q is positive definite, or sees (dual: reaches) every mode."""
    if Q.shape != A.shape:
        raise Unsolved("stability/size_of_the_weight", n=A.rows)
    kind = exact.definiteness(Q)
    if kind is None:
        raise Unsolved("stability/definiteness_of_the_weight")
    if kind == "positive definite":
        return True
    F = sp.ImmutableMatrix(A if dual else A.T)
    seen = exact.controllability_matrix(F, Q)
    rank = exact.rank(seen)
    yield Step("semidefinite", unclaimed="a rank; it only tells whether the sign of P decides", Q=Q, dual=dual,
               rank=rank, n=A.rows)  # fmt: skip
    return bool(rank == A.rows)


@stability.method("routh", title="Routh's criterion", source="Gantmacher, The Theory of Matrices II, XV §4")
def by_routh(given: Given[StateSpace, StabilityOptions]) -> Derivation[Answers]:
    """As many roots in the right half plane as changes of sign in the first column of the array."""
    A, discrete = given.system.A, given.system.discrete
    tabled = yield from routh_array_of(A, discrete=discrete)
    signs = [exact.sign_of(x) for x in tabled.array.at_zero]
    if None in signs:
        yield from depends_on_parameters(A, discrete=discrete)
    parts = exact.routh_parts(tabled.array.coefficients)
    changes = exact.sign_changes(signs)
    yield Step(
        "sign_changes",
        unclaimed="counted; the number has a check of its own",
        column=list(zip([row.entries[0] for row in tabled.array.rows], signs, strict=True)),
        epsilon=tabled.array.epsilon,
        changes=changes,
        discrete=discrete,
        trusted=len(parts) == 1,
    )
    if len(parts) > 1:
        changes = yield from _split(tabled, parts)
    verdict = yield from _verdict_of_array(A, tabled, changes, discrete=discrete)
    return (yield from _answers(given, verdict, array=tabled.array.matrix, right_half_plane_roots=sp.Integer(changes)))


def _split(tabled: Tabled, parts: Sequence[tuple[tuple[Expr, ...], int]]) -> Derivation[int]:
    """Count for each factor by an array of its own: ε must not move roots that lie symmetrically to the origin."""
    x, whole = tabled.variable, tabled.array.coefficients
    p = sp.Add(*(c * x ** (len(whole) - 1 - i) for i, c in enumerate(whole)))
    found = []
    for c, m in parts:
        factor = sp.Add(*(a * x ** (len(c) - 1 - i) for i, a in enumerate(c)))
        found.append((factor, m, exact.sign_changes([exact.sign_of(entry) for entry in exact.routh(c).at_zero])))
    monic = product(sp.cancel(whole[0] / sp.Mul(*(c[0] ** m for c, m in parts))), *(power(f, m) for f, m, _ in found))
    total = sum(m * count for _, m, count in found)
    yield Step("split", claims={"factors": Claim(p, monic, "the symmetric factor")}, factors=found, total=total, x=x)
    return total


def _verdict_of_array(A: ImmutableMatrix, tabled: Tabled, outside: int, *, discrete: bool) -> Derivation[str]:
    """No changes of sign and no row of zeros: stable. A row of zeros without changes: roots on the boundary."""
    zeros = tabled.ones > 0 or any(row.special for row in tabled.array.rows)
    verdict = UNSTABLE if outside else STABLE
    if zeros and not outside:
        found = exact.location(A, discrete=discrete)
        yield from critical_eigenvalues(A, found, discrete=discrete)
        verdict = str(found.verdict)
    yield Step("verdict", unclaimed="a consequence of the count; the answer has a check of its own", verdict=verdict,
               outside=outside, boundary=zeros and not outside, discrete=discrete)  # fmt: skip
    if _spectrum(A) is not None:
        yield from factors_of(A, sp.Symbol("z" if discrete else "s"))
    yield from _confirmation(A)
    return verdict


def _confirmation(A: ImmutableMatrix) -> Derivation[None]:
    """The eigenvalues beside a criterion that needs none; left out where they have no usable form."""
    spectrum = _spectrum(A)
    if spectrum is not None:
        lamda = sp.Symbol("lamda")
        chi = exact.faddeev_leverrier(A).characteristic_polynomial(lamda)
        linear = product(*(power(lamda - root.value, root.multiplicity) for root in spectrum.roots))
        yield Step("confirmation", claims={"roots": Claim(chi, linear, "the eigenvalues")}, roots=spectrum.roots)


def _spectrum(A: ImmutableMatrix) -> exact.Spectrum | None:
    try:
        return exact.spectrum(A)
    except exact.NotExact:
        return None


def _answers(given: Given[StateSpace, StabilityOptions], verdict: str, **further: Any) -> Derivation[Answers]:
    """The answers that all methods give, in the order of the catalogue."""
    bibo = yield from external_stability_of(given.system, verdict)
    answers = Answers(verdict=verdict)
    if bibo is not None:
        answers["bibo_stable"] = bibo
    spectrum = _spectrum(given.system.A)
    if spectrum is not None:
        answers["eigenvalues"] = spectrum.eigenvalues
    answers.update(further)
    return answers


@stability.consequence("verdict", of=("eigenvalues",), symbolic=False)
def verdict_of_the_eigenvalues(given: Given[StateSpace, StabilityOptions], found: Mapping[str, Any]) -> Any:
    """By the largest real part (discrete: modulus); None on the boundary with equal ones, or with parameters."""
    values = found["eigenvalues"]
    if any(value.free_symbols for value in values):
        return None
    sizes = [sp.N(sp.Abs(value) - 1 if given.system.discrete else sp.re(value), 30) for value in values]
    largest = max(sizes)
    if abs(largest) > BOUNDARY:
        return STABLE if largest < 0 else UNSTABLE
    critical = [value for value, size in zip(values, sizes, strict=True) if abs(size) <= BOUNDARY]
    return MARGINAL if len(set(critical)) == len(critical) else None


@stability.consequence("verdict", of=("right_half_plane_roots",), symbolic=False)
def verdict_of_the_count(_given: Given[StateSpace, StabilityOptions], found: Mapping[str, Any]) -> Any:
    """Unstable where an eigenvalue is outside."""
    return UNSTABLE if found["right_half_plane_roots"] > 0 else None


stability.consequence("right_half_plane_roots", of=("array",), symbolic=False)(consequences.sign_changes)


stability.mistake(mistakes.DIAGONAL, "eigenvalues")(mistakes.diagonal_entries)


@stability.mistaken_question(mistakes.WEIGHT_REVERSED)
def weight_reversed(system: System, options: StabilityOptions) -> tuple[System, StabilityOptions] | None:
    """Lyapunov's equation with +Q on its right."""
    return None if options.Q is None else (system, replace(options, Q=sp.ImmutableMatrix(-options.Q)))


stability.meaning("eigenvalues")(meanings.no_eigenvalue)
stability.meaning("array")(first_routh_entry)


@stability.meaning("verdict")
def by_the_half_plane(wrong: Attempt[System, StabilityOptions]) -> Reason | None:
    """Re λ < 0 taken for |λ| < 1."""
    if str(wrong.value) not in ("asymptotically stable", "unstable"):
        return None
    return meanings.half_plane(wrong, wrong.answers.get("eigenvalues"), stable=str(wrong.value) != "unstable")
