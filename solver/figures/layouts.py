"""The block diagrams of the course as layouts; signals and blocks bear the labels given, or the course's own."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from solver.figures.layout import RADIUS, Block, Dot, Label, Layout, Sum

Labels = Mapping[str, str]


def _plant(layout: Layout, x: float, labels: Labels, u: str = "u") -> float:
    """Draw B, the integrator with A fed back, and C from x on at y = 0; return the x of the branch after the state.

    The input must arrive at (x, 0).
    """
    layout.add(Block(x + 1.3, 0, labels.get("B", "B"), 1.1), Sum(x + 2.7, 0))
    layout.add(
        Label(x + 0.35, 0, labels.get("u", u), "above"), Label(x + 3.25, 0, labels.get("xdot", r"\dot{x}"), "above")
    )
    layout.wire((x, 0), (x + 0.75, 0))
    layout.wire((x + 1.85, 0), (x + 2.5, 0))
    layout.add(Block(x + 4.2, 0, labels.get("integrator", r"\int"), 0.9))
    layout.wire((x + 2.9, 0), (x + 3.75, 0))
    state = x + 5.4
    layout.wire((x + 4.65, 0), (x + 6.2, 0))
    layout.add(Dot(state, 0), Label(state + 0.4, 0, labels.get("x", "x"), "above"))
    layout.add(Block(x + 4.2, 1.3, labels.get("A", "A"), 0.9))
    layout.wire((state, 0), (state, 1.3), (x + 4.65, 1.3))
    layout.wire((x + 3.75, 1.3), (x + 2.7, 1.3), (x + 2.7, RADIUS))
    layout.add(Block(x + 6.75, 0, labels.get("C", "C"), 1.1))
    return state


def _output(layout: Layout, x: float, labels: Labels) -> None:
    """Draw the arrow of the output from the block C that ends at x."""
    layout.wire((x, 0), (x + 1.1, 0))
    layout.add(Label(x + 0.7, 0, labels.get("y", "y"), "above"))


def state_feedback(labels: Labels) -> Layout:
    """State feedback u = −K x + v."""
    layout = Layout()
    layout.add(Sum(0.9, 0), Label(0.2, 0, labels.get("r", "v"), "above"))
    layout.wire((-0.2, 0), (0.7, 0))
    layout.sign(0.7, 0.1, "+")
    layout.wire((1.1, 0), (1.2, 0), arrow=False)
    state = _plant(layout, 1.2, labels)
    _output(layout, 8.5, labels)
    layout.add(Block(3.9, -1.3, labels.get("K", "K_f"), 1.3))
    layout.wire((state, 0), (state, -1.3), (4.55, -1.3))
    layout.wire((3.25, -1.3), (0.9, -1.3), (0.9, -RADIUS))
    layout.sign(0.85, -0.25, "-", "below left")
    return layout


def state_feedback_reference(labels: Labels) -> Layout:
    """State feedback with a reference: u = −K x + K_o r."""
    layout = state_feedback({**labels, "r": ""})
    layout.add(Block(-1.1, 0, labels.get("K_o", "K_o"), 1.3))
    layout.wire((-2.9, 0), (-1.75, 0))
    layout.wire((-0.45, 0), (-0.2, 0), arrow=False)
    layout.add(Label(-2.4, 0, labels.get("r", "r"), "above"))
    return layout


def servo(labels: Labels) -> Layout:
    """State feedback with integral action: u = −K x + k_I ξ, ξ' = r − y."""
    layout = Layout()
    layout.wire((-4.4, 0), (-3.4, 0))
    layout.add(Label(-3.95, 0, labels.get("r", "r"), "above"), Sum(-3.2, 0))
    layout.sign(-3.4, 0.1, "+")
    layout.wire((-3.0, 0), (-2.2, 0))
    layout.add(Label(-2.6, 0, labels.get("xidot", r"\dot{\xi}"), "above"))
    layout.add(Block(-1.75, 0, labels.get("error_integrator", r"\int"), 0.9))
    layout.wire((-1.3, 0), (-0.6, 0))
    layout.add(Label(-0.95, 0, labels.get("xi", r"\xi"), "above"), Block(0.0, 0, labels.get("k_I", "k_I"), 1.2))
    layout.wire((0.6, 0), (1.1, 0))
    layout.add(Sum(1.3, 0))
    layout.sign(1.1, 0.1, "+")
    layout.wire((1.5, 0), (1.6, 0), arrow=False)
    state = _plant(layout, 1.6, labels)
    layout.wire((8.9, 0), (10.2, 0))
    layout.add(Dot(9.4, 0), Label(9.75, 0, labels.get("y", "y"), "above"))
    layout.add(Block(4.3, -1.3, labels.get("K", "K_f"), 1.3))
    layout.wire((state, 0), (state, -1.3), (4.95, -1.3))
    layout.wire((3.65, -1.3), (1.3, -1.3), (1.3, -RADIUS))
    layout.sign(1.25, -0.25, "-", "below left")
    layout.wire((9.4, 0), (9.4, -2.3), (-3.2, -2.3), (-3.2, -RADIUS))
    layout.sign(-3.25, -0.25, "-", "below left")
    return layout


