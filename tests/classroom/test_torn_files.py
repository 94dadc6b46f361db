"""An answer file that is hardly YAML loses the value that makes it so, and nothing else."""

import pytest

from solver.classroom.reading.files import load_submitted
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
        "  a: {K: [14, 4]}\n  a: {polynomial: s^2 + 9s + 20}\n",
        "  a: {K: [14, 4]}\n  a:\n" + P,
        "  a:\n    K: [14, 4]\n  a:\n" + P,
        "  a: {K: [14, 4], polynomial: s^2 + 9s + 20},\n",
        "  a.K: [14, 4]\n  a.polynomial: s^2 + 9s + 20\n",
        "  a) K: [14, 4]\n  a: {polynomial: s^2 + 9s + 20}\n",
        "  a：{K：[14， 4]， polynomial：s^2 + 9s + 20}\n",
        "  a:\n    K: [14, 4]\n    my remark: by Ackermann: see page 2\n" + P,
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


def test_of_three_of_one_part_all_count_and_of_three_values_none():
    parts = ("polynomial: s^2 + 9s + 20", "K: [14, 4]", "closed_loop_A: [[0, 1], [-20, -9]]")
    found = verdicts(HEAD + "".join(f"  a: {{{part}}}\n" for part in parts))
    assert found == {"a.K": "correct", "a.polynomial": "correct", "a.closed_loop_A": "correct"}
    found = verdicts(f"{HEAD}  a: {{K: [14, 4]}}\n  a: {{K: [1, 4]}}\n  a: {{K: [14, 4]}}\n")
    assert found == {"a.K": "not judged"}


@pytest.mark.parametrize(
    "text",
    [
        "a:\n  K: [14, 4]\nb: {controllable: yes}\n",
        "answers:\na:\n  K: [14, 4]\nb: {controllable: yes}\n",
        "answers:\n  a:\n    K: [14, 4]\nb: {controllable: yes}\n",
        "answers:\n  a:\n    K: [14, 4]\nanswers:\n  b: {controllable: yes}\n",
    ],
)
def test_parts_that_do_not_stand_below_the_answers_are_read(text):
    assert verdicts(f"student: Ada\n{text}") == {"a.K": "correct", "b.controllable": "correct"}


def test_a_part_below_the_answers_and_beside_them_is_not_guessed():
    assert verdicts("answers:\n  a: {K: [14, 4]}\na: {K: [1, 1]}\n") == {"a.K": "correct"}


@pytest.mark.parametrize("encoding", ["utf-16", "utf-8-sig", "cp1252"])
def test_files_in_the_encodings_of_windows_are_read(encoding, tmp_path):
    (tmp_path / "a.yaml").write_bytes(f"student: Jörg\n{HEAD[13:]}  a: {{polynomial: s² + 9s + 20}}\n".encode(encoding))
    source = load_submitted(tmp_path / "a.yaml")
    assert source.text.startswith("student: Jörg\n")
    assert verdicts(source.text) == {"a.polynomial": "correct"}


def test_what_is_no_text_is_not_taken_for_one(tmp_path):
    (tmp_path / "a.yaml").write_bytes(b"PK\x03\x04\xe4\x00")
    with pytest.raises(InputError, match="not a text in UTF-8"):
        load_submitted(tmp_path / "a.yaml")
