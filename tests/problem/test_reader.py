from __future__ import annotations

from textwrap import dedent

import pytest
import sympy as sp

from solver.problem.model import Display, Part, Problem
from solver.problem.reader import load, read_problem
from solver.problem.source import InputError, Source
from solver.systems import StateSpace
from solver.tasks import catalogue as real_catalogue

M = sp.ImmutableMatrix
SYSTEM = "system: {A: [[0, 1], [-2, -3]], B: [0, 1]}\n"
FIND = "find: {a: stability}\n"


def test_a_whole_problem(catalogue):
    text = """\
title: Servo position loop
source: Lecture note, 3.5 example 1
statement: |
  Place the poles of $A$.
parameters: {m: 2, d: 0.5}
assume: {a: positive}
display: {decimals: 4}
system:
  A: [[0, 1], [-a/m, -d/m]]
  B: [0, 1/m]
find:
  a: stability
  (b): {task: placement, method: [bass_gura, ackermann], poles: ["-3 ± 2j"], marks: 3.5, prompt: Find $K$.}
"""
    a = sp.Symbol("a", positive=True)
    system = StateSpace(M([[0, 1], [-a / 2, sp.Rational(-1, 4)]]), M([0, sp.Rational(1, 2)]))
    assert read_problem(Source("some/folder/servo-loop.yaml", text), catalogue) == Problem(
        name="servo-loop",
        title="Servo position loop",
        source="Lecture note, 3.5 example 1",
        statement="Place the poles of $A$.",
        display=Display("decimal", 4, decimals_typed=True),
        parameters={"m": sp.Integer(2), "d": sp.Rational(1, 2)},
        symbols={"a": a},
        assumed={"positive": (a,)},
        system=system,
        parts=(
            Part("a", "stability", ("stability",), system, decimals_typed=True, written=frozenset({"task"})),
            Part(
                "(b)",
                "placement",
                ("bass_gura", "ackermann"),
                system,
                {"poles": (-3 + 2 * sp.I, -3 - 2 * sp.I)},
                "Find $K$.",
                sp.Rational(7, 2),
                decimals_typed=True,
                written=frozenset({"task", "method", "poles", "prompt", "marks"}),
            ),
        ),
    )


@pytest.mark.parametrize(
    ("name", "title"),
    [("servo-loop.yaml", "Servo loop"), ("a/b/ex_02.yml", "Ex 02"), ("<text>", "Problem"), ("3.5.yaml", "3.5")],
)
def test_the_title_defaults_to_the_name_of_the_file(catalogue, name, title):
    assert read_problem(Source(name, SYSTEM + FIND), catalogue).title == title


@pytest.mark.parametrize(
    ("line", "display"),
    [
        ("", Display()),
        ("display: exact\n", Display("exact")),
        ("display: both\n", Display("both")),
        ("display: decimals\n", Display("decimal")),
        ("display: {decimals: 3}\n", Display("decimal", 3)),
        ("display: {mode: both, decimals: 8}\n", Display("both", 8)),
        ("display: {mode: exact}\n", Display("exact")),
    ],
)
def test_display(read, line, display):
    assert read(line + SYSTEM + FIND).display == display


@pytest.mark.parametrize(
    ("text", "typed"),
    [
        (SYSTEM + FIND, False),
        ("system: {A: 0.5}\n" + FIND, True),
        ("system: {A: 1e-3}\n" + FIND, True),
        ("parameters: {m: 0.5}\nsystem: {A: m}\n" + FIND, True),
        (SYSTEM + "find: {a: {task: stability, gain: [0.5, 1]}}\n", True),
        (SYSTEM + "find: {a: {task: stability, marks: 2.5}}\n", False),
        ("title: 0.5\n" + SYSTEM + FIND, False),
    ],
)
def test_decimals_typed_in_the_mathematics_are_noticed(read, text, typed):
    assert read(text).parts[0].decimals_typed is typed