def observer(labels: Labels) -> Layout:
    """The observer x̂' = A x̂ + B u + L (y − ŷ) beside its plant."""
    return _observer(labels, feedback=False)


def observer_feedback(labels: Labels) -> Layout:
    """The observer, with u = −K x̂ fed back."""
    return _observer(labels, feedback=True)


def _plant_above(layout: Layout, labels: Labels) -> None:
    """The plant in a row, its input and its output tapped at x = 1.2 and x = 8.6 for the observer below."""
    layout.add(Block(3.6, 0, labels.get("plant", r"\dot{x}=Ax+Bu"), 3.4), Block(6.9, 0, labels.get("C", "C"), 1.1))
    layout.wire((0.0, 0), (1.9, 0))
    layout.wire((5.3, 0), (6.35, 0))
    layout.wire((7.45, 0), (9.6, 0))
    layout.add(Label(5.8, 0, labels.get("x", "x"), "above"), Label(9.2, 0, labels.get("y", "y"), "above"))
    layout.add(Label(0.4, 0, labels.get("u", "u"), "above"), Dot(1.2, 0), Dot(8.6, 0))


def _new_input(layout: Layout, labels: Labels) -> None:
    """The sum before u at which the feedback of the estimate is taken from the new input."""
    layout.add(Sum(-0.2, 0), Label(-0.9, 0, labels.get("r", "v"), "above"))
    layout.wire((-1.3, 0), (-0.4, 0))
    layout.sign(-0.4, 0.1, "+")
    layout.sign(-0.25, -0.25, "-", "below left")


def _observer(labels: Labels, *, feedback: bool) -> Layout:
    layout = Layout()
    y0 = -3.4
    _plant_above(layout, labels)
    _estimator(layout, labels, driven=True)
    if feedback:
        _new_input(layout, labels)
        layout.add(Block(2.2, y0 - 2.5, labels.get("K", "K_f"), 1.3))
        layout.wire((5.8, y0 - 1.3), (5.8, y0 - 2.5), (2.85, y0 - 2.5))
        layout.add(Dot(5.8, y0 - 1.3))
        layout.wire((1.55, y0 - 2.5), (-0.2, y0 - 2.5), (-0.2, -RADIUS))
    return layout


def _estimator(layout: Layout, labels: Labels, *, driven: bool) -> None:
    """The model of the plant below it, corrected by y − ŷ; the output is tapped at x = 8.6, the input at x = 1.2."""
    y0, hat = -3.4, labels.get("xhat", r"\hat{x}")
    layout.add(Sum(3.4, y0))
    if driven:
        layout.add(Block(1.2 + 0.9, y0, labels.get("B", "B"), 1.0))
        layout.wire((1.2, 0), (1.2, y0), (1.6, y0))
        layout.wire((2.6, y0), (3.2, y0))
    layout.add(Block(4.7, y0, labels.get("integrator", r"\int"), 0.9))
    layout.wire((3.6, y0), (4.25, y0))
    layout.wire((5.15, y0), (6.35, y0))
    layout.add(Dot(5.8, y0), Label(5.8, y0, hat, "above"), Block(6.9, y0, labels.get("C", "C"), 1.1))
    layout.add(Block(4.7, y0 - 1.3, labels.get("A", "A"), 0.9))
    layout.wire((5.8, y0), (5.8, y0 - 1.3), (5.15, y0 - 1.3))
    layout.wire((4.25, y0 - 1.3), (3.4, y0 - 1.3), (3.4, y0 - RADIUS))
    layout.add(Sum(8.6, y0), Label(8.0, y0, labels.get("yhat", r"\hat{y}"), "above"))
    layout.wire((7.45, y0), (8.4, y0))
    layout.wire((8.6, 0), (8.6, y0 + RADIUS))
    layout.sign(8.65, y0 + 0.25, "+", "above right")
    layout.sign(8.4, y0 - 0.1, "-", "below left")
    layout.add(Block(6.0, y0 + 1.6, labels.get("L", "L_c"), 1.3))
    layout.wire((8.8, y0), (9.3, y0), (9.3, y0 + 1.6), (6.65, y0 + 1.6))
    layout.wire((5.35, y0 + 1.6), (3.4, y0 + 1.6), (3.4, y0 + RADIUS))


def kalman_filter(labels: Labels) -> Layout:
    """The filter x̂' = A x̂ + L (y − C x̂) beside a plant with noise at its states and at its output, without input."""
    return _filter(labels, driven=False)


def driven_kalman_filter(labels: Labels) -> Layout:
    """The filter with the input that its plant has."""
    return _filter(labels, driven=True)


