"""Judges of design: spectra of the loops, formulas of second order."""

import control
import numpy as np

from tests.classroom.corpus.judges.registry import (
    POINTS,
    difference,
    judge,
    letter,
    matrix,
    multiset,
    polynomial_of,
    truth,
    unique,
    word,
)
from tests.classroom.corpus.meanings import Meaning
from tests.hunt.asked import Point
from tests.hunt.judges.found import hidden
from tests.hunt.plants import fraction, loop, matrices


def specification(point: Point) -> tuple[float, float]:
    """ζ and ω_n from any two specifications."""
    given = {}
    for name in ("overshoot", "settling_time", "peak_time", "rise_time", "damping_ratio", "natural_frequency"):
        if point.option(name) is not None:
            raw = str(point.option(name))
            given[name] = point.number(raw.rstrip("%")).real / (100 if raw.endswith("%") else 1)
    band = 3 if point.option("settling_band") == "5%" else 4
    if "overshoot" in given:
        log = np.log(given["overshoot"])
        zeta = -log / np.sqrt(np.pi**2 + log**2)
    elif "damping_ratio" in given:
        zeta = given["damping_ratio"]
    else:
        zeta = band / given["settling_time"] / given["natural_frequency"]
    damped = np.sqrt(1 - zeta**2)
    formulas = {
        "natural_frequency": lambda value: value,
        "settling_time": lambda value: band / (zeta * value),
        "peak_time": lambda value: np.pi / (damped * value),
        "rise_time": lambda value: (np.pi - np.arccos(zeta)) / (damped * value),
    }
    return zeta, next(formulas[name](value) for name, value in given.items() if name in formulas)


def wanted(point: Point, A: np.ndarray, lost: list[complex]) -> np.ndarray:
    """The poles of the loop: those asked for, with those that cannot be moved."""
    if point.option("poles") is None:
        zeta, omega = specification(point)
        return np.roots([1, 2 * zeta * omega, omega**2])
    poles = point.roots(point.option("poles"))
    return poles if len(poles) == len(A) else np.array([*poles, *lost])


def _spectrum(M: np.ndarray, poles: np.ndarray) -> np.ndarray:
    return np.poly(M) - np.poly(poles)


def gain_of(point: Point) -> np.ndarray:
    """K of the question, or the one that its poles give a plant with one input."""
    A, B, _, _ = matrices(point)
    for name in ("own_K", "gain"):
        if point.option(name) is not None:
            return point.matrix(point.option(name))
    return np.atleast_2d(control.acker(A, B, list(wanted(point, A, []))))


@judge("pole_placement", "K")
def K(point: Point, meant: Meaning):
    A, B, _, _ = matrices(point)
    return _spectrum(A - B @ matrix(meant, (B.shape[1], len(A))), wanted(point, A, hidden(A, B)))


@unique("pole_placement", "closed_loop_A")
def closed_loop(point: Point):
    A, B, _, _ = matrices(point)
    return A - B @ gain_of(point)


@judge("pole_placement", "polynomial")
def polynomial(point: Point, meant: Meaning):
    A, B, _, _ = matrices(point)
    return polynomial_of(meant, letter(point), np.poly(wanted(point, A, hidden(A, B))))


@judge("pole_placement", "gain_polynomial")
def gain_polynomial(point: Point, meant: Meaning):
    A, B, _, _ = matrices(point)
    left = []
    for gains in np.random.default_rng(5).uniform(-3, 3, (4, len(A))):
        named = {f"k{i + 1}": k for i, k in enumerate(gains)}
        for s in POINTS[:3]:
            theirs = np.linalg.det(s * np.eye(len(A)) - A + B @ gains[None, :])
            left.append(np.ravel(meant(**named, **{letter(point): s}) - theirs))
    return left


@judge("observer", "L")
def L(point: Point, meant: Meaning):
    A, _, C, _ = matrices(point)
    return _spectrum(A - matrix(meant, (len(A), len(C))) @ C, wanted(point, A, hidden(A.T, C.T)))