def test_parameters_may_refer_to_those_before_them(read):
    problem = read("parameters: {m: 2, k: 3/m, w: sqrt(k q)}\nsystem: {A: [[w, k], [m, 1]]}\n" + FIND)
    q = sp.Symbol("q", real=True)
    assert problem.parameters == {"m": 2, "k": sp.Rational(3, 2), "w": sp.sqrt(sp.Rational(3, 2) * q)}
    assert problem.system.A[0, 0] == sp.sqrt(sp.Rational(3, 2) * q)
    assert problem.symbols == {"q": q}


def test_parameters_are_put_into_options_too(read):
    problem = read("parameters: {p: 2}\n" + SYSTEM + "find: {a: {task: placement, poles: [-p, -2p]}}\n")
    assert problem.parts[0].options["poles"] == (-2, -4)


def test_greek_letters_and_their_names_are_the_same(read):
    problem = read(
        "parameters: {ζ: 1/2}\nassume: {omega_n: positive}\nsystem: {A: [[0, 1], [-ω_n^2, -2 zeta ω_n]]}\n" + FIND
    )
    w = sp.Symbol("omega_n", positive=True)
    assert M([[0, 1], [-(w**2), -w]]) == problem.system.A


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        ("parameters: {m: 1, s: 2}", ["1:20-21 's' cannot be a parameter: s is the variable of the Laplace transform"]),
        ("parameters: {m: 1, λ: 2}", ["1:20-21 'λ' cannot be a parameter: λ stands for eigenvalues"]),
        ("assume: {t: positive}\nparameters: {m: 1}", ["1:10-11 't' cannot be a parameter: t is the time"]),
        ("parameters: {m: 1, 2x: 3}", ["1:20-22 a name is expected: letters, digits and _"]),
        ("parameters: {m: 1, 'a b': 3}", ["1:21-24 a name is expected: letters, digits and _"]),
        ("parameters: {m: a, a: 2}", ["1:17-18 'a' cannot stand here: its value is given further down"]),
        ("parameters: {m: 2m}", ["1:18-19 'm' cannot stand here: it is what is defined"]),
        ("parameters: {m: 1/0}", ["1:19-20 division by zero"]),
        ("parameters: {m: inf}", ["1:17-20 a finite value is expected here"]),
        ("parameters: {m: 1, μ: 2, mu: 3}", ["1:26-28 'mu' is given twice: it is the same name as 'mu'"]),
        ("parameters: {m: positive}", ["1:17-25 'positive' is what can be assumed of a name, not a value"]),
        ("parameters: {m: 1, mm: 2}", ["1:20-22 the parameter 'mm' occurs nowhere"]),
    ],
)
def test_what_is_wrong_with_parameters_is_said(complaints, lines, expected):
    assert complaints(lines + "\nsystem: {A: [[m, n]  , [1, 2]]}\n" + FIND) == expected


def test_a_parameter_that_occurs_nowhere_suggests_the_one_meant(read):
    with pytest.raises(InputError, match="did you mean 'omega'"):
        read("parameters: {omgea: 2}\nsystem: {A: omega}\n" + FIND)


def test_a_parameter_used_by_another_or_by_an_option_occurs(read):
    system = read("parameters: {m: 2, k: m}\nsystem: {A: k}\n" + FIND).parts[0].system
    assert list(system.A) == [2]
    placed = read("parameters: {p: 2}\n" + SYSTEM + "find: {a: {task: placement, poles: [-1, -p]}}\n")
    assert placed.parts[0].options["poles"] == (-1, -2)


def test_an_assumption_about_an_unused_name_is_accepted(read):
    assert read("assume: {q: positive}\n" + SYSTEM + FIND).symbols == {"q": sp.Symbol("q", positive=True)}


@pytest.mark.parametrize(
    ("text", "methods"),
    [
        ("transition", ("laplace",)),
        ("{task: transition}", ("laplace",)),
        ("{task: transition, method: modal}", ("modal",)),
        ("{task: transition, method: [modal, series, laplace]}", ("modal", "series", "laplace")),
        ("{task: transition, system: {A: 1, time: discrete}}", ("z_transform",)),
        ("{task: transition, method: [modal, z_transform], system: {A: 1, time: discrete}}", ("modal", "z_transform")),
        ("stability", ("stability",)),
    ],
)
def test_methods_are_as_asked_or_the_first_for_the_kind_of_time(part, text, methods):
    assert part(text).methods == methods


