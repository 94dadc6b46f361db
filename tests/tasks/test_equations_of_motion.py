"""Equations of motion against sympy's LagrangesMethod: steps, textbook values, corruptions, marking, bad input."""

from __future__ import annotations

import pytest
import sympy as sp
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

from solver.classroom.verdicts import Verdict
from solver.derivation import CheckStatus, Status
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue
from tests.helpers.marked import marked

TASK = "equations_of_motion"


def file(system, find=TASK):
    return Source("file.yaml", f"system: {{{system}}}\nfind: {{a: {find}}}\n")


def read(system, find=TASK):
    return read_problem(file(system, find), catalogue())


def solved(system, find=TASK):
    return solve_problem(read(system, find)).parts[0]


def rejected(system, **answers):
    task, part = catalogue()[TASK], read(system).parts[0]
    checks = list(task.verify(task.given(part.system, {}), answers))
    return not checks or any(check.status is CheckStatus.FAILED for check in checks)


def complaint(system):
    with pytest.raises(InputError) as caught:
        read(system)
    return [f"{each.column} {each.message} {each.suggestion}".strip() for each in caught.value.diagnostics]


def symbols(names):
    return sp.symbols(names, real=True)


CART = (
    "lagrangian: {coordinates: [x, theta], bodies: [{mass: m_c, position: [x, 0]}, {mass: m_p, "
    'position: ["x + l sin(theta)", "l cos(theta)"], inertia: J, angle: theta}], gravity: g, '
    'dissipation: "b x\'^2/2", forces: {x: u}}, inputs: [u]'
)
ACROBOT = (
    "lagrangian: {coordinates: [q1, q2], bodies: [{mass: m1, position: [a1 sin(q1), -a1 cos(q1)], inertia: I1, "
    'angle: q1}, {mass: m2, position: ["l1 sin(q1) + a2 sin(q1 + q2)", "-l1 cos(q1) - a2 cos(q1 + q2)"], inertia: I2, '
    "angle: q1 + q2}], gravity: g, forces: {q2: tau}}, inputs: [tau]"
)
SPRING = (
    'lagrangian: {coordinates: [r, phi], bodies: [{mass: m, position: ["r sin(phi)", "-r cos(phi)"]}], gravity: g, '
    'springs: [{stiffness: k, length: r, rest: l}], dissipation: "d r\'^2/2"}'
)
DOUBLE = (
    'lagrangian: {coordinates: [a, b], bodies: [{mass: m1, position: ["l1 sin(a)", "-l1 cos(a)"]}, {mass: m2, '
    'position: ["l1 sin(a) + l2 sin(b)", "-l1 cos(a) - l2 cos(b)"]}], gravity: g}'
)
BOUND = (
    "lagrangian: {coordinates: [x, y], kinetic: \"m (x'^2 + y'^2)/2\", potential: m g y, "
    "constraints: [x^2 + y^2 = l^2]}"
)
ROPE = (
    "lagrangian: {coordinates: [x, y], bodies: [{mass: m, position: [x, y]}], "
    'springs: [{stiffness: k, length: "sqrt(x^2 + (l - y)^2)", rest: r}], gravity: g}'
)
MOVED = (
    'lagrangian: {coordinates: [theta], bodies: [{mass: m, position: ["w + l sin(theta)", "-l cos(theta)"]}], '
    "gravity: g}, inputs: [w]"
)
TURNING = (
    "lagrangian: {coordinates: [x, y], kinetic: \"m (x'^2 + y'^2)/2 + b (x y' - y x')/2\", potential: k (x^2 + y^2)/2}"
)
HOOP = (
    'lagrangian: {coordinates: [theta], kinetic: "m R^2 (theta\'^2 + w^2 sin(theta)^2)/2", '
    'potential: "-m g R cos(theta)"}'
)
EVERY = {"cart": CART, "acrobot": ACROBOT, "spring": SPRING, "double": DOUBLE, "bound": BOUND, "rope": ROPE,
         "moved": MOVED, "turning": TURNING, "hoop": HOOP}  # fmt: skip


