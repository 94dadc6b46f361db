"""Generated questions over all tasks, all methods and all options: the same seed gives the same questions.

Each is a part of a problem file.
"""

from collections.abc import Callable, Iterator, Sequence

import sympy as sp
import yaml

from tests.hunt.dice import Asked, Dice, rows

SHARES: dict[str, tuple[int, Callable[[Dice], Asked]]] = {}
"""How many questions of each task, and how one is made."""


def share(count: int) -> Callable[[Callable[[Dice], Asked]], Callable[[Dice], Asked]]:
    """Enter the maker of a task's questions."""

    def enter(maker: Callable[[Dice], Asked]) -> Callable[[Dice], Asked]:
        SHARES[maker.__name__] = count, maker
        return maker

    return enter


def questions(seed: int, tasks: Sequence[str] = (), times: float = 1) -> Iterator[tuple[str, Asked]]:
    """Questions by name: `times` the share of each task."""
    for task, (count, maker) in SHARES.items():
        for i in range(max(1, round(count * times)) if not tasks or task in tasks else 0):
            yield f"{task.replace('_', '-')}-{seed}-{i}", {"task": task, **maker(Dice(f"{task} {seed} {i}"))}


def problem(seed: int, tasks: Sequence[str] = (), times: float = 1) -> str:
    """The questions as a problem file."""
    asked = dict(questions(seed, tasks, times))
    return yaml.safe_dump({"title": "Generated", "find": asked}, allow_unicode=True, sort_keys=False, width=1000)


def system(asked: Asked, *keys: str) -> Asked:
    """Some keys of a system."""
    return {key: value for key, value in asked.items() if key in {*keys, "time"}}


@share(4)
def characteristic_polynomial(dice: Dice) -> Asked:
    A = rows(dice.matrix(dice.integer(2, 4)))
    matrix = dice.letters(A, "a", "b") if dice.one([True, False]) else A
    return {"method": dice.one(["determinant", "faddeev_leverrier"]), "system": {"matrix": matrix}}


@share(6)
def eigenstructure(dice: Dice) -> Asked:
    return {"system": {"matrix": rows(dice.matrix(dice.integer(2, 4)))}}


@share(3)
def fundamental_subspaces(dice: Dice) -> Asked:
    n, r = dice.integer(2, 4), dice.integer(1, 2)
    return {"system": {"matrix": rows(dice.entries(n, r) * dice.entries(r, dice.integer(2, 5)))}}


@share(3)
def similarity_transformation(dice: Dice) -> Asked:
    n = dice.integer(2, 3)
    return {"T": rows(dice.coordinates(n)), "system": dice.plant(n)}


@share(7)
def matrix_function(dice: Dice) -> Asked:
    function = dice.one(["A^10", "inv(A)", "exp(A t)", "A^3 - 2A + 4I", "sin(A)", "A^k", "exp(A)"])
    A = dice.matrix(dice.integer(2, 3), stable=True)
    return {"function": function, "method": "cayley_hamilton", "system": {"matrix": rows(A)}}


@share(3)
def resolvent(dice: Dice) -> Asked:
    discrete = dice.one([False, True])
    A = dice.letters(rows(dice.matrix(dice.integer(2, 3), discrete=discrete)), *dice.one([(), ("a",)]))
    methods = dice.one(["adjugate", "faddeev_leverrier"])
    return {"method": methods, "system": {"A": A} | ({"time": "discrete"} if discrete else {})}


@share(10)
def state_transition_matrix(dice: Dice) -> Asked:
    discrete = dice.one([False, False, True])
    methods = ["z_transform", "cayley_hamilton"] if discrete else ["laplace", "cayley_hamilton", "power_series"]
    A = dice.matrix(dice.integer(2, 3), discrete=discrete)
    return {"method": dice.one(methods), "system": {"A": rows(A)} | ({"time": "discrete"} if discrete else {})}


