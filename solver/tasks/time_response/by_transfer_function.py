"""Responses from rest by the transfer function alone, as lemmas: Y = G U and back, or y = g ∗ u."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.arithmetic.integrals import integrated
from solver.arithmetic.sums import added_up
from solver.derivation import Claim, Derivation, Given, Step, lemma
from solver.lazy import exact, systems
from solver.lazy import sympy as sp
from solver.stated.algebra import product, quotient, total
from solver.stated.calculus import integral
from solver.stated.lists import summation
from solver.tasks.time_response.by_transform import input_transform, transformed_back
from solver.tasks.time_response.dead_time import dead_time_apart
from solver.tasks.time_response.question import Question, entry_or_column

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

    from solver.tasks.time_response.question import Moving
    from solver.tasks.time_response.response import ResponseOptions


@lemma("response_transfer")
def apart_from_dead_time(given: Given[Moving, ResponseOptions]) -> Derivation[None]:
    """The dead time of a transfer function, where it has one, makes the input come later."""
    if isinstance(given.system, systems.DeadTime):
        yield from dead_time_apart(given.system)


@lemma("response_transfer")
def output_by_transform(asked: Question, G: ImmutableMatrix) -> Derivation[None]:
    """Y = G U, transformed back, piece by piece."""
    yield Step(
        "transformed_output",
        unclaimed="the definition of the transfer function",
        detail="full",
        discrete=asked.discrete,
        G=_name_of(asked),
    )
    for number, piece in enumerate(asked.pieces, 1):
        again = _begun_before(asked, number)
        if again is not None:
            yield again
        else:
            yield from _output_to(asked, G, piece, str(number) if len(asked.pieces) > 1 else "")


def _begun_before(asked: Question, number: int) -> Step | None:
    """The output to a piece that is a multiple of an earlier one, but later: nothing is to be transformed again."""
    piece = asked.pieces[number - 1]
    for i, earlier in enumerate(asked.pieces[: number - 1], 1):
        factor = _multiple(piece, earlier)
        if factor is None:
            continue
        before, now = (asked.begun(asked.function(asked.output(each)), each.delay) for each in (earlier, piece))
        later = sp.expand(piece.delay - earlier.delay)
        t = asked.time
        moved = before.xreplace({t: t - later}) if earlier.delay != 0 else asked.begun(before, later)
        return Step(
            "again",
            claims={"y": Claim(product(factor, moved), now, "the earlier output, later")},
            discrete=asked.discrete,
            delay=piece.delay,
            factor=factor,
            later=later,
            before=str(i),
            part=str(number),
            late=earlier.delay != 0,
        )
    return None


def _multiple(piece: exact.Piece, earlier: exact.Piece) -> Any:
    """The factor by which an earlier piece gives this one; None if there is none."""
    now, before = ([*each.inputs.flat(), *each.impulses.flat()] for each in (piece, earlier))
    first = next((i for i, entry in enumerate(before) if entry != 0), None)
    if first is None:
        return None
    factor = sp.cancel(now[first] / before[first])
    constant = not factor.free_symbols & {sp.Symbol("t"), sp.Symbol("k")} and factor != 0
    alike = constant and all(sp.expand(a - factor * b) == 0 for a, b in zip(now, before, strict=True))
    return factor if alike else None


def _name_of(asked: Question) -> str:
    """The index of the rational factor where there is a dead time beside it."""
    return "0" if asked.late else ""


def _strictly(asked: Question) -> str:
    """The index of what is left where a constant is divided out."""
    D = asked.system.D
    through = D is not None and not D.is_zero_matrix
    return str(int(asked.late)) if through else _name_of(asked)


def _output_to(asked: Question, G: ImmutableMatrix, piece: exact.Piece, part: str) -> Derivation[None]:
    """G(s) U(s) for one piece of the input, and its function of time."""
    s, image = asked.variable, asked.output(piece)
    U = piece.image(s, discrete=asked.discrete)
    yield from input_transform(asked, piece, U)
    passed = _passed_on(asked, piece)
    column = image.expression(s) if passed is None else sp.ImmutableMatrix(image.expression(s) + passed)
    factored = _factored(asked, G)
    divided = quotient(U, s) if asked.discrete else U
    carried = sp.ImmutableMatrix(U / s) if asked.discrete else U
    yield Step(
        "output_transform",
        claims={"image": Claim(product(G, divided), column, "transform of the output")},
        U=U,
        whole=sp.ImmutableMatrix(column * s),
        discrete=asked.discrete,
        shown=product(entry_or_column(factored), entry_or_column(carried)),
        G=_name_of(asked),
        part=part,
        delay=piece.delay,
    )
    yield from transformed_back(asked, image, column, part, piece.delay, "y")


def _factored(asked: Question, G: ImmutableMatrix) -> ImmutableMatrix:
    """G, each entry in lowest terms over the irreducible factors of its denominator."""
    found: ImmutableMatrix = exact.weighting(asked.system).expression(asked.variable)
    D = asked.system.D
    return found if D is None or D.is_zero_matrix else G


def _passed_on(asked: Question, piece: exact.Piece) -> ImmutableMatrix | None:
    """D times the impulses of a piece in continuous time; None where that is nothing."""
    D = asked.system.D
    if D is None or asked.discrete:
        return None
    through = sp.ImmutableMatrix(D * piece.impulses)
    return None if through.is_zero_matrix else through


@lemma("response_transfer")
def output_by_convolution(asked: Question, G: ImmutableMatrix) -> Derivation[None]:
    """The weighting function g, and y = g ∗ u, piece by piece."""
    s, system = asked.variable, asked.system
    through = system.D is not None and not system.D.is_zero_matrix
    yield Step(
        "convolution_formula",
        unclaimed="the general formula, derived in the text",
        detail="full",
        discrete=asked.discrete,
        through=through,
        G=_name_of(asked),
    )
    image = exact.weighting(system)
    strictly = image.expression(s)
    if through:
        apart = [entry_or_column(sp.ImmutableMatrix(part)) for part in (system.D, strictly)]
        yield Step(
            "direct",
            claims={"G": Claim(entry_or_column(G), total(*apart), "constant part apart")},
            discrete=asked.discrete,
            D=system.D,
            G=_name_of(asked),
            rest=_strictly(asked),
        )
    yield from transformed_back(asked, image, strictly, _strictly(asked), 0, "g")
    g = asked.function(image)
    for number, piece in enumerate(asked.pieces, 1):
        again = _begun_before(asked, number)
        yield again or _convolved(asked, piece, g, str(number) if len(asked.pieces) > 1 else "")


def _convolved(asked: Question, piece: exact.Piece, g: ImmutableMatrix, part: str) -> Step:
    """The integral of g(t − τ) u(τ), in discrete time the sum of g(k − i) u(i), and what D passes on."""
    t, D = asked.time, asked.system.D
    y = asked.function(asked.output(piece))
    names: dict[str, Any] = {
        "discrete": asked.discrete,
        "delay": piece.delay,
        "part": part,
        "through": None if D is None or D.is_zero_matrix else D,
        "g": _strictly(asked),
        "shifted": asked.begun(y, piece.delay),
        "single": len(y) == 1,
    }
    direct: list[Any] = [product(D, piece.inputs)] if names["through"] is not None and any(piece.inputs.flat()) else []
    if asked.discrete:
        i = sp.Symbol("i")
        u = piece.inputs.xreplace({t: i})
        stated = summation(product(g.xreplace({t: t - 1 - i}), u), i, sp.Integer(0), t - 1)
        claims = {"y": Claim(total(stated, *direct), y, "convolution sum")}
        summand = sp.ImmutableMatrix(g.xreplace({t: t - 1 - i}) * u)
        worked_out = added_up(summand, i, t, _without(y, D, piece) if direct else y)
        return Step("convolution_sum", claims=claims, steps=worked_out, u=u, **names)
    tau = sp.Symbol("tau")
    u = piece.inputs.xreplace({t: tau})
    integrand = sp.ImmutableMatrix((g.xreplace({t: t - tau}) * u).applyfunc(sp.expand_mul))
    acting = any(u.flat()) or not piece
    terms: list[Any] = [integral(integrand, tau, sp.Integer(0), t)] if acting else []
    passed = _passed_on(asked, piece)
    if any(piece.impulses.flat()):
        terms.append(product(g, piece.impulses))
    claims = {"y": Claim(total(*terms, *direct), y, "convolution")}
    if acting:
        claims = {"integrand": Claim(product(g.xreplace({t: t - tau}), u), integrand, "what is integrated"), **claims}
    integrated_alone = _without(y, D, piece) if direct else y
    whole = acting and len(terms) == 1
    worked_out = integrated(integrand, tau, sp.Integer(0), t, integrated_alone) if whole else ()
    return Step(
        "convolution", claims=claims, steps=worked_out, tau=tau, u=u, impulses=piece.impulses, dropped=passed, **names
    )


def _without(y: ImmutableMatrix, D: Any, piece: exact.Piece) -> ImmutableMatrix:
    """The output less what is passed on to it directly."""
    return sp.ImmutableMatrix((y - D * piece.inputs).applyfunc(sp.expand))
