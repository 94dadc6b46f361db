"""What must hold of transforms taken apart holds of the right result, and of none that is a little wrong."""

import pytest
import sympy as sp

from solver import exact
from solver.derivation import CheckStatus
from solver.lazy import Call
from solver.postconditions import check_calls
from tools.corrupted_kernels.changes import changes

s, t = sp.symbols("s t")
a, b = sp.symbols("a b", real=True)
F = (1 - sp.exp(-s)) / (s * (s + 1)) + sp.exp(-2 * s) / s**2
f = t * sp.exp(-t) + sp.Heaviside(t - 1) * t**2 + 3 * sp.DiracDelta(t - 2)
IMAGE = exact.rational_image(1 / ((s + 1) ** 2 * (s + 2)), s)

CALLS = {
    "read_image": [(F, s), (1 / ((s + a) * (s + b)), s)],
    "rational_image": [((s**3 + 5) / (s + 1) ** 2, s)],
    "transform_pieces": [(f, t)],
    "late_image": [(sp.Integer(2), 1 / s, s)],
    "ratio_of_images": [(IMAGE, exact.rational_image(3 / ((s + 1) ** 2 * (s + 2)), s))],
    "covered": [(IMAGE.proper, s)],
    "is_found_otherwise": [(IMAGE.proper, s), (exact.rational_image(1 / (s * (s**2 + 1) ** 2), s).proper, s)],
    "poles_of": [(exact.rational_image(1 / (s * (s**2 + 1) ** 2), s).proper, s)],
    "values_after": [((s + 3) / (s**2 + 3 * s + 2), 3, s)],
    "factors_for_convolution": [(IMAGE, s)],
    "impulse_balance": [(s**2 + 3 * s + 2, s + 3, (sp.S.One, sp.S.Zero, sp.S.Zero), sp.S.Zero, s)],
    "abscissa_of": [(exact.transform_pieces(f, t),)],
}
SEEN = {
    "read_image": ("[0] .delay", "[1] .delay", "[0] .image.cancels", "[0] .image.whole", "[0] left out"),
    "rational_image": (".cancels", ".whole"),
    "transform_pieces": tuple(f"[{i}] .{name}" for i in range(3) for name in ("delay", "function", "moved", "impulse")),
    "poles_of": ("[0] .paired", "[0] left out", "[1] .paired", "[1] left out"),
    "covered": ("[0] left out", "[0] .pole", "[1] left out"),
}
"""Changes that are looked at; of other results all of them. The rest is told by claims of the steps."""

CASES = [pytest.param(name, arguments, id=f"{name}-{i}") for name in CALLS for i, arguments in enumerate(CALLS[name])]


def statuses(name, arguments, result):
    return {check.status for check in check_calls([Call(name, arguments, {}, result, 1)], [])}


@pytest.mark.parametrize(("name", "arguments"), CASES)
def test_it_holds_of_the_right_result_and_of_none_that_is_a_little_wrong(name, arguments):
    result = getattr(exact, name)(*arguments)
    assert statuses(name, arguments, result) <= {CheckStatus.PASSED}
    told = SEEN.get(name, ("",))
    judged = [each for each in changes(result) if any(each.what.startswith(part) for part in told)][:20]
    survived = []
    for each in judged:
        try:
            found = statuses(name, arguments, each.made())
        except (ValueError, IndexError, KeyError, TypeError, AttributeError):
            continue
        if CheckStatus.FAILED not in found:
            survived.append(each.what)
    assert judged
    assert not survived
