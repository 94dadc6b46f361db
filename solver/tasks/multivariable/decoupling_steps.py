"""The steps of decoupling: what acts on the outputs, the law, the loop, and what is hidden in it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.arithmetic.determinants import expanded, first_line
from solver.arithmetic.factors import factors_multiplied
from solver.arithmetic.inverses import inverted
from solver.arithmetic.products import multiplied
from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, power, product, total
from solver.stated.matrices import determinant, inverse
from solver.tasks.design.frames import linear_factors
from solver.tasks.representation.plants import matrices_of
from solver.words import Phrase, Reason

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

    from solver.systems import StateSpace
    from solver.tasks.needed import WithBoth

Polynomials = Sequence[tuple["Expr", ...]]


@dataclass(frozen=True)
class Channels:
    """What acts on the outputs, and the polynomials asked for: None where nothing decouples the plant, or with a fault.

    `poles` are those of each channel.
    """

    found: exact.Interaction
    poles: tuple[tuple[Expr, ...], ...] = ()
    polynomials: tuple[tuple[Expr, ...], ...] | None = None
    fault: Reason | None = None


def channels_of(plant: StateSpace, poles: Sequence[Any] | None) -> Channels:
    """Return the channels with their poles: at the origin, of a list a channel, or of a flat list."""
    found = exact.interaction(*matrices_of(plant))
    if found.determinant == 0:
        return Channels(found)
    degrees = [r or 0 for r in found.degrees]
    listed = _by_channel(poles, degrees)
    if sum(map(len, listed)) != sum(degrees):
        values = {"degrees": degrees, "needed": sum(degrees), "count": sum(map(len, listed))}
        return Channels(found, fault=Reason("decoupling/number_of_poles", values))
    for i, (own, r) in enumerate(zip(listed, degrees, strict=True), 1):
        if len(own) != r:
            return Channels(found, fault=Reason("decoupling/poles_of_a_channel", {"i": i, "r": r, "count": len(own)}))
        if any(c.has(sp.I) for c in exact.monic(own)):
            return Channels(found, fault=Reason("decoupling/pair_apart", {"i": i}))
    return Channels(found, listed, tuple(exact.monic(own) for own in listed))


def _by_channel(poles: Sequence[Any] | None, degrees: Sequence[int]) -> tuple[tuple[Expr, ...], ...]:
    """The poles of each channel; what is too much stands in a last one."""
    if poles is None:
        return tuple((sp.S.Zero,) * r for r in degrees)
    if poles and isinstance(poles[0], tuple | list):
        return tuple(map(tuple, poles))
    flat, found = list(poles), []
    for r in degrees:
        found.append(tuple(flat[:r]))
        flat = flat[r:]
    return (*found, *([tuple(flat)] if flat else []))


@lemma("decoupling")
def interaction_of(plant: WithBoth) -> Derivation[tuple[exact.Interaction, list[Any] | None]]:
    """Differentiate each output until an input acts on it; the decoupling matrix, and whether it has an inverse.

    Also for which parameters that is different; None without parameters.
    """
    A, B, C, D = matrices_of(plant)
    if C.rows != B.cols:
        raise Unsolved("decoupling/not_square", p=C.rows, m=B.cols)
    found = exact.interaction(A, B, C, D)
    for i, channel in enumerate(found.channels, 1):
        yield _differentiated(i, channel, plant)
    E, det = found.matrix, found.determinant
    names = [_entry_name(i, r) for i, r in enumerate(found.degrees, 1)]
    yield Step(
        "matrix",
        claims={"determinant": Claim(determinant(E), det, "determinant of the decoupling matrix"), **_written_out(E)},
        steps=expanded(E, exact.multiplied_out(det)) if _is_work(E) else (),
        E=E,
        degrees=found.degrees,
        feasible=det != 0,
        discrete=plant.discrete,
        names=names,
        rows=[(name, channel.entry) for name, channel in zip(names, found.channels, strict=True) if name != "0"],
    )
    exceptions = None
    if E.free_symbols or any(channel.last.free_symbols for channel in found.channels):
        exceptions = list(exact.interaction_conditions(found))
        yield Step("exceptions", unclaimed="the conditions are checked with the answers", exceptions=exceptions,
                   feasible=det != 0)  # fmt: skip
    if det == 0:
        yield _infeasible(found, (A, B, C, D))
    return found, exceptions


def _entry_name(i: int, r: int | None) -> str:
    """What stands in row i of B*."""
    if r is None:
        return "0"
    power_of = {1: "", 2: "A"}.get(r, rf"A^{{{r - 1}}}")
    return f"d_{{{i}}}" if r == 0 else f"c_{{{i}}}{power_of}B"


def _is_work(E: ImmutableMatrix) -> bool:
    """Whether a determinant has more in it than two products with a factor of one."""
    return E.rows > 2 or any(
        0 not in pair and not {1, -1} & set(pair) for pair in ((E[0], E[-1]), (E[1 % len(E)], E[-2 % len(E)]))
    )


def _written_out(E: ImmutableMatrix) -> dict[str, Claim]:
    """The first line of a determinant, where there is something to multiply."""
    if not 2 <= E.rows <= 4 or any(E.row(i).is_zero_matrix for i in range(E.rows)):
        return {}
    return {"stated": Claim(determinant(E), first_line(E), "the determinant multiplied out")}


def _differentiated(i: int, channel: exact.Channel, plant: WithBoth) -> Step:
    """The rows c, cA, … and what of the inputs acts on the output, until it is not zero."""
    claims: dict[str, Claim] = {}
    lines: list[tuple[str, str]] = []
    for k, acts in enumerate(channel.reached):
        if k:
            claims[f"row{k}"] = Claim(product(channel.rows[k - 1], plant.A), channel.rows[k], Phrase("$c_i A^k$"))
        claims[f"acts{k}"] = Claim(product(channel.rows[k], plant.B), acts, Phrase("$c_i A^k B$"))
        lines.append((f"row{k}" if k else "", f"acts{k}"))
    return Step(
        "differentiated",
        claims=claims,
        unclaimed="" if claims else "the row of D as it is given",
        i=i,
        c=channel.rows[0],
        d=channel.entry if channel.degree == 0 else None,
        r=channel.degree,
        lines=lines,
        n=plant.order,
        discrete=plant.discrete,
    )


def _infeasible(found: exact.Interaction, matrices: tuple[ImmutableMatrix, ...]) -> Step:
    """A combination of the rows of B* that is zero; and whether a compensator with states of its own would do."""
    E = found.matrix
    w = sp.ImmutableMatrix(exact.null_basis(sp.ImmutableMatrix(E.T)).T.row(0))
    zero = sp.ImmutableMatrix(sp.zeros(1, E.cols))
    never = [i for i, r in enumerate(found.degrees, 1) if r is None]
    return Step(
        "infeasible",
        claims={} if never else {"combination": Claim(product(w, E), zero, Phrase("the rows are dependent"))},
        unclaimed="the rows of zeros are checked above" if never else "",
        w=w,
        never=never,
        dynamic=exact.dynamically_decouplable(*matrices),
    )


@lemma("decoupling")
def polynomials_of(
    plant: WithBoth, found: exact.Interaction, poles: Sequence[Any] | None, x: Symbol
) -> Derivation[Polynomials]:
    """The polynomials of the channels, and the rows c α(A)."""
    own = channels_of(plant, poles)
    if own.fault is not None or own.polynomials is None:
        fault = own.fault or Reason("decoupling/number_of_poles", {})
        raise Unsolved(fault.kind, **fault.values)
    rows = exact.decoupling_law(found, own.polynomials).rows
    claims: dict[str, Claim] = {}
    steps: tuple[Step, ...] = ()
    for i, (channel, listed, wanted) in enumerate(zip(found.channels, own.poles, own.polynomials, strict=True), 1):
        polynomial = exact.polynomial_in(x, wanted)
        claims[f"alpha{i}"] = Claim(linear_factors(x, listed), polynomial, Phrase("polynomial of channel {i}", i=i))
        terms = [product(a, row) for a, row in zip(wanted, reversed(channel.rows), strict=True) if a != 0]
        claims[f"row{i}"] = Claim(total(*terms), sp.ImmutableMatrix(rows.row(i - 1)), Phrase("row {i}", i=i))
        steps += factors_multiplied(x, listed)
    yield Step(
        "rows",
        claims=claims,
        steps=steps,
        x=x,
        given=poles is not None,
        degrees=found.degrees,
        coefficients=own.polynomials,
        lasts=[channel.last for channel in found.channels],
        simple=[all(a == 0 for a in wanted[1:]) for wanted in own.polynomials],
        discrete=plant.discrete,
    )
    return own.polynomials


@lemma("decoupling")
def law_of(
    plant: WithBoth, found: exact.Interaction, polynomials: Polynomials, x: Symbol
) -> Derivation[exact.DecouplingLaw]:
    """F = B*⁻¹ and K = F times the rows."""
    law = exact.decoupling_law(found, tuple(polynomials))
    E = found.matrix
    identity = bool(sp.eye(E.rows) == E)
    claims = {
        "F": Claim(inverse(E), law.F, "inverse of the decoupling matrix"),
        "K": Claim(product(law.F, law.rows), law.K, "gain of the feedback"),
    }
    steps = inverted("(B^{*})", E, law.F) + (() if identity else multiplied(law.F, law.rows, law.K))
    yield Step("law", claims=claims, steps=steps, E=E, rows=law.rows, K=law.K, F=law.F, identity=identity, x=x,
               discrete=plant.discrete)  # fmt: skip
    return law


@lemma("decoupling")
def closed_loop_of(
    plant: WithBoth, law: exact.DecouplingLaw, polynomials: Polynomials, x: Symbol
) -> Derivation[tuple[ImmutableMatrix, ImmutableMatrix]]:
    """A − BK, and the transfer matrix from v to y, which is diagonal."""
    A, B, C, D = matrices_of(plant)
    loop, seen = exact.added(A, -B * law.K), exact.added(C, -D * law.K)
    inputs, direct = exact.added(B * law.F), exact.added(D * law.F)
    G = sp.ImmutableMatrix(sp.diag(*(1 / exact.polynomial_in(x, wanted) for wanted in polynomials)))
    pencil = difference(product(x, sp.ImmutableMatrix(sp.eye(A.rows))), loop)
    terms = [product(seen, inverse(pencil), inputs), *([] if direct.is_zero_matrix else [direct])]
    claims = {
        "loop": Claim(difference(A, product(B, law.K)), loop, "closed loop"),
        "inputs": Claim(product(B, law.F), inputs, "inputs of the closed loop"),
        "G": Claim(total(*terms), G, "decoupled transfer matrix"),
    }
    if not D.is_zero_matrix:
        claims["seen"] = Claim(difference(C, product(D, law.K)), seen, "output of the closed loop")
        claims["direct"] = Claim(product(D, law.F), direct, "direct path of the closed loop")
    at_origin = all(a == 0 for wanted in polynomials for a in wanted[1:]) and any(len(each) > 1 for each in polynomials)
    yield Step("loop", claims=claims, x=x, loop=loop, G=G, m=C.rows, at_origin=at_origin, discrete=plant.discrete)
    return loop, G


@lemma("decoupling")
def hidden_motion_of(
    plant: WithBoth, found: exact.Interaction, loop: ImmutableMatrix, polynomials: Polynomials, x: Symbol
) -> Derivation[None]:
    """The modes of the loop that no channel shows, which are zeros of the plant; and whether they decay."""
    n, shown = plant.order, found.derivatives.rows
    motion = exact.hidden_motion(found, loop)
    if motion is None:
        yield Step("all_shown", unclaimed="counted", n=n, degrees=[r or 0 for r in found.degrees])
        return
    H, lamda = motion.H, sp.Symbol("lamda")
    placed, condition = _places(H, discrete=plant.discrete)
    zero = sp.ImmutableMatrix(sp.zeros(shown, H.rows))
    claims = {"moves": Claim(product(loop, motion.N), product(motion.N, H), "the motion that no output shows")}
    if shown:
        claims["unseen"] = Claim(product(found.derivatives, motion.N), zero, "states that no output shows")
    if H.rows > 1:
        claims["polynomial"] = Claim(determinant(exact.pencil(H, lamda)), exact.factored(H, lamda), "hidden modes")
    hidden = exact.faddeev_leverrier(H).characteristic_polynomial(x)
    factors = Counter(exact.polynomial_in(x, each) for each in polynomials if len(each) > 1)
    shown_too = product(*(power(p, k) for p, k in factors.items()), hidden)
    claims["all"] = Claim(determinant(exact.pencil(loop, x)), shown_too, "poles of the closed loop")
    positions = [each.position for each in placed or ()]
    yield Step("hidden", claims=claims, N=motion.N, H=H, k=H.rows, n=n, shown=shown, Q=found.derivatives, x=x)
    yield Step(
        "decay",
        unclaimed="the hidden modes are checked above",
        placed=None if placed is None else [(each.root, each.position) for each in placed],
        unstable=any(position is not None and position >= 0 for position in positions),
        grows=1 in positions,
        open=placed is None or None in positions,
        condition=condition,
        k=H.rows,
        discrete=plant.discrete,
    )


def _places(H: ImmutableMatrix, *, discrete: bool) -> tuple[Any, Any]:
    """The hidden modes with their places, and for which parameters all decay; None where neither can be told."""
    try:
        placed = exact.location(H, discrete=discrete).placed
        conditions = [
            c for f in exact.spectrum(H).factors for c in exact.root_conditions(f.coefficients, discrete=discrete)
        ]
    except exact.NotExact:
        return None, None
    return placed, exact.all_positive(conditions) if any(each.position is None for each in placed) else None
