"""A question about one channel of several: from there on B, C and D are those of the channel, however they came."""

import pytest

import solver

SYSTEMS = {
    "equations": """equations: ["m1 x1'' = u1 - k (x1 - x2)", "m2 x2'' = u2 - k (x2 - x1)"], inputs: [u1, u2],
        outputs: [x1, x2]""",
    "lagrangian": """lagrangian: {coordinates: [x1, x2], kinetic: "x1'^2/2 + x2'^2", potential: "k (x1 - x2)^2/2",
        forces: {x1: u1, x2: u2}}, inputs: [u1, u2], outputs: [x1, x2]""",
    "circuit": """circuit: ["V1 1 0 v_s", "R 1 2", "C 2 0", "I1 0 2 i_s"], outputs: [v_C, i_R]""",
    "state space": "A: [[1, 2], [3, 4]], B: [[1, 2], [3, 5]], C: [[1, 0], [0, 1]], D: [[0, 1], [1, 0]]",
}
ASKED = {
    "input": "input: 1",
    "output": "output: 2",
    "both": "input: 2, output: 1",
    "recursion": "input: 2, method: faddeev_leverrier",
}


@pytest.mark.parametrize("kind", SYSTEMS)
def test_one_channel_of_several_is_verified(kind):
    parts = "".join(f"\n  {name}: {{task: transfer_function, {asked}}}" for name, asked in ASKED.items())
    found = solver.solve(f"system: {{{SYSTEMS[kind]}}}\nfind:{parts}\n")
    assert {part.id: part.status for part in found.parts} == dict.fromkeys(ASKED, "verified")


def test_a_channel_is_shown_only_where_there_are_several():
    system = "system: {A: [[1, 2], [3, 4]], B: [1, 0], C: [0, 1]}"
    found = solver.solve(f"{system}\nfind: {{a: {{task: transfer_function, input: 1, output: 1}}}}\n")
    assert "channel" not in [step.kind for step in found.parts[0].steps]
