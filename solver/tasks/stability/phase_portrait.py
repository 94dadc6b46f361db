"""The phase portrait of two states: what kind of equilibrium the origin is, and what the free motions look like."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from solver.derivation import (
    AnswerName,
    Answers,
    Attempt,
    Check,
    Claim,
    Derivation,
    Given,
    Refusal,
    Step,
    Task,
    Unsolved,
)
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import linear_algebra, stability
from solver.stated.algebra import difference, exponential, power, product
from solver.stated.matrices import determinant, trace
from solver.tasks import meanings, mistakes
from solver.tasks.linear_algebra.eigenstructure import eigenvalues_of, right_eigenvectors_of
from solver.tasks.plant_options import PlantOptions
from solver.tasks.stability.jumping_points import kind_by_moduli
from solver.tasks.stability.planar_kinds import kind_by_signs, kind_in_z, other_cases
from solver.tasks.stability.trajectories import portrait_of
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

    from solver.systems import StateSpace, System

KINDS = (
    *("stable node", "unstable node", "stable degenerate node", "unstable degenerate node", "stable star"),
    *("unstable star", "stable focus", "unstable focus", "center", "saddle", "shear", "line of equilibria"),
    "all points are equilibria",
)

phase_portrait: Task[StateSpace, PlantOptions] = Task(
    "phase_portrait",
    title="Phase portrait",
    doc="The kind of equilibrium at the origin of x' = A x or x(k+1) = A x(k), two states, and the motions around it.",
    needs=("A",),
    options=PlantOptions,
    answers=[
        AnswerName(
            "kind",
            r"\text{kind}",
            "the kind of equilibrium (with parameters: in general)",
            principal=True,
            words=KINDS,
            earned=("spectrum", "invariants", "sizes", "conditions", "kind"),
        ),
        AnswerName("eigenvalues", r"\lambda_i", "the eigenvalues, each as often as its multiplicity", numbered=True),
        AnswerName("exceptions", r"\text{exceptions}", "where the parameters make it another", optional=True),
    ],
)


@phase_portrait.refusal
def has_no_plane(system: System, options: PlantOptions) -> Iterable[Refusal]:  # noqa: ARG001 - no options
    """There must be two states."""
    if (order := getattr(system, "order", 2)) != 2:
        yield "", Reason("phase_portrait/number_of_states", {"n": order})


@phase_portrait.method(source="Lecture note, section 1.15.2")
def by_eigenvalues(given: Given[StateSpace, PlantOptions]) -> Derivation[Answers]:
    """Trace, determinant and discriminant tell the eigenvalues apart; these tell the kind, in discrete time by |λ|."""
    A = given.system.A
    if A.rows != 2:
        raise Unsolved("phase_portrait/another_order", n=A.rows)
    kind, found = yield from (kind_by_moduli if given.system.discrete else _kind_by_signs)(A)
    answers = Answers(kind=kind, eigenvalues=exact.spectrum(A).eigenvalues)
    return Answers(**answers, exceptions=list(found.exceptions)) if found.exceptions else answers


def _kind_by_signs(A: ImmutableMatrix) -> Derivation[tuple[str, exact.PlanarSigns]]:
    """The kind of the origin of x' = A x (2×2), and the portrait."""
    yield from eigenvalues_of(A)
    tr, det, discriminant = exact.invariants(A)
    yield Step(
        "invariants",
        claims={
            "trace": Claim(trace(A), tr, "trace"),
            "determinant": Claim(determinant(A), det, "determinant"),
            "discriminant": Claim(difference(power(tr, 2), product(4, det)), discriminant, "discriminant"),
        },
    )
    found = exact.planar_signs(A)
    signs, kind = found.signs, kind_by_signs(A, *found.signs)
    if found.exceptions:
        yield Step(
            "general",
            unclaimed="conditions, not equalities; the answer has a check of its own",
            kind=kind,
            open=[
                (name, x, sign)
                for name, x, sign, is_open in zip(
                    ("trace", "determinant", "discriminant"), (tr, det, discriminant), signs, found.open, strict=True
                )
                if is_open
            ],
            exceptions=list(found.exceptions),
            others=list(other_cases(A, (tr, det, discriminant), found)),
        )
    yield from _directions(A, kind, found)
    yield Step("kind", unclaimed="read off; the answer has a check of its own", kind=kind, equilibria=_equilibria(A))
    if not A.free_symbols and not A.is_zero_matrix:
        t = sp.Symbol("t")
        Phi = exact.exponential(A, t).matrix
        at = sp.ImmutableMatrix(t * A)
        yield Step(
            "portrait",
            claims={"Phi": Claim(exponential(at), Phi, "the state transition matrix")},
            figures=(portrait_of(A, Phi, t, kind),),
            Phi=Phi,
            kind=kind,
            lines=signs[2] >= 0,
        )
    return kind, found