@share(16)
def response(dice: Dice) -> Asked:
    discrete = dice.one([False, False, True])
    inputs = [1, "exp(-t)", "sin(2t)", "t", "step(t - 1)", "delta(t)", "cos(t)", "2 - exp(-3t)", "t exp(-2t)"]
    steps = [1, "(1/2)^k", "k", "cos(pi k/2)", "delta(k)", "step(k - 2)", "(-1)^k"]
    kind = dice.one(["complete", "zero_input", "zero_state", "zero_state"])
    asked: Asked = {"kind": kind, "method": dice.one(["z_transform" if discrete else "laplace", "convolution"])}
    n = dice.integer(1, 3)
    if not discrete and kind == "zero_state" and dice.one([True, False]):
        return asked | {"input": dice.one(inputs), "system": {"transfer_function": dice.transfer(n, n - 1)}}
    if kind != "zero_input":
        asked["input"] = dice.one(steps if discrete else inputs)
    if kind != "zero_state":
        asked["initial_state"] = [dice.integer(-2, 3) for _ in range(n)]
    return asked | {"system": dice.plant(n, stable=dice.one([True, True, False]), discrete=discrete)}


@share(6)
def transfer_function(dice: Dice) -> Asked:
    several = dice.one([1, 1, 2])
    plant = dice.plant(dice.integer(2, 3), several, several)
    if several == 1 and dice.one([True, False]):
        plant["A"] = dice.letters(plant["A"], "a")
    if dice.one([False, True]):
        loop = {"controller": dice.one([2, "K", "3(s+1)/s"]), "feedback": dice.one(["unity", "1/(s+4)"])}
        return {"system": {"transfer_function": dice.transfer(2, 1)}, **loop}
    return {"method": dice.one(["adjugate", "faddeev_leverrier"]), "system": plant}


@share(8)
def realization(dice: Dice) -> Asked:
    form = dice.one(["controllable", "observable", "diagonal", "jordan", "modal"])
    if form == "diagonal":
        poles = dice.random.sample(range(1, 7), 3)
        G = f"(s+7)/({''.join(f'(s+{p})' for p in poles)})"
    else:
        n = dice.integer(2, 4)
        G = dice.transfer(n, n - dice.integer(0, 2))
    conventions = {"controllable": ["last_row", "first_row"], "jordan": ["subdiagonal", "superdiagonal"]}
    conventions["observable"] = conventions["controllable"]
    asked = {"convention": dice.one(conventions[form])} if form in conventions else {}
    return {"form": form, **asked, "system": {"transfer_function": G}}


@share(5)
def minimal_realization(dice: Dice) -> Asked:
    if dice.one([True, False]):
        return {"system": {"transfer_matrix": [[dice.transfer(dice.integer(1, 2), 0) for _ in range(2)] for _ in "ab"]}}
    blocks = dice.modes(3, stable=False)
    B, C = dice.entries(3, 1), dice.entries(1, 3)
    B[dice.integer(0, 2), 0] = 0
    T = dice.coordinates(3)
    A = T * sp.diag(*blocks) * T.inv()
    return {"system": {"A": rows(A), "B": rows(T * B), "C": rows(C * T.inv())}}


@share(4)
def state_space_model(dice: Dice) -> Asked:
    n = dice.integer(1, 3)
    left = " + ".join(f"{dice.integer(1, 6)}y{chr(39) * i}" for i in range(n + 1))
    right = " + ".join(f"{dice.integer(1, 4)}u{chr(39) * i}" for i in range(dice.integer(1, n)))
    return {"system": {"equations": [f"{left} = {right}"], "inputs": ["u"], "outputs": ["y"]}}