def test_options_of_any_chosen_method_are_taken(part):
    assert part("{task: transition, method: laplace}").options == {}
    assert part("{task: transition, method: [laplace, series]}").options == {"terms": 3}
    assert part("{task: transition, method: [modal, series], terms: 5}").options == {"terms": 5, "convention": "right"}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("stabilty", ["3:6-14 there is no task 'stabilty'"]),
        ("{task: x}", ["3:13-14 there is no task 'x'"]),
        ("{task: '</script>\\input'}", ["3:13-30 there is no task '</script>\\input'"]),
        ("{task: transition, method: laplce}", ["3:33-39 transition has no method 'laplce'"]),
        ("{task: transition, method: [modal, modal]}", ["3:41-46 the method modal is given twice"]),
        ("{task: transition, method: []}", ["3:33-35 the list of methods is empty"]),
        ("{task: transition, method: z_transform}",
         ["3:33-44 the method z_transform is not for systems in continuous time"]),
        ("{task: stability, method: stability}", ["3:24-30 stability has one method only; leave out 'method'"]),
        ("{task: transition, terms: 3}", ["3:25-30 'terms' is an option of the method series, not of laplace"]),
        ("{task: transition, term: 3, method: series}", ["3:25-29 transition has no option 'term'"]),
        ("{task: transition, x: 1, y: 2}",
         ["3:25-26 transition has no option 'x'", "3:31-32 transition has no option 'y'"]),
        ("placement", ["3:6-15 placement needs the option 'poles': poles of the closed loop"]),
        ("{task: stability, marks: -1}", ["3:31-33 marks can't be negative"]),
        ("{task: stability, marks: {answr: 2, answer: -1}}",
         ["3:32-37 stability has no answer 'answr'", "3:50-52 marks can't be negative"]),
        ("{task: stability, marks: {}}",
         ["3:31-33 no answer is named here; write marks: 3, or the marks of each answer: {K: 2, polynomial: 1}"]),
        ("{task: stability, marks: many}", ["3:31-35 a number is expected here, not many"]),
        ("{task: stability, marks: sqrt(2)}", ["3:31-38 a number is expected here, not sqrt(2)"]),
        ("realization", None),
        ("{task: stability, system: {A: [[1, 2]]}}", ["3:36-44 A must be square, it is 1×2"]),
    ],
)  # fmt: skip
def test_what_is_wrong_with_a_part_is_said_at_its_place(complaints, text, expected):
    found = complaints(f"system: {{A: [[0, 1], [-2, -3]]}}\nfind:\n  a: {text}\n")
    if expected is None:
        expected = ["3:6-17 realization needs a transfer function (or A, B and C); the system has only A"]
    if text == "placement":
        expected = [expected[0], "3:6-15 placement needs B; the system has only A"]
    assert sorted(found) == sorted(expected)


@pytest.mark.parametrize(
    ("task", "system", "expected"),
    [
        ("controllability", "system: {A: 1}\n", "controllability needs B; the system has only A"),
        ("controllability", "system: {matrix: 1}\n", "controllability needs B; the system has only A"),
        ("controllability", "", "controllability is about a system, and there is none"),
        ("stability", "system: {matrix: [[1, 2]]}\n", "stability needs A; the matrix is not square"),
        (
            "realization",
            "system: {A: 1, B: 1}\n",
            "realization needs a transfer function (or A, B and C); the system has only A and B",
        ),
    ],
)  # fmt: skip
def test_a_question_about_what_the_system_lacks_is_refused(complaints, task, system, expected):
    (found,) = complaints(f"{system}find: {{a: {task}}}\n")
    assert found.split(" ", 1)[1] == expected


