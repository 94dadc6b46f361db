"""The linear quadratic regulator: the state feedback that minimizes ∫ xᵀQx + uᵀRu dt."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from solver.derivation import (
    AnswerName,
    Answers,
    Check,
    Claim,
    Derivation,
    Given,
    MatrixOf,
    Number,
    Option,
    Step,
    Task,
    lemma,
)
from solver.derivation.stated import Stated, difference, inverse, product, transpose
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.tasks.design.regulator import Regulator, faulty_weights
from solver.tasks.design.riccati import solution_by_hamiltonian, solutions_by_equations
from solver.tasks.design.riccati_checks import (
    FLOATS,
    gain_check,
    listed_checks,
    loop_check,
    spectrum_check,
    stabilizing_checks,
)

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

    from solver.numeric import Weights

lqr = Task(
    "lqr",
    group="Design",
    title="Linear quadratic regulator",
    doc="The feedback u = −K x that minimizes ∫ xᵀQx + uᵀRu dt, by the algebraic Riccati equation.",
    needs=("A", "B"),
    options=[
        Option("Q", MatrixOf("n", "n"), "weight of the state, n×n, symmetric and positive semidefinite (default I)"),
        Option("R", MatrixOf("m", "m"), "weight of the input, m×m, symmetric and positive definite (default I)"),
        Option("output_weight", MatrixOf(), "w for Q = w CᵀC, or a matrix W (p×p) for Q = CᵀWC"),
        Option("tolerances", MatrixOf("n", 1, flat="column"), "tolerable deviations x̃ of the states: Q = diag(1/x̃²)"),
        Option("initial_state", MatrixOf("n", 1, flat="column"), "x(0), for the least cost (numbers or symbols)"),
        Option("cost_factor", Number(), "factor before the integral of the cost, 1/2 (the default) or 1"),
    ],
    answers=[
        AnswerName("P", "P", "the stabilizing solution of the Riccati equation, n×n"),
        AnswerName("K", "K_f", "the gain in u = −K x, m×n"),
        AnswerName("u", "u", "the control law in the states x1, x2, … (several inputs: a column)"),
        AnswerName("Q", "Q", "weight of the state as used"),
        AnswerName("R", "R", "weight of the input as used"),
        AnswerName("closed_loop_A", "A - BK_f", "A − BK"),
        AnswerName("eigenvalues", r"\lambda_i", "eigenvalues of the closed loop"),
        AnswerName("cost", r"J^{*}", "the least cost from the initial state", optional=True),
        AnswerName("equations", r"\text{equations}", "expressions in p11, p12, … that are zero", ("riccati",)),
        AnswerName("solutions", r"P_i", "all real symmetric solutions", ("riccati",), optional=True),
        AnswerName(
            "definiteness",
            r"\text{definiteness}",
            "what each solution is, in order",
            ("riccati",),
            optional=True,
            ordered=True,
        ),
    ],
    example={"Q": "[[1, 0], [0, 1]]", "R": "1"},
)


@lqr.refusal
def wrong_weights(system: Any, options: Mapping[str, Any]) -> Iterable[tuple[str, str]]:
    """Weights given twice, of the wrong size, or not definite as they must be."""
    yield from faulty_weights(options)
    yield from _faulty_state_weight(system, options)
    factor = options.get("cost_factor")
    if factor is not None and factor.is_positive is False:
        yield "cost_factor", "cost_factor must be positive"


def _faulty_state_weight(system: Any, options: Mapping[str, Any]) -> Iterable[tuple[str, str]]:
    """Faults of the weight of the state: given twice or not at all, of the wrong size or sign."""
    ways = [name for name in ("Q", "output_weight", "tolerances") if name in options]
    if not ways and "R" not in options:
        yield "", "say what is weighed: give Q and R, or output_weight, or tolerances"
    for other in ways[1:]:
        yield other, f"the weight of the state is given twice, by {ways[0]} and by {other}"
    W: Any = options.get("output_weight")
    C: Any = getattr(system, "C", None)
    if W is not None and C is None:
        yield "output_weight", "output_weight needs outputs, and the system has no C"
    elif W is not None:
        p = C.rows
        if W.shape not in {(1, 1), (p, p)}:
            yield "output_weight", f"output_weight must be a number or {p}×{p}, one row and column for each output"
        else:
            yield from (
                ("output_weight", message.replace("Q", "output_weight", 1)) for _, message in faulty_weights({"Q": W})
            )
    tolerances = options.get("tolerances")
    if tolerances is not None and any(x.is_positive is False for x in tolerances):
        yield "tolerances", "tolerances must be positive"


def _weights_as_stated(given: Given) -> tuple[Any, ImmutableMatrix]:
    """Q, as the formula that gives it where there is one, and R."""
    C, W, tolerances = given.system.C, given.output_weight, given.tolerances
    R = given.R if given.R is not None else sp.ImmutableMatrix(sp.eye(given.system.B.cols))
    if tolerances is not None:
        return sp.ImmutableMatrix(sp.diag(*(1 / x**2 for x in tolerances))), R
    if W is None:
        return (given.Q if given.Q is not None else sp.ImmutableMatrix(sp.eye(given.system.order))), R
    if W.shape == (1, 1):
        return product(W[0, 0], transpose(C), C), R
    return product(transpose(C), W, C), R


@lemma("regulator")
def _weights(given: Given) -> Derivation[tuple[ImmutableMatrix, ImmutableMatrix]]:
    """Show Q and R as used."""
    C, W = given.system.C, given.output_weight
    stated, R = _weights_as_stated(given)
    Q = stated
    claims = {}
    if isinstance(stated, Stated):
        scale = W[0, 0] * sp.eye(C.rows) if W.shape == (1, 1) else W
        Q = sp.ImmutableMatrix((C.T * scale * C).expand())
        claims["Q"] = Claim(stated, Q, "weight of the state")
    way = "outputs" if W is not None else "tolerances" if given.tolerances is not None else "given"
    yield Step(
        "weights",
        claims=claims,
        unclaimed="" if claims else "the weights are given",
        Q=Q,
        R=R,
        way=way,
        scalar=W is not None and W.shape == (1, 1),
        chosen_Q=way == "given" and given.Q is None,
        chosen_R=given.R is None,
        tolerances=list(given.tolerances) if given.tolerances is not None else [],
        factor=_factor(given),
    )
    return Q, R


def _factor(given: Given) -> Expr:
    """The factor before the integral."""
    return sp.sympify(given.cost_factor) if given.cost_factor is not None else sp.Rational(1, 2)


@lqr.method("riccati", title="Riccati equation", source="Lecture note, section 5.3", time="continuous")
def by_the_riccati_equation(given: Given) -> Derivation[Answers]:
    """Solve AᵀP + PA − P B R⁻¹ Bᵀ P + Q = 0 entry by entry and choose the stabilizing solution."""
    Q, R = yield from _weights(given)
    problem = Regulator.of(given.system.A, given.system.B, Q, R)
    equation, listed = yield from solutions_by_equations(problem)
    answers = yield from _control(given, problem, equation)
    answers["equations"] = problem.restored(listed.equations)
    if listed.solutions is not None:
        answers["solutions"] = problem.restored(listed.solutions)
        answers["definiteness"] = listed.definiteness
    return answers


@lqr.method(
    "hamiltonian",
    title="Hamiltonian matrix",
    source="Lancaster and Rodman, Algebraic Riccati Equations",
    time="continuous",
)
def by_the_hamiltonian_matrix(given: Given) -> Derivation[Answers]:
    """Take the stable half of the spectrum of the Hamiltonian matrix; its invariant subspace gives P."""
    Q, R = yield from _weights(given)
    problem = Regulator.of(given.system.A, given.system.B, Q, R)
    equation = yield from solution_by_hamiltonian(problem)
    return (yield from _control(given, problem, equation))


@lemma("regulator")
def _control(given: Given, problem: Regulator, equation: exact.Riccati) -> Derivation[Answers]:
    """Find K = R⁻¹BᵀP, u = −K x, the closed loop and the cost."""
    P, n = equation.stabilizing.P, problem.A.rows
    K = equation.gain(problem.B, problem.R)
    yield Step(
        "gain",
        claims={"K": Claim(product(inverse(problem.R), sp.ImmutableMatrix(problem.B.T), P), K, "the gain")},
        K=K,
    )
    states = states_of(given)
    control = sp.ImmutableMatrix(-K * sp.Matrix(states))
    u = control[0, 0] if control.rows == 1 else control
    yield Step("law", claims={"u": Claim(product(-1, K, sp.ImmutableMatrix(states)), control, "the control law")}, u=u)
    loop = sp.ImmutableMatrix((problem.A - problem.B * K).expand())
    yield Step(
        "closed_loop",
        claims={"loop": Claim(difference(problem.A, product(problem.B, K)), loop, "closed loop $A - BK$")},
        eigenvalues=equation.eigenvalues,
        n=n,
    )
    answers = Answers(P=P, K=K, u=u, Q=problem.Q, R=problem.R, closed_loop_A=loop, eigenvalues=equation.eigenvalues)
    x0 = _initial_state(given)
    if x0 is not None:
        start = x0.xreplace({plain: positive for positive, plain in problem.plain.items()})
        stated = product(_factor(given), sp.ImmutableMatrix(start.T), P, start)
        cost = sp.expand((start.T * P * start)[0, 0] * _factor(given))
        yield Step("cost", claims={"J": Claim(stated, cost, "the least cost")}, factor=_factor(given))
        answers["cost"] = cost
    return Answers(**{name: problem.restored(value) for name, value in answers.items()})


def states_of(given: Given) -> list[Symbol]:
    """The symbols of the states: their names, or x1, x2, …."""
    names = given.system.state_names or tuple(f"x{i + 1}" for i in range(given.system.order))
    return [sp.Symbol(name) for name in names]


def _initial_state(given: Given) -> ImmutableMatrix | None:
    x0: ImmutableMatrix | None = given.initial_state if given.initial_state is not None else given.system.x0
    return x0


def _problem(given: Given) -> Weights:
    """The plant and the weights, for the judges."""
    stated, R = _weights_as_stated(given)
    if isinstance(stated, Stated):
        C, W = given.system.C, given.output_weight
        stated = sp.ImmutableMatrix(C.T * (W[0, 0] * sp.eye(C.rows) if W.shape == (1, 1) else W) * C)
    return numeric.Weights(given.system.A, given.system.B, stated, R)


@lqr.verification("P")
def is_the_stabilizing_solution(given: Given, answers: Answers) -> Iterable[Check]:
    """P is symmetric, solves the Riccati equation, and A − BR⁻¹BᵀP is Hurwitz; there is only one such P."""
    yield from stabilizing_checks(_problem(given), answers["P"], "A - BR^{-1}B^{T}P")


@lqr.verification("K")
def is_optimal(given: Given, answers: Answers) -> Iterable[Check]:
    """K stabilizes and is R⁻¹BᵀP for the matrix P of its own cost."""
    label = "$K$ stabilizes, and $K = R^{-1}B^{T}P$ for the $P$ of its own cost"
    yield gain_check(_problem(given), answers["K"], "K", label)


@lqr.verification("u")
def is_the_optimal_control(given: Given, answers: Answers) -> Iterable[Check]:
    """U = −K x at random states, K from scipy."""
    yield numeric.check_residual(
        "$u = -Kx$ at random states",
        "scipy.linalg.solve_continuous_are",
        lambda: numeric.control_residual(_problem(given), answers["u"], states_of(given)),
        FLOATS,
    )


@lqr.verification("Q", "R")
def are_the_weights_asked_for(given: Given, answers: Answers) -> Iterable[Check]:
    """Q and R as the question says."""
    Q, R = _weights_as_stated(given)
    for name, stated in (("Q", Q), ("R", R)):
        if name in answers:
            yield numeric.check_claim(Claim(stated, answers[name]), f"${name}$ as the question says", answer=name)


@lqr.verification("closed_loop_A")
def is_the_optimal_loop(given: Given, answers: Answers) -> Iterable[Check]:
    """A − BK with scipy's K."""
    yield loop_check(_problem(given), answers["closed_loop_A"], "closed_loop_A", "$A - BK$ with the optimal $K$")


