"""Every equality that a step displays is really checked: a corrupted right side is rejected."""

import pytest
import sympy as sp

from solver.derivation import CheckStatus, Claim, Status
from solver.numeric import Environments, check_claim
from solver.stated import Stated
from solver.tasks import catalogue
from tests.helpers.asking import ask, example_options, system
from tests.helpers.shares import turn


def whole(rows, *, discrete=False):
    """A plant with one input and one output, so that every task can be asked of it."""
    n = len(rows)
    B, C = [[int(i == n - 1)] for i in range(n)], [[int(j == 0) for j in range(n)]]
    return system(rows, B=B, C=C, discrete=discrete)


PLANTS = {
    "distinct": whole([[0, 1], [-2, -3]]),
    "complex": whole([[0, 1], [-5, -2]]),
    "defective": whole([[-1, 0, 0], [0, -1, 0], [1, 0, -1]]),
    "surd": whole([[0, 1], [2, 0]]),
    "cubic": whole([[0, 1, 0], [0, 0, 1], [-1, -1, 0]]),
    "discrete": whole([[0, 1], [-6, -5]], discrete=True),
    "discrete, complex": whole([[0, 1], [-2, 2]], discrete=True),
}
QUICK = {"distinct", "discrete, complex"}
PROGRAMS = ("numpy", "scipy", "mpmath", "sympy", "random points", "ranks of", "contour integral", "orthonormal basis")
WAYS = {
    "inspection", "counted", "compared", "positive", "decimals", "residual", "recursion", "coefficients",
    "greatest common divisors", "characteristic polynomial", "characteristic polynomial of its companion matrix",
    "Gauss–Legendre quadrature", "series", "Cauchy's integral formula", "invariant subspaces in floats",
    "orthogonal bases (50 digits)", "return difference at random points", "sequence of points",
    "the steps simulated, and their costs summed up",
}  # fmt: skip
"""How checks are made: by a program or with points, or in one of these ways."""

CASES = [
    pytest.param(
        task, method, plant, id=(case := f"{task}-{method}-{name}"), marks=() if name in QUICK else turn(case, 4)
    )
    for name, plant in PLANTS.items()
    for task, declared in catalogue().items()
    for method in declared.methods_for(plant.discrete)
    if not list(declared.refused(plant, example_options(task)))
]


def corruptions(right):
    """A sign, one entry or a factor changed; of a stated formula, one of its operands."""
    if isinstance(right, Stated):
        for i, operand in enumerate(right.operands):
            for corrupted in corruptions(operand):
                yield Stated(right.operation, (*right.operands[:i], corrupted, *right.operands[i + 1 :]))
    elif isinstance(right, sp.MatrixBase):
        yield sp.ImmutableMatrix(right + sp.ones(*right.shape))
        for i in range(len(right)):
            changed = right.as_mutable()
            changed[i] = changed[i] + sp.Rational(1, 1000)
            yield sp.ImmutableMatrix(changed)
    elif isinstance(right, sp.Expr):
        yield right + sp.Rational(1, 1000)
        yield right * sp.Rational(1001, 1000) if right != 0 else sp.Integer(1)


def same_value(claim):
    """Whether a corruption happens to be right again (the operand is multiplied by zero, say)."""
    return check_claim(claim, "").status is CheckStatus.PASSED


@pytest.mark.parametrize(("task", "method", "plant"), CASES)
def test_steps_and_checks_say_what_they_rest_on_and_corrupted_claims_are_rejected(task, method, plant):
    result = ask(task, plant, method)
    they_say_what_they_rest_on(result)
    corrupted_claims_are_rejected(result)


def corrupted_claims_are_rejected(result):
    assert result.status is not Status.FAILED, result.reason
    claims = [claim for step in result.steps for each in step.walk() for claim in each.claims.values()]
    assert claims or result.status is Status.UNSOLVED
    known = Environments()  # what a corruption leaves as it is, is evaluated once
    for claim in claims:
        assert not (isinstance(claim.left, sp.Number) and isinstance(claim.right, Stated)), "a value before its formula"
        assert check_claim(claim, "", environments=known).status is CheckStatus.PASSED
        for corrupted in corruptions(claim.right):
            if not same_value(Claim(claim.right, corrupted)):
                check = check_claim(Claim(claim.left, corrupted), "", environments=known)
                assert check.status is CheckStatus.FAILED, claim


def they_say_what_they_rest_on(result):
    for step in result.steps:
        for each in step.walk():
            assert each.claims or each.unclaimed, each
    for check in result.checks:
        assert str(check.oracle) in WAYS or str(check.oracle).startswith(PROGRAMS), check
        assert str(check.claim) not in WAYS - {"characteristic polynomial"}, check
        assert not str(check.claim).startswith(PROGRAMS[:5]), check
