"""How discrete plants are judged: by matrix exponentials and integrals, by what a rule puts for s, by mapped roots."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Check, CheckStatus, Claim, Given
from solver.lazy import numeric, systems
from solver.lazy import sympy as sp
from solver.numeric.judges import digital as judges
from solver.numeric.judges import representation
from solver.stated.algebra import difference, exponential, product, quotient, total
from solver.stated.calculus import integral, value_at
from solver.stated.matrices import determinant, inverse
from solver.tasks.sample_times import sample_time_of
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr

    from solver.derivation import Task
    from solver.stated import Stated

RULES = ("forward_euler", "backward_euler", "tustin")


def register(task: Task[Any, Any]) -> None:
    """Register the judges of A, B, C, D and of G."""
    task.verification("A", "B", "C", "D")(of_matrices)
    task.verification("G")(of_transfer_function)


def s_of(given: Given[Any, Any], z: Any) -> Stated:
    """What the method puts for s."""
    h = h_of(given)
    below = {"forward_euler": sp.S.One, "backward_euler": z, "tustin": z + 1}[given.method]
    return quotient(z - 1, product(h, below))


def h_of(given: Given[Any, Any]) -> Any:
    """The h of the rule."""
    T, prewarp = sample_time_of(given), given.options.prewarp
    if given.method == "tustin":
        return T / 2 if prewarp is None else sp.tan(prewarp * T / 2) / prewarp
    return T


def of_matrices(given: Given[Any, Any], answers: Answers) -> Iterable[Check]:
    """Each matrix by its definition; where all are there, any states with the transfer matrix of the plant will do."""
    plant = given.system
    if not hasattr(plant, "A"):
        return
    claims = _held(given) if given.method in ("", "zero_order_hold") else _ruled(given)
    whole = _whole(given, answers)
    judged: tuple[str, ...] = ()
    if whole is not None:
        check = numeric.check_claim(whole, Phrase("$C_{{d}}(zI - A_{{d}})^{{-1}}B_{{d}} + D_{{d}}$ at random points"))
        if given.method == "matched" or check.status is CheckStatus.PASSED:
            judged = ("A", "B", "C", "D") if given.method == "matched" else ("B", "C", "D")
            yield replace(check, judges=judged)
    elif given.method == "matched":
        yield from _poles_alone(given, answers)
    for name, (label, claim) in claims.items():
        if name in answers and name not in judged:
            yield numeric.check_claim(claim(answers[name]), label, answer=name)


def _held(given: Given[Any, Any]) -> dict[str, Any]:
    """A_d = e^{AT}, B_d = ∫₀ᵀ e^{At} dt B, C and D as they are."""
    plant, T = given.system, sample_time_of(given)
    tau = sp.Dummy("tau", real=True)
    moved = integral(product(exponential(product(plant.A, tau)), plant.B), tau, sp.S.Zero, T)
    return {
        "A": (Phrase("$A_{{d}} = e^{{AT}}$"), lambda M: Claim(exponential(product(plant.A, T)), M)),
        "B": (Phrase(r"$B_{{d}} = \int_{{0}}^{{T}} e^{{At}}B\,dt$"), lambda M: Claim(moved, M)),
        "C": (Phrase("$C_{{d}} = C$"), lambda M: Claim(plant.C, M)),
        "D": (Phrase("$D_{{d}} = D$"), lambda M: Claim(plant.D, M)),
    }


def _ruled(given: Given[Any, Any]) -> dict[str, Any]:
    """The equations that the matrices of a rule satisfy."""
    if given.method not in RULES:
        return {}
    A, B, C, D = (getattr(given.system, name) for name in "ABCD")
    h, one = h_of(given), sp.ImmutableMatrix(sp.eye(A.rows))
    forward, pencil = total(one, product(h, A)), difference(one, product(h, A))
    if given.method == "forward_euler":
        return {
            "A": (Phrase("$A_{{d}} = I + TA$"), lambda M: Claim(forward, M)),
            "B": (Phrase("$B_{{d}} = TB$"), lambda M: Claim(product(h, B), M)),
            "C": (Phrase("$C_{{d}} = C$"), lambda M: Claim(C, M)),
            "D": (Phrase("$D_{{d}} = D$"), lambda M: Claim(D, M)),
        }
    tustin = given.method == "tustin"
    through = product(C, inverse(pencil), h, B)
    return {
        "A": (Phrase("$(I - hA)A_{{d}}$"), lambda M: Claim(product(pencil, M), forward if tustin else one)),
        "B": (Phrase("$(I - hA)B_{{d}}$"), lambda M: Claim(product(pencil, M), product(2 * h if tustin else h, B))),
        "C": (Phrase("$C_{{d}}(I - hA)$"), lambda M: Claim(product(M, pencil), C)),
        "D": (Phrase("$D_{{d}} = D + C(I - hA)^{{-1}}hB$"), lambda M: Claim(total(D, through), M)),
    }


def _whole(given: Given[Any, Any], answers: Answers) -> Claim | None:
    """The transfer matrix of the answers is that of the plant with what the method puts for s; None: not judged."""
    if given.method not in ("backward_euler", "tustin", "matched") or not {*"ABCD"} <= answers.keys():
        return None
    z, plant = sp.Symbol("z"), given.system
    A, B, C, D = (answers[name] for name in "ABCD")
    found = total(product(C, inverse(_pencil(z, A)), B), D)
    if given.method == "matched":
        return Claim(found, answers["G"]) if "G" in answers else None
    return Claim(found, total(product(plant.C, inverse(_pencil(s_of(given, z), plant.A)), plant.B), plant.D))


def _pencil(x: Any, A: Any) -> Stated:
    return difference(product(x, sp.ImmutableMatrix(sp.eye(A.rows))), A)


def _poles_alone(given: Given[Any, Any], answers: Answers) -> Iterator[Check]:
    """Of a matched plant without all its matrices only the poles can be judged."""
    if "A" in answers and answers["A"].shape == given.system.A.shape:
        z = sp.Symbol("z")
        image = difference(product(z, sp.ImmutableMatrix(sp.eye(given.system.A.rows))),
                           exponential(product(given.system.A, sample_time_of(given))))  # fmt: skip
        claim = Claim(determinant(image), determinant(_pencil(z, answers["A"])))
        yield numeric.check_claim(claim, Phrase("the poles are $e^{{\\lambda T}}$"), answer="A")


def of_transfer_function(given: Given[Any, Any], answers: Answers) -> Iterable[Check]:
    """The values of G at random z."""
    z, T, plant, found = sp.Symbol("z"), sample_time_of(given), given.system, answers["G"]
    if given.method in RULES:
        M = sp.ImmutableMatrix([[found]]) if not hasattr(found, "shape") else found
        for i in range(M.rows):
            for j in range(M.cols):
                claim = Claim(
                    value_at(plant.numerators[i][j] / plant.denominators[i][j], plant.variable, s_of(given, z)), M[i, j]
                )
                yield numeric.check_claim(claim, Phrase("$G(s)$ with the rule for $s$"), answer="G")
        return
    if given.method == "matched":
        G, s = _continuous(plant)
        check = partial(judges.matched_residual, G, s, T, found, z)
        yield numeric.check_residual(Phrase("poles and zeros at $e^{{sT}}$, the gain at low frequencies"),
                                     "mpmath.polyroots (40 digits)", check, answer="G")  # fmt: skip
        return
    yield numeric.check_claim(Claim(held_transfer(plant, T), found), Phrase("$G(z)$ by matrix exponentials"),
                              answer="G")  # fmt: skip


def held_transfer(plant: Any, T: Expr) -> Stated:
    """G_d(z) of a transfer function behind a hold, by a realization of it."""
    return judges.stated_pulse(sampling_of(plant, T), sp.Symbol("z"))


def sampling_of(plant: Any, T: Expr, *, held: bool = True, delay: Any = 0) -> Any:
    """The plant as the judges take it: realized, its dead time in periods."""
    if isinstance(plant, systems.DeadTime):
        plant, delay = plant.rational, plant.delay + delay
    quadruple = representation.realized(plant.numerators, plant.denominators, plant.variable)
    A, B, C, D = (sp.ImmutableMatrix(M) for M in quadruple)
    late, ahead = judges.periods(delay, T)
    return judges.Sampling((A, B, C, D), T, held, late, ahead)


def _continuous(plant: Any) -> tuple[Any, Any]:
    """G(s) of one channel, of states by their transfer function."""
    s = sp.Symbol("s")
    if hasattr(plant, "numerators"):
        return plant.numerators[0][0] / plant.denominators[0][0], s
    pencil = s * sp.eye(plant.A.rows) - plant.A
    G = (plant.C * pencil.adjugate() * plant.B)[0, 0] / pencil.det() + plant.D[0, 0]
    return sp.cancel(sp.together(G)), s
