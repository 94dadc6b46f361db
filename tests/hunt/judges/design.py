"""Judges of design: spectra of the loops, formulas of second order, python-control's gains."""

import control
import numpy as np
import sympy as sp

from tests.hunt.asked import Point
from tests.hunt.judges.found import Found, circle, hidden
from tests.hunt.judges.representation import POINTS, letter
from tests.hunt.plants import fraction, loop, matrices


def specified(point: Point) -> np.ndarray | None:
    """The poles that are asked for: as listed, or from ζ and ω_n where those are."""
    if point.option("poles") is not None:
        return point.roots(point.option("poles"))
    if point.option("damping_ratio") is not None and point.option("natural_frequency") is not None:
        zeta, omega = (point.number(point.option(name)).real for name in ("damping_ratio", "natural_frequency"))
        return np.roots([1, 2 * zeta * omega, omega**2])
    return None


def desired_poles(point: Point, found: Found) -> None:
    zeta, omega = found.number("damping_ratio").real, found.number("natural_frequency").real
    damped = omega * np.sqrt(max(0.0, 1 - zeta**2))
    band = {"5%": 3}.get(point.option("settling_band"), 4)
    formulas = {
        "damping_ratio": zeta,
        "natural_frequency": omega,
        "settling_time": band / (zeta * omega),
        "peak_time": np.pi / damped if damped else np.inf,
        "rise_time": (np.pi - np.arccos(zeta)) / damped if damped else np.inf,
        "overshoot": np.exp(-np.pi * zeta / np.sqrt(1 - zeta**2)) if zeta < 1 else 0.0,
    }
    for name, value in formulas.items():
        if point.option(name) is not None:
            raw = str(point.option(name))
            asked = point.number(raw.rstrip("%")).real / (100 if raw.endswith("%") else 1)
            found.same(name, [value], [asked])
    found.same("poles", np.poly(found.list("poles")), [1, 2 * zeta * omega, omega**2])
    for s in POINTS:
        theirs = s**2 + 2 * zeta * omega * s + omega**2
        found.same("polynomial", [found.number("polynomial", s=sp.sympify(s))], [theirs])


