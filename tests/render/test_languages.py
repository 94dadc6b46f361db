"""A page in another language: nothing of it stays English, and nothing but its words changes."""

import ast
import html
import json
import re
from collections import Counter
from dataclasses import replace
from functools import cache

import pytest
import yaml

import solver
from solver.derivation import Status
from solver.document.model import Presentation
from solver.document.works import document_of
from solver.engine import solve_problem
from solver.messages import Messages
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.resources import root
from solver.tasks import catalogue
from solver.words import Phrase, languages

PLANT = {"A": [[1, 0, -1], [1, 2, 1], [2, 2, 3]], "B": [1, 0, 1]}
HIDDEN = {"A": [[1, 0], [0, -2]], "B": [0, 1]}
SAMPLED = {**HIDDEN, "time": "discrete"}
METHODS = ["coefficient_matching", "bass_gura", "canonical_form", "ackermann"]
PAGES = {
    "polynomial": {
        "system": {"matrix": [[1, 2, 0], [3, 1, 1], [0, 2, 5]]},
        "find": {
            "a": {"task": "characteristic_polynomial", "method": ["determinant", "faddeev_leverrier"], "marks": 2}
        },
    },
    "four": {
        "system": {"matrix": [[0, 1, 0, 0], [-2, 0, 1, 0], [0, 0, 0, 1], [1, 0, -2, 0]]},
        "find": {"a": {"task": "characteristic_polynomial", "method": "determinant"}},
    },
    "triangular": {"system": {"A": [[1, 2], [0, 3]]}, "find": {"a": "characteristic_polynomial"}},
    "one": {"system": {"A": [[4]]}, "find": {"a": {"task": "characteristic_polynomial", "marks": 1}}},
    "methods": {
        "system": PLANT,
        "find": {"a": {"task": "pole_placement", "method": METHODS, "poles": [-1, "-1 ± 2j"]}},
    },
    "two_states": {
        "system": {"A": [[1, 2], [3, 4]], "B": [1, 1]},
        "find": {"a": {"task": "pole_placement", "method": METHODS[1:], "poles": [-1, -2]}},
    },
    "specified": {
        "system": {"A": [[0, -1], [-3, -2]], "B": [0, 1]},
        "find": {
            letter: {"task": "pole_placement", **given}
            for letter, given in {
                "a": {"overshoot": "14%", "rise_time": "1.25"},
                "b": {"settling_time": 2, "peak_time": 1, "overshoot": "13.5%"},
                "c": {"damping_ratio": "1/2", "natural_frequency": 2},
                "d": {"natural_frequency": 3, "rise_time": 1},
                "e": {"settling_time": 2, "rise_time": 1, "settling_band": "5%"},
                "f": {"peak_time": 1, "rise_time": "0.7"},
                "g": {"damping_ratio": 2, "natural_frequency": 1},
                "h": {"natural_frequency": 2, "peak_time": 2},
                "i": {"natural_frequency": 2, "settling_time": 3},
            }.items()
        },
    },
    "hidden": {
        "system": HIDDEN,
        "find": {
            "a": {"task": "pole_placement", "method": METHODS, "poles": [1, -3]},
            "b": {"task": "pole_placement", "method": METHODS, "poles": [-3]},
            "c": {"task": "pole_placement", "poles": [-3, -4]},
        },
    },
    "inputs": {
        "system": {"A": [[0, 1, 0], [0, 0, 1], [1, 2, 3]], "B": [[0, 1], [0, 0], [1, 0]]},
        "find": {"a": {"task": "pole_placement", "method": [*METHODS, "unity_rank"], "poles": [-1, -2, -3]}},
    },
    "eigenvectors": {
        "system": {"A": [[0, 1, 0], [0, 0, 1], [6, -11, 6]], "B": [[1, 0], [0, 1], [1, 1]]},
        "find": {
            letter: {"task": "pole_placement", **given}
            for letter, given in {
                "a": {"poles": [-1, "-2 ± j"], "eigenvectors": [[13, 1, 1], [5, "j", "-j"], [0, 0, 0]]},
                "b": {"poles": [-1, -2, -2], "eigenvectors": [[13, 1, 0], [5, 0, 1], [0, 0, 0]]},
                "c": {"poles": [-1, -1, -1], "eigenvectors": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]},
                "d": {"poles": [-1, -2, -3], "eigenvectors": [[5, 0, 0], [-13, 1, 0], [6, 0, 1]]},
                "e": {"poles": ["p", "q", 1], "eigenvectors": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]},
            }.items()
        },
    },
    "uncontrollable": {
        "system": {"A": [[1, 0, 0], [1, -1, 0], [0, 0, -2]], "B": [[1, 0], [0, 1], [0, 0]]},
        "find": {
            "a": {
                "task": "pole_placement",
                "poles": [-2, -3, -4],
                "eigenvectors": [[1, 0, 0], [0, 1, 0], [1, 0, 1]],
            },
            "b": {
                "task": "pole_placement",
                "poles": [-5, -3, -4],
                "eigenvectors": [[1, 0, 0], [0, 1, 0], [1, 0, 1]],
            },
        },
    },
    "cyclic": {
        "system": {"A": [[1, 0], [0, 1]], "B": [[1, 0], [0, 1]]},
        "find": {"a": {"task": "pole_placement", "poles": [-1, -2]}},
    },
    "structure": {
        "system": {"A": [[0, 1], [-2, -3]], "B": [0, 1]},
        "find": {
            "a": {"task": "pole_placement", "poles": [-1, -3], "structure": ["p", 1]},
            "b": {"task": "pole_placement", "poles": [-1, -3], "structure": ["p", 0]},
        },
    },
    "parameters": {
        "system": {"A": [[0, 1], ["a", 1]], "B": [0, 1]},
        "find": {"a": {"task": "pole_placement", "poles": ["p_1", "p_2"]}, "b": "characteristic_polynomial"},
    },
    "discrete": {
        "system": {"A": [[0, 1], [-2, -3]], "B": [0, 1], "time": "discrete"},
        "find": {"a": {"task": "pole_placement", "poles": ["1/2", "1/3"]}},
    },
    "sampled": {
        "system": {
            "A": [[1, "1/10"], [0, 1]],
            "B": ["1/200", "1/10"],
            "time": "discrete",
            "sample_time": "1/10",
        },
        "find": {
            letter: {"task": "pole_placement", **given}
            for letter, given in {
                "a": {"s_poles": ["-4 ± 3j"]},
                "b": {"s_poles": [-6, -7]},
                "c": {"s_poles": ["-1 ± 40j"]},
                "d": {"overshoot": "10%", "settling_time": 2},
            }.items()
        },
    },
    "realized": {
        "system": {"transfer_function": "(s + 2)/(s^2 + s + 1)"},
        "find": {
            "a": {"task": "pole_placement", "poles": [-2, -3]},
            "b": {"task": "characteristic_polynomial", "gain": {"from": "a"}},
        },
    },
    "nothing": {
        "system": {"A": [[1, 0], [0, -2]], "B": [0, 0]},
        "find": {"a": {"task": "pole_placement", "poles": [-3, -4]}},
    },
}
NAMES = set(
    "ackermann bass gura cayley hamilton leverrier kailath linear systems gantmacher numpy linalg det scipy mpmath "
    "expm lstsq eig inv svd solve html pdf problem yaml tan cos sin arccos band basis die matrix minus pole polynom "
    "system transformation von was moore ieee trans automatic control dimension norm real pivot inverse".split()
)
"""Words of both languages, and names: a title of a book, functions, authors."""


