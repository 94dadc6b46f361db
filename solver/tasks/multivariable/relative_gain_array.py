"""The relative gain array: how the other loops change the gain from an input to an output."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

from solver.arithmetic.inverses import inverted as inverse_worked_out
from solver.derivation import (
    AnswerName,
    Answers,
    Check,
    Claim,
    Derivation,
    Given,
    Refusal,
    Step,
    Task,
    Unsolved,
    option,
)
from solver.lazy import exact, numeric, systems
from solver.lazy import sympy as sp
from solver.numeric.judges import multivariable as judges
from solver.options.number import Number
from solver.stated.algebra import power, product
from solver.stated.calculus import value_at
from solver.stated.limits import limit
from solver.stated.matrices import determinant, entrywise_product, inverse, transpose
from solver.tasks import mistakes
from solver.tasks.multivariable import relative_gain_mistakes
from solver.tasks.plant_options import LoopOptions
from solver.tasks.representation.plants import stated_transfer, variable_of
from solver.tasks.representation.transfer_function import transfer_function_of
from solver.words import Phrase, Reason

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

    from solver.systems import DelayedMatrix
    from solver.tasks.needed import InputOutput

    Plant = InputOutput | DelayedMatrix


@dataclass(frozen=True, kw_only=True)
class RelativeGainOptions(LoopOptions):
    """Where the gains are compared."""

    frequency: Expr = option(Number(), "the frequency ω", default=0)


relative_gain_array: Task[Plant, RelativeGainOptions] = Task(
    "relative_gain_array",
    title="Relative gain array",
    doc="Λ = G ∘ (G⁻¹)ᵀ at a frequency, and which inputs it pairs with which outputs.",
    needs=("gains",),
    options=RelativeGainOptions,
    example={"transfer_matrix": "[[2/(s + 1), 1/(s + 2)], [1/(s + 1), 3/(s + 2)]]"},
    answers=[
        AnswerName(
            "Lambda",
            r"\Lambda",
            "the relative gain array, one row an output, one column an input",
            principal=True,
            earned=("gains", "scaled", "function", "inverse", "array"),
        ),
    ],
)


@relative_gain_array.refusal
def as_many_inputs_as_outputs(system: Any, options: RelativeGainOptions) -> Iterable[Refusal]:
    """G is square; a frequency of a discrete system needs the sample time."""
    p, m = system.size("p"), system.size("m")
    if p is not None and m is not None and p != m:
        yield "", Reason("relative_gain_array/not_square", {"p": p, "m": m})
    if system.discrete and system.sample_time is None and options.frequency != 0:
        yield "frequency", Reason("relative_gain_array/no_sample_time")


@relative_gain_array.method(source="Bristol, IEEE Trans. Automatic Control 11 (1966), 133–134")
def by_the_inverse(given: Given[Plant, RelativeGainOptions]) -> Derivation[Answers]:
    """The gains at the frequency, their inverse, and the products entry by entry."""
    plant, x, at = given.system, variable_of(given.system), _point(given)
    if not isinstance(plant, (systems.TransferFunction, systems.DelayedMatrix)):
        G = yield from transfer_function_of(plant)
        shown = G.matrix
    else:
        G, shown = _fractions(plant), _as_typed(plant, x, at)
    found = exact.gains_at(G.numerators, G.denominators, x, at)
    K = _with_dead_times(plant, found.gains, x, at)
    if any(found.powers):
        yield _scaled(shown, found.powers, K, x, at)
    else:
        yield Step("gains", claims={"gains": Claim(value_at(shown, x, at), K, Phrase("the gains"))}, x=x, at=at,
                   frequency=given.options.frequency)  # fmt: skip
    gains = exact.relative_gains(K)
    if gains.array is not None and gains.inverse is not None:
        yield from _products(K, gains.determinant, gains.inverse, gains.array)
        array = gains.array
    elif any(found.powers):
        array = yield from _by_its_function(shown, x, at)
    else:
        raise Unsolved("relative_gain_array/singular", K=K, at=at, x=x)
    yield _sums(array)
    yield _pairing(plant, array, gains.determinant)
    return Answers(Lambda=array)


def _fractions(plant: Any) -> exact.TransferMatrix:
    """The rational entries, cancelled or not."""
    G = plant if isinstance(plant, systems.TransferFunction) else plant.rational
    return exact.transfer_matrix_of_fractions(G.numerators, G.denominators, G.variable)


def _as_typed(plant: Any, x: Any, at: Expr) -> ImmutableMatrix:
    """G as it was given where it has values at the point, else cancelled."""
    G = plant if isinstance(plant, systems.TransferFunction) else plant.rational
    below = [q.subs(x, at) for row in G.denominators for q in row]
    shown: ImmutableMatrix = plant.matrix if any(q.equals(0) for q in below) else plant.uncancelled
    return shown


def _point(given: Given[Plant, RelativeGainOptions]) -> Expr:
    """The point jω, in discrete time e^{jωT}."""
    system, omega = given.system, given.options.frequency
    if not system.discrete:
        return sp.I * omega
    if omega == 0:
        return sp.S.One
    angle = omega * system.sample_time
    return sp.cos(angle) + sp.I * sp.sin(angle)


def _with_dead_times(plant: Any, K: ImmutableMatrix, x: Any, at: Expr) -> ImmutableMatrix:
    """The entries times the values of their e^{−T x}."""
    if not isinstance(plant, systems.DelayedMatrix):
        return K
    return sp.ImmutableMatrix(K.multiply_elementwise(plant.factors.subs(x, at)))


def _scaled(G: ImmutableMatrix, powers: tuple[int, ...], K: ImmutableMatrix, x: Any, at: Expr) -> Step:
    """The rows without their poles at the point: Λ does not change when a row is multiplied by a function."""
    diagonal = sp.ImmutableMatrix(sp.diag(*((x - at) ** k for k in powers)))
    claim = Claim(limit(product(diagonal, G), x, at), K, Phrase("the gains without the poles"))
    rows = [(i + 1, power(x - at, k)) for i, k in enumerate(powers) if k]
    return Step("scaled", claims={"gains": claim}, x=x, at=at, rows=rows)


def _products(K: ImmutableMatrix, det: Expr, inverted: ImmutableMatrix, array: ImmutableMatrix) -> Iterable[Step]:
    """The inverse of K, and the products of its entries with those of K."""
    n, places = K.rows, [(i, j) for i in range(K.rows) for j in range(K.rows)]
    claims = {
        "determinant": Claim(determinant(K), det, Phrase("determinant of the gains")),
        "inverse": Claim(inverse(K), inverted, Phrase("inverse of the gains")),
    }
    yield Step("inverse", claims=claims, steps=inverse_worked_out("K", K, inverted), n=n)
    claim = Claim(entrywise_product(K, transpose(inverted)), array, Phrase("products entry by entry"))
    entries = [(product(K[i, j], inverted[j, i]), array[i, j]) for i, j in places]
    yield Step("array", claims={"array": claim}, n=n, entries=entries)


def _by_its_function(G: ImmutableMatrix, x: Any, at: Expr) -> Derivation[ImmutableMatrix]:
    """Λ as a function, and its limit."""
    if G.has(sp.exp):
        raise Unsolved("relative_gain_array/delayed_pole", at=at, x=x)
    function = exact.relative_gains(G).array
    if function is None:
        raise Unsolved("relative_gain_array/singular_everywhere")
    stated = entrywise_product(G, transpose(inverse(G)))
    yield Step("function", claims={"function": Claim(stated, function, Phrase("Λ as a function"))}, x=x, at=at)
    found = exact.values_at(function, x, at)
    if found is None:
        raise Unsolved("relative_gain_array/no_limit", at=at, x=x)
    yield Step("limit", claims={"limit": Claim(limit(function, x, at), found, Phrase("the limit"))}, x=x, at=at)
    return found


def _sums(array: ImmutableMatrix) -> Step:
    """Each row and each column sums up to one."""
    ones = sp.ImmutableMatrix(sp.ones(array.rows, 1))
    claims = {
        "rows": Claim(product(array, ones), ones, Phrase("sums of the rows")),
        "columns": Claim(product(transpose(ones), array), sp.ImmutableMatrix(ones.T), Phrase("sums of the columns")),
    }
    return Step("sums", detail="full", claims=claims, n=array.rows)


def _pairing(plant: Any, array: ImmutableMatrix, det: Expr) -> Step:
    """What the entries say of pairing outputs with inputs."""
    found = exact.pairing(array)
    outputs, inputs = (_names(plant, of, sign, array.rows) for of, sign in (("output", "y"), ("input", "u")))
    pairs = [] if found is None else [
        (outputs[i], inputs[j], entry) for i, (j, entry) in enumerate(zip(found.inputs, found.entries, strict=True))
    ]  # fmt: skip
    negative = [] if found is None else [(outputs[i], inputs[j], array[i, j]) for i, j in found.negative]
    return Step(
        "pairing",
        detail="full",
        unclaimed="a judgement",
        array=array,
        pairs=pairs,
        negative=negative,
        taken=any(each in negative for each in pairs),
        close=found is not None and bool(found.distance <= CLOSE),
        halves=found is not None and all(entry == sp.S.Half for entry in array.flat()),
        large=found is not None and bool(found.largest >= LARGE),
        real=not array.has(sp.I),
        one=array[0, 0] if array.rows == 2 else None,
        outputs=outputs,
        inputs=inputs,
        exceptions=exact.vanishing_factors(det) if det.free_symbols else [],
    )


def _names(plant: Any, of: str, sign: str, n: int) -> list[Any]:
    """The symbols of the channels."""
    given = plant.names(of)
    return [sp.Symbol(name) for name in given] if given else list(sp.symbols(f"{sign}1:{n + 1}"))


CLOSE = 0.25
"""So near to one the loops hardly act on each other."""
LARGE = 10
"""An entry of this size tells that small errors of the gains matter much."""


@relative_gain_array.verification("Lambda")
def is_the_product_in_numbers(given: Given[Plant, RelativeGainOptions], answers: Answers) -> Iterable[Check]:
    """G ∘ (G⁻¹)ᵀ in numbers, beside the point."""
    plant, x = given.system, variable_of(given.system)
    if isinstance(plant, (systems.TransferFunction, systems.DelayedMatrix)):
        G: Any = plant.uncancelled
    else:
        G = stated_transfer(plant, x)
    check = partial(judges.relative_gain_residual, G, answers["Lambda"], x, _point(given))
    label = Phrase(r"$\Lambda = G \circ (G^{{-1}})^{{T}}$")
    yield numeric.check_residual(label, "mpmath, inverse of the gains (50 digits)", check, answer="Lambda")


def _gains_of(given: Given[Plant, RelativeGainOptions]) -> ImmutableMatrix:
    """K, for usual mistakes."""
    plant, x, at = given.system, variable_of(given.system), _point(given)
    if isinstance(plant, (systems.TransferFunction, systems.DelayedMatrix)):
        G = _fractions(plant)
    else:
        G = exact.transfer_matrix(plant.A, plant.B, plant.C, plant.D, x)
    return _with_dead_times(plant, exact.gains_at(G.numerators, G.denominators, x, at).gains, x, at)


relative_gain_mistakes.register(relative_gain_array, _gains_of)
relative_gain_array.mistaken_question(mistakes.EXCHANGED)(mistakes.inputs_for_outputs)