def by_sympy(answers, coordinates, forces=None, friction=0):
    """The left sides of the equations by LagrangesMethod, in our symbols."""
    t = dynamicsymbols._t
    functions = {name: dynamicsymbols(name) for name in coordinates}
    put = {}
    for name, f in functions.items():
        put |= {sp.Symbol(name, real=True): f, sp.Symbol(f"{name}_dot", real=True): f.diff(t)}
    method = LagrangesMethod(answers["lagrangian"].xreplace(put), list(functions.values()))
    equations = method.form_lagranges_equations()
    back = {}
    for name, f in functions.items():
        back |= {f.diff(t, 2): sp.Symbol(f"{name}_ddot", real=True), f.diff(t): sp.Symbol(f"{name}_dot", real=True)}
    found = equations.xreplace({key: value for key, value in back.items() if key.derivative_count == 2})
    found = found.xreplace(back).xreplace({f: sp.Symbol(name, real=True) for name, f in functions.items()})
    drag = [sp.diff(friction, sp.Symbol(f"{name}_dot", real=True)) for name in coordinates]
    return [e + d - (forces or {}).get(name, 0) for e, d, name in zip(found, drag, coordinates, strict=True)]


def equal(left, right):
    return sp.expand(sp.expand_trig(sp.expand(left - right))).rewrite(sp.exp).expand() == 0


@pytest.mark.parametrize("name", EVERY)
def test_every_kind_of_energy_is_solved_and_verified(name):
    result = solved(EVERY[name])
    assert result.status is Status.VERIFIED
    assert all(check.status is CheckStatus.PASSED for check in result.checks)


def test_a_pendulum_on_a_cart():
    result = solved(CART)
    m_c, m_p, l, J, g, b, u = symbols("m_c m_p l J g b u")
    theta, w, a, v, x2 = symbols("theta theta_dot theta_ddot x_dot x_ddot")
    assert [step.kind for step in result.steps] == [
        "body", "body", "kinetic", "potential", "lagrangian", "coordinate", "coordinate", "equations",
        "manipulator", "skew",
    ]  # fmt: skip
    T = (m_c + m_p) * v**2 / 2 + m_p * l * v * w * sp.cos(theta) + (J + m_p * l**2) * w**2 / 2
    assert sp.expand(result.answers["kinetic"] - T) == 0
    assert result.answers["potential"] == m_p * g * l * sp.cos(theta)
    first, second = result.answers["equations"]
    assert sp.expand(first - ((m_c + m_p) * x2 + m_p * l * (a * sp.cos(theta) - w**2 * sp.sin(theta)) + b * v - u)) == 0
    assert sp.expand(second - (m_p * l * x2 * sp.cos(theta) + (J + m_p * l**2) * a - m_p * g * l * sp.sin(theta))) == 0
    assert result.answers["M"] == sp.Matrix(
        [[m_c + m_p, m_p * l * sp.cos(theta)], [m_p * l * sp.cos(theta), J + m_p * l**2]]
    )
    assert result.answers["C"] == sp.Matrix([[0, -m_p * l * w * sp.sin(theta)], [0, 0]])
    assert result.answers["gravity"] == sp.Matrix([0, -m_p * g * l * sp.sin(theta)])
    momentum = result.steps[6].claims["momentum"].right
    assert sp.expand(sp.Add(*momentum.operands) - (m_p * l * v * sp.cos(theta) + (J + m_p * l**2) * w)) == 0


@pytest.mark.parametrize(
    ("system", "coordinates", "forces", "friction"),
    [
        (CART, ["x", "theta"], {"x": symbols("u")}, symbols("b") * symbols("x_dot") ** 2 / 2),
        (ACROBOT, ["q1", "q2"], {"q2": symbols("tau")}, 0),
        (SPRING, ["r", "phi"], {}, symbols("d") * symbols("r_dot") ** 2 / 2),
        (DOUBLE, ["a", "b"], {}, 0),
        (TURNING, ["x", "y"], {}, 0),
        (HOOP, ["theta"], {}, 0),
        (ROPE, ["x", "y"], {}, 0),
    ],
)
def test_the_equations_are_those_of_lagranges_method(system, coordinates, forces, friction):
    answers = solved(system).answers
    for ours, theirs in zip(answers["equations"], by_sympy(answers, coordinates, forces, friction), strict=True):
        assert equal(ours, theirs)


