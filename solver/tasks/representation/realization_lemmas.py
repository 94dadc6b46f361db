"""Steps on the way from a transfer function to state equations: dividing out D, companion forms, assembling."""

from __future__ import annotations

from typing import Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product, quotient, total
from solver.stated.matrices import inverse
from solver.tasks.representation.chains import integrators_of


@lemma("realization")
def direct_path_of(G: exact.TransferMatrix) -> Derivation[None]:
    """Divide D = G(∞) out, and say what cancels: a realization of the full order keeps it."""
    x, siso = G.variable, G.shape == (1, 1)
    if not G.direct.is_zero_matrix:
        yield Step(
            "division",
            claims={"division": Claim(fractions(G), total(plain(G.direct), proper_part(G)), "polynomial division")},
            x=x,
            siso=siso,
            D=plain(G.direct),
        )
    if siso and G.cancelled_polynomial.degree() > 0:
        top, bottom = G.numerator_factored, G.chi_factored
        yield Step(
            "common_factor",
            claims={
                "numerator": Claim(G.numerators[0][0], top, "numerator in factors"),
                "denominator": Claim(G.chi, bottom, "denominator in factors"),
            },
            x=x,
            factor=G.cancelled_factored,
            n=G.common_denominator.degree(),
        )


@lemma("realization")
def companion_form_of(
    G: exact.TransferMatrix, form: str, *, first: bool, discrete: bool
) -> Derivation[exact.Realization]:
    """Controllable: a chain of integrators (delays) driven at its end; observable: its dual."""
    found = (
        exact.controllable_realization(G, first_row=first)
        if form == "controllable"
        else exact.observable_realization(G, first_row=first)
    )
    x, n, siso = G.variable, found.A.rows, G.shape == (1, 1)
    shown = {"x": x, "n": n, "form": form, "first": first, "discrete": discrete, "siso": siso, "sizes": found.sizes}
    if siso:
        yield _coefficients(G, found, shown)
    else:
        yield Step(
            "blocks",
            claims={
                f"block{j + 1}": Claim(left, right, "over the least common denominator")
                for j, (left, right) in enumerate(_block_fractions(G, form))
            },
            **shown,
        )
    yield from assembled(G, found, **shown)
    return found


def _coefficients(G: exact.TransferMatrix, found: exact.Realization, shown: dict[str, Any]) -> Step:
    """Which coefficient stands where: a₀ … aₙ₋₁ of the denominator, b₀ … bₙ₋₁ of the numerator."""
    x, n = G.variable, found.A.rows
    controllable = shown["form"] == "controllable"
    A, b = (found.A, found.C.flat()) if controllable else (found.A.T, found.B.flat())
    a = [-A[0, n - 1 - j] for j in range(n)] if shown["first"] else [-A[n - 1, j] for j in range(n)]
    b = b[::-1] if shown["first"] else b
    return Step(
        "coefficients",
        claims={
            "denominator": Claim(_by_powers([*a, sp.Integer(1)], x), G.chi, "coefficients of the denominator"),
            "numerator": Claim(_by_powers(b, x), G.strictly_proper_numerators[0][0], "coefficients of the numerator"),
        },
        a=a,
        b=b,
        **shown,
    )


def _by_powers(rising: list[Any], x: Any) -> Any:
    """The polynomial with these coefficients, term by term from the highest power."""
    terms = [product(c, x**k) if k else c for k, c in reversed(list(enumerate(rising))) if c != 0]
    return total(*terms) if terms else sp.Integer(0)


def _block_fractions(G: exact.TransferMatrix, form: str) -> list[tuple[Any, Any]]:
    """Each column (observable: row) of G − D over one denominator."""
    by_rows = form == "observable"

    def vector(entries: list[Any]) -> Any:
        return sp.ImmutableMatrix(1, len(entries), entries) if by_rows else sp.ImmutableMatrix(len(entries), 1, entries)

    return [
        (vector([p / q for p, q in pairs]), quotient(vector(tops), chi))
        for pairs, tops, chi in exact.common_denominators(G, by_rows=by_rows)
    ]


@lemma("realization")
def assembled(
    G: exact.TransferMatrix, found: exact.Realization, *, cancelled: bool = False, **shown: Any
) -> Derivation[None]:
    """The matrices, tested: C (xI − A)⁻¹ B + D = G."""
    x, n = G.variable, found.A.rows
    pencil = difference(product(x, sp.ImmutableMatrix(sp.eye(n))), found.A)
    dynamic = product(found.C, inverse(pencil), found.B)
    through = [] if found.D.is_zero_matrix else [found.D]
    transfer = plain(G.matrix) if cancelled else fractions(G)
    yield Step(
        "assembled",
        claims={"transfer": Claim(total(dynamic, *through), transfer, "the realization has the transfer function")},
        A=found.A,
        B=found.B,
        C=found.C,
        D=found.D,
        figures=integrators_of(found, discrete=x.name == "z"),
        **shown,
    )


def plain(M: Any) -> Any:
    """A matrix 1×1 as its entry."""
    return M[0, 0] if M.shape == (1, 1) else M


def fractions(G: exact.TransferMatrix) -> Any:
    """G, not cancelled."""
    pairs = zip(G.numerators, G.denominators, strict=True)
    return plain(sp.ImmutableMatrix([[p / q for p, q in zip(*row, strict=True)] for row in pairs]))


def proper_part(G: exact.TransferMatrix) -> Any:
    """G − D, not cancelled."""
    pairs = zip(G.strictly_proper_numerators, G.denominators, strict=True)
    return plain(sp.ImmutableMatrix([[p / q for p, q in zip(*row, strict=True)] for row in pairs]))
