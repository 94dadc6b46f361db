"""Formulas by which answers of several tasks follow from others."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from solver.lazy import exact
from solver.lazy import sympy as sp

if TYPE_CHECKING:
    from solver.derivation import Given

Found = Mapping[str, Any]


def closed_loop(given: Given[Any, Any], found: Found) -> Any:
    """A − BK."""
    return sp.ImmutableMatrix(given.system.A - given.system.B * found["K"])


def error_matrix(given: Given[Any, Any], found: Found) -> Any:
    """A − LC."""
    return sp.ImmutableMatrix(given.system.A - found["L"] * given.system.C)


def polynomial_of(name: str) -> Callable[[Given[Any, Any], Found], Any]:
    """Return the formula det(xI − M) for the answer M, x = s or z."""

    def polynomial(given: Given[Any, Any], found: Found) -> Any:
        x = sp.Symbol("z" if given.system.discrete else "s")
        return exact.faddeev_leverrier(found[name]).characteristic_polynomial(x)

    return polynomial


def eigenvalues_of(name: str) -> Callable[[Given[Any, Any], Found], Any]:
    """Return the formula for the eigenvalues of the answer of this name."""

    def eigenvalues(_given: Given[Any, Any], found: Found) -> Any:
        try:
            return exact.spectrum(found[name]).eigenvalues
        except exact.NotExact:  # roots beside parameters
            return None

    return eigenvalues


def words_of_definiteness(_given: Given[Any, Any], found: Found) -> Any:
    """What each solution of a Riccati equation is; None with parameters."""
    solutions = found["solutions"]
    if any(P.free_symbols for P in solutions):
        return None
    return [exact.definiteness_of_numbers(P) for P in solutions]


def reference_gain(given: Given[Any, Any], found: Found) -> Any:
    """K_o = N + K F, K the answer or the gain given."""
    K = found.get("K", given.options.gain)
    return sp.ImmutableMatrix(found["N"] + K * found["F"])


def state_of_rest(given: Given[Any, Any], found: Found) -> Any:
    """F from A F + B N = 0 (discrete: A − I), where that has one solution."""
    plant = given.system
    rest = exact.at_rest(plant.A, discrete=plant.discrete)
    return None if exact.is_singular(rest) else sp.ImmutableMatrix(-exact.inverse(rest) * plant.B * found["N"])


def modes_decay(given: Given[Any, Any], found: Found) -> bool | None:
    """Whether all hidden modes are inside the region of stability; None with parameters."""
    modes = found["hidden_modes"]
    if any(mode.free_symbols for mode in modes):
        return None
    sizes = [sp.Abs(mode) - 1 if given.system.discrete else sp.re(mode) for mode in modes]
    return all(bool(sp.N(size) < 0) for size in sizes)


def sign_changes(_given: Given[Any, Any], found: Found) -> Any:
    """The changes of sign in the first column of a Routh array; None with zeros in it, or with parameters."""
    column = list(found["array"][:, 0])
    if any(entry.free_symbols or entry == 0 for entry in column):
        return None
    return sp.Integer(exact.sign_changes([int(sp.sign(entry)) for entry in column]))