@unique("observer", "error_A")
def error(point: Point):
    A, _, C, _ = matrices(point)
    return A - np.atleast_2d(control.acker(A.T, C.T, list(wanted(point, A, [])))).T @ C


@judge("observer", "polynomial")
def error_polynomial(point: Point, meant: Meaning):
    A, _, C, _ = matrices(point)
    return polynomial_of(meant, letter(point), np.poly(wanted(point, A, hidden(A.T, C.T))))


def _parts(point: Point) -> tuple[np.ndarray, ...]:
    """The blocks of a plant whose measured states come first, C = [I 0]; and the gain L that the poles ask for."""
    A, B, C, _ = matrices(point)
    p = len(C)
    if not np.array_equal(C, np.eye(len(A))[:p]) or p != 1:
        raise NotImplementedError("only of one state that stands first")
    A11, A12, A21, A22 = A[:p, :p], A[:p, p:], A[p:, :p], A[p:, p:]
    gain = np.atleast_2d(control.acker(A22.T, A12.T, list(point.roots(point.option("poles"))))).T
    if point.option("own_L") is not None:
        gain = point.matrix(point.option("own_L"), column=True)
    return A11, A12, A21, A22, B[:p], B[p:], gain


@judge("reduced_observer", "L")
def reduced_gain(point: Point, meant: Meaning):
    gain = _parts(point)[-1]
    return matrix(meant, gain.shape) - gain


@judge("reduced_observer", "J")
def reduced_matrix(point: Point, meant: Meaning):
    _, A12, _, A22, _, _, gain = _parts(point)
    return matrix(meant, A22.shape) - (A22 - gain @ A12)


@judge("reduced_observer", "N")
def reduced_output(point: Point, meant: Meaning):
    A11, A12, A21, A22, _, _, gain = _parts(point)
    return matrix(meant, A21.shape) - (A21 - gain @ A11 + (A22 - gain @ A12) @ gain)


@judge("reduced_observer", "M")
def reduced_input(point: Point, meant: Meaning):
    *_, B1, B2, gain = _parts(point)
    return matrix(meant, B2.shape) - (B2 - gain @ B1)


def _gains(point: Point) -> tuple[np.ndarray, np.ndarray]:
    A, _, C, _ = matrices(point)
    if point.option("observer_gain") is not None:
        return gain_of(point), point.matrix(point.option("observer_gain"), column=True)
    return gain_of(point), np.atleast_2d(control.acker(A.T, C.T, list(point.roots(point.option("observer_poles"))))).T


@judge("observer_feedback", "closed_loop_A")
def whole(point: Point, meant: Meaning):
    """In (x, x − x̂); an equally usual choice of coordinates, (x, x̂), counts too."""
    A, B, C, _ = matrices(point)
    gain, inner = _gains(point)
    zero = np.zeros_like(A)
    errors = np.block([[A - B @ gain, B @ gain], [zero, A - inner @ C]])
    estimates = np.block([[A, -B @ gain], [inner @ C, A - B @ gain - inner @ C]])
    ours = matrix(meant, errors.shape)
    return min((ours - errors, ours - estimates), key=lambda left: np.max(np.abs(left)))


@judge("observer_feedback", "eigenvalues")
def eigenvalues(point: Point, meant: Meaning):
    A, B, C, _ = matrices(point)
    gain, inner = _gains(point)
    return multiset(meant(), [*np.linalg.eigvals(A - B @ gain), *np.linalg.eigvals(A - inner @ C)])


@judge("observer_feedback", "compensator")
def compensator(point: Point, meant: Meaning):
    A, B, C, D = matrices(point)
    gain, inner = _gains(point)
    M = A - B @ gain - inner @ C + inner @ D @ gain
    theirs = [-gain @ np.linalg.solve(s * np.eye(len(A)) - M, inner) for s in POINTS]
    return [difference(meant(**{letter(point): s}), value) for s, value in zip(POINTS, theirs, strict=True)]