def _pair(dice: Dice, dual: bool) -> Asked:
    n, kind = dice.integer(2, 4), dice.one(["rank", "pbh", "gramian"])
    discrete = dice.one([False, False, True])
    if kind == "gramian":
        plant = dice.plant(2, stable=True, discrete=discrete)
        horizon = {"horizon": dice.integer(1, 3)} if dice.one([True, False]) else {}
        return {"method": "gramian", **horizon, "system": system(plant, "A", "C" if dual else "B")}
    plant = dice.plant(n, dice.integer(1, 2), dice.integer(1, 2), discrete=discrete)
    if kind == "rank" and dice.one([True, False]):
        plant["A"] = dice.letters(plant["A"], "a", "b")
    return {"method": kind, "system": system(plant, "A", "C" if dual else "B")}


@share(7)
def controllability(dice: Dice) -> Asked:
    return _pair(dice, dual=False)


@share(7)
def observability(dice: Dice) -> Asked:
    return _pair(dice, dual=True)


def _hidden(dice: Dice, *keys: str) -> Asked:
    """A plant whose last mode no input reaches and no output shows, in other coordinates."""
    n, discrete = dice.integer(2, 3), dice.one([False, True])
    T = dice.coordinates(n + 1)
    A = sp.diag(dice.matrix(n, discrete=discrete), dice.one(dice.modes(1, stable=False, discrete=discrete)))
    B = dice.entries(n, 1).col_join(sp.zeros(1, 1))
    C = dice.entries(1, n).row_join(sp.zeros(1, 1))
    plant = {"A": rows(T * A * T.inv()), "B": rows(T * B), "C": rows(C * T.inv())}
    return system(plant, *keys) | ({"time": "discrete"} if discrete else {})


@share(4)
def stabilizability(dice: Dice) -> Asked:
    return {"system": _hidden(dice, "A", "B")}


@share(4)
def detectability(dice: Dice) -> Asked:
    return {"system": _hidden(dice, "A", "C")}


@share(6)
def kalman_decomposition(dice: Dice) -> Asked:
    return {"part": dice.one(["controllable", "observable", "full"]), "system": _hidden(dice, "A", "B", "C")}


@share(4)
def parameter_condition(dice: Dice) -> Asked:
    plant = dice.plant(dice.integer(2, 3))
    dual = dice.one([True, False])
    plant["C" if dual else "B"] = dice.letters(plant["C" if dual else "B"], "a")
    return {"property": "unobservable" if dual else "uncontrollable", "parameter": "a", "system": plant}


@share(8)
def stability(dice: Dice) -> Asked:
    method, discrete = dice.one(["eigenvalues", "lyapunov", "routh"]), dice.one([False, False, True])
    plant = dice.plant(dice.integer(2, 3), stable=method == "lyapunov", discrete=discrete)
    dual = {"dual": True} if method == "lyapunov" and dice.one([True, False]) else {}
    return {"method": method, **dual, "system": plant}


@share(6)
def stability_range(dice: Dice) -> Asked:
    if dice.one([True, False]):
        loop = {"controller": "K", "feedback": "unity"}
        return {"method": "routh", **loop, "system": {"transfer_function": dice.transfer(3, dice.integer(0, 1))}}
    return {"method": dice.one(["routh", "eigenvalues"]), "system": {"A": dice.letters(rows(dice.matrix(2)), "a")}}


@share(7)
def phase_portrait(dice: Dice) -> Asked:
    return {"system": {"A": rows(dice.matrix(2))}}


@share(8)
def routh_hurwitz(dice: Dice) -> Asked:
    method, n = dice.one(["array", "hurwitz_determinants"]), dice.integer(3, 5)
    terms = [f"{dice.integer(1, 9)}s^{i}" for i in range(n, -1, -1)]
    if dice.one([True, False]):
        terms[dice.integer(1, n)] = f"K s^{dice.integer(0, 1)}"
    return {"method": method, "system": {"polynomial": " + ".join(terms)}}