@lqr.verification("eigenvalues")
def are_the_stable_eigenvalues(given: Given, answers: Answers) -> Iterable[Check]:
    """The stable half of the spectrum of the Hamiltonian matrix."""
    yield spectrum_check(_problem(given), answers["eigenvalues"])


@lqr.verification("cost")
def is_the_least_cost(given: Given, answers: Answers) -> Iterable[Check]:
    """The cost of the optimal loop by its Lyapunov equation."""
    x0 = _initial_state(given)
    yield numeric.check_residual(
        "the cost of the optimal loop from $x(0)$",
        "scipy.linalg.solve_continuous_lyapunov",
        lambda: numeric.cost_residual(_problem(given), answers["cost"], x0, _factor(given)),
        FLOATS,
    )


@lqr.verification("equations")
def are_the_entries_of_the_equation(given: Given, answers: Answers) -> Iterable[Check]:
    """The entries of AᵀP + PA − P B R⁻¹ Bᵀ P + Q, in any order and scale."""
    yield numeric.check_residual(
        "the entries of the Riccati equation at random $P$",
        "random points",
        lambda: numeric.equations_residual(_problem(given), answers["equations"]),
    )


@lqr.verification("solutions", "definiteness")
def are_all_solutions(given: Given, answers: Answers) -> Iterable[Check]:
    """Every one solves the equation, none is missing or listed twice, and the words fit."""
    yield from listed_checks(_problem(given), answers)