@cache
def solved(name):
    text = json.dumps({"title": "T", **PAGES[name]}, ensure_ascii=False)
    return solve_problem(read_problem(Source("q.yaml", text), catalogue()))


@cache
def told(name):
    """The document in English and in German, at the level with most words."""
    document = document_of(solved(name), Presentation("tutor"))
    return document, document.told(language="de")


EVERY_PAGE = [
    pytest.param(name, marks=[pytest.mark.xdist_group(f"german {name}"), *([pytest.mark.slow] if place % 3 else [])])
    for place, name in enumerate(PAGES)
]


def words_of(page):
    """The words that a reader sees, or hears: text, alternative texts, labels; formulas left out."""
    visible = re.sub(r"(?s)<(style|math|code)\b.*?</\1>", " ", page)
    heard = re.findall(r'(?:alt|aria-label|title)="([^"]*)"', visible)
    text = html.unescape(re.sub(r"<[^>]*>", " ", visible) + " " + " ".join(heard))
    return {word.lower() for word in re.findall(r"[^\W\d_]{3,}", text)}


@pytest.mark.parametrize("name", EVERY_PAGE)
def test_no_english_word_remains_on_a_german_page(name):
    document, german = told(name)
    english = words_of(document.html())
    assert english & words_of(german.html()) <= NAMES
    assert '<html lang="de">' in german.html()
    plain = {word.lower() for word in re.findall(r"[^\W\d_]{4,}", re.sub(r"\$[^$]*\$", " ", german.markdown()))}
    assert english & plain <= NAMES | {"left", "right", "operatorname", "begin", "end", "frac", "bmatrix", "aligned"}