def test_the_form_of_a_manipulator_gives_the_equations_back():
    answers = solved(ACROBOT).answers
    speed, bend = (sp.Matrix(symbols(f"q1_{d} q2_{d}")) for d in ("dot", "ddot"))
    force = sp.Matrix([0, symbols("tau")])
    M, C, G = (answers[name] for name in ("M", "C", "gravity"))
    assert (M * bend + C * speed + G - force - sp.Matrix(answers["equations"])).expand() == sp.zeros(2, 1)
    rate = M.diff(symbols("q2")) * symbols("q2_dot")
    assert ((rate - 2 * C) + (rate - 2 * C).T).expand() == sp.zeros(2, 2)


def test_products_of_sines_and_cosines_of_two_angles_are_one():
    answers = solved(DOUBLE).answers
    a, b, a_dot, b_dot, l1, l2, m2 = symbols("a b a_dot b_dot l1 l2 m2")
    assert answers["M"][0, 1] == l1 * l2 * m2 * sp.cos(a - b)
    assert answers["C"] == l1 * l2 * m2 * sp.sin(a - b) * sp.Matrix([[0, b_dot], [-a_dot, 0]])


def test_a_constraint_has_its_multiplier_and_follows_the_equations():
    result = solved(BOUND)
    m, g, x, y, l, lambda1 = symbols("m g x y l lambda1")
    x2, y2 = symbols("x_ddot y_ddot")
    assert result.answers["equations"] == [
        m * x2 - 2 * lambda1 * x, m * y2 + m * g - 2 * lambda1 * y, x**2 + y**2 - l**2
    ]  # fmt: skip
    assert not rejected(BOUND, equations=[m * x2 - 2 * sp.Symbol("lambda1") * x, *result.answers["equations"][1:]])


def test_what_moves_a_body_stands_in_its_equation():
    result = solved(MOVED)
    m, g, l, theta, a, w2 = symbols("m g l theta theta_ddot w_ddot")
    (equation,) = result.answers["equations"]
    assert sp.expand(equation - m * l * (l * a + w2 * sp.cos(theta) + g * sp.sin(theta))) == 0
    assert "M" not in result.answers


coefficients = st.lists(st.integers(-3, 3), min_size=8, max_size=8)


@settings(max_examples=10)
@given(coefficients)
def test_any_two_bodies_move_as_lagranges_method_says(c):
    system = (
        f"lagrangian: {{coordinates: [p, q], bodies: [{{mass: 2, "
        f'position: ["({c[0]}) p + ({c[1]}) sin(q)", "p^2/2 - q"]}}, '
        f'{{mass: m, position: ["cos(p + ({c[2]}) q)", "({c[3]}) q + ({c[4]}) p"], '
        f'inertia: J, angle: "p - ({c[5]}) q"}}], '
        f'gravity: g, springs: [{{stiffness: k, length: "p - ({c[6]}) q", rest: 1}}], dissipation: "({c[7]}) p\' q\'"}}'
    )
    result = solved(system)
    assert result.status is Status.VERIFIED
    friction = c[7] * symbols("p_dot") * symbols("q_dot")
    for ours, theirs in zip(
        result.answers["equations"], by_sympy(result.answers, ["p", "q"], {}, friction), strict=True
    ):
        assert equal(ours, theirs)


def corrupted(expression):
    """Signs, dropped terms, factors, sines for cosines."""
    yield -expression
    yield expression * 2
    for term in sp.Add.make_args(sp.expand(expression)):
        yield expression - term
        yield expression - 2 * term
        yield expression + term / 100
        exchanged = term.xreplace({f: sp.cos(f.args[0]) for f in term.atoms(sp.sin)})
        if exchanged != term:
            yield expression - term + exchanged


def is_constant(difference, system):
    """Whether no motion changes a difference of energies."""
    return not sp.expand(difference).free_symbols & set(read(system).parts[0].system.jets)


