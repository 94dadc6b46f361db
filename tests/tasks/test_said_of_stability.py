"""What the pages about stability say in words, in every case that steers them."""

import pytest
import sympy as sp

from tests.helpers.asking import system
from tests.helpers.said import Family, cases_of, wrongly_said

p, d = sp.symbols("p d", positive=True)
k = sp.Symbol("k", real=True)
half = sp.Rational(1, 2)
FIRST, SECOND = (sp.ImmutableMatrix(sp.diag(*entries)) for entries in ((1, 0), (0, 1)))


def discrete(rows, **matrices):
    """A system in discrete time."""
    return system(rows, discrete=True, **matrices)


def companion(*coefficients):
    """The companion matrix of the monic polynomial with these coefficients after the first."""
    n = len(coefficients)
    return [[int(j == i + 1) for j in range(n)] for i in range(n - 1)] + [[-c for c in reversed(coefficients)]]


SYSTEMS = {
    "nodes": system([[-1, 0], [0, -2]]),
    "unstable": system([[3, -2], [1, -1]]),
    "apart": system([[0, 0], [0, 0]]),
    "chain": system([[0, 1], [0, 0]]),
    "oscillator": system([[0, 1], [-1, 0]]),
    "damped": system([[0, 1], [-p, -d]]),
    "d_inside": discrete([[0, 1], [-half, 1]]),
    "d_circle": discrete([[0, 1], [-1, 1]]),
    "d_outside": discrete([[2]]),
    "d_chain": discrete([[1, 1], [0, 1]]),
    "d_ones": discrete([[1, 0], [0, 1]]),
    "k_range": system([[0, 1], [-k, -1]]),
    "k_never": system([[0, 1], [-k, 0]]),
}
BY_EIGENVALUES = SYSTEMS | {
    "three_apart": system(sp.diag(0, 0, 0, -1)),
    "two_of_three": system([[0, 1, 0], [0, 0, 0], [0, 0, 0]]),
    "surd": system([[0, 1], [2, 0]]),
    "complex": system([[0, 1], [-5, -2]]),
    "undamped": system([[0, 1], [-p, 0]]),
    "driven": system([[0, 1], [-p, d]]),
    "resonance": system([[0, 1, 0, 0], [-p, 0, 0, 0], [0, 0, 0, 1], [0, 0, -1, 0]]),
    "d_surd": discrete([[0, 1], [half, 0]]),
    "d_pair": discrete([[0, 1], [-1 / (2 + p), 0]]),
    "bibo": system([[1, 0], [0, -1]], B=[[0], [1]], C=[[1, 1]]),
    "not_bibo": system([[1, 0], [0, -1]], B=[[1], [1]], C=[[1, 1]]),
    "only_B": system([[1, 0], [0, -1]], B=[[0], [1]]),
    "only_C": system([[1, 0], [0, -1]], C=[[1, 0]]),
    "no_pole": system([[1, 0], [0, 2]], B=[[0], [0]], C=[[1, 0]]),
    "d_bibo": discrete([[2, 0], [0, half]], B=[[0], [1]], C=[[1, 1]]),
    "d_not_bibo": discrete([[2, 0], [0, half]], B=[[1], [1]], C=[[1, 1]]),
    "two_cancel": system(sp.diag(1, 2, -1), B=[[0], [0], [1]], C=[[1, 1, 1]]),
    "k_bibo": system([[1, 0], [0, k]], B=[[0], [1]], C=[[1, 1]]),
}
BY_LYAPUNOV = {name: SYSTEMS[name] for name in SYSTEMS if name not in {"apart", "d_circle", "d_chain"}} | {
    "dual": (system([[-1, 0], [0, -2]]), {"dual": True}),
    "dual_unstable": (system([[3, -2], [1, -1]]), {"dual": True}),
    "semi": (system([[0, 1], [-2, -3]]), {"Q": FIRST}),
    "semi_hidden": (system([[-1, 0], [0, -2]]), {"Q": FIRST}),
    "semi_dual": (system([[0, 1], [-2, -3]]), {"Q": SECOND, "dual": True}),
    "semi_unstable": (system([[0, 1], [2, 1]]), {"Q": FIRST}),
    "d_dual": (discrete([[half, 0], [0, 0]]), {"dual": True}),
    "d_dual_out": (discrete([[2]]), {"dual": True}),
    "d_semi": (discrete([[0, 1], [0, half]]), {"Q": FIRST}),
    "scalar": system([[-3]]),
    "saddle": system([[1, 0], [0, -1]]),
    "three": system(sp.diag(-1, -2, -3)),
    "lower": system([[-2, 0], [3, 1]]),
}
BY_ROUTH = {name: SYSTEMS[name] for name in SYSTEMS if name not in {"k_never"}} | {
    "pivot": system(companion(2, 2, 4, 11, 10)),
    "zeros": system(companion(7, 6, 42, 8, 56)),
    "split": system(companion(0, 2, -2, 1, -2)),
    "double": system(companion(0, 2, 0, 1)),
    "mixed": system(companion(1, 3, 3, 3, 2, 1)),
    "pair_twice": system(companion(0, 0, 0, 2, 0, 0, 0, 1)),
    "d_one": discrete([[1, 0], [0, half]]),
    "d_zero": discrete([[0, 1], [0, 0]]),
    "d_two_out": discrete([[2, 0], [0, 3]]),
}
SAID_OF_EIGENVALUES = {
    r"dies out if $|\lambda|": "d_inside d_circle d_outside d_chain d_ones d_surd d_pair d_bibo d_not_bibo",
    r"dies out if $\operatorname{Re}": (
        "all but d_inside d_circle d_outside d_chain d_ones d_surd d_pair d_bibo d_not_bibo"
    ),
    "&= -2 < 0": "nodes",
    "&= 1 > 0": "bibo not_bibo only_B only_C no_pole two_cancel k_bibo",
    r"\approx 1.4142 > 0": "surd",
    "&= 2 > 1": "d_outside d_bibo d_not_bibo",
    r"\approx 0.70711 < 1": "d_inside d_surd",
    "{1}{2} < 1": "d_bibo d_not_bibo",
    r"{1}| &= 1 \\": "d_circle",
    "&= 0 ": "apart chain oscillator three_apart two_of_three undamped resonance",
    "&= 1 > ": "bibo not_bibo only_B only_C no_pole two_cancel k_bibo",
    "$c = p$": "damped driven",
    r"\pm\sqrt{-p} = j": "undamped resonance",
    "have negative real parts, whether": "damped",
    "Not both roots of": "driven",
    "lies on the imaginary axis, so": "apart chain oscillator three_apart two_of_three undamped resonance",
    "lies on the unit circle, so": "d_circle d_chain d_ones",
    "(it is simple, so there is one)": "oscillator d_circle undamped resonance",
    "There are 2 independent eigenvectors, as many": "apart d_ones",
    "There are 3 independent eigenvectors": "three_apart",
    "There is only 1 independent eigenvector for the multiplicity 2": "chain d_chain",
    "There are only 2 independent eigenvectors for the multiplicity 3": "two_of_three",
    "All eigenvalues lie inside the unit circle": "d_inside d_surd d_pair",
    "All eigenvalues lie in the open left half plane": "nodes damped complex",
    "There is an eigenvalue outside the unit circle": "d_outside d_bibo d_not_bibo",
    "There is an eigenvalue in the right half plane": (
        "unstable surd driven bibo not_bibo only_B only_C no_pole two_cancel k_bibo"
    ),
    "has a chain of generalized": "chain d_chain two_of_three",
    r"$k\lambda^{k}$": "d_chain",
    r"$te^{\lambda t}$": "chain two_of_three",
    "in the right half plane, but $0$ on the imaginary axis has": "chain two_of_three",
    "outside the unit circle, but $1$ on it has": "d_chain",
    "as many eigenvectors as their multiplicity.": "apart oscillator d_circle d_ones three_apart undamped resonance",
    "stays bounded, but does not die out": "apart oscillator d_circle d_ones three_apart undamped resonance",
    "No eigenvalue lies outside the unit circle": "d_circle d_chain d_ones",
    "No eigenvalue lies in the right half plane": "apart chain oscillator three_apart two_of_three undamped resonance",
    "and those on it have": "d_circle d_ones",
    "and those on the imaginary axis have": "apart oscillator three_apart undamped resonance",
    "**asymptotically stable**": "nodes damped d_inside complex d_surd d_pair",
    "**marginally stable**": "apart oscillator d_circle d_ones three_apart undamped resonance",
    "**unstable**": (
        "all but nodes apart oscillator damped d_inside d_circle "
        "d_ones k_range k_never three_apart complex undamped resonance d_surd d_pair"
    ),
    "is also BIBO stable": "nodes damped d_inside complex d_surd d_pair",
    "Neither $B$ nor $C$": (
        "unstable apart chain oscillator d_circle d_outside d_chain "
        "d_ones three_apart two_of_three surd undamped driven resonance"
    ),
    "transfer function does not count": "bibo not_bibo no_pole d_bibo d_not_bibo two_cancel k_bibo",
    "transfer matrix does not count": "only_B only_C",
    "$B$ is not given": "only_C",
    "$C$ is not given": "only_B",
    "No pole is left": "no_pole",
    "The eigenvalue $1$ cancels": "bibo only_B k_bibo",
    r"The eigenvalues $1,\; 2$ cancel.": "no_pole two_cancel",
    "So nothing can grow": "no_pole",
    "All poles that are left lie inside the unit circle": "d_bibo",
    "All poles that are left lie in the open left half plane": "bibo only_B two_cancel",
    "Not all of them lie inside the unit circle": "d_not_bibo",
    "Not all of them lie in the open left half plane": "not_bibo only_C",
    "although its free motion": "bibo only_B no_pole d_bibo two_cancel",
    "depends on the parameters": "k_range k_never k_bibo",
    "needs a look of its own": "resonance",
    "No values of the parameters make the system": "k_never",
    "asymptotically stable exactly for": "k_range",
}
SAID_OF_LYAPUNOV = {
    "A^{T}P + PA = -Q": "all but d_inside d_ones d_outside dual dual_unstable semi_dual d_dual d_dual_out d_semi",
    "AP + PA^{T} = -Q": "dual dual_unstable semi_dual",
    "A^{T}PA - P = -Q": "d_inside d_ones d_outside d_semi",
    "APA^{T} - P = -Q": "d_dual d_dual_out",
    "here 1.": "d_outside d_dual_out scalar",
    "here 3.": "all but d_outside d_dual_out scalar three",
    "here 6.": "three",
    r"\dot{V} = -x^{T}Qx$ along": (
        "all but d_inside d_ones d_outside dual dual_unstable semi_dual d_dual d_dual_out d_semi"
    ),
    "$V$ changes by": "d_inside d_ones d_outside d_semi",
    "These 3 linear equations have one": (
        "all but d_ones d_outside oscillator chain k_never d_dual_out scalar saddle three"
    ),
    "These 6 linear": "three",
    "linear equations have one solution.": "k_range damped three",
    "find a pivot for each unknown": (
        "all but d_ones d_outside oscillator chain k_range damped k_never d_dual_out scalar saddle three"
    ),
    "Row operations": "all but d_ones oscillator chain k_range damped k_never saddle three",
    "infinitely many solutions": "saddle",
    "contradict each other": "d_ones oscillator chain k_never",
    "the product of two eigenvalues (or": "d_ones",
    "two eigenvalues (or twice the same)": "oscillator chain k_never saddle",
    "inside the unit circle: the system is not": "d_ones",
    "in the open left half plane: the system is not": "oscillator chain k_never saddle",
    "must be controllable": "semi_dual",
    "must be observable": "semi semi_hidden semi_unstable d_semi",
    "so the sign of $P$ decides.": "semi semi_dual semi_unstable d_semi",
    "proves nothing here": "semi_hidden",
    "All are positive: $P$": "d_inside nodes damped dual semi semi_dual d_dual d_semi scalar three",
    "Not all are positive": "unstable d_outside dual_unstable semi_hidden semi_unstable d_dual_out lower",
    "The signs depend": "k_range",
    "With the transposed matrix": "dual semi_dual d_dual",
    "V(x(k+1)) - V(x(k))": "d_inside d_dual d_semi",
    r"\dot{V} = -x^{T}Qx$ n": "nodes damped dual semi semi_dual scalar three",
    "never positive; it stays": "semi semi_dual d_semi",
    "negative, so": "d_inside nodes oscillator damped dual d_dual scalar three",
    r"the sum $\sum": "d_outside d_dual_out",
    r"the integral $\int": "unstable dual_unstable semi_unstable lower",
    "A^{k}Q(A^{T})^{k}": "d_dual_out",
    "(A^{T})^{k}QA^{k}": "d_outside",
    "e^{At}Qe^{A^{T}t}": "dual_unstable",
    "e^{A^{T}t}Qe^{At}": "unstable semi_unstable lower",
    "An eigenvalue on the unit circle": "d_outside d_dual_out",
    r"the left side is $|\lambda|^{2} - 1$ times": "d_outside d_dual_out",
    r"the left side is $2\operatorname{Re}\lambda$ times": "unstable dual_unstable semi_unstable lower",
    "an eigenvector of $A^{T}$ for it": "dual_unstable d_dual_out",
    "An eigenvalue on the imaginary": "unstable dual_unstable semi_unstable lower",
    "there is an eigenvalue outside the unit": "d_outside d_dual_out",
    "there is an eigenvalue in the right": "unstable dual_unstable semi_unstable lower",
    "Compare with the eigenvalues": "all but d_ones oscillator chain k_range k_never semi_hidden saddle",
    "(multiplicity 2)": "d_ones chain",
    "**asymptotically stable**": "d_inside nodes damped dual semi semi_hidden semi_dual d_dual d_semi scalar three",
    "**unstable**": "unstable d_outside chain dual_unstable semi_unstable d_dual_out saddle lower",
    "**marginally stable**": "d_ones oscillator",
    "Where the eigenvalues lie": "d_ones oscillator chain k_never semi_hidden saddle",
    r"\Delta_{1} = \frac{1}{2} > 0": "nodes dual semi_hidden three",
    r"= -\frac{1}{3} < 0": "d_outside d_dual_out",
}
SAID_OF_ROUTH = {
    "Roots at $z = 1$": "d_ones d_chain d_one",
    "Its root lies on": "d_one",
    "Its roots lie on": "d_ones d_chain",
    "Bilinear transformation": "d_inside d_ones d_circle d_chain d_outside d_one d_zero d_two_out",
    "Multiplied by $(w - 1)^{1}$": "d_outside d_one",
    "Multiplied by $(w - 1)^{2}$": "d_inside d_circle d_zero d_two_out",
    "A zero in the first": "pivot split mixed pair_twice",
    "A row of zeros": "apart d_circle oscillator chain zeros double pair_twice",
    "(for a small": "pivot split mixed pair_twice",
    "There are no changes": "all but unstable d_outside k_range pivot split mixed pair_twice d_two_out",
    "There is one change": "unstable d_outside",
    "There are 2 changes": "pivot d_two_out",
    "There are 3 changes": "split",
    "cannot be trusted": "split mixed",
    "Split off": "split mixed",
    "has no roots in": "split mixed",
    "has 1 root in": "split",
    "has 2 roots in": "mixed",
    "Together: 1": "split",
    "Together: 2": "mixed",
    "1 eigenvalue lies outside": "d_outside",
    "2 eigenvalues lie outside": "d_two_out",
    "1 eigenvalue lies in the right": "unstable split",
    "2 eigenvalues lie in the right": "pivot mixed",
    "No eigenvalue lies outside the unit circle, but there": "d_ones d_circle d_one",
    "No eigenvalue lies in the right half plane, but there": "apart oscillator zeros",
    "No eigenvalue lies outside the unit circle, but on": "d_chain",
    "No eigenvalue lies in the right half plane, but on": "chain double",
    "The first column is positive throughout": "d_inside nodes damped d_zero",
    "lie inside the unit circle.": "d_inside d_zero",
    "lie in the open left half plane.": "nodes damped",
    "**asymptotically stable**": "d_inside nodes damped d_zero",
    "**marginally stable**": "d_ones apart d_circle oscillator zeros d_one",
    "**unstable**": "unstable d_chain d_outside chain pivot split double mixed pair_twice d_two_out",
    "Compare with": "all but k_range",
    "(multiplicity 2)": "d_ones apart d_chain chain double pair_twice d_zero",
    "lies on the imaginary axis, so": "apart oscillator chain zeros double",
    "lies on the unit circle, so": "d_ones d_circle d_chain d_one",
}
FAMILIES = {
    "eigenvalues": Family("stability", "eigenvalues", BY_EIGENVALUES, SAID_OF_EIGENVALUES),
    "lyapunov": Family("stability", "lyapunov", BY_LYAPUNOV, SAID_OF_LYAPUNOV),
    "routh": Family("stability", "routh", BY_ROUTH, SAID_OF_ROUTH),
}


@pytest.mark.parametrize(**cases_of(FAMILIES))
def test_the_words_are_those_of_the_case(family, name):
    assert not wrongly_said(family, name)
