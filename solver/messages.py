r"""Words of a language: phrases, reasons, and the environment in which all macros of `templates/wording/` are found.

English is the language of the templates. Another one, `de`, is a folder `templates/wording/de/` with the files that
differ: the same files of macros, each of which comes before the English one of its name, and `phrases.yaml`, in any
folder of it, the translation of what stands in the program as a short English text: titles, labels of claims, meanings
of answers, words of verdicts, headings. What a language does not have is said in English.

Reasons are worded by `reasons/<file>.md.jinja`. A macro is called with the reason's values `v` and writes one line of
Markdown, however it is broken in the file. Pages print values in the display that their problem asks for; a message is
read outside of a page too, so it has a spelling of its own: `value|formula`. Other filters: `reason|said` words a
reason within a reason, `text|say` a phrase, `name|named` the name of a quantity.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined, TemplateNotFound
from jinja2.sandbox import ImmutableSandboxedEnvironment

from solver.compiled import kept
from solver.notation import SYMBOL, spelled
from solver.symbols import COURSE
from solver.words import ENGLISH, PHRASES, Phrase, Reason, folders, formula

_TAG = re.compile(r"\{%.*?%\}")


class _Lines(FileSystemLoader):
    """Finds templates; a line of text stays a line where a tag ends it.

    Jinja drops the newline after every tag, which would glue such a line to the next: "…, not the control.Only …".
    """

    def get_source(self, environment: Environment, template: str) -> tuple[str, str, Callable[[], bool]]:
        """Return the text of a template, its file, and whether it is unchanged."""
        text, file, unchanged = super().get_source(environment, template)
        return "\n".join(map(_kept, text.split("\n"))), file, unchanged


def _kept(line: str) -> str:
    """Return a line with its newline kept, if it has text and ends in a tag that says nothing about blanks."""
    if not line.endswith("%}") or line.endswith(("-%}", "+%}")) or not _TAG.sub("", line).strip():
        return line
    return f"{line[:-2]}+%}}"


def environment(templates: Path | None) -> ImmutableSandboxedEnvironment:
    """Return an environment that finds the files of macros."""
    return ImmutableSandboxedEnvironment(
        loader=_Lines(folders(templates)),
        bytecode_cache=kept(templates),
        undefined=StrictUndefined,
        auto_reload=False,  # templates do not change while a program runs
        autoescape=False,  # this is Markdown; HTML is escaped where it is made, in `render.prose`
        trim_blocks=True,
        lstrip_blocks=True,
    )


@dataclass(frozen=True, slots=True)
class Messages:
    """How reasons and phrases are worded; a folder of templates, if there is one, comes before the installed ones."""

    templates: Path | None = None
    language: str = ENGLISH
    notation: str = COURSE

    def files(self, wording: str) -> list[str]:
        """Return the files that may hold a macro, the one of the language first."""
        english = f"{wording}.md.jinja"
        return [english] if self.language == ENGLISH else [f"{self.language}/{english}", english]

    def reason(self, reason: Reason) -> str:
        """Return a reason in words (Markdown with `$math$`), one line."""
        wording, _, name = reason.kind.partition("/")
        for file in self.files(f"reasons/{wording}"):
            try:
                macro = getattr(_environment(self).get_template(file).module, name, None)
            except TemplateNotFound:
                continue
            if macro is not None:
                return " ".join(str(macro(reason.values)).split())
        raise LookupError(f"the macro {name!r} of templates/wording/reasons/{wording}.md.jinja is missing")

    def told(self, what: Reason | str) -> str:
        """Return a reason or a phrase in words."""
        return self.reason(what) if isinstance(what, Reason) else self.say(what)

    def say(self, text: str) -> str:
        r"""Return a phrase in the language and with the symbols of the notation, which it names as `\sym{K}`.

        A text that is no phrase is returned as it stands.
        """
        if isinstance(text, Phrase):
            values = {name: self.say(value) if isinstance(value, str) else value for name, value in text.values.items()}
            return self._spelled(self._translated(text.pattern).format(**values))
        return self._spelled(self._translated(text))

    def _translated(self, text: str) -> str:
        return text if self.language == ENGLISH else _phrases(self).get(text, text)

    def _spelled(self, text: str) -> str:
        return spelled(text, self.notation) if SYMBOL in text else text

    def named(self, name: str) -> str:
        """Return the name of a quantity or option as it is spoken: `peak_time` is the peak time."""
        return self.say(name.replace("_", " "))


@lru_cache(maxsize=8)
def _environment(messages: Messages) -> ImmutableSandboxedEnvironment:
    """Return the environment that finds the macros of reasons."""
    found = environment(messages.templates)
    found.filters.update(formula=formula, said=messages.reason, say=messages.say, named=messages.named)
    return found


@lru_cache(maxsize=8)
def _phrases(messages: Messages) -> Mapping[str, str]:
    """Return the phrases of a language, all files together; the user's folder wins."""
    from yaml import safe_load  # noqa: PLC0415 - English needs no phrases

    found: dict[str, Any] = {}
    for folder in reversed(folders(messages.templates)):
        for file in sorted((folder / messages.language).rglob(PHRASES)):
            found |= safe_load(file.read_text(encoding="utf-8")) or {}
    return {key: str(value) for key, value in found.items()}