def _filter(labels: Labels, *, driven: bool) -> Layout:
    layout = Layout()
    plant = r"\dot{x}=Ax+Bu+w" if driven else r"\dot{x}=Ax+w"
    layout.add(Block(3.6, 0, labels.get("plant", plant), 3.4), Block(6.9, 0, labels.get("C", "C"), 1.1))
    layout.wire((3.6, 1.3), (3.6, 0.45))
    layout.add(Label(3.6, 1.1, labels.get("w", "w"), "right"))
    layout.wire((5.3, 0), (6.35, 0))
    layout.add(
        Label(5.8, 0, labels.get("x", "x"), "above"), Sum(8.0, 0), Label(8.0, 1.1, labels.get("v", "v"), "right")
    )
    layout.wire((7.45, 0), (7.8, 0))
    layout.wire((8.0, 1.3), (8.0, RADIUS))
    layout.wire((8.2, 0), (9.8, 0))
    layout.add(Label(9.4, 0, labels.get("y", "y"), "above"), Dot(8.6, 0))
    if driven:
        layout.wire((0.0, 0), (1.9, 0))
        layout.add(Label(0.4, 0, labels.get("u", "u"), "above"), Dot(1.2, 0))
    _estimator(layout, labels, driven=driven)
    return layout


def reduced_observer(labels: Labels) -> Layout:
    """The observer of reduced order ω' = J ω + N y + M u, η̂₂ = ω + L y."""
    return _reduced(labels, feedback=False)


def reduced_observer_feedback(labels: Labels) -> Layout:
    """The observer of reduced order, with u = −K x̂ fed back; x̂ is put together from y and the estimate."""
    return _reduced(labels, feedback=True)


def _reduced(labels: Labels, *, feedback: bool) -> Layout:
    layout = Layout()
    y0 = -2.2
    _plant_above(layout, labels)
    layout.add(Block(2.2, y0, labels.get("M", "M"), 1.0), Sum(3.6, y0))
    layout.wire((1.2, 0), (1.2, y0), (1.7, y0))
    layout.wire((2.7, y0), (3.4, y0))
    layout.add(Block(5.0, y0, labels.get("integrator", r"\int"), 0.9))
    layout.wire((3.8, y0), (4.55, y0))
    layout.add(Block(5.0, y0 - 1.3, labels.get("J", "J"), 0.9))
    layout.wire((5.45, y0), (7.1, y0))
    layout.add(Dot(6.1, y0), Label(6.1, y0, labels.get("omega", r"\omega"), "above"), Sum(7.3, y0))
    layout.wire((6.1, y0), (6.1, y0 - 1.3), (5.45, y0 - 1.3))
    layout.wire((4.55, y0 - 1.3), (3.6, y0 - 1.3), (3.6, y0 - RADIUS))
    layout.add(Dot(8.6, y0 + 1.1), Block(5.0, y0 + 1.1, labels.get("N", "N"), 0.9))
    layout.wire((8.6, 0), (8.6, y0 + 1.1), (5.45, y0 + 1.1))
    layout.wire((4.55, y0 + 1.1), (3.6, y0 + 1.1), (3.6, y0 + RADIUS))
    layout.add(Block(8.6, y0 - 1.3, labels.get("L", "L_c"), 0.9))
    layout.wire((8.6, y0 + 1.1), (8.6, y0 - 0.85))
    layout.wire((8.15, y0 - 1.3), (7.3, y0 - 1.3), (7.3, y0 - RADIUS))
    layout.wire((7.5, y0), (8.4, y0), arrow=False)
    layout.wire((8.8, y0), (10.2, y0))
    layout.wire((8.4, y0), (8.8, y0), arrow=False)
    layout.add(Label(9.6, y0, labels.get("estimate", r"\hat{\eta}_2"), "above"))
    if feedback:
        _new_input(layout, labels)
        layout.add(Block(5.0, y0 - 2.6, labels.get("K", r"K_f\,[S_1\;\;S_2]"), 2.6))
        layout.wire((10.2, y0), (10.2, y0 - 2.45), (6.3, y0 - 2.45))
        layout.wire((9.6, 0), (10.7, 0), (10.7, y0 - 2.75), (6.3, y0 - 2.75))
        layout.wire((3.7, y0 - 2.6), (-0.2, y0 - 2.6), (-0.2, -RADIUS))
    return layout


def model_matching(labels: Labels) -> Layout:
    """The compensator before the plant: together they have the transfer function asked for."""
    layout = Layout()
    layout.wire((-1.4, 0), (0.0, 0))
    layout.add(Label(-0.9, 0, labels.get("r", "r"), "above"), Block(1.1, 0, labels.get("compensator", "H(s)"), 2.2))
    layout.wire((2.2, 0), (3.6, 0))
    layout.add(Label(2.9, 0, labels.get("u", "u"), "above"), Block(4.7, 0, labels.get("plant", "G(s)"), 2.2))
    layout.wire((5.8, 0), (7.2, 0))
    layout.add(Label(6.6, 0, labels.get("y", "y"), "above"))
    return layout


LAYOUTS: Mapping[str, Callable[[Labels], Layout]] = {
    "state_feedback": state_feedback,
    "state_feedback_reference": state_feedback_reference,
    "servo": servo,
    "observer": observer,
    "observer_feedback": observer_feedback,
    "kalman_filter": kalman_filter,
    "driven_kalman_filter": driven_kalman_filter,
    "reduced_observer": reduced_observer,
    "reduced_observer_feedback": reduced_observer_feedback,
    "model_matching": model_matching,
}