SLOW = [pytest.param(name, marks=pytest.mark.slow) for name in ("spring", "rope", "turning", "hoop")]


@pytest.mark.parametrize("name", ["cart", "bound", "moved", *SLOW])
def test_corrupted_answers_are_rejected(name):
    system = EVERY[name]
    answers = solved(system).answers
    assert not rejected(system, **answers)
    for key in ("kinetic", "potential", "lagrangian"):
        for wrong in corrupted(answers[key]):
            if wrong != answers[key] and (key == "kinetic" or not is_constant(wrong - answers[key], system)):
                assert rejected(system, **{key: wrong}), (key, wrong)
    for i, equation in enumerate(answers["equations"]):
        for wrong in list(corrupted(equation))[2:]:
            listed = [*answers["equations"][:i], wrong, *answers["equations"][i + 1 :]]
            if sp.expand(wrong) != 0 and not sp.cancel(wrong / equation).is_number:
                assert rejected(system, equations=listed), wrong
    assert rejected(system, equations=answers["equations"][1:])
    for key in ("M", "C", "gravity"):
        M = answers.get(key)
        for place in range(len(M or [])):
            for wrong in corrupted(M[place] if M[place] != 0 else symbols("unknown")):
                changed = sp.Matrix(M)
                changed[place] = wrong
                if sp.expand(wrong - M[place]) != 0:
                    assert rejected(system, **{key: changed.as_immutable()}), (key, place, wrong)


def test_equations_are_right_up_to_factors_and_order():
    answers = solved(CART).answers
    first, second = answers["equations"]
    l, m_p = symbols("l m_p")
    for right in ([second, first], [-2 * first, second / (m_p * l)], [first * sp.cos(symbols("theta")), second]):
        assert not rejected(CART, equations=right)
    assert rejected(CART, equations=[first, first])
    assert rejected(CART, equations=[first, second * symbols("theta_dot")])
    assert not rejected(CART, potential=answers["potential"] + symbols("g") * l)
    assert rejected(CART, kinetic=answers["kinetic"] + l)


PROBLEM = f"system: {{{CART}}}\nfind: {{a: {TASK}}}\n"
FIRST = "(m_c + m_p) x'' + m_p l theta'' cos(theta) - m_p l theta'^2 sin(theta) + b x' = u"
SECOND = "m_p l x'' cos(theta) + (J + m_p l^2) theta'' - m_p g l sin(theta) = 0"


def verdict(*equations):
    return marked(PROBLEM, yaml.safe_dump({"answers": {"a": {"equations": list(equations)}}}))["a"].answers["equations"]


@pytest.mark.parametrize(
    "written",
    [
        (FIRST, SECOND),
        (SECOND, FIRST),
        ("x'' cos(theta) + (l + J/(m_p l)) theta'' = g sin(theta)", FIRST.replace("''", "_ddot").replace("'", "_dot")),
    ],
)
def test_right_equations_are_marked_right_as_they_are_written(written):
    found = verdict(*written)
    assert found.verdict is Verdict.CORRECT
    assert [str(each) for each in found.entries] == ["correct", "correct"]


@pytest.mark.parametrize(
    ("first", "second", "mistake"),
    [
        (FIRST.replace("= u", "= -u"), SECOND, "force_sign"),
        (FIRST, SECOND.replace(" - m_p g l sin(theta)", ""), "no_gravity"),
        (FIRST, SECOND.replace("- m_p g", "+ m_p g"), "gravity_sign"),
        (FIRST, SECOND.replace("J + ", ""), "rotational_inertia"),
        (FIRST, SECOND.replace("(J + m_p l^2)", "J"), "parallel_axis"),
        (FIRST.replace(" + b x'", ""), SECOND, "friction"),
        (FIRST.replace(" - m_p l theta'^2 sin(theta)", ""),
         SECOND.replace(" - m_p g", " + m_p l x' theta' sin(theta) - m_p g"),
         "product_rule"),
        ("(m_c + m_p) x'' - m_p l theta'' sin(theta) - m_p l theta'^2 cos(theta) + b x' = u",
         "-m_p l x'' sin(theta) + (J + m_p l^2) theta'' + m_p g l cos(theta) = 0", "exchanged"),
    ],
)  # fmt: skip
def test_usual_mistakes_are_named(first, second, mistake):
    found = verdict(first, second)
    assert (found.verdict, found.mistake) == (Verdict.WRONG, mistake)


