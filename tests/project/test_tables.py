"""The lists of tasks in the documentation are those of the declarations."""

from pathlib import Path

from solver.tasks import catalogue
from tools.tables import GUIDE, PAGE, guide, main, page

PROJECT = Path(__file__).parents[2]


def test_the_tables_are_up_to_date():
    assert main(["--check"]) == 0


def test_every_method_option_and_answer_is_on_the_page():
    text = page(catalogue())
    for task in catalogue().values():
        about = text.partition(f"### `{task.name}`\n")[2].partition("\n### ")[0]
        names = {*task.options, *task.answers, *(set(task.methods) - {task.name})}
        assert all(f"`{name}`" in about for name in names), task.name
    assert PAGE.read_text(encoding="utf-8") == text


def test_what_stands_around_the_list_is_kept():
    text = GUIDE.read_text(encoding="utf-8")
    assert guide(text, catalogue()) == text
    assert guide(text.replace("`stability`", "`stabilty`"), catalogue()) == text.replace("`stabilty`", "`stability`")
