"""The phase portrait in discrete time: points that jump, kinds by |λ|, and the figure of their orbits."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.derivation.figures import Curve, Mark, Plot
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product
from solver.stated.complex_numbers import absolute
from solver.tasks.linear_algebra.eigenstructure import eigenvalues_of, right_eigenvectors_of
from solver.tasks.stability.planar_kinds import kind_in_z
from solver.tasks.stability.trajectories import eigenvector_lines
from solver.words import Phrase

if TYPE_CHECKING:
    from collections.abc import Iterator

    from sympy import Expr, ImmutableMatrix

NAMES = ("p(1)", "p(-1)", r"\det A - 1", r"(\operatorname{tr}A)^{2} - 4\det A")
JUMPS = 14
"""No orbit is followed further, forward or back."""
OUT, NEAR = 1.25, 0.02
"""The half width of what is shown, and the distance from the origin at which an orbit is as good as there."""
ANGLES = ((1, 0), (1, "1/2"), (1, 1), ("1/2", 1), (0, 1), ("-1/2", 1), (-1, 1), (-1, "1/2"))


@lemma("jumping_points")
def kind_by_moduli(A: ImmutableMatrix) -> Derivation[tuple[str, exact.PlanarSigns]]:
    """The kind of the origin of x(k+1) = A x(k) (2×2). Raises Unsolved for an eigenvalue −1 that leaves it unnamed."""
    yield from eigenvalues_of(A)
    found = exact.planar_signs_in_z(A)
    kind, values = kind_in_z(A, *found.signs), exact.invariants_in_z(A)
    yield from _sizes(A, values)
    if not kind:
        raise Unsolved("phase_portrait/eigenvalue_minus_one")
    if found.exceptions:
        told = zip(NAMES, values, found.signs, found.open, strict=True)
        yield Step(
            "general",
            unclaimed="conditions, not equalities; the answer has a check of its own",
            open=[(name, x, sign) for name, x, sign, is_open in told if is_open],
            exceptions=list(found.exceptions),
        )
    if found.signs[3] >= 0:
        yield from right_eigenvectors_of(A)
    else:
        start, jump = sp.ImmutableMatrix([1, 0]), sp.ImmutableMatrix([A[0, 0], A[1, 0]])
        yield Step(
            "turn",
            claims={"jump": Claim(product(A, start), jump, "where (1, 0) jumps to")},
            counterclockwise=found.sign_of(A[1, 0]),
        )
    yield Step(
        "kind",
        unclaimed="read off; the answer has a check of its own",
        kind=kind,
        equilibria=_fixed_points(A),
        alternating=_alternating(A),
        dead=A.free_symbols == set() and exact.determinant(A) == 0,
    )
    if not A.free_symbols:
        yield Step("portrait", unclaimed="a drawing", figures=(portrait_of_jumps(A, kind),), kind=kind)
    return kind, found


def _sizes(A: ImmutableMatrix, values: tuple[Expr, ...]) -> Iterator[Step]:
    """The sizes of the eigenvalues; with parameters the values that tell where they lie."""
    if not A.free_symbols:
        eigenvalues = list(dict.fromkeys(exact.spectrum(A).eigenvalues))
        det = exact.determinant(A)
        sizes = [sp.sqrt(det) if value.has(sp.I) else sp.Abs(value) for value in eigenvalues]
        claims = {
            f"size{i}": Claim(absolute(value), size, Phrase("size of eigenvalue {i}", i=i))
            for i, (value, size) in enumerate(zip(eigenvalues, sizes, strict=True), 1)
        }
        yield Step("sizes", claims=claims, values=eigenvalues, pair=eigenvalues[0].has(sp.I))
        return
    at_one, at_minus_one, size, discriminant = values
    x = sp.Symbol("lambda")
    tr, det, _ = exact.invariants(A)
    p = x**2 - tr * x + det
    claims = {
        "at_one": Claim(p.subs(x, 1), at_one, "$p(1)$"),
        "at_minus_one": Claim(p.subs(x, -1), at_minus_one, "$p(-1)$"),
        "size": Claim(det - 1, size, r"$\det A - 1$"),
        "discriminant": Claim(tr**2 - 4 * det, discriminant, "discriminant"),
    }
    yield Step("conditions", claims=claims, det=det)


def _fixed_points(A: ImmutableMatrix) -> ImmutableMatrix | None:
    """The direction of the line of equilibria x = A x, if they form one."""
    M = sp.ImmutableMatrix(A - sp.eye(2))
    if M.is_zero_matrix or exact.sign_of(sp.expand(M[0, 0] * M[1, 1] - M[0, 1] * M[1, 0])) != 0:
        return None
    row = next(i for i in range(2) if M[i, 0] != 0 or M[i, 1] != 0)
    return sp.ImmutableMatrix([M[row, 1], -M[row, 0]])


def _alternating(A: ImmutableMatrix) -> list[Expr]:
    """The negative eigenvalues."""
    if A.free_symbols:
        return []
    return [value for value in dict.fromkeys(exact.spectrum(A).eigenvalues) if value.is_real and value < 0]


def portrait_of_jumps(A: ImmutableMatrix, kind: str) -> Plot:
    """Orbits of x(k+1) = A x(k) (2×2, numbers): points at the steps, joined in their order."""
    u = sp.Symbol("u")
    orbits = (_orbit(A, x0) for x0 in _starts(A, kind))
    jumps = [
        Curve(tuple(y for _, y in orbit), "", tuple(x for x, _ in orbit), style="jumps")
        for orbit in orbits
        if len(orbit) > 1
    ]
    return Plot(
        Phrase("Phase portrait: {kind}", kind=kind),
        "x_{1}",
        "x_{2}",
        u,
        sp.Integer(0),
        sp.Integer(1),
        (*eigenvector_lines(A, u), *jumps),
        marks=(Mark(sp.Integer(0), sp.Integer(0)),),
        equal=True,
    )


def _starts(A: ImmutableMatrix, kind: str) -> list[ImmutableMatrix]:
    """Where orbits pass: the edge of a square; inside of it where they come from outside and leave again."""
    edge = [sp.ImmutableMatrix([sp.Rational(a), sp.Rational(b)]) for a, b in ANGLES]
    edge += [sp.ImmutableMatrix(-x) for x in edge]
    if kind == "center":
        return [sp.ImmutableMatrix([sp.Rational(i, 3), 0]) for i in range(1, 4)]
    if kind.endswith("focus"):
        return edge[::8]
    if kind == "saddle":
        vectors = [chain[0] for space in exact.eigenstructure(A).eigenspaces for chain in space.chains]
        v, w = (each / max(abs(sp.N(entry)) for entry in each.flat()) for each in vectors)
        tops = [scale * (v + sign * w) for scale in (sp.Rational(1, 6), sp.Rational(2, 5)) for sign in (1, -1)]
        return [sp.ImmutableMatrix(sign * x) for x in [*tops, v / 2, w / 2] for sign in (1, -1)]
    if kind == "shear":
        return [sp.ImmutableMatrix(x * scale) for x in edge[::2] for scale in (sp.Rational(1, 3), sp.Rational(2, 3))]
    return edge[::2]


def _orbit(A: ImmutableMatrix, x0: ImmutableMatrix) -> list[tuple[Any, Any]]:
    """The points of the orbit through x0 that are shown, in their order."""
    forward = _steps(A, x0)
    if exact.determinant(A) == 0:
        return [_point(x0), *forward]
    return [*_steps(exact.inverse(A), x0)[::-1], _point(x0), *forward]


def _steps(A: ImmutableMatrix, x0: ImmutableMatrix) -> list[tuple[Any, Any]]:
    """The points after x0 up to the first near the origin, where the orbit stands still or leaves what is shown."""
    M = sp.Matrix(A).evalf(30)
    points, x = [_point(x0)], sp.Matrix(x0).evalf(30)
    while len(points) <= JUMPS and max(map(abs, x)) > NEAR:
        x = M * x
        if max(map(abs, x)) > OUT or _point(x) == points[-1]:
            break
        points.append(_point(x))
    return points[1:]


def _point(x: Any) -> tuple[Any, Any]:
    """The coordinates in six decimals."""
    first, second = (sp.Rational(round(float(entry) * 10**6), 10**6) for entry in x)
    return first, second
