"""Whatever the text, reading it gives a problem or an error with its place, never another exception."""

from __future__ import annotations

import contextlib
from pathlib import Path

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from solver.problem.files import load
from solver.problem.model import Problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from tests.helpers.tried import tried

VALID = [
    "title: Servo\nparameters: {m: 1, k: 3/4}\nassume: {a: positive}\ndisplay: {decimals: 4}\n"
    "system:\n  A: [[0, 1], [-k/m, -a]]\n  B: [0, 1]\n  C: [1, 0]\n  initial_state: [1, -0.5]\n"
    "find:\n  a: stability\n  b: {task: placement, method: ackermann, poles: [\"-3 ± 2j\"], marks: 3.5}\n"
    "  c: {task: options, gain: {from: b}, shape: \"exp(-2t)\", count: 3}\n",
    "system: {transfer_function: (2s^3+5s^2+3s+1)/(4s^4+2s^2+3s+6)}\nfind:\n  a: realization\n"
    "  b: {task: realization, system: {transfer_function: {zeros: [-1], poles: [-2, -3 ± j], gain: 5}}}\n"
    "  c: {task: realization, system: {time: discrete, transfer_matrix: [[1/z, {poles: [-2]}]]}}\n",
    "statement: |\n  Find $\\Phi(t)$ and\n  $$x(t)$$\nfind:\n  a:\n    task: transition\n    method: [modal, series]\n"
    "    terms: 4\n    prompt: 'Two methods: it''s enough'\n    system: {A: [[0.1, 1], [-1, 0]], states: [x, v]}\n"
    "  b: {task: transition, system: {time: discrete, sample_time: 0.1, A: [[sqrt(2), 1], [0, 2/3]]}}\n",
]  # fmt: skip

MATRIX = "system: {{A: [[{}, 1], [2, 3]]}}\nfind: {{a: stability}}\n"


def outcome(text, catalogue):
    """Read a text; anything but a problem or an InputError that can be shown gets out as an exception."""
    found: object = None
    try:
        found = read_problem(Source("file.yaml", text), catalogue)
    except InputError as error:
        found = error
    if isinstance(found, Problem):
        return "read"
    assert found.diagnostics
    assert found.render().startswith("file.yaml:")
    last = text.count("\n") + 2
    assert all(0 <= each.line <= last and each.message for each in found.diagnostics)
    return "refused"


@pytest.mark.parametrize("text", VALID)
def test_the_files_that_are_mutated_below_are_right(text, catalogue):
    assert outcome(text, catalogue) == "read"


@pytest.mark.parametrize(
    "entry",
    [
        '__import__("os").getcwd()',
        "().__class__.__base__.__subclasses__()",
        "open('/etc/hostname').read()",
        "x.subs(x,2)",
        "lambda: 1",
        "9^9^9",
        "9**9**9",
        "(1/3)^(10^8)",
        "1e999999999",
        "1" * 5000,
        "(" * 5000,
        "-" * 5000 + "x",
        "x+" * 1999 + "x",
        "exp(exp(exp(exp(100))))",
        "(a+b+c+d+f+g+h)^64",
        "NaN",
        ".inf",
        "inf",
        "inf - inf",
        "1/0",
        "0^(-1)",
        "log(0)",
        "tan(pi/2)",
        "1/(x-x)",
        "zoo",
        "oo",
        "</script>",
        "\\input{/etc/passwd}",
        "^^5c",
        "x\u200by",
        "ａ",
        "x!",
        "factorial(10^7)",
        "$x$",
        "{{ config }}",
    ],
)
def test_hostile_entries_are_refused_at_their_place(entry, catalogue, complaints):
    quoted = entry.replace("'", "''")
    found = complaints(MATRIX.format(f"'{quoted}'"))
    assert found
    assert all(line.startswith("1:") for line in found)


@pytest.mark.parametrize(
    "text", ["</script><script>alert(1)</script>", "\\input{/etc/passwd}", "^^5c", "{{ 7*7 }}", "%s%n"]
)
def test_markup_in_texts_is_plain_text(text, read):
    texts = f"title: '{text}'\nstatement: '{text}'\nsource: '{text}'\nsystem: {{A: 1}}\n"
    problem = read(texts + f"find: {{a: {{task: stability, prompt: '{text}'}}}}\n")
    assert (problem.title, problem.statement, problem.source, problem.parts[0].prompt) == (text,) * 4


@pytest.mark.parametrize(
    "text",
    [
        "!!python/object/apply:os.system ['true']",
        "system: !!python/name:os.system x\nfind: {a: stability}",
        "a: &a [x]\nb: [*a, *a]",
        "<<: {system: {A: 1}}\nfind: {a: stability}",
        "system: {A: 1}\nsystem: {A: 2}\nfind: {a: stability}",
        "find: {a: stability}\n---\nfind: {a: stability}",
        "\x00\x01\x02",
        "\x89PNG\r\n\x1a\n",
        "title: \u202etxt\nsystem: {A: 1}\nfind: {a: stability}",
        "[" * 100_000,
        "{" * 100_000,
        "- " * 100_000,
        "system: {A: " + "[" * 100_000,
        "find: {a: {task: " + "x" * 30_000 + "}}",
        "find: {" + "x" * 30_000 + ": stability}",
        "find: {a: {from: {from: {from: b}}}}",
        "? {a: 1}\n: 1",
        "system: {A: [" + ", ".join(["[" + ", ".join(["1"] * 200) + "]"] * 90) + "]}\nfind: {a: stability}",
        "parameters: {" + ", ".join(f"p{i}: {i}" for i in range(5000)) + "}\nsystem: {A: 1}\nfind: {a: stability}",
        "find:\n" + "".join(f"  p{i}: nothing\n" for i in range(60)),
    ],
)
def test_hostile_files_are_refused(text, catalogue):
    assert outcome(text, catalogue) == "refused"


