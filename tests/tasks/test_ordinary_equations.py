"""The lemma that solves differential equations: its steps, its claims, what is beyond; systems; elimination."""

import pytest
import sympy as sp

from solver.derivation import CheckStatus, Unsolved
from solver.jets import jet_symbol
from solver.numeric import check_steps
from solver.render.wording import Wording
from solver.tasks.variations.ordinary_equations import solved, way_of

t = sp.Symbol("t")
x, x1, x2, x3, x4 = (jet_symbol(("x", k)) for k in range(5))
y, y1, y2 = (jet_symbol(("y", k)) for k in range(3))
l1, l1_rate, l2, l2_rate, u = (
    jet_symbol(jet) for jet in (("lambda1", 0), ("lambda1", 1), ("lambda2", 0), ("lambda2", 1), ("u", 0))
)
a, b = sp.Symbol("a", positive=True), sp.Symbol("b", real=True)
C1 = sp.Symbol("C1", real=True)


def run(equations, names=("x",), constants=()):
    """The families and the steps, all claims of which hold, worded at every level."""
    derivation, steps = solved(equations, names, t, constants), []
    while True:
        try:
            steps.append(next(derivation))
        except StopIteration as end:
            families = end.value
            break
    assert all(check.status is CheckStatus.PASSED for check in check_steps(steps))
    for detail in ("brief", "full", "tutor"):
        assert len(Wording(detail=detail).words(steps)) == len(steps)
    return families, [step.kind for step in steps]


def residual(equation, functions, constants):
    jets = {jet_symbol((name, k)): sp.diff(f, t, k) for name, f in functions.items() for k in range(6)}
    at = {c: sp.Rational(3 * i + 4, 5) for i, c in enumerate(constants)}
    at |= {t: sp.Rational(7, 5), a: sp.Rational(3, 2), b: sp.Rational(-2, 7)}
    return abs(sp.N(equation.xreplace(jets).subs(at), 30))


SINGLE = [
    (x2 + x, "constant_coefficients", ["characteristic", "homogeneous"], 2),
    (-2 * x2 - 2 * x, "constant_coefficients", ["standard_form", "characteristic", "homogeneous"], 2),
    (
        x2 - x - t * sp.exp(t) - 3,
        "constant_coefficients",
        ["characteristic", "homogeneous", "trial", "trial", "general"],
        2,
    ),
    (x2 - 6 * t, "integrated", ["integrated"], 2),
    (x2 / (1 + x1**2) ** sp.Rational(3, 2), "integrated", ["standard_form", "integrated"], 2),
    (x4 - x, "constant_coefficients", ["characteristic", "homogeneous"], 4),
    (a * x2 + b * x, "constant_coefficients", ["standard_form", "characteristic", "homogeneous"], 2),
    (x3 - x1 - x, "constant_coefficients", ["characteristic", "homogeneous"], 3),
    (t**2 * x2 + t * x1 - x - t**3, "euler_cauchy", ["indicial", "powers", "trial", "sum"], 2),
    ((1 + t**2) * x2 + 2 * t * x1, "reduced", ["standard_form", "reduced", "integrating_factor", "integrated"], 2),
    (x1 + 2 * t * x - t, "integrating_factor", ["integrating_factor"], 1),
    (t**2 * x1 - 1, "integrated", ["standard_form", "integrated"], 1),
]  # fmt: skip


@pytest.mark.parametrize(("equation", "way", "kinds", "order"), SINGLE, ids=[str(each[0]) for each in SINGLE])
def test_one_equation(equation, way, kinds, order):
    assert way_of([equation], ["x"], t) == way
    (family,), steps = run([equation])
    assert steps == kinds
    assert len(family.constants) == order
    assert residual(equation, family.functions, family.constants) < 1e-20
    shares = [sp.diff(family.functions["x"], c) for c in family.constants]
    wronskian = sp.Matrix([[sp.diff(share, t, k) for share in shares] for k in range(order)])
    assert abs(sp.N(wronskian.det().subs({t: 1.3, a: 1.5, b: -0.3}))) > 1e-9


@pytest.mark.parametrize(
    ("equation", "branches"),
    [
        (x / sp.sqrt(1 + x1**2) - C1, [C1 * sp.cosh((sp.Symbol("C2", real=True) + t) / C1)]),
        (1 / (x * sp.sqrt(1 + x1**2)) - C1, None),
        (x * x1 - C1, None),
    ],
)
def test_a_first_integral(equation, branches):
    assert way_of([equation], ["x"], t, [C1]) == "separable"
    families, steps = run([equation], constants=[C1])
    assert steps == ["rate", "separated"]
    assert all(family.constants[0] == C1 and len(family.constants) == 2 for family in families)
    if branches is not None:
        assert [family.functions["x"] for family in families] == branches


def test_constants_are_numbered_on_and_beside_names_of_the_question():
    (family,), _ = run([x2 - sp.Symbol("C1", real=True) * t])
    assert [str(c) for c in family.constants] == ["C2", "C3"]
    (family,), _ = run([x1 - C1 * t], constants=[C1])
    assert [str(c) for c in family.constants] == ["C1", "C2"]


@pytest.mark.parametrize(
    "equation", [x2 + sp.sin(x), x2 + t * x, x2 + x - 1 / t, x1**3 + x1 * x - t, x3 - a * x], ids=str
)
def test_what_is_beyond_is_told_with_the_equation(equation):
    with pytest.raises(Unsolved) as told:
        run([equation])
    assert str(told.value)


SYSTEMS = [
    ([l1_rate, l2_rate + l1, u + l2, x1 - y, y1 - u], ("lambda1", "lambda2", "u", "x", "y"), 4),
    ([l1_rate + x, l1 + u, x1 + x - u], ("lambda1", "u", "x"), 2),
    ([x2 - y, y2 - x], ("x", "y"), 4),
    ([2 * x2 + y2, x2 + 2 * y2], ("x", "y"), 4),
    ([x2 - y1, y2 + x1], ("x", "y"), 4),
    ([x2 + x, y2 - y - sp.exp(t)], ("x", "y"), 4),
    ([x1 + y - t, y1 - x], ("x", "y"), 2),
    ([x2 - a * y, y2 - a * x], ("x", "y"), 4),
]


@pytest.mark.parametrize(("equations", "names", "order"), SYSTEMS, ids=[str(each[0]) for each in SYSTEMS])
def test_several_equations(equations, names, order):
    assert way_of(equations, names, t) == "in_turn"
    (family,), _ = run(equations, names)
    assert len(family.constants) == order
    assert all(residual(equation, family.functions, family.constants) < 1e-18 for equation in equations)


def test_a_system_beyond_elimination_is_refused():
    assert way_of([x * y1 - 1, x1 * y2], ["x", "y"], t) == ""
    with pytest.raises(Unsolved):
        run([x * y1 - 1, x1 * y2], ("x", "y"))
