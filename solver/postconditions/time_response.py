"""Inputs read piece by piece, delays, and what is said of the long run."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
import sympy as sp

from solver.derivation import Check, Claim
from solver.postconditions.linear_algebra import factor_claims


def of_read_inputs(found: Sequence[Any], inputs: Sequence[Any], time: Any, *, discrete: bool) -> Iterator[Claim]:
    """What begins at each time is what the inputs hold with a step, or an impulse, at that time."""
    if discrete:
        yield from _samples_of_inputs(found, inputs, time)
        return
    smooth = {sp.Heaviside: lambda *_: sp.S.One, sp.DiracDelta: lambda *_: sp.S.Zero}
    whole, parts = sp.ImmutableMatrix(list(inputs)), sp.zeros(len(inputs), 1)
    impulses = {piece.delay: piece.impulses for piece in found}
    for piece in found:
        parts += piece.inputs.xreplace({time: time - piece.delay})
        if piece.delay != 0:
            step = sp.Heaviside(time - piece.delay)
            begins = [sp.expand(u).coeff(step) for u in inputs]
            yield Claim(sp.ImmutableMatrix(begins), piece.inputs.xreplace({time: time - piece.delay}))
    for kind, value in smooth.items():
        whole = whole.applyfunc(lambda u, kind=kind, value=value: u.replace(kind, value))
    yield Claim(whole, sp.ImmutableMatrix(parts))
    at = {each.args[0] for u in inputs for each in u.atoms(sp.DiracDelta)}
    for argument in at | {time - delay for delay in impulses}:
        weights = [sp.expand(u).coeff(sp.DiracDelta(argument)) for u in inputs]
        own = impulses.get(sp.expand(time - argument), sp.zeros(len(inputs), 1))
        yield Claim(sp.ImmutableMatrix(weights), sp.ImmutableMatrix(own))


def _samples_of_inputs(found: Sequence[Any], inputs: Sequence[Any], k: Any) -> Iterator[Claim]:
    """The pieces add up to the inputs at the samples around zero and around each start."""
    sampled = {sp.Heaviside: lambda at, *_: sp.Heaviside(at, 1), sp.DiracDelta: lambda at: sp.KroneckerDelta(at, 0)}
    whole, parts = sp.ImmutableMatrix(list(inputs)), sp.zeros(len(inputs), 1)
    for kind, value in sampled.items():
        whole = whole.applyfunc(lambda u, kind=kind, value=value: u.replace(kind, value))
    for piece in found:
        parts += piece.inputs.xreplace({k: k - piece.delay}) * sp.Heaviside(k - piece.delay, 1)
    starts = {0, *(int(piece.delay) for piece in found)}
    for sample in sorted({max(0, start + i) for start in starts for i in range(-1, 6)}):
        at = {k: sp.Integer(sample)}
        yield Claim(sp.ImmutableMatrix(whole.subs(at)), sp.ImmutableMatrix(parts.subs(at)))


def of_shifted(found: Any, f: Any, t: Any, delay: Any, *, discrete: bool = False) -> Iterator[Claim | Check]:
    """f(t − T) after T, zero before."""
    later = f.xreplace({t: t - delay})
    yield Claim(found.replace(sp.Heaviside, lambda *_: sp.S.One), sp.ImmutableMatrix(later))
    if delay != 0:
        step = sp.Heaviside(t - delay, 1) if discrete else sp.Heaviside(t - delay)
        before = found.xreplace({step: sp.S.Zero}).replace(sp.KroneckerDelta, lambda *_: sp.S.Zero)
        yield Claim(sp.ImmutableMatrix(before), sp.ImmutableMatrix(sp.zeros(*f.shape)))
        yield Check.that("the step of a delay", "compared", found.atoms(sp.Heaviside) <= {step})


def of_decays(found: bool, factor: Any, *, discrete: bool) -> Iterator[Check]:
    """All roots of the factor inside, where they are numbers."""
    c = factor.coefficients
    if not any(each.free_symbols for each in c):
        roots = np.roots([complex(each) for each in c])
        sizes = abs(roots) - 1 if discrete else roots.real
        near = bool(np.any(abs(sizes) < 1e-9))
        yield Check.that("modes that die out", "numpy.roots", bool(np.all(sizes < 0) and not near) == found)


def of_constant_root(found: bool, factor: Any, *, discrete: bool) -> Iterator[Check]:
    """The factor is x (in discrete time x − 1)."""
    constant = list(factor.coefficients) == [1, -1 if discrete else 0]
    yield Check.that("a constant mode", "coefficients", constant == found)


def of_horizon(found: Any, *_: Any, **__: Any) -> Iterator[Check]:
    """Time goes on; how long a plot shows it is a free choice."""
    if found is not None:
        yield Check.that("the end of a plot", "positive", bool(found > 0))


def of_response(found: Any, *_: Any) -> Iterator[Claim]:
    """The roots of each factor of the transforms."""
    for _delay, each in found.pieces:
        for image in (each.x, each.y):
            for factor in () if image is None else image.factors:
                yield from factor_claims(factor)
