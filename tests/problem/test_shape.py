from __future__ import annotations

import pytest

from solver.problem.source import InputError

SYSTEM = "system: {A: [[0, 1], [-2, -3]]}\n"
FIND = "find: {a: stability}\n"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("just words", ["1:1-11 a problem is a mapping with the keys 'system' and 'find', not just words"]),
        ("- 1\n", ["1:1-2 a problem is a mapping with the keys 'system' and 'find', not a list"]),
        ("title: x\n", ["0:0-1 'find' is missing"]),
        ("statment: x\n" + SYSTEM + FIND, ["1:1-9 unknown key 'statment'"]),
        (SYSTEM + "find:\n", ["2:6-7 a mapping (key: value) is expected here, not nothing"]),
        (SYSTEM + "find: {}\n", ["2:7-9 this is empty"]),
        (SYSTEM + "find: [stability]\n", ["2:7-18 a mapping (key: value) is expected here, not a list"]),
        (SYSTEM + "find: {a b: stability}\n",
         ["2:8-11 'a b' cannot name a part: at most 32 letters, digits, and - _ . ( )"]),
        (SYSTEM + f"find: {{{'x' * 33}: stability}}\n",
         [f"2:8-41 '{'x' * 33}' cannot name a part: at most 32 letters, digits, and - _ . ( )"]),
        (SYSTEM + "find: {a: , b: [x], c: true}\n", [
            "2:11-12 a task's name or a mapping {task: .., ..} is expected here, not nothing",
            "2:16-19 a task's name or a mapping {task: .., ..} is expected here, not a list",
            "2:24-28 a task's name or a mapping {task: .., ..} is expected here, not true or false",
        ]),
        (SYSTEM + "find:\n  a: {method: x}\n", ["3:6-17 'task' is missing here"]),
        (SYSTEM + "find:\n  a: {task: stability, marks: [1], prompt: {x: y}}\n", [
            "3:31-34 a number, or the marks of each answer, as in {K: 2, polynomial: 1}, is expected here, not a list",
            "3:44-50 a number or a text is expected here, not a mapping",
        ]),
        ("title: [1]\nsource: true\nstatement:\n" + SYSTEM + FIND, [
            "1:8-11 a number or a text is expected here, not a list",
            "2:9-13 a number or a text is expected here, not true or false",
            "3:11-12 a number or a text is expected here, not nothing",
        ]),
        ("parameters: [m, 1]\n" + SYSTEM + FIND, ["1:13-19 a mapping (key: value) is expected here, not a list"]),
        ("parameters: {m: [1]}\n" + SYSTEM + FIND, ["1:17-20 a number or a text is expected here, not a list"]),
        ("assume: {m: positve}\n" + SYSTEM + FIND, [
            "1:13-20 'positve' is not known here; it is one of positive, negative, nonzero, real, complex, integer"
        ]),
        ("display: exct\n" + SYSTEM + FIND, ["1:10-14 'exct' is not known here; it is one of exact, decimals, both"]),
        ("display: [4]\n" + SYSTEM + FIND, ["1:10-13 exact, both or {decimals: 4} is expected here, not a list"]),
        ("display: {decimal: 4}\n" + SYSTEM + FIND, ["1:11-18 unknown key 'decimal'"]),
        ("display: {decimals: 0}\n" + SYSTEM + FIND,
         ["1:21-22 decimals must be a whole number of at least 1 and at most 30"]),
        ("display: {decimals: four}\n" + SYSTEM + FIND,
         ["1:21-25 decimals must be a whole number of at least 1 and at most 30, not 'four'"]),
        ("system: 3\n" + FIND, [
            "1:9-10 a system: a mapping such as {A: [[0, 1], [-2, -3]], B: [0, 1]} is expected here, not 3"
        ]),
        ("system: {}\n" + FIND, ["1:9-11 'A' is missing here"]),
        ("system: {B: [1]}\n" + FIND, ["1:9-17 'A' is missing here"]),
        ("system: {A: {x: 1}}\n" + FIND,
         ["1:13-19 a matrix: a list of rows [[..], [..]] is expected here, not a mapping"]),
        ("system: {A: }\n" + FIND, ["1:13-14 a matrix: a list of rows [[..], [..]] is expected here, not nothing"]),
        ("system: {A: []}\n" + FIND, ["1:13-15 this is empty"]),
        ("system: {A: [[1, true], [{x: 1}, [2]]]}\n" + FIND, [
            "1:18-22 a number or a text is expected here, not true or false",
            "1:26-32 a number or a text is expected here, not a mapping",
            "1:34-37 a number or a text is expected here, not a list",
        ]),
        ("system: {A: [[1]], intial_state: [1]}\n" + FIND, ["1:20-32 unknown key 'intial_state'"]),
        ("system: {tranfer_function: 1/s}\n" + FIND, ["1:10-26 unknown key 'tranfer_function' in a system"]),
        ("system: {transfer_function: 1/s, A: [[1]]}\nfind: {a: realization}\n",
         ["1:34-35 'A' cannot stand beside 'transfer_function'"]),
        ("system: {matrix: [[1]], B: [1]}\n" + FIND, ["1:25-26 'B' cannot stand beside 'matrix'"]),
        ("system: {matrix: [[1]], B: [1], C: [1]}\n" + FIND, ["1:25-26 'B' and 'C' cannot stand beside 'matrix'"]),
        ("system: {A: [[1]], time: dicrete}\n" + FIND,
         ["1:26-33 'dicrete' is not known here; it is one of continuous, discrete"]),
        ("system: {transfer_function: [1]}\n" + FIND, [
            "1:29-32 an expression, {zeros, poles, gain} or {numerator, denominator} is expected here, not a list"
        ]),
        ("system: {transfer_function: {numerator: [1]}}\n" + FIND, ["1:29-45 'denominator' is missing here"]),
        ("system: {transfer_function: {poles: [1], zeroes: [1]}}\n" + FIND, ["1:42-48 unknown key 'zeroes'"]),
        ("system: {transfer_function: {numerator: [1], denominatr: [1, 2]}}\n" + FIND,
         ["1:46-56 unknown key 'denominatr'"]),
        ("system: {transfer_function: {numerator: [1], poles: [1], denominator: [1, 2], gain: 3}}\n" + FIND,
         ["1:46-51 'poles' and 'gain' cannot stand beside 'numerator'"]),
        (SYSTEM + "fnd: {a: stability}\n", ["2:1-4 unknown key 'fnd'"]),
        ("system: {transfer_matrix: 1/s}\n" + FIND, ["1:27-30 a list is expected here, not 1/s"]),
        ("system: {transfer_matrix: [1/s]}\n" + FIND, ["1:28-31 a list is expected here, not 1/s"]),
    ],
)  # fmt: skip
def test_what_is_wrong_with_the_shape_is_said_at_its_place(complaints, text, expected):
    assert complaints(text) == expected


