"""A system in coordinates that keep its parts apart: the new matrices, the hidden modes, the transfer function."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import accumulate
from typing import TYPE_CHECKING, Any

from solver.arithmetic.coordinates import in_coordinates
from solver.derivation import Claim, Derivation, Step, lemma
from solver.derivation.figures import Part, Parts
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated import Stated
from solver.stated.algebra import difference, product, quotient, total
from solver.stated.matrices import determinant, inverse, partitioned
from solver.words import formula

if TYPE_CHECKING:
    from sympy import ImmutableMatrix


@lemma("parts")
def parts_of(plant: Any, found: exact.Decomposition, part: str) -> Derivation[None]:
    """T⁻¹AT, T⁻¹B, CT with lines between the parts, what is hidden, and the transfer function if there is one."""
    yield _transformed(plant, found, part)
    yield Step("blocks", unclaimed="the blocks are read off from the matrices", part=part, found=found,
               figures=_boxes(found, part))  # fmt: skip
    yield _hidden(plant, found, part)
    if plant.B is not None and plant.C is not None:
        yield _transfer(plant, found, part)


PLACES = {"full": ((0, 0), (0, 1), (1, 0), (1, 1)), "controllable": ((0, 0), (1, 0)), "observable": ((0, 0), (0, 1))}
NAMES = {
    "full": ("controllable and observable", "controllable only", "observable only", "neither"),
    "controllable": ("controllable", "not controllable"),
    "observable": ("observable", "not observable"),
}


def _boxes(found: exact.Decomposition, part: str) -> tuple[Parts, ...]:
    """The parts that have states, as boxes; none where their modes depend on parameters."""
    present = [i for i, order in enumerate(found.orders) if order]
    if any(mode.free_symbols for i in present for mode in found.modes(i)):
        return ()
    boxes = [
        Part(
            NAMES[part][i],
            tuple(map(formula, found.modes(i))),
            PLACES[part][i],
            _acts(found.input_block(i)),
            _acts(found.output_block(i)),
            tuple(k for k, j in enumerate(present) if j != i and _acts(found.block(j, i))),
        )
        for i in present
    ]
    return (Parts("The parts, their modes, and what acts on what", tuple(boxes)),)


def _acts(block: ImmutableMatrix | None) -> bool:
    return block is not None and not block.is_zero_matrix


def _lined(M: ImmutableMatrix, rows: Sequence[int], columns: Sequence[int]) -> Stated:
    """M with lines between blocks of the given sizes."""
    return partitioned(M, tuple(accumulate(rows)), tuple(accumulate(columns)))


def _transformed(plant: Any, found: Any, part: str) -> Step:
    """A, B and C in the new coordinates."""
    T, sizes = found.T, found.orders
    claims = {
        "A": Claim(product(found.T_inverse, plant.A, T), _lined(found.A, sizes, sizes), "$T^{-1}AT$"),
    }
    if plant.B is not None:
        claims["B"] = Claim(product(found.T_inverse, plant.B), _lined(found.B, sizes, ()), "$T^{-1}B$")
    if plant.C is not None:
        claims["C"] = Claim(product(plant.C, T), _lined(found.C, (), sizes), "$CT$")
    D = None if plant.D is None or plant.D.is_zero_matrix else plant.D
    lines = in_coordinates(T, found.T_inverse, plant.A, plant.B, plant.C, inverse_too=False)
    return Step("transformed", claims=claims, steps=lines, part=part, D=D, changes=found.changes)


def _hidden(plant: Any, found: exact.Decomposition, part: str) -> Step:
    """The eigenvalues of the hidden parts, and whether they are stable."""
    x = sp.Symbol("lamda")
    claims, modes = {}, {}
    for i in range(1, len(found.orders)):
        if found.orders[i]:
            modes[i] = found.modes(i)
            pencil = difference(product(x, sp.ImmutableMatrix(sp.eye(found.orders[i]))), found.block(i, i))
            roots = product(*(x - mode for mode in modes[i]))
            claims[f"part{i}"] = Claim(determinant(pencil), roots, "eigenvalues of the hidden part")
    stable = {mode: _is_stable(mode, plant.discrete) for mode in found.hidden_modes}
    return Step(
        "hidden",
        claims=claims,
        part=part,
        modes=modes,
        unstable={i: [mode for mode in own if stable[mode] is False] for i, own in modes.items()},
        undecided=[mode for mode, known in stable.items() if known is None],
        discrete=plant.discrete,
    )


def _is_stable(mode: Any, discrete: bool) -> bool | None:
    """Whether Re λ < 0 (discrete: |λ| < 1); None where parameters leave it open."""
    if not mode.free_symbols:
        return bool(sp.N(sp.Abs(mode) - 1 if discrete else sp.re(mode), 30) < -1e-20)
    real, imaginary = exact.complex_parts(mode)
    sign = exact.sign_of(sp.expand(real**2 + imaginary**2 - 1) if discrete else real)
    return None if sign is None else sign < 0


def _transfer(plant: Any, found: exact.Decomposition, part: str) -> Step:
    """The transfer function of the whole plant and of its first part."""
    x = sp.Symbol("z" if plant.discrete else "s")
    D = plant.D if plant.D is not None else sp.ImmutableMatrix(sp.zeros(plant.C.rows, plant.B.cols))
    G = exact.transfer_matrix(plant.A, plant.B, plant.C, D, x).matrix
    whole = _formula(plant.A, plant.B, plant.C, D, x)
    first = _formula(found.block(0, 0), found.input_block(0), found.output_block(0), D, x)
    claims = {
        "first": Claim(first, G, "transfer function of the first part"),
        "whole": Claim(whole, G, "transfer function of the plant"),
    }
    if found.orders[0] and G.shape == (1, 1):
        own = exact.transfer_matrix(found.block(0, 0), found.input_block(0), found.output_block(0), D, x)
        stated = quotient(own.numerators[0][0], own.chi)
        claims["quotient"] = Claim(first, stated, "transfer function of the first part, not cancelled")
    return Step(
        "transfer",
        claims=claims,
        part=part,
        G=G if G.shape != (1, 1) else G[0, 0],
        x=x,
        order=found.orders[0],
        D=None if D.is_zero_matrix else D,
    )


def _formula(A: ImmutableMatrix, B: Any, C: Any, D: ImmutableMatrix, x: Any) -> Stated:
    """C (xI − A)⁻¹ B + D as it stands; D alone where there is no state."""
    if not A.rows:
        return total(D)
    pencil = difference(product(x, sp.ImmutableMatrix(sp.eye(A.rows))), A)
    return total(product(C, inverse(pencil), B), *([] if D.is_zero_matrix else [D]))