def pole_placement(point: Point, found: Found) -> None:
    A, B, _, _ = matrices(point)
    K, F = found.matrix("K"), found.matrix("closed_loop_A")
    found.same("A − BK", F, A - B @ K)
    found.polynomial("polynomial", "polynomial", letter(point), F)
    lost = hidden(A, B)
    poles = specified(point)
    if poles is not None:
        wanted = poles if len(poles) == len(A) else [*poles, *lost]
        found.spectrum("eigenvalues of the loop", wanted, F)
        if B.shape[1] == 1 and not lost and not np.iscomplexobj(A):
            found.same("python-control", K, np.atleast_2d(control.acker(A, B, list(poles))), 1e-6)
    else:
        second_order(point, found, F)
    if "fixed_poles" in found:
        found.same("fixed poles", np.poly(found.list("fixed_poles")), np.poly(lost), 1e-6)
    if "gain_polynomial" in found and point.option("structure") is None:
        gains = np.array([[point.random.uniform(-2, 2) for _ in range(B.size // len(A) * len(A))]]).reshape(-1, len(A))
        named = {f"k{i + 1}": sp.Float(x, 20) for i, x in enumerate(gains.ravel())}
        M = A - B @ gains
        for x in circle(M)[:3]:
            ours = found.number("gain_polynomial", **named, **{letter(point): sp.sympify(x)})
            found.same("gain polynomial", [ours], [np.linalg.det(x * np.eye(len(A)) - M)])


def second_order(point: Point, found: Found, F: np.ndarray) -> None:
    """Specifications of second order are those of the two poles nearest to the axis."""
    pair = sorted(np.linalg.eigvals(F), key=lambda p: -p.real)[:2]
    omega = abs(pair[0])
    zeta = -pair[0].real / omega
    damped = omega * np.sqrt(1 - zeta**2)
    values = {
        "settling_time": 4 / (zeta * omega),
        "peak_time": np.pi / damped,
        "overshoot": np.exp(-np.pi * zeta / np.sqrt(1 - zeta**2)),
        "damping_ratio": zeta,
        "natural_frequency": omega,
    }
    for name, value in values.items():
        if point.option(name) is not None:
            raw = str(point.option(name))
            asked = point.number(raw.rstrip("%")).real / (100 if raw.endswith("%") else 1)
            found.same(name, [value], [asked], 1e-8)


def observer(point: Point, found: Found) -> None:
    A, _, C, _ = matrices(point)
    L, F = found.matrix("L"), found.matrix("error_A")
    found.same("A − LC", F, A - L @ C)
    found.polynomial("polynomial", "polynomial", letter(point), F)
    poles = point.roots(point.option("poles"))
    lost = hidden(A.T, C.T)
    found.spectrum("eigenvalues of the error", poles if len(poles) == len(A) else [*poles, *lost], F)


def reduced_observer(point: Point, found: Found) -> None:
    A, B, C, _ = matrices(point)
    L, J, N, M, T = (found.matrix(name) for name in "LJNMT")
    measured = point.option("measured")
    C = np.eye(len(A))[[i - 1 for i in measured]] if measured else C
    p = len(C)
    inverse = np.linalg.inv(T)
    found.same("C T = [I 0]", C @ T, np.eye(len(A))[:p])
    E = inverse[p:] - L @ C
    found.same("E A = J E + N C", E @ A, J @ E + N @ C)
    found.same("E B = M", E @ B, M)
    poles = point.roots(point.option("poles"))
    if len(poles) == len(J):
        found.spectrum("eigenvalues of J", poles, J)


def observer_feedback(point: Point, found: Found) -> None:
    A, B, C, D = matrices(point)
    poles, observer_poles = (point.roots(point.option(name)) for name in ("poles", "observer_poles"))
    spectrum = [*poles, *observer_poles]
    found.spectrum("separation", spectrum, found.matrix("closed_loop_A"))
    if "eigenvalues" in found:
        found.same("eigenvalues", np.poly(found.list("eigenvalues")), np.poly(spectrum), 1e-7)
    if not point.option("reduced") and C.shape[0] == B.shape[1] == 1:
        K = np.atleast_2d(control.acker(A, B, list(poles)))
        L = np.atleast_2d(control.acker(A.T, C.T, list(observer_poles))).T
        inner = A - B @ K - L @ C + L @ D @ K
        for s in POINTS:
            theirs = -K @ np.linalg.solve(s * np.eye(len(A)) - inner, L)
            found.same("compensator", found.matrix("compensator", **{letter(point): sp.sympify(s)}), theirs, 1e-7)


def reference_tracking(point: Point, found: Found) -> None:
    A, B, C, D = matrices(point)
    F, N, K_o = (found.matrix(name) for name in ("F", "N", "K_o"))
    K = point.matrix(point.option("gain")) if point.option("gain") is not None else found.matrix("K")
    rest = A - np.eye(len(A)) if point.discrete else A
    found.same("A F + B N = 0", rest @ F + B @ N, np.zeros((len(A), len(C))))
    found.same("C F + D N = I", C @ F + D @ N, np.eye(len(C)))
    found.same("K_o = N + K F", K_o, N + K @ F)
    if point.option("poles") is not None:
        found.spectrum("eigenvalues of the loop", point.roots(point.option("poles")), A - B @ K)


def servo(point: Point, found: Found) -> None:
    A, B, C, D = matrices(point)
    K, k_I, whole = (found.matrix(name) for name in ("K", "k_I", "closed_loop_A"))
    corner = np.eye(len(C)) if point.discrete else np.zeros((len(C), len(C)))
    theirs = np.block([[A - B @ K, B @ k_I], [-C + D @ K, corner - D @ k_I]])
    found.same("closed loop in (x, ξ)", whole, theirs)
    poles = specified(point)
    if poles is not None and len(poles) == len(whole):
        found.spectrum("eigenvalues of the loop", poles, whole)


def model_matching(point: Point, found: Found) -> None:
    plant, target = loop(point), fraction(point, point.option("target"))
    if "K" in found:
        A, B, C, K = (found.matrix(name) for name in ("A", "B", "C", "K"))
        M = [(C @ np.linalg.solve(s * np.eye(len(A)) - A + B @ K, B))[0, 0] for s in POINTS]
        ratio = [m * np.polyval(target[1], s) / np.polyval(target[0], s) for m, s in zip(M, POINTS, strict=True)]
        found.same("the loop is the target times a gain", ratio, [ratio[0]] * len(ratio))
    for s in POINTS:
        value = np.polyval(target[0], s) / np.polyval(target[1], s) * np.polyval(plant[1], s) / np.polyval(plant[0], s)
        found.same("compensator", [found.number("compensator", **{letter(point): sp.sympify(s)})], [value])
    excess = [len(each[1]) - len(np.trim_zeros(each[0], "f")) for each in (plant, target)]
    zeros, kept = np.roots(plant[0]), np.roots(target[0])
    hidden_zeros = [z for z in zeros if not any(abs(z - w) < 1e-6 for w in kept)]
    if excess[0] != excess[1]:
        found.holds("feasible with another excess", not found.values["feasible"])
    elif any(z.real > 0 for z in hidden_zeros):
        found.holds("feasible with an unstable zero cancelled", not found.values["feasible"])