@share(6)
def desired_poles(dice: Dice) -> Asked:
    first = {"overshoot": ["10%", "0.2", "4.32%"], "damping_ratio": [0.4, "1/2", 0.707, "sqrt(3)/2"]}
    second = {"settling_time": [1, 2, 0.5], "peak_time": [1, 0.5], "natural_frequency": [1, 5]}
    return {name: dice.one(values[name]) for values in (first, second) for name in [dice.one(sorted(values))]}


SINGLE = ["coefficient_matching", "bass_gura", "canonical_form", "ackermann"]


@share(10)
def pole_placement(dice: Dice) -> Asked:
    discrete, n, several = dice.one([False, False, True]), dice.integer(2, 3), dice.one([1, 1, 1, 2])
    plant = system(dice.plant(n, several, discrete=discrete), "A", "B")
    method = "unity_rank" if several > 1 else dice.one(SINGLE)
    return {"method": method, "poles": dice.poles(n, discrete), "system": plant}


@share(7)
def observer(dice: Dice) -> Asked:
    discrete, n = dice.one([False, False, True]), dice.integer(2, 3)
    plant = system(dice.plant(n, discrete=discrete), "A", "C")
    return {"method": dice.one(SINGLE), "poles": dice.poles(n, discrete), "system": plant}


@share(4)
def reduced_observer(dice: Dice) -> Asked:
    n = dice.integer(2, 3)
    return {"poles": dice.poles(n - 1), "system": dice.plant(n)}


@share(4)
def observer_feedback(dice: Dice) -> Asked:
    n, reduced = dice.integer(1, 3), dice.one([False, True])
    n = max(n, 2) if reduced else n
    observer_poles = dice.poles(n - 1 if reduced else n)
    return {"poles": dice.poles(n), "observer_poles": observer_poles, "reduced": reduced, "system": dice.plant(n)}


@share(4)
def reference_tracking(dice: Dice) -> Asked:
    n, discrete = dice.integer(1, 3), dice.one([False, False, True])
    return {"poles": dice.poles(n, discrete), "system": dice.plant(n, discrete=discrete)}


@share(5)
def servo(dice: Dice) -> Asked:
    n, discrete = dice.integer(1, 2), dice.one([False, False, True])
    poles, plant = dice.poles(n + 1, discrete), dice.plant(n, discrete=discrete)
    return {"method": dice.one(SINGLE), "poles": poles, "system": plant}


@share(3)
def model_matching(dice: Dice) -> Asked:
    plant = {"transfer_function": f"(s{dice.one(['+1', '+3', '-1'])})/({dice.factors(3)})"}
    return {"target": f"{dice.integer(1, 4)}/({dice.factors(2)})", "system": plant}


@share(8)
def lqr(dice: Dice) -> Asked:
    plant = dice.plant(dice.integer(1, 2), dice.one([1, 1, 2]))
    n, m = len(plant["A"]), len(plant["B"][0])
    weight = dice.one([{"output_weight": dice.integer(1, 3)}, {"Q": rows(sp.diag(*[dice.integer(1, 4)] * n))}])
    R = rows(sp.diag(*[dice.one([1, 2, 4])] * m))
    start = {"initial_state": [dice.integer(-1, 2) for _ in range(n)]} if dice.one([True, False]) else {}
    return {"method": dice.one(["riccati", "hamiltonian"]), **weight, "R": R, **start, "system": plant}


@share(5)
def kalman_filter(dice: Dice) -> Asked:
    plant = system(dice.plant(dice.integer(1, 2), 1, dice.one([1, 1, 2])), "A", "C")
    Q, R = (rows(sp.eye(len(plant[name])) * dice.integer(1, 3)) for name in ("A", "C"))
    return {"method": dice.one(["riccati", "hamiltonian"]), "Q": Q, "R": R, "system": plant}


@share(3)
def optimal_tracking(dice: Dice) -> Asked:
    plant = dice.plant(dice.integer(1, 2))
    return {"Q": rows(sp.eye(len(plant["A"]))), "R": dice.integer(1, 4), "system": plant}