def displayed(step):
    """The formulas that a step displays, words in them left out."""
    return [re.sub(r"\\text\{.*?\}", "", each) for each in re.findall(r"(?s)\$\$.*?\$\$", step.markdown)]


@pytest.mark.parametrize("name", EVERY_PAGE)
def test_the_formulas_of_a_german_page_are_those_of_the_english_one(name):
    document, german = told(name)
    for ours, theirs in zip(document.parts, german.parts, strict=True):
        assert [each.tex for each in ours.answers] == [each.tex for each in theirs.answers]
        assert [each.kind for each in ours.steps] == [each.kind for each in theirs.steps]
        assert [displayed(step) for step in ours.steps] == [displayed(step) for step in theirs.steps]
        assert ours.status == theirs.status
        checks = [[(check.residual, check.status) for check in part.checks] for part in (ours, theirs)]
        assert checks[0] == checks[1]


def test_the_pages_have_every_kind_of_step_that_german_words():
    steps = (step for name in PAGES for part in solved(name).parts for step in part.steps)
    kinds = {(each.wording, each.kind) for step in steps for each in step.walk()}
    worded = {
        (path.relative_to(root("templates") / "wording" / "de").as_posix().removesuffix(".md.jinja"), macro)
        for path in (root("templates") / "wording" / "de").rglob("*.md.jinja")
        for macro in re.findall(r"macro (\w+)\(v, c\)", path.read_text(encoding="utf-8"))
    }
    assert worded <= kinds


@pytest.mark.parametrize("language", languages()[1:])
def test_a_language_has_only_files_macros_and_phrases_that_english_has(language):
    folder = root("templates") / "wording"
    macros = re.compile(r"macro (\w+\([^)]*\))")
    for path in (folder / language).rglob("*.md.jinja"):
        english = folder / path.relative_to(folder / language)
        assert set(macros.findall(path.read_text(encoding="utf-8"))) <= set(
            macros.findall(english.read_text(encoding="utf-8"))
        ), path.name


def displays(path):
    """What each macro of a template displays and says names stand for, words in formulas left out."""
    for body in re.split(r"(?=\{% macro )", path.read_text(encoding="utf-8"))[1:]:
        shown = re.findall(r"\{\{-? *(?:eq|align|stands|row)\(.*?\) *-?\}\}", body, re.DOTALL)
        yield re.search(r"macro (\w+)", body)[1], Counter(re.sub(r"\\\\text\{.*?\}|\s+", "", each) for each in shown)


@pytest.mark.parametrize("language", languages()[1:])
def test_a_language_displays_what_english_displays(language):
    folder = root("templates") / "wording"
    told = 0
    for path in sorted((folder / language / "lemmas").rglob("*.md.jinja")):
        english = dict(displays(folder / path.relative_to(folder / language)))
        for macro, shown in displays(path):
            assert shown == english[macro], (path.name, macro)
            told += shown.total()
    assert told > 50


