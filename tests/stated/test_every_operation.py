"""Every stated operation: printed as on paper, right values accepted, nearly right ones rejected."""

import itertools
from importlib import import_module
from pkgutil import iter_modules

import pytest
import sympy as sp

from solver.derivation import CheckStatus, Claim
from solver.formula import read
from solver.numeric import NotEvaluable, check_claim
from solver.numeric.evaluation import operations
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.points import free_symbols, whole_symbols
from solver.numeric.evaluation.stated import about
from solver.render.latex import tex
from solver.stated import Stated, calculus, every_operation, lists, transforms
from tests.stated import cases
from tests.stated.values import w, x, z

MODULES = [import_module(f"{cases.__name__}.{each.name}") for each in iter_modules(cases.__path__)]
RIGHT = [pair for module in MODULES for pair in module.RIGHT]
PRINTED = [pair for module in MODULES for pair in module.PRINTED]


def name_of(side):
    return getattr(side, "operation", None) or ""


@pytest.mark.parametrize(("formula", "printed"), PRINTED, ids=lambda item: str(item)[:60])
def test_formulas_are_printed_as_stated(formula, printed):
    assert tex(formula) == printed
    assert read(printed)


@pytest.mark.parametrize(("left", "right"), RIGHT, ids=name_of)
def test_a_right_statement_passes(left, right):
    check = check_claim(Claim(left, right), "right")
    assert check.status is CheckStatus.PASSED, check


def nearly(right):
    """Wrong right sides that are close: one entry off by a thousandth, by one; the sign."""
    if not isinstance(right, sp.MatrixBase):
        return [right + sp.Rational(1, 1000), -right + 1, right * 2 + 1]
    wrong = []
    for i, j in itertools.product(range(right.rows), range(right.cols)):
        entry = right[i, j]
        for change in (entry * sp.Rational(1001, 1000) + sp.Rational(1, 10**6), entry + 1, 1 - entry):
            other = right.as_mutable()
            other[i, j] = change
            if other[i, j] != entry:
                wrong.append(other)
    return wrong[::5]  # every change, each at another entry


@pytest.mark.parametrize(("left", "right"), RIGHT, ids=name_of)
def test_a_nearly_right_statement_fails(left, right):
    if isinstance(left, list):
        candidates = [[right[0] + 1, *right[1:]], [*right[:-1], -right[-1]], right[::-1]]
    else:
        candidates = [each for each in nearly(right) if each != right]
    for wrong in candidates:
        check = check_claim(Claim(left, wrong), "wrong")
        assert check.status is CheckStatus.FAILED, (wrong, check)


def test_every_operation_has_cases_of_its_value_and_of_its_notation():
    """A right value above is followed by wrong ones, so an operation with cases is one whose evaluation can reject."""
    for pairs in (RIGHT, PRINTED):
        assert {left.operation for left, _ in pairs if isinstance(left, Stated)} == set(every_operation())


def test_every_operation_has_an_evaluation_and_every_evaluation_an_operation():
    assert {module.name for module in iter_modules(operations.__path__)} == set(every_operation())
    for name in every_operation():
        assert callable(about(name, "evaluate")), name


@pytest.mark.parametrize("declared", every_operation().values(), ids=lambda each: each.name)
def test_what_an_operation_binds_needs_no_value(declared):
    """The variable is no free symbol of a case, unless an operand outside of the binding holds it."""
    formulas = [left for left, _ in RIGHT if isinstance(left, Stated) and left.operation == declared.name]
    for formula in formulas:
        binding = declared.binding
        if binding is None:
            assert free_symbols(formula) == frozenset().union(*map(free_symbols, formula.operands))
            continue
        variable = formula.operands[binding.variable]
        outside = [each for i, each in enumerate(formula.operands) if i not in (binding.variable, *binding.within)]
        assert (variable in free_symbols(formula)) == (variable in free_symbols(outside))
        assert any(variable in free_symbols(formula.operands[i]) for i in binding.within) or len(formulas) > 1


@pytest.mark.parametrize(
    "formula",
    [
        calculus.convolution_sum(2**x, 3**x, w),
        transforms.inverse_z(z / (z - 2), z, w),
        lists.summation(x, x, w, 5),
        lists.summation(x, x, 0, w),
        lists.indexed_product(x, x, w, 5),
        lists.indexed_product(x, x, 1, w),
    ],
    ids=name_of,
)
def test_what_counts_terms_or_samples_is_a_whole_number(formula):
    assert whole_symbols(formula) == {w}


def test_an_operation_without_an_evaluation_is_told():
    with pytest.raises(NotEvaluable, match="no rule for the operation nothing"):
        value_of(Stated("nothing", (1,)), Environment.at([{}]))