@pytest.mark.parametrize(
    ("task", "system"),
    [
        ("realization", "system: {A: 1, B: 1, C: 1}\n"),
        ("realization", "system: {transfer_function: 1/s}\n"),
        ("subspaces", "system: {A: 1}\n"),
        ("{task: subspaces, matrix: [[1, 2]]}", ""),
        ("desired", ""),
        ("{task: desired, overshoot: 14%}", ""),
    ],
)
def test_a_question_whose_needs_are_met_is_read(read, task, system):
    assert read(f"{system}find:\n  a: {task}\n").parts[0].id == "a"


def test_a_gain_needs_an_input(complaints):
    assert complaints("system: {A: 1}\nfind: {a: {task: stability, gain: 1}}\n") == [
        "2:29-33 a gain needs A and B; the system has only A"
    ]


def test_errors_in_a_system_do_not_hide_those_in_parts(complaints):
    found = complaints(
        "system: {A: [[1, 2], [3]]}\nfind:\n  a: controllability\n  b: {task: transition, method: laplce}\n"
    )
    assert found == ["1:22-25 A has 2 rows, row 2 has 1 entry", "4:33-39 transition has no method 'laplce'"]


def test_part_names(read):
    names = ["a", "1.b", "(ii)", "stm_2", "α", "x" * 32, "no", "true", "3"]
    problem = read(SYSTEM + "find:\n" + "".join(f"  {name}: stability\n" for name in names))
    assert [part.id for part in problem.parts] == names


def test_a_file_is_loaded_and_read(tmp_path, catalogue):
    path = tmp_path / "servo.yaml"
    path.write_text(SYSTEM + FIND, encoding="utf-8")
    assert read_problem(load(path), catalogue).name == "servo"
    path.write_text(SYSTEM + "find: {a: nothing}\n", encoding="utf-8")
    with pytest.raises(InputError, match=r"servo\.yaml:2:11: error: there is no task 'nothing'"):
        read_problem(load(path), catalogue)


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("statement: Let $\\foo$ be.\n", "1:17-18 in a formula: \\foo is not known in formulas here"),
        ("statement: |\n  One line,\n  then $a_{1$ here.\n", "3:11-12 in a formula: this { is not closed"),
    ],
)
def test_a_formula_that_cannot_be_drawn_is_reported_at_its_place(complaints, text, found):
    assert complaints(f"{text}system: {{A: 1}}\nfind: {{a: stability}}\n") == [found]


def test_a_formula_in_a_prompt_is_checked_too(complaints):
    (found,) = complaints("system: {A: 1}\nfind:\n  a: {task: stability, prompt: 'Is $x^$ stable?'}\n")
    assert found.startswith("3:39")


def test_marks_may_be_given_to_each_answer(catalogue):
    text = SYSTEM + "find: {a: {task: placement, method: ackermann, poles: [-1, -2], marks: {K: 2, polynomial: 0.5}}}\n"
    part = read_problem(Source("problem.yaml", text), catalogue).parts[0]
    assert (part.marks, part.answer_marks) == (sp.Rational(5, 2), {"K": 2, "polynomial": sp.Rational(1, 2)})


def test_a_part_may_carry_no_marks(catalogue):
    text = SYSTEM + "find: {a: {task: placement, method: ackermann, poles: [-1, -2], marks: 0}}\n"
    assert read_problem(Source("problem.yaml", text), catalogue).parts[0].marks == 0


def test_decimals_of_one_part_say_nothing_of_another_unless_it_goes_on_with_them():
    text = """
    system: {A: [[0, 1], [-2, -3]], B: [0, 1]}
    find:
      a: {task: pole_placement, poles: [-1.5, -2]}
      b: {task: stability}
      c: {task: stability, gain: {from: a}}
      d: {task: stability, system: {A: [[0.5]], B: [1]}}
    """
    problem = read_problem(Source("file.yaml", dedent(text)), real_catalogue())
    assert [part.decimals_typed for part in problem.parts] == [True, False, True, True]
    assert not problem.display.decimals_typed