def strings_of_the_program():
    """Every string constant of the program, and every text of its templates."""
    for path in (root("templates").parent / "solver").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Constant) and isinstance(node.value, str):
                yield node.value
    for kind in ("html", "latex", "wording/reasons"):
        for path in (root("templates") / kind).glob("*.jinja"):
            text = path.read_text(encoding="utf-8")
            yield from re.findall(r'"([^"]*)"', text)
            yield from re.findall(r'phrase\("([^"]*)"', text)


@pytest.mark.parametrize("language", languages()[1:])
def test_every_phrase_stands_in_the_program(language):
    said = set(strings_of_the_program())
    spoken = {name.replace("_", " ") for name in said}
    for path in (root("templates") / "wording" / language).rglob("phrases.yaml"):
        phrases = yaml.safe_load(path.read_text(encoding="utf-8"))
        assert {phrase for phrase in phrases if phrase not in said and phrase not in spoken} == set(), path


@pytest.mark.parametrize("language", languages()[1:])
def test_a_phrase_is_translated_once(language):
    files = (root("templates") / "wording" / language).rglob("phrases.yaml")
    lines = [line for path in files for line in path.read_text(encoding="utf-8").splitlines()]
    keys = [next(iter(yaml.safe_load(line))) for line in lines if line and not line.startswith("#")]
    assert len(keys) == len(set(keys))


REFUSING = {"NotEvaluable", "Undefined", "ShapeMismatch", "NoRule", "Phrase", "_misfit", "Claim", "that", "within"}


def what_oracles_say():
    """What is said by the oracles' ground floor, the checks of kernels and the judges that both German tasks use."""
    solver = root("templates").parent / "solver"
    rooms = [solver / "numeric" / "evaluation", solver / "postconditions"]
    files = [path for room in rooms for path in room.rglob("*.py")]
    for path in [*files, solver / "numeric" / "judges" / "design" / "second_order.py"]:
        tree = ast.parse(path.read_text(encoding="utf-8"))
        patterns = {
            node.targets[0].id: node.value
            for node in ast.walk(tree)
            if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name)
        }
        for node in ast.walk(tree):
            if isinstance(node, ast.Call) and getattr(node.func, "id", getattr(node.func, "attr", "")) in REFUSING:
                told = [patterns.get(each.id, each) if isinstance(each, ast.Name) else each for each in node.args]
                texts = [each.value for each in told if isinstance(each, ast.Constant)]
                yield from (text for text in texts if isinstance(text, str) and "." not in text)


@pytest.mark.parametrize("language", languages()[1:])
def test_a_language_words_whatever_an_oracle_says(language):
    found: dict[str, str] = {}
    for path in (root("templates") / "wording" / language).rglob("phrases.yaml"):
        found |= yaml.safe_load(path.read_text(encoding="utf-8"))
    said = set(what_oracles_say())
    assert len(said) > 50
    assert said <= set(found)


def test_a_reason_is_told_in_the_language_and_in_english_where_it_has_no_words():
    part = document_of(solved("nothing")).told(language="de").parts[0]
    assert part.status is Status.UNSOLVED
    assert part.reason == "Der Eingang wirkt gar nicht auf den Zustand."
    system = PAGES["discrete"]["system"]
    problem = {"system": system, "language": "de", "find": {"a": {"task": "controllability", "method": "gramian"}}}
    unsolved = solver.solve(yaml.safe_dump(problem)).parts[0]
    assert unsolved.reason.startswith("The Gramian over an infinite time")