@pytest.mark.parametrize(
    ("system", "says"),
    [
        ("lagrangian: {coordinates: [x], kinetic: m x'^2/2, forces: {y: u}}, inputs: u", "69 'y' is no coordinate"),
        ("lagrangian: {coordinates: [theta], kinetic: m theta'^2/2, forces: {tetha: u}}, inputs: u",
         "77 'tetha' is no coordinate theta"),
        ("lagrangian: {coordinates: [x], potential: x^2}", "23 a kinetic energy is missing"),
        ("lagrangian: {coordinates: [x], bodies: [{mass: m, position: x}]}", "70 a position is two expressions"),
        ("lagrangian: {coordinates: [x], bodies: [{mass: m, position: [x, 0, 0]}]}", "70 a position is two"),
        ("lagrangian: {coordinates: [x], kinetic: x'^2, springs: [{length: x}]}", "66 'stiffness' is missing here"),
        ("lagrangian: {coordinates: [x], bodies: [{mas: m, position: [x, 0]}]}", "51 unknown key 'mas' mass"),
        ("lagrangian: {coordinates: [x], bodies: [{mass: m}]}", "51 'mass' needs 'position' beside it"),
        ("lagrangian: {coordinates: [x], kinetic: x'^2, gravity: g}", "56 gravity acts on 'bodies'; there are none"),
        ("lagrangian: {coordinates: [x, y], kinetic: x'^2}", "40 'y' occurs nowhere"),
        ("lagrangian: {coordinates: [x], kinetic: x''^2}", "50 this is to be given in coordinates and velocities"),
        ("lagrangian: {coordinates: [x], kinetic: x'^2, potential: m x'}", "67 this is to be given in coordinates"),
        ("lagrangian: {coordinates: [x], kinetic: lambda1 x'^2, constraints: [x]}", "64 'lambda1' is the multiplier"),
        ("lagrangian: {coordinates: [x], kinetic: x'^2}, states: [x'']", "66 states are the coordinates"),
        ("lagrangian: {coordinates: [x], kinetic: x'^2}, inputs: [x]", "66 'x' is a coordinate already"),
        ("time: discrete, lagrangian: {coordinates: [x], kinetic: x'^2}", "16 energies are those of a system"),
        ("lagrangian: {coordinates: [x], kinetic: z'^2}", "z is not a function of time"),
    ],
)  # fmt: skip
def test_what_is_wrong_with_energies_is_said_at_its_place(system, says):
    found = complaint(system)
    assert any(says in message for message in found), found


def test_every_question_about_equations_takes_energies():
    linear = (
        "lagrangian: {coordinates: [x], kinetic: m x'^2/2, potential: k x^2/2, dissipation: d x'^2/2, forces: {x: u}}, "
        "inputs: [u]"
    )
    G = solved(linear, "transfer_function").answers["G"]
    s, m, d, k = sp.Symbol("s"), *symbols("m d k")
    assert sp.cancel(G - 1 / (m * s**2 + d * s + k)) == 0
    model = solved(CART + ", states: [theta, theta', x, x']", "state_space_model")
    assert model.status is Status.VERIFIED
    assert model.answers["f"][0] == symbols("theta_dot")


def test_a_coordinate_that_a_constraint_gives_is_eliminated():
    rolls = (
        "lagrangian: {coordinates: [x, phi], kinetic: \"M x'^2/2 + J phi'^2/2\", forces: {phi: tau}, "
        "constraints: [x = R phi]}, inputs: [tau], states: [phi, phi']"
    )
    result = solved(rolls, "state_space_model")
    M, J, R = symbols("M J R")
    assert result.status is Status.VERIFIED
    assert sp.cancel(result.answers["B"][1] - 1 / (J + M * R**2)) == 0
