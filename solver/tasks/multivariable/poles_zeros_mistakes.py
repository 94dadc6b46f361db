"""The usual mistakes with poles and zeros of several inputs and outputs, and what a wrong value would mean."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt, Slip, Task
from solver.lazy import exact, systems
from solver.lazy import sympy as sp
from solver.tasks.plant_options import LoopOptions
from solver.tasks.representation.plants import matrices_of, variable_of
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr

    from solver.tasks.needed import InputOutput

    Wrong = Attempt[InputOutput, LoopOptions]

OF_ENTRIES = Slip(
    "zeros_of_entries",
    "these are the zeros of the entries; a transmission zero is where the rank of the whole matrix falls",
)
OF_THE_DETERMINANT = Slip(
    "zeros_of_determinant",
    "these are the zeros of the determinant in lowest terms, where a zero cancels against a pole at the same place",
)
UNCANCELLED = Slip("uncancelled_minors", "a minor is not in lowest terms: what cancels in it is no pole and no zero")
UNION = Slip(
    "poles_of_entries",
    "these are the poles of the entries, each once; the minors of higher order tell how often a pole counts",
)
COUNTED_BY_ENTRY = Slip(
    "poles_by_entry",
    "the poles of all entries are counted together; entries share poles, and the minors tell how often",
)
ONCE = Slip("multiplicity", "each value is listed once; multiplicities count")
HIDDEN = Slip("hidden_modes_kept", "these are the eigenvalues of $A$; a mode that is hidden is no pole of $G$")
WITH_HIDDEN = Slip("invariant_for_transmission", "decoupling zeros are among them, which are no transmission zeros")


def register(task: Task[Any, Any]) -> None:
    """Name the mistakes of a task with these answers."""
    task.mistake(ONCE, "zeros", "invariant_zeros")(each_once)
    task.mistake(OF_ENTRIES, "zeros")(zeros_of_the_entries)
    task.mistake(OF_THE_DETERMINANT, "zeros")(zeros_of_the_determinant)
    task.mistake(UNCANCELLED, "zeros")(zeros_of_the_uncancelled_determinant)
    task.mistake(UNCANCELLED, "poles")(poles_of_the_uncancelled_determinant)
    task.mistake(UNION, "poles")(poles_of_the_entries)
    task.mistake(COUNTED_BY_ENTRY, "poles")(poles_entry_by_entry)
    task.mistake(ONCE, "poles")(each_once)
    task.mistake(HIDDEN, "poles")(eigenvalues)
    task.mistake(WITH_HIDDEN, "zeros")(invariant_zeros)
    task.meaning("poles", "zeros")(what_is_there)


def _transfer(wrong: Wrong) -> exact.TransferMatrix:
    plant = wrong.given.system
    if isinstance(plant, systems.TransferFunction):
        return exact.transfer_matrix_of_fractions(plant.numerators, plant.denominators, plant.variable)
    return exact.transfer_matrix(*matrices_of(plant), variable_of(plant))


def _roots(p: Any, x: Any) -> list[Expr]:
    """The roots of a polynomial of numbers with multiplicity, in decimals where there is no short form; else none."""
    polynomial = sp.Poly(p, x)
    if polynomial.is_zero or polynomial.degree() == 0 or polynomial.free_symbols_in_domain - {x}:
        return []
    found: list[Expr] = []
    for factor, times in polynomial.factor_list()[1]:
        short = sp.roots(factor) if factor.degree() < 3 else dict.fromkeys(factor.nroots(n=30, maxsteps=500), 1)
        found += [root for root, m in short.items() for _ in range(m * times)]
    return found


def _of_entries(wrong: Wrong, *, poles: bool) -> list[list[Expr]]:
    """The poles (the zeros) of each entry."""
    G = _transfer(wrong)
    quotients = [sp.fraction(sp.together(entry)) for entry in G.matrix.flat()]
    return [_roots(pair[1 if poles else 0], G.variable) for pair in quotients if pair[0] != 0]


def zeros_of_the_entries(wrong: Wrong) -> Iterable[Any]:
    """Those of all entries, with multiplicity or each once."""
    found = [root for listed in _of_entries(wrong, poles=False) for root in listed]
    yield found
    yield list(dict.fromkeys(found))


def zeros_of_the_determinant(wrong: Wrong) -> Iterable[Any]:
    """Those of the numerator of the determinant, cancelled."""
    G = _transfer(wrong)
    if G.shape[0] == G.shape[1]:
        yield _roots(sp.numer(sp.together(exact.rational_determinant(G))), G.variable)


def zeros_of_the_uncancelled_determinant(wrong: Wrong) -> Iterable[Any]:
    """Those of the numerator over the power of the common denominator, or over the product of the denominators."""
    for top, _ in _uncancelled(wrong):
        yield _roots(top, _transfer(wrong).variable)


def poles_of_the_uncancelled_determinant(wrong: Wrong) -> Iterable[Any]:
    """The roots of these denominators."""
    for _, bottom in _uncancelled(wrong):
        yield _roots(bottom, _transfer(wrong).variable)


def _uncancelled(wrong: Wrong) -> Iterable[tuple[Any, Any]]:
    """The determinant of two by two over both denominators as they arise when nothing is cancelled."""
    G = _transfer(wrong)
    if G.shape != (2, 2):
        return
    (a, b), (c, d) = [[sp.fraction(sp.together(entry)) for entry in row] for row in G.matrix.tolist()]
    for below in (a[1] * d[1] * b[1] * c[1], G.common_denominator.as_expr() ** 2, sp.lcm(a[1] * d[1], b[1] * c[1])):
        top = sp.cancel((a[0] * d[0] / (a[1] * d[1]) - b[0] * c[0] / (b[1] * c[1])) * below)
        yield top, below


def poles_of_the_entries(wrong: Wrong) -> Iterable[Any]:
    """Each pole of an entry once; or as often as in the entry where it is most often."""
    listed = _of_entries(wrong, poles=True)
    distinct = list(dict.fromkeys(root for roots in listed for root in roots))
    yield distinct
    yield [root for root in distinct for _ in range(max(roots.count(root) for roots in listed))]


def poles_entry_by_entry(wrong: Wrong) -> Iterable[Any]:
    """The poles of all entries one after another."""
    yield [root for roots in _of_entries(wrong, poles=True) for root in roots]


def each_once(wrong: Wrong) -> Iterable[Any]:
    """Each value of a list once."""
    yield list(dict.fromkeys(wrong.ours))


def eigenvalues(wrong: Wrong) -> Iterable[Any]:
    """The eigenvalues of A."""
    plant = wrong.given.system
    if not isinstance(plant, systems.TransferFunction):
        yield exact.spectrum(plant.A).eigenvalues


def invariant_zeros(wrong: Wrong) -> Iterable[Any]:
    """The zeros of the system matrix, hidden modes among them."""
    plant = wrong.given.system
    if not isinstance(plant, systems.TransferFunction):
        x = variable_of(plant)
        yield _roots(exact.system_matrix(*matrices_of(plant), x).zero_polynomial.as_expr(), x)


def what_is_there(wrong: Wrong) -> Reason | None:
    """A listed zero where G has its full rank, a listed pole where G is finite; else how many there must be."""
    G = _transfer(wrong)
    listed = [sp.S.Zero + value for value in wrong.value]
    if G.matrix.free_symbols - {G.variable} or any(not value.is_number for value in listed):
        return None
    for value in listed:
        told = _told(G, value, wrong)
        if told is not None:
            return told
    if len(listed) == len(wrong.ours):
        return None
    values = {"count": len(listed), "right": len(wrong.ours), "zeros": wrong.name == "zeros"}
    return Reason("transfer_matrix_poles_zeros/count", values)


def _told(G: exact.TransferMatrix, value: Expr, wrong: Wrong) -> Reason | None:
    """What G is at a value that is no pole, or no zero, of it; None where it is one, or nearly."""
    near = [abs(complex(value) - complex(each)) < 1e-2 * max(1.0, abs(complex(each))) for each in wrong.ours]
    if any(near) or not value.is_Rational:
        return None
    there = G.matrix.xreplace({G.variable: value})
    if there.has(sp.zoo, sp.nan):
        return None
    values = {"x": G.variable, "value": value, "rank": there.rank()}
    if wrong.name == "zeros":
        return Reason("transfer_matrix_poles_zeros/rank", values)
    return Reason("transfer_matrix_poles_zeros/finite", values)