@pytest.mark.parametrize(
    ("text", "suggestion"),
    [
        ("statment: x\n" + SYSTEM + FIND, "statement"),
        ("assume: {m: postive}\n" + SYSTEM + FIND, "positive"),
        ("display: exat\n" + SYSTEM + FIND, "exact"),
        ("display: {decimal: 4}\n" + SYSTEM + FIND, "decimals"),
        ("system: {A: [[1]], inital_state: [1]}\n" + FIND, "initial_state"),
        ("system: {transferfunction: 1/s}\n" + FIND, "transfer_function"),
        ("system: {transfer_function: {zeroes: [1]}}\n" + FIND, "zeros"),
        (SYSTEM + "find: {a: stabilty}\n", "stability"),
        ("system: {transfer_function: [[1/s, 1]]}\nfind: {a: transfer_function}\n", "transfer_matrix"),
    ],
)
def test_a_misspelt_word_brings_the_right_one(read, text, suggestion):
    with pytest.raises(InputError, match=f"did you mean '{suggestion}'"):
        read(text)


def test_sixty_parts_are_read_and_sixty_one_refused(read, complaints):
    parts = [f"  p{i}: stability\n" for i in range(61)]
    assert len(read(SYSTEM + "find:\n" + "".join(parts[:60])).parts) == 60
    assert complaints(SYSTEM + "find:\n" + "".join(parts)) == ["3:3-4 there are more than 60 parts"]


def test_errors_in_all_sections_are_reported_together(complaints):
    found = complaints(
        "titel: x\nassume: {m: big}\ndisplay: {decimals: no}\nsystem: {A: [[1, 2], [3]]}\n"
        "find:\n  a: stabilty\n  b: {task: transition, method: laplce}\n  c: [x]\n"
    )
    assert [line.split(":")[0] for line in found] == ["1", "2", "3", "4", "6", "7", "8"]


def test_a_surplus_key_does_not_hide_what_else_is_wrong(complaints):
    found = complaints("system: {A: [[1, 2], [3]], inital_state: [1]}\n" + FIND)
    assert found == ["1:22-25 A has 2 rows, row 2 has 1 entry", "1:28-40 unknown key 'inital_state'"]