def _rest(point: Point) -> tuple[np.ndarray, np.ndarray]:
    """F and N of the state and input that keep the output at the reference."""
    A, B, C, D = matrices(point)
    n, p = len(A), len(C)
    M = np.block([[A - np.eye(n) if point.discrete else A, B], [C, D]])
    found = np.linalg.solve(M, np.vstack([np.zeros((n, p)), np.eye(p)]))
    return found[:n], found[n:]


@judge("reference_tracking", "F")
@judge("optimal_tracking", "F")
def F(point: Point, meant: Meaning):
    return matrix(meant, _rest(point)[0].shape) - _rest(point)[0]


@judge("reference_tracking", "N")
@judge("optimal_tracking", "N")
def N(point: Point, meant: Meaning):
    return matrix(meant, _rest(point)[1].shape) - _rest(point)[1]


@judge("reference_tracking", "K_o")
def K_o(point: Point, meant: Meaning):
    F, N = _rest(point)
    theirs = N + gain_of(point) @ F
    return matrix(meant, theirs.shape) - theirs


def servo_gains(point: Point) -> tuple[np.ndarray, np.ndarray]:
    """K and k_I of u = −K x + k_I ξ, of a plant with one input and output."""
    A, B, C, D = matrices(point)
    n = len(A)
    corner = np.eye(1) if point.discrete else np.zeros((1, 1))
    big = np.block([[A, np.zeros((n, 1))], [-C, corner]])
    both = np.atleast_2d(control.acker(big, np.vstack([B, -D]), list(point.roots(point.option("poles")))))
    return both[:, :n], -both[:, n:]


@judge("servo", "K")
def servo_K(point: Point, meant: Meaning):
    theirs = servo_gains(point)[0]
    return matrix(meant, theirs.shape) - theirs


@judge("servo", "k_I")
def servo_k(point: Point, meant: Meaning):
    theirs = servo_gains(point)[1]
    return matrix(meant, theirs.shape) - theirs


@unique("desired_poles", "damping_ratio")
def damping_ratio(point: Point):
    return specification(point)[0]


@unique("desired_poles", "natural_frequency")
def natural_frequency(point: Point):
    return specification(point)[1]


@judge("desired_poles", "poles")
def desired(point: Point, meant: Meaning):
    zeta, omega = specification(point)
    return multiset(meant(), np.roots([1, 2 * zeta * omega, omega**2]))


@judge("desired_poles", "polynomial")
def desired_polynomial(point: Point, meant: Meaning):
    zeta, omega = specification(point)
    return polynomial_of(meant, "s", np.array([1, 2 * zeta * omega, omega**2]))


@judge("model_matching", "feasible")
def feasible(point: Point, meant: Meaning):
    """The same excess of poles, and zeros that are cancelled decay."""
    plant, target = loop(point), fraction(point, point.option("target"))
    excess = [len(each[1]) - len(each[0]) for each in (plant, target)]
    kept = np.roots(target[0])
    cancelled = [z for z in np.roots(plant[0]) if not any(abs(z - w) < 1e-6 for w in kept)]
    fits = excess[0] == excess[1] and all(z.real < 0 for z in cancelled)
    new = [w for w in kept if not any(abs(z - w) < 1e-6 for z in np.roots(plant[0]))]
    return [word(truth(meant) == (fits and not new))]


@judge("model_matching", "compensator")
def matching_compensator(point: Point, meant: Meaning):
    plant, target = loop(point), fraction(point, point.option("target"))
    left = []
    for s in POINTS:
        theirs = np.polyval(target[0], s) * np.polyval(plant[1], s) / np.polyval(target[1], s) / np.polyval(plant[0], s)
        left.append(np.ravel(meant(s=s) - theirs))
    return left