@pytest.mark.parametrize(
    ("plant", "options", "english", "german"),
    [
        (PLANT, {"poles": [-1]}, "the closed loop has 3 poles; give 3, not 1",
         "der geschlossene Kreis hat 3 Pole; geben Sie 3 an, nicht 1"),
        (HIDDEN, {"poles": [-1, -2, -3]}, "give 2 or 1 (all, or those that can be moved), not 3",
         "geben Sie 2 oder 1 an (alle oder die, die sich verschieben lassen), nicht 3"),
        (PLANT, {}, "say where the poles are to be", "geben Sie an, wo die Pole liegen sollen"),
        (HIDDEN, {"overshoot": "14%"}, "two specifications fix a pair of poles; only the overshoot is given",
         "zwei Vorgaben legen ein Polpaar fest; gegeben ist nur Überschwingweite"),
        (HIDDEN, {"poles": [-1, -2], "structure": ["p"]}, "the row K has 2 entries", "die Zeile K hat 2 Elemente"),
        (HIDDEN, {"poles": [-1, -2], "structure": [1, 0]}, "holds no symbol", "keinen gesuchten Buchstaben"),
        (HIDDEN, {"s_poles": [-1, -2]}, "the plant is in continuous time, where poles are in s already",
         "die Strecke ist zeitkontinuierlich, ihre Pole liegen also schon in der s-Ebene"),
        (SAMPLED, {"s_poles": [-1, -2], "poles": ["1/2", "1/3"]}, "the poles are given twice",
         "die Pole sind zweimal angegeben"),
        (SAMPLED, {"s_poles": [-1, -2]}, "the sampling period is not given: write sample_time: 0.1",
         "die Abtastzeit ist nicht angegeben: schreiben Sie 'sample_time: 0.1'"),
        (SAMPLED, {"overshoot": "14%", "rise_time": 1}, "the sampling period is not given",
         "die Abtastzeit ist nicht angegeben"),
        ({**SAMPLED, "sample_time": 1}, {"s_poles": [-1, -2], "sample_time": 2}, "leave one of them out",
         "die Abtastzeit hier ist $2$, die des Systems $1$"),
    ],
)  # fmt: skip
@pytest.mark.parametrize("limits", [{}, {"seconds": 60}])
def test_what_is_wrong_with_a_question_is_told_in_its_language(plant, options, english, german, limits):
    problem = {"system": plant, "find": {"a": {"task": "pole_placement", **options}}}
    for language, words in (("en", english), ("de", german)):
        with pytest.raises(InputError) as refused:
            solver.solve(yaml.safe_dump({**problem, "language": language}), **limits)
        assert words in str(refused.value)
    with pytest.raises(InputError, match=re.escape(german)):
        solver.solve(yaml.safe_dump(problem), language="de", **limits)


def test_a_file_says_its_language_and_notation():
    text = yaml.safe_dump({**PAGES["triangular"], "language": "de", "notation": "ogata"})
    display = read_problem(Source("q.yaml", text), catalogue()).display
    assert (display.language, display.notation) == ("de", "ogata")
    assert solver.solve(text).parts[0].title == "Charakteristisches Polynom"
    assert solver.solve(text, language="en").parts[0].title == "Characteristic polynomial"


@pytest.mark.parametrize(("key", "word", "suggested"), [("language", "dee", "de"), ("notation", "Ogatta", "ogata")])
def test_an_unknown_language_or_notation_is_refused_with_a_suggestion(key, word, suggested):
    with pytest.raises(InputError) as refused:
        read_problem(Source("q.yaml", json.dumps({**PAGES["triangular"], key: word})), catalogue())
    assert f"there is no {key} '{word}'" in str(refused.value)
    assert suggested in refused.value.render()


def test_a_phrase_is_english_text_with_a_pattern_that_a_language_words():
    phrase = Phrase("row {i}", i=3)
    assert phrase == "row 3"
    german = Messages(language="de")
    assert german.say(phrase) == "Zeile 3"
    assert german.say(Phrase("{claim} (step {step})", claim=phrase, step=1)) == "Zeile 3 (Schritt 1)"
    assert german.say("no phrase of ours") == "no phrase of ours"
    assert replace(german, notation="ogata").say(r"$A - \sym{L}C$") == "$A - K_eC$"
