"""Formulas of `solver.stated.transforms`: what they are equal to, and how they are printed."""

import sympy as sp

from solver.stated.algebra import difference, exponential, power, product, quotient, total
from solver.stated.matrices import adjugate, determinant, inverse
from solver.stated.transforms import inverse_laplace, inverse_z, laplace, z_transform
from tests.stated.values import ADJ, CHI, PHI, POWER, A, F, a, k, s, t, w, z

RIGHT = [
    (inverse_laplace(ADJ / CHI, s, t), PHI),
    (inverse_laplace(inverse(F), s, t), PHI),
    (inverse_laplace(inverse(difference(product(s, sp.eye(2)), A)), s, t), PHI),
    (inverse_laplace(quotient(adjugate(F), determinant(F)), s, t), PHI),
    (inverse_laplace(1 / (s + a) ** 3, s, t), t**2 * sp.exp(-a * t) / 2),
    (inverse_laplace(1 / s, s, t), 1),
    (inverse_laplace(w / (s**2 + w**2), s, t), sp.sin(w * t)),
    (inverse_laplace(1 / (s * (1 + 1 / (s + 2))), s, t), sp.Rational(2, 3) + sp.exp(-3 * t) / 3),
    (
        inverse_laplace(total(product(quotient(1, s + 1), A), product(quotient(2, power(s + 3, 2)), sp.eye(2))), s, t),
        A * sp.exp(-t) + 2 * t * sp.exp(-3 * t) * sp.eye(2),
    ),
    (inverse_laplace(difference(quotient(A, s), product(quotient(1, s + 1), A)), s, t), A * (1 - sp.exp(-t))),
    (
        inverse_laplace(difference(quotient(1, s), difference(1 / (s + a), 1 / (s + 2))), s, t),
        1 - sp.exp(-a * t) + sp.exp(-2 * t),
    ),
    (
        inverse_laplace(quotient(1, product(s, s + a, s + 3)), s, t),
        (1 / (3 * a) + sp.exp(-a * t) / (a * (a - 3)) + sp.exp(-3 * t) / (3 * (3 - a))),
    ),
    (inverse_laplace(power(F, -1), s, t), PHI),
    (inverse_laplace(quotient(1, power(s + a, 3)), s, t), t**2 * sp.exp(-a * t) / 2),
    (inverse_laplace(quotient(1 / (s + a), sp.ImmutableMatrix([[2]])), s, t), sp.exp(-a * t) / 2),
    (inverse_laplace(inverse(total(product(s, sp.eye(2)), -A)), s, t), PHI),
    ([inverse_laplace([1 / s, 1 / (s + a)][i], s, t) for i in (0, 1)], [1, sp.exp(-a * t)]),
    (
        inverse_laplace(product(inverse(F), sp.ImmutableMatrix([0, 1]), quotient(1, s)), s, t),
        sp.Matrix([sp.Rational(1, 2) - sp.exp(-t) + sp.exp(-2 * t) / 2, sp.exp(-t) - sp.exp(-2 * t)]),
    ),
    (inverse_laplace(1e-3 / (s + 1e-3), s, t), sp.Rational(1, 1000) * sp.exp(-t / 1000)),
    (inverse_z(z * inverse(z * sp.eye(2) - A).operands[0].inv(), z, k), POWER),
    (inverse_z(product(z, inverse(z * sp.eye(2) - A)), z, k), POWER),
    (inverse_z(z / (z - a) ** 2, z, k), k * a ** (k - 1)),
    (inverse_z(1 / z**2, z, k), sp.KroneckerDelta(k, 2)),
    (inverse_z(product(z, total(quotient(1, z - 2), quotient(1, z - a))), z, k), 2**k + a**k),
    (laplace(1, t, s), 1 / s),
    (laplace(t * sp.exp(a * t), t, s), 1 / (s - a) ** 2),
    (laplace(sp.sin(2 * t), t, s), 2 / (s**2 + 4)),
    (laplace(exponential(product(A, t)), t, s), F.inv()),
    (laplace(t, t, 2 + sp.I), 1 / (2 + sp.I) ** 2),
    (product(s, laplace(sp.exp(-a * t), t, s)), s / (s + a)),
    (z_transform(1, k, z), z / (z - 1)),
    (z_transform(k * a**k, k, z), a * z / (z - a) ** 2),
    (z_transform(sp.KroneckerDelta(k, 2), k, z), 1 / z**2),
    (z_transform(power(A, k), k, z), z * (z * sp.eye(2) - A).inv()),
]

PRINTED = [
    (inverse_laplace(1 / (s + 1), s, t), r"\mathcal{L}^{-1}\left\{\frac{1}{s + 1}\right\}"),
    (inverse_z(z / (z - 1), z, k), r"\mathcal{Z}^{-1}\left\{\frac{z}{z - 1}\right\}"),
    (laplace(sp.exp(-t), t, s), r"\mathcal{L}\left\{e^{-t}\right\}"),
    (z_transform(k, k, z), r"\mathcal{Z}\left\{k\right\}"),
]
