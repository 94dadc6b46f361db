"""Realizations of one transfer function by all methods: the same function, as many states as there are poles."""

import numpy as np
import pytest
import sympy as sp

from solver import exact
from solver.exact.time_response.input_generators import read_inputs

s, t, k, z = sp.symbols("s t k z")
M = sp.ImmutableMatrix
SIMPLE = {
    "one pole": ([[3]], [[s + 2]]),
    "one pole and a feedthrough": ([[2 * s + 1]], [[s + 2]]),
    "a number": ([[3]], [[sp.Integer(2)]]),
    "real poles": ([[s + 5]], [[(s + 1) * (s + 2) * (s - 3)]]),
    "a pair": ([[s + 3]], [[s**2 + 2 * s + 5]]),
    "poles with roots": ([[1]], [[s**2 + 4 * s + 1]]),
    "two inputs and outputs": ([[1, 2], [1, 3]], [[s + 1, s + 2], [s + 2, s + 1]]),
}
REPEATED = {
    "a double pole": ([[s + 3]], [[(s + 1) ** 2]]),
    "a triple pole and another": ([[s**2 + 1]], [[(s + 1) ** 3 * (s + 4)]]),
    "a double pair": ([[s]], [[(s**2 + 1) ** 2]]),
    "a double pole in one entry": ([[1, 1], [1, 2]], [[(s + 1) ** 2, s + 1], [s + 1, s + 1]]),
}


def has_the_function(found, tops, bottoms):
    """Whether C (sI − A)⁻¹ B + D is the matrix of the fractions at some points."""
    A, B, C, D = (
        np.array(N.evalf().tolist(), dtype=complex).reshape(N.shape) for N in (found.A, found.B, found.C, found.D)
    )
    for point in (0.7, -0.3 + 2.1j, 3.3):
        G = C @ np.linalg.solve(point * np.eye(len(A)) - A, B) + D
        right = [
            [complex(sp.sympify(top / bottom).subs(s, point)) for top, bottom in zip(*rows, strict=True)]
            for rows in zip(tops, bottoms, strict=True)
        ]
        if not np.allclose(G, right, rtol=1e-9, atol=1e-11):
            return False
    return True


@pytest.mark.parametrize("name", [*SIMPLE, *REPEATED])
@pytest.mark.parametrize("method", ["controllable", "observable", "jordan", "modal", "diagonal"])
def test_every_realization_has_the_transfer_function(name, method):
    tops, bottoms = (SIMPLE | REPEATED)[name]
    G = exact.transfer_matrix_of_fractions(tops, bottoms, s)
    realize = getattr(exact, f"{method}_realization")
    if method == "diagonal" and name in REPEATED:
        with pytest.raises(ValueError, match="chain"):
            realize(G)
        return
    found = realize(G)
    assert has_the_function(found, tops, bottoms)
    if method in {"jordan", "diagonal"}:
        poles = [entry for i, entry in enumerate(found.A.flat()) if i % (found.A.rows + 1) == 0]
        common = sp.lcm_list([sp.sympify(bottom) for row in bottoms for bottom in row])
        assert all(sp.expand(common.subs(s, pole)) == 0 for pole in poles)


@pytest.mark.parametrize("entry", [sp.Float("0.5"), sp.Float("0.5") * sp.I])
def test_complex_numbers_beside_decimals_have_no_exact_product(entry):
    T = M([[sp.I, entry], [1, 2]])
    for computed in (exact.inverse_in_full, exact.is_singular, lambda T: exact.product_of(T, T)):
        with pytest.raises(exact.NotExact):
            computed(T)


@pytest.mark.parametrize(
    ("u", "image"),
    [
        (sp.exp(-t), 1 / (s + 1)),
        (sp.DiracDelta(t) + sp.exp(-t), 1 + 1 / (s + 1)),
        (3 * sp.DiracDelta(t), sp.Integer(3)),
        (t * sp.sin(2 * t), 4 * s / (s**2 + 4) ** 2),
        (t**2 * sp.exp(t), 2 / (s - 1) ** 3),
    ],
)
def test_the_transform_of_an_input(u, image):
    (piece,) = read_inputs([u], t, discrete=False)
    assert sp.cancel(piece.image(s, discrete=False)[0] - image) == 0


@pytest.mark.parametrize(
    ("u", "image"),
    [
        (2**k, z / (z - 2)),
        (k, z / (z - 1) ** 2),
        (k**2, z * (z + 1) / (z - 1) ** 3),
        (3**k + sp.DiracDelta(k), z / (z - 3) + 1),
        (sp.Heaviside(k - 2), 1 / (z * (z - 1))),
        (sp.DiracDelta(k - 2), z**-2),
        (sp.sin(sp.pi * k / 2), z / (z**2 + 1)),
    ],
)
def test_the_z_transform_of_an_input(u, image):
    pieces = read_inputs([sp.sympify(u)], k, discrete=True)
    found = sum(piece.image(z, discrete=True)[0] * z**-piece.delay for piece in pieces)
    assert sp.cancel(sp.together(found) - image) == 0
