"""Formulas of `solver.stated.calculus`: what they are equal to, and how they are printed."""

import sympy as sp
from sympy import Integer, exp, oo

from solver.stated.algebra import exponential, product
from solver.stated.calculus import (
    convolution,
    convolution_sum,
    denoted,
    derivative,
    integral,
    partial_derivative,
    time_derivative,
    value_at,
)
from solver.stated.matrices import inverse
from tests.stated.values import PHI, A, F, M, a, k, m, s, t, tau, x

q, w = sp.Function("q")(t), sp.Function("w")(x, t)
SPEED, ACCELERATION = sp.diff(q, t), sp.diff(q, t, 2)
LAGRANGIAN = a * SPEED**2 / 2 - sp.cos(q) * SPEED + x * sp.cos(q)

X_DOT, X_DDOT = sp.symbols("x_dot x_ddot", real=True)
MOVES = [(x, X_DOT), (X_DOT, X_DDOT)]

RIGHT = [
    (derivative(sp.exp(a * x), x), a * sp.exp(a * x)),
    (derivative(sp.Matrix([[sp.exp(-50 * x), x**4]]), x, 3), sp.Matrix([[-125000 * sp.exp(-50 * x), 24 * x]])),
    (derivative(1 / (x - 3), x, 2), 2 / (x - 3) ** 3),
    (derivative(inverse(F), s), -(F.inv() ** 2)),
    (integral(sp.exp(-a * tau), tau, 0, t), (1 - sp.exp(-a * t)) / a),
    (integral(product(sp.exp(-(t - tau)), sp.sin(tau)), tau, 0, t), (sp.exp(-t) + sp.sin(t) - sp.cos(t)) / 2),
    (integral(exponential(A * tau), tau, 0, t), A.inv() * (PHI - sp.eye(2))),
    (integral(sp.exp(-3 * tau), tau, 1, sp.oo), sp.exp(-3) / 3),
    (value_at(PHI, t, 0), sp.eye(2)),
    (value_at(derivative(PHI, t, 2), t, sp.Integer(0)), A**2),
    (value_at(x**2 + a, x, a), a**2 + a),
    (partial_derivative(a * x**3, x), 3 * a * x**2),
    (partial_derivative(a * x**3, x, 2), 6 * a * x),
    (partial_derivative(LAGRANGIAN, SPEED), a * SPEED - sp.cos(q)),
    (partial_derivative(LAGRANGIAN, q), sp.sin(q) * (SPEED - x)),
    (derivative(partial_derivative(LAGRANGIAN, SPEED), t), a * ACCELERATION + sp.sin(q) * SPEED),
    (derivative(t * q**2, t), q**2 + 2 * t * q * SPEED),
    (derivative(sp.Matrix([[q, SPEED]]), t), sp.Matrix([[SPEED, ACCELERATION]])),
    (partial_derivative(w**2, x), 2 * w * sp.diff(w, x)),
    (derivative(sp.diff(w, x), t), sp.diff(w, x, t)),
    (time_derivative(a * sp.sin(x), MOVES), a * sp.cos(x) * X_DOT),
    (time_derivative(partial_derivative(denoted("L", x * X_DOT**2), X_DOT), MOVES), 2 * (X_DOT**2 + x * X_DDOT)),
    (denoted("L", a * x**2), a * x**2),
    (value_at(q, t, x + 1), sp.Function("q")(x + 1)),
    (convolution(sp.exp(-t), sp.sin(t), t), (sp.exp(-t) + sp.sin(t) - sp.cos(t)) / 2),
    (convolution(exponential(product(A, t)), sp.Matrix([0, 1]), t), A.inv() * (PHI - sp.eye(2)) * sp.Matrix([0, 1])),
    (convolution(1, t, t), t**2 / 2),
    (convolution_sum(2**k, a**k, k), (2 ** (k + 1) - a ** (k + 1)) / (2 - a)),
    (convolution_sum(k, 1, k), k * (k + 1) / 2),
]

PRINTED = [
    (derivative(exp(-t), t), r"\frac{d}{dt}e^{-t}"),
    (derivative(exp(-t) + 1, t), r"\frac{d}{dt}(1 + e^{-t})"),
    (derivative(M, t, 2), rf"\frac{{d^{{2}}}}{{dt^{{2}}}}{m}"),
    (derivative(exp(-t), t, 0), "e^{-t}"),
    (integral(exp(-t) + 1, t, Integer(0), oo), r"\int_{0}^{\infty}(1 + e^{-t})\,dt"),
    (value_at(s**2 + 1, s, Integer(-2)), r"\left.(s^{2} + 1)\right|_{s = -2}"),
    (value_at(derivative(M, t), t, Integer(0)), rf"\left.\frac{{d}}{{dt}}{m}\right|_{{t = 0}}"),
    (partial_derivative(a * x, x, 2), r"\frac{\partial^{2}}{\partial x^{2}}ax"),
    (partial_derivative(denoted("L", a * x), x), r"\frac{\partial L}{\partial x}"),
    (time_derivative(a * x + 1, MOVES), r"\frac{d}{dt}(ax + 1)"),
    (time_derivative(denoted("x_1", a * x), MOVES), r"\frac{dx_1}{dt}"),
    (time_derivative(partial_derivative(denoted("L", x), x), MOVES), r"\frac{d}{dt}\frac{\partial L}{\partial x}"),
    (denoted("L", a * x), "L"),
    (partial_derivative(q, SPEED), r"\frac{\partial}{\partial\frac{dq}{dt}}q(t)"),
    (convolution(exp(-t), t + 1, t), r"e^{-t} \ast (t + 1)"),
    (convolution_sum(a**k, k, k), r"a^{k} \ast k"),
]