def _directions(A: ImmutableMatrix, kind: str, found: exact.PlanarSigns) -> Derivation[None]:
    """Real eigenvalues: the lines of the eigenvectors; a pair: the sense of rotation, seen on the first axis."""
    if found.signs[2] >= 0:
        yield from right_eigenvectors_of(A)
        return
    start = sp.ImmutableMatrix([1, 0])
    velocity = sp.ImmutableMatrix([A[0, 0], A[1, 0]])
    yield Step(
        "rotation",
        claims={"velocity": Claim(product(A, start), velocity, "the velocity at (1, 0)")},
        velocity=velocity,
        counterclockwise=found.sign_of(A[1, 0]),
        kind=kind,
    )


def _equilibria(A: ImmutableMatrix) -> ImmutableMatrix | None:
    """The direction of the line of equilibria, if they form one."""
    if A.is_zero_matrix or exact.sign_of(sp.expand(A[0, 0] * A[1, 1] - A[0, 1] * A[1, 0])) != 0:
        return None
    row = next(i for i in range(2) if A[i, 0] != 0 or A[i, 1] != 0)
    return sp.ImmutableMatrix([-A[row, 1], A[row, 0]])


@phase_portrait.verification("kind", "exceptions")
def is_the_kind_of_the_eigenvalues(given: Given[StateSpace, PlantOptions], answers: Answers) -> Iterable[Check]:
    """Signs (discrete: sizes) and imaginary parts of the eigenvalues, dim ker(A − λI) for a double one, 100 digits."""
    exceptions, discrete = answers.get("exceptions"), given.system.discrete
    general, special = stability.kinds_and_exceptions(given.system.A, exceptions or (), discrete=discrete)
    kinds = {str(answers["kind"])} if "kind" in answers else general
    if "kind" in answers:
        right = general == kinds if exceptions is not None or not given.system.parameters else kinds <= general
        yield Check.that("the kind is that of the eigenvalues", "mpmath.eig", right, answer="kind")
    if exceptions is not None:
        fits = len(general) == 1 and not general & special
        says = "where an exception holds, and only there, the kind is another"
        yield Check.that(says, "mpmath.eig", fits, answer="exceptions")


@phase_portrait.verification("eigenvalues")
def are_the_roots(given: Given[StateSpace, PlantOptions], answers: Answers) -> Iterable[Check]:
    """det(xI − A) = Π(x − λᵢ) at random x."""
    yield numeric.check_residual(
        r"$\det(xI - A) = \prod_i (x - \lambda_i)$",
        "numpy.linalg.det",
        lambda: linear_algebra.spectrum_residual(given.system.A, answers["eigenvalues"]),
    )


@phase_portrait.consequence("kind", of=("eigenvalues",), symbolic=False)
def kind_of(given: Given[StateSpace, PlantOptions], found: Mapping[str, Any]) -> Any:
    """The kind by the eigenvalues; None where they coincide or depend on parameters."""
    values = found["eigenvalues"]
    if len(values) != 2 or values[0] == values[1] or any(value.free_symbols for value in values):
        return None
    tr, det, discriminant = sum(values), values[0] * values[1], (values[0] - values[1]) ** 2
    discrete = given.system.discrete
    deciding = (1 - tr + det, 1 + tr + det, det - 1) if discrete else (tr, det)
    signs = [_sign(sp.re(sp.N(x, 30))) for x in (*deciding, discriminant)]
    return (kind_in_z if discrete else kind_by_signs)(sp.ImmutableMatrix(sp.eye(2)), *signs) or None


def _sign(x: Any) -> int:
    """The sign of a number of 30 digits."""
    return 0 if abs(x) < sp.Rational(1, 10**20) else int(sp.sign(x))


phase_portrait.mistake(mistakes.DIAGONAL, "eigenvalues")(mistakes.diagonal_entries)


phase_portrait.meaning("eigenvalues")(meanings.no_eigenvalue)


@phase_portrait.meaning("kind")
def by_the_half_plane(wrong: Attempt[StateSpace, PlantOptions]) -> Reason | None:
    """In discrete time: the kind that the same matrix has in continuous time."""
    A = wrong.given.system.A
    if not wrong.given.system.discrete or A.free_symbols or A.rows != 2:
        return None
    kinds, _ = stability.kinds_and_exceptions(A)
    return Reason("phase_portrait/half_plane") if str(wrong.value) in kinds else None
