"""What goes wrong where natural frequency and damping ratio are asked for."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt, Slip, Task
from solver.lazy import exact
from solver.lazy import sympy as sp

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import Polynomial

HALF = Slip("coefficient", "the coefficient of $s$ is $2\\,\\sym{damping_ratio}\\,\\omega_n$; the 2 is forgotten")
WITHOUT_FREQUENCY = Slip(
    "without_frequency", "it is $\\sym{damping_ratio}\\,\\omega_n$, not yet divided by $\\omega_n$"
)
SAMPLES = Slip("samples", "it is the angle in a sampling period; divided by $T$ it is a frequency")
AS_IN_S = Slip(
    "as_in_s", "the polynomial in $z$ is compared with the standard form in $s$; its poles are $s = (\\ln z)/T$"
)
SQUARE = Slip("square", "it is $\\omega_n^2$; the root is not taken")
HERTZ = Slip("hertz", "it is the frequency in hertz, $\\omega_n/2\\pi$; asked for is $\\omega_n$ in rad/s")
DAMPED = Slip(
    "damped_frequency", "it is the damped frequency $\\omega_d = \\omega_n\\sqrt{1 - \\sym{damping_ratio}^2}$"
)
NOT_MONIC = Slip("not_monic", "the polynomial is not yet divided by its leading coefficient")

Wrong = Attempt["Polynomial", Any]


def register(task: Task[Polynomial, Any]) -> None:
    """Register the usual mistakes of the task."""
    task.mistake(HALF, "damping_ratio")(without_the_two)
    task.mistake(WITHOUT_FREQUENCY, "damping_ratio")(decay_rate)
    task.mistake(SQUARE, "natural_frequency")(without_the_root)
    task.mistake(HERTZ, "natural_frequency")(in_hertz)
    task.mistake(DAMPED, "natural_frequency")(damped)
    task.mistake(SAMPLES, "natural_frequency")(in_samples)
    task.mistake(AS_IN_S, "natural_frequency", "damping_ratio")(compared_in_z)
    task.mistake(NOT_MONIC, "natural_frequency", "damping_ratio")(of_the_polynomial_as_given)


def without_the_two(wrong: Wrong) -> Iterable[Expr]:
    """2ζ."""
    yield 2 * wrong.ours


def decay_rate(wrong: Wrong) -> Iterable[Expr]:
    """ζω_n, and 2ζω_n."""
    if wrong.given.system.discrete:
        return
    found = exact.damping_of(wrong.given.system.coefficients)
    yield found.twice / 2
    yield found.twice


def without_the_root(wrong: Wrong) -> Iterable[Expr]:
    """ω_n²."""
    yield wrong.ours**2


def in_hertz(wrong: Wrong) -> Iterable[Expr]:
    """ω_n/2π."""
    yield wrong.ours / (2 * sp.pi)


def damped(wrong: Wrong) -> Iterable[Expr]:
    """ω_d."""
    p = wrong.given.system
    if p.discrete and p.sample_time is not None:
        found = exact.sampled_damping_of(p.coefficients, p.sample_time)
        if found.angle is not None:
            yield found.angle / p.sample_time
    elif (turn := exact.damped_frequency(exact.damping_of(p.coefficients))) is not None:
        yield turn


def in_samples(wrong: Wrong) -> Iterable[Expr]:
    """ω_n T of a discrete system."""
    if wrong.given.system.discrete:
        yield wrong.ours * wrong.given.system.sample_time


def compared_in_z(wrong: Wrong) -> Iterable[Expr]:
    """√(b₀/b₂) and b₁/(2√(b₂b₀)) of a discrete system."""
    b2, b1, b0 = wrong.given.system.coefficients
    if wrong.given.system.discrete and b0 / b2 > 0:
        yield sp.sqrt(b0 / b2) if wrong.name == "natural_frequency" else b1 / (2 * b2 * sp.sqrt(b0 / b2))


def of_the_polynomial_as_given(wrong: Wrong) -> Iterable[Expr]:
    """√b₀ and b₁/(2√b₀)."""
    b2, b1, b0 = wrong.given.system.coefficients
    if b2 != 1 and not wrong.given.system.discrete:
        yield sp.sqrt(b0) if wrong.name == "natural_frequency" else b1 / (2 * sp.sqrt(b0))
