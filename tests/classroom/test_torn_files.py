"""An answer file that is hardly YAML loses the value that makes it so, and nothing else."""

import pytest

from solver.problem.source import InputError
from tests.helpers.marked import marked

pytestmark = pytest.mark.xdist_group("torn_files")  # its problem is solved once

PLANT = """
system: {A: [[0, 1], [-6, -5]], B: [0, 1], C: [1, 0]}
find: {a: {task: pole_placement, poles: [-4, -5]}, b: controllability}
"""
HEAD = "student: Ada\nanswers:\n"
END = "  b: {controllable: yes}\n"
P = "    polynomial: s^2 + 9s + 20\n"


def verdicts(text):
    return {
        f"{part}.{name}": str(answer.verdict)
        for part, verdict in marked(PLANT, text).items()
        for name, answer in verdict.answers.items()
        if answer.verdict in ("correct", "wrong", "not judged")
    }


@pytest.mark.parametrize(
    "part",
    [
        "  a:\n    K: [14, 4\n" + P,
        "  a:\n    K: '[14, 4]\n" + P,
        "  a: {K: [14, 4], polynomial: s^2 + 9s + 20\n",
        "  a:\n    K: “[14, 4]”\n    polynomial: „s^2 + 9s + 20“\n",
        "  a:\n    K:[14, 4]\n" + P,
        "  a:\n    K:[14, 4]\n    polynomial:s^2 + 9s + 20\n",
        "  a: {K:[14, 4], polynomial: s^2 + 9s + 20}\n",
        "  a:\n    K = [14, 4]\n    polynomial = s^2 + 9s + 20\n",
        "  a:\n    K: [14, 4]\n    polynomial = s^2 + 9s + 20\n",
        "  a:\n    K: [14,\t4]\n" + P,
        "\ta:\n\t\tK: [14, 4]\n\t\tpolynomial: s^2 + 9s + 20\n",
        "  a:\n    K: [14,\u200b 4]\n" + P,
        "  a:\n    K: [14, 4\u00ad]\n" + P,
        "  a:\n    K: [14, 4\x00]\n" + P,
        "\u00a0 a:\n    K: [14, 4]\n" + P,
        "  a:\n    K: [14, 4]\n    I computed this by hand\n" + P,
        "  a:\n    K: |\n          14\n        4\n" + P,
        "  a:\n    K: [14, 4]\n     polynomial: s^2 + 9s + 20\n",
        "  a:\n    K: [14, 4]\n   polynomial: s^2 + 9s + 20\n",
        '  a:\n    K: "\\begin{bmatrix}14&4\\end{bmatrix}"\n' + P,
        '  a:\n    K: "\\frac{28}{2}, 4"\n' + P,
        "  - a:\n      - K: [14, 4]\n      - polynomial: s^2 + 9s + 20\n",
        "  A:\n    k: [14, 4]\n    Polynomial: s^2 + 9s + 20\n",
        "  a):\n    K: [14, 4]\n" + P,
        "  Part a:\n    • K: [14, 4]\n" + P,
        "  a:\n    K: [14, 4]\n    K: [14, 4]\n" + P,
    ],
)
def test_what_can_be_read_in_one_way_is(part):
    listing = next((each for each in ("  - ", "\t") if part.startswith(each)), "  ")
    found = verdicts(f"{HEAD}{part}{listing}{END.strip()}\n")
    assert found == {"a.K": "correct", "a.polynomial": "correct", "b.controllable": "correct"}


@pytest.mark.parametrize(
    "value",
    [
        "&x [14, 4]",
        "*K",
        "!x",
        "@x",
        "`x`y`",
        "---",
        "?",
        "[14, 4}",
        "[" * 40 + "1" + "]" * 40,
        "[" * 300 + "1" + "]" * 300,
        "1+" * 12000 + "1",
        "[14, 4]\n    K: [14, 5]",
        "[14, 5]\n    K: [14, 4]",
    ],
)
def test_what_cannot_be_read_costs_nothing_but_itself(value):
    found = verdicts(f"{HEAD}  a:\n    K: {value}\n{P}{END}")
    assert found == {"a.K": "not judged", "a.polynomial": "correct", "b.controllable": "correct"}


def test_a_value_that_cannot_be_read_within_braces_costs_nothing_but_itself():
    found = verdicts(f"{HEAD}  a: {{K: !x, polynomial: s^2 + 9s + 20}}\n{END}")
    assert found == {"a.K": "not judged", "a.polynomial": "correct", "b.controllable": "correct"}


@pytest.mark.parametrize("student", ["[Ada", "Ada: L.", "'Ada", "*", "Ada\t"])
def test_the_name_of_a_student_loses_no_answer(student):
    found = verdicts(f"student: {student}\nanswers:\n  a:\n    K: [14, 4]\n{P}{END}")
    assert set(found.values()) == {"correct"}


def test_where_it_is_not_clear_to_which_part_an_answer_belongs_the_file_is_at_fault():
    with pytest.raises(InputError, match="missing"):
        verdicts("answers: {a: {K: [14, 4], b: {controllable: yes}}\n")


def test_lines_keep_their_numbers():
    lines = f"{HEAD}  a:\n    K: [0 1;\n      2 3\n{P}    closed_loop_A: [1, 2+]\n{END}"
    (reason,) = (str(marked(PLANT, lines)["a"].answers["closed_loop_A"].reason),)
    assert "line 7" in reason


def test_blocks_of_code_and_ends_of_lines_of_other_systems_are_read():
    file = f"{HEAD}  a:\n    K: [14, 4]\n{END}"
    wanted = {"a.K": "correct", "b.controllable": "correct"}
    for text in (f"```yaml\n{file}```\n", file.replace("\n", "\r\n"), file.replace("\n", "\r"), f"\ufeff{file}"):
        assert verdicts(text) == wanted


def test_of_a_part_that_is_given_twice_what_was_given_twice_is_not_judged():
    found = verdicts(f"{HEAD}  a:\n    K: [14, 4]\n{P}  a:\n    K: [1, 1]\n{END}")
    assert found == {"a.K": "not judged", "a.polynomial": "correct", "b.controllable": "correct"}
