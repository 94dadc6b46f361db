r"""Reasons and messages in words: the macros of `templates/wording/reasons/<file>.md.jinja`.

A macro is called with the reason's values `v` and writes one line of Markdown, however it is broken in the file. Pages
print values in the display that their problem asks for; a message is read outside of a page too, so it has a spelling
of its own: `value|formula`, by sympy, with j for the imaginary unit and decimals of five digits. Other filters:
`reason|said` words a reason within a reason, `word|say` a phrase, `name|named` the name of a quantity.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from jinja2 import FileSystemLoader, StrictUndefined
from jinja2.sandbox import ImmutableSandboxedEnvironment

from solver import resources
from solver.words import Reason, formula


@dataclass(frozen=True, slots=True)
class Messages:
    """How reasons are worded; a folder of templates, if there is one, comes before the installed ones."""

    templates: Path | None = None

    def reason(self, reason: Reason) -> str:
        """Return a reason in words (Markdown with `$math$`), one line."""
        file, _, macro = reason.kind.partition("/")
        module = _environment(self).get_template(f"reasons/{file}.md.jinja").module
        return " ".join(str(getattr(module, macro)(reason.values)).split())

    def say(self, phrase: str) -> str:
        """Return a phrase in words."""
        return phrase

    def named(self, name: str) -> str:
        """Return the name of a quantity or option as it is spoken: `peak_time` is the peak time."""
        return self.say(name.replace("_", " "))


@lru_cache(maxsize=8)
def _environment(messages: Messages) -> ImmutableSandboxedEnvironment:
    """Return the environment that finds the macros of reasons."""
    own = [messages.templates / "wording", messages.templates] if messages.templates else []
    environment = ImmutableSandboxedEnvironment(
        loader=FileSystemLoader([*own, resources.root("templates") / "wording"]),
        undefined=StrictUndefined,
        auto_reload=False,  # templates do not change while a program runs
        autoescape=False,  # this is Markdown
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters.update(formula=formula, said=messages.reason, say=messages.say, named=messages.named)
    return environment
