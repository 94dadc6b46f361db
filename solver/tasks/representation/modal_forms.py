"""State equations on the modes of a transfer function: diagonal, Jordan and modal form."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated import Stated
from solver.stated.algebra import difference, power, product, quotient, total
from solver.stated.calculus import derivative, value_at
from solver.tasks.representation.realization_lemmas import assembled, plain, proper_part
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Symbol


@lemma("modal_forms")
def mode_form_of(
    G: exact.TransferMatrix, form: str, *, superdiagonal: bool, discrete: bool
) -> Derivation[exact.Realization]:
    """Poles, residues, one state (a chain, a pair) for each pole."""
    x, siso = G.variable, G.shape == (1, 1)
    modes = exact.modes(G)
    distinct = [(mode.root.value, mode.multiplicity) for mode in modes]
    yield Step(
        "poles",
        claims={"poles": Claim(G.chi, product(*(power(x - p, m) for p, m in distinct)), "poles with multiplicity")},
        x=x,
        poles=distinct,
        factored=G.chi_factored,
        decimals=any(mode.root.kind == "decimal" for mode in modes),
        complex=any(mode.root.kind in ("complex", "decimal") and mode.root.shift != 0 for mode in modes),
    )
    if form == "diagonal":
        _refuse_chains(modes, x)
    yield from residues_of(G, modes)
    if form == "diagonal":
        found = exact.diagonal_realization(G)
    elif form == "jordan":
        found = exact.jordan_realization(G, superdiagonal=superdiagonal)
    else:
        yield from _real_pairs(G, modes)
        found = exact.modal_realization(G, superdiagonal=superdiagonal)
    shown = {"x": x, "n": found.A.rows, "form": form, "discrete": discrete, "siso": siso, "sizes": found.sizes}
    yield Step(
        "states",
        unclaimed="the choice of the states is a definition; the matrices are tested below",
        chains=form != "diagonal" and any(mode.multiplicity > 1 for mode in modes),
        hidden=any(all(R.is_zero_matrix for R in mode.residues) for mode in modes),
        superdiagonal=superdiagonal,
        pairs=form == "modal"
        and any(mode.root.kind in ("complex", "decimal") and mode.root.shift != 0 for mode in modes),
        complex=form != "modal" and any(mode.root.value.has(sp.I) for mode in modes),
        undecided=form == "modal" and any(mode.root.kind == "symbolic" and mode.root.shift != 0 for mode in modes),
        **shown,
    )
    yield from assembled(G, found, first=False, **shown)
    return found


def _refuse_chains(modes: Sequence[exact.Mode], x: Symbol) -> None:
    """A pole that occurs in a higher power of (x − p)⁻¹ has no diagonal block."""
    for mode in modes:
        if not mode.simple:
            raise Unsolved(
                "realization/repeated_pole", variable=x, pole=mode.root.value, multiplicity=mode.multiplicity
            )


@lemma("modal_forms")
def residues_of(G: exact.TransferMatrix, modes: Sequence[exact.Mode]) -> Derivation[None]:
    """G − D as a sum of rⱼ/(x − p)ʲ, and how each rⱼ is found."""
    x, siso = G.variable, G.shape == (1, 1)
    terms = [
        quotient(plain(R), power(x - mode.root.value, j))
        if siso
        else product(quotient(1, power(x - mode.root.value, j)), R)
        for mode in modes
        for j, R in enumerate(mode.residues, 1)
        if not R.is_zero_matrix
    ]
    formulas = _residue_formulas(G, modes) if siso else {}
    yield Step(
        "partial_fractions",
        claims={
            **formulas,
            "sum": Claim(proper_part(G), total(*terms) if terms else proper_part(G), "partial fractions"),
        },
        x=x,
        siso=siso,
        formulas=list(formulas),
        through=not G.direct.is_zero_matrix,
        repeated=any(mode.multiplicity > 1 for mode in modes),
        vanishing=[mode.root.value for mode in modes if all(R.is_zero_matrix for R in mode.residues)],
        ranks=[] if siso else [(mode.root.value, mode.rank) for mode in modes if mode.multiplicity == 1],
    )


def _residue_formulas(G: exact.TransferMatrix, modes: Sequence[exact.Mode]) -> dict[str, Claim]:
    """Rⱼ = (1/(m − j)!) d^{m−j}/dx^{m−j} (x − p)ᵐ(G − D) at x = p."""
    x, N = G.variable, G.strictly_proper_numerators[0][0]
    claims: dict[str, Claim] = {}
    for i, mode in enumerate(modes, 1):
        p, m = mode.root.value, mode.multiplicity
        others = [power(x - other.root.value, other.multiplicity) for other in modes if other is not mode]
        covered: Any = quotient(N, product(*others)) if others else N
        for j, R in enumerate(mode.residues, 1):
            times = m - j
            inner = derivative(covered, x, times) if times else covered
            left: Stated = value_at(inner, x, p)
            if times > 1:
                left = product(sp.Rational(1, sp.factorial(times)), left)
            name = f"r_{{{i}}}" if m == 1 else f"r_{{{i},{j}}}"
            claims[name] = Claim(left, plain(R), Phrase("residue ${name}$", name=name))
    return claims


@lemma("modal_forms")
def _real_pairs(G: exact.TransferMatrix, modes: Sequence[exact.Mode]) -> Derivation[None]:
    """The two terms of a simple conjugate pair, added: a real fraction of second order."""
    x = G.variable
    if G.shape != (1, 1):
        return
    for mode in modes:
        root = mode.root
        if root.kind not in ("complex", "decimal") or mode.multiplicity > 1 or not exact.is_upper(mode):
            continue
        r = mode.residues[0][0, 0]
        alpha, beta = exact.real_and_imaginary(r)
        both = total(quotient(r, x - root.value), quotient(alpha - sp.I * beta, x - (root.sigma - sp.I * root.shift)))
        real = quotient(
            difference(product(2 * alpha, difference(x, root.sigma)), product(2 * beta, root.shift)),
            total(power(x - root.sigma, 2), power(root.shift, 2)),
        )
        yield Step(
            "real_pair",
            claims={"pair": Claim(both, real, "conjugate terms added")},
            x=x,
            sigma=root.sigma,
            omega=root.shift,
            alpha=alpha,
            beta=beta,
        )
