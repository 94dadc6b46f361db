"""An input that acts on nothing is pointed out where the system is given."""

import pytest

import solver


@pytest.mark.parametrize(
    ("inputs", "outputs", "says"),
    [
        ("[u]", "[x]", ""),
        ("[u, w]", "[x]", "The input $w$ occurs in no equation, and acts on nothing."),
        ("[u, w]", "[x + w]", ""),
        ("[w, u, v]", "[x]", "The inputs $w$ and $v$ occur in no equation, and act on nothing."),
    ],
)
def test_an_input_in_no_equation_is_pointed_out(inputs, outputs, says):
    system = f"equations: [\"x'' + x = u\"], inputs: {inputs}, outputs: {outputs}"
    page = solver.solve(f"system: {{{system}}}\nfind: {{a: state_space_model}}\n").markdown()
    assert says in page
    assert ("in no equation" in page) == bool(says)
