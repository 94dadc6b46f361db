"""A declaration that the catalogue cannot read is told with its place and what to write."""

import pytest

from solver.derivation import Topic
from solver.tasks import Catalogue, DeclarationError
from solver.tasks.declarations import declared_by, topics

TOPIC = 'TOPIC = Topic(group="Design", order=60, title="State feedback")\n'
HEAD = '"""A task."""\n\nfrom solver.derivation import Task\n\n'


@pytest.fixture
def declared(tmp_path):
    """Return what a text declares as the file of the task `root_locus`."""

    def of(text, file="root_locus"):
        path = tmp_path / f"{file}.py"
        path.write_text(HEAD + text, encoding="utf-8")
        return declared_by(path, Topic("Design", 60, "State feedback"), "solver.tasks.classical")

    return of


def test_the_order_of_the_words_is_free(declared):
    text = 'root_locus: Task[Any, Any] = Task(\n    doc="x", title="Root locus", needs=(), name="root_locus"\n)\n'
    found = declared(
        text + '\n\n@root_locus.method(title="By hand", name="by_hand")\ndef draw(given):\n    """Draw."""\n'
    )
    assert (found.title, found.methods, found.module) == (
        "Root locus", ("by_hand",), "solver.tasks.classical.root_locus"
    )  # fmt: skip


def test_a_method_without_a_name_has_the_task_s(declared):
    found = declared(
        'root_locus = Task("root_locus", title="Root locus")\n\n\n@root_locus.method()\ndef draw(given): ...\n'
    )
    assert found.methods == ("root_locus",)


@pytest.mark.parametrize(
    ("written", "name"), [('title="By hand"', "root_locus"), ('name="by_hand"', "by_hand"), ('"by_hand"', "by_hand")]
)
def test_a_method_is_named_first_or_by_the_word(declared, written, name):
    text = f'root_locus = Task("root_locus", title="x")\n\n\n@root_locus.method({written})\ndef draw(given): ...\n'
    assert declared(text).methods == (name,)


def test_a_file_without_a_declaration_declares_nothing(declared):
    assert declared('"""It speaks of Task(...) only."""\n') is None


UNREADABLE = {
    'root_locus = Task("root_locus", doc="x")': (5, 'title="Root locus"'),
    'root_locus = Task("root_locus", title=TITLE)': (5, 'title="Root locus"'),
    "root_locus = Task(NAME, title='x')": (5, "its name comes first"),
    'locus = Task("root_locus", title="x")': (5, "root_locus: Task"),
    'loci = Task("loci", title="x")': (5, "loci.py"),
    'def make():\n    return Task("root_locus", title="x")': (6, "at the left margin"),
    'root_locus = Task("root_locus", title="x")\nother = Task("other", title="x")': (6, "one file declares one task"),
    'root_locus = Task("root_locus", title="x")\n@root_locus.method(HOW)\ndef draw(given): ...': (6, '("by_hand", …)'),
    'root_locus = Task("root_locus", title="x")\n@root_locus.method\ndef draw(given): ...': (6, "with brackets"),
    'root_locus = Task("root_locus", title=': (5, "no Python"),
}


@pytest.mark.parametrize("text", UNREADABLE)
def test_what_cannot_be_read_is_told_with_its_place(declared, text):
    line, says = UNREADABLE[text]
    with pytest.raises(DeclarationError) as caught:
        declared(text)
    assert f"root_locus.py:{line}: " in str(caught.value)
    assert says in str(caught.value)


@pytest.mark.parametrize(
    "text", ["", "TOPIC = NAME", 'TOPIC = Topic(group="Design")', 'TOPIC = Topic(group=G, order=1, title="x")']
)
def test_a_topic_that_cannot_be_read_is_told_with_its_place(tmp_path, text):
    folder = tmp_path / "classical"
    folder.mkdir()
    (folder / "__init__.py").write_text(text, encoding="utf-8")
    with pytest.raises(DeclarationError, match=r"__init__.py:1: a topic declares itself: TOPIC = Topic\(group="):
        topics(tmp_path)


def test_topics_of_a_group_stand_together_in_their_order(tmp_path):
    for name, group, order in (("a", "Design", 30), ("b", "Analysis", 10), ("c", "Design", 5), ("d", "Analysis", 20)):
        (tmp_path / name).mkdir()
        declared = f'TOPIC = Topic(group="{group}", order={order}, title="{name}")\n'
        (tmp_path / name / "__init__.py").write_text(declared, encoding="utf-8")
    assert [topic.title for topic in topics(tmp_path).values()] == ["c", "a", "b", "d"]


def test_a_task_declared_twice_is_told(tmp_path):
    for name in ("a", "b"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "__init__.py").write_text(TOPIC, encoding="utf-8")
        (tmp_path / name / "same.py").write_text('same = Task("same", title="x")\n', encoding="utf-8")
    with pytest.raises(DeclarationError, match=r"declared twice, in topics.a.same and topics.b.same"):
        Catalogue(tmp_path, "topics").declarations()