@pytest.mark.parametrize("content", [b"", b"\xff\xfe\x00", b"\x7fELF\x02\x01\x01\x00", b"\xef\xbb\xbf", b"find: \xc3"])
def test_hostile_bytes_are_refused(content, tmp_path: Path, catalogue):
    path = tmp_path / "file.yaml"
    path.write_bytes(content)
    with pytest.raises(InputError):
        read_problem(load(path), catalogue)


@given(st.text(max_size=200))
def test_any_text_gives_a_problem_or_an_error_with_its_place(catalogue, text):
    assert outcome(text, catalogue) in {"read", "refused"}


WORDS = [
    "system",
    "find",
    "A",
    "B",
    "C",
    "D",
    "a",
    "task",
    "method",
    "poles",
    "gain",
    "from",
    "stability",
    "options",
    "time",
    "discrete",
    "null",
    "true",
    "transfer_function",
    "numerator",
    "denominator",
    "zeros",
    "matrix",
    "parameters",
    "assume",
    "display",
    "answer",
    "states",
    "sqrt(",
    "^",
    "inf",
    "0",
    "1",
    "s",
    "t",
    "1/s",
    ":",
    "[",
    "]",
    "{",
    "}",
    "'",
    '"',
    "*",
    "&",
    "!",
    "?",
]
PIECES = st.sampled_from([*WORDS, ": ", ", ", "\n", "  ", "- ", "-3 ± 2j", "|\n", "# ", "\t"])


@given(st.lists(PIECES, max_size=60).map("".join))
def test_any_text_of_the_words_of_the_format_gives_a_problem_or_an_error(catalogue, text):
    assert outcome(text, catalogue) in {"read", "refused"}


@st.composite
def mutations(draw):
    """A valid file with a few characters changed, cut out or doubled, or lines dropped, doubled or swapped."""
    text = draw(st.sampled_from(VALID))
    for _ in range(draw(st.integers(1, 4))):
        kind = draw(st.sampled_from(["replace", "cut", "double", "insert", "drop line", "double line", "swap lines"]))
        if "line" in kind:
            text = _of_lines(draw, kind, text)
            continue
        at = draw(st.integers(0, len(text)))
        end = min(len(text), at + draw(st.integers(0, 12)))
        new = {"cut": "", "double": text[at:end] * 2, "insert": draw(PIECES) + text[at:end]}
        text = text[:at] + new.get(kind, draw(st.text(max_size=3))) + text[end:]
    return text


def _of_lines(draw, kind, text):
    lines = text.split("\n")
    i, j = (draw(st.integers(0, len(lines) - 1)) for _ in range(2))
    if kind == "drop line":
        del lines[i]
    elif kind == "double line":
        lines.insert(j, lines[i])
    else:
        lines[i], lines[j] = lines[j], lines[i]
    return "\n".join(lines)


@tried(300)
@given(mutations())
@example(VALID[0].replace("[1, 0]", "[1, 0, 0]"))
def test_any_mutation_of_a_valid_file_gives_a_problem_or_an_error(catalogue, text):
    assert outcome(text, catalogue) in {"read", "refused"}


@given(st.sampled_from(VALID), st.integers(0, 10**6), st.integers(0, 255))
def test_any_changed_byte_gives_a_problem_or_an_error(catalogue, tmp_path_factory, text, at, byte):
    content = bytearray(text.encode())
    content[at % len(content)] = byte
    path = tmp_path_factory.getbasetemp() / "changed.yaml"
    path.write_bytes(bytes(content))
    with contextlib.suppress(InputError):
        assert read_problem(load(path), catalogue).parts


@given(st.text(max_size=40))
def test_any_entry_of_a_matrix_gives_a_problem_or_an_error(catalogue, entry):
    quoted = entry.replace("'", "''")
    outcome(MATRIX.format(f"'{quoted}'"), catalogue)


TRANSFER = st.text("s12+-*/^() .ajeπ", max_size=24)


@given(TRANSFER)
def test_any_transfer_function_gives_a_problem_or_an_error(catalogue, text):
    outcome(f"system: {{transfer_function: '{text}'}}\nfind: {{a: realization}}\n", catalogue)


@given(st.lists(st.text("j12+-*/^() .a±", max_size=12), max_size=5))
def test_any_list_of_poles_gives_a_problem_or_an_error(catalogue, poles):
    listed = ", ".join(f"'{pole}'" for pole in poles)
    outcome(f"system: {{A: 1, B: 1}}\nfind: {{a: {{task: placement, poles: [{listed}]}}}}\n", catalogue)
