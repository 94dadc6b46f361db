"""The guides of a first hour, followed word for word: `python -m tools.guides` prints what their commands say now.

In a guide a file is written where its name stands above a block ("`exam.yaml`:", then ```yaml), and the lines of a
```console block that begin with `$` are run, below which stands what they print; `...` stands for any lines. Commands
are `solve`, `cat` and `rm`. With `--pictures` the pictures are taken anew, each as the comment above it says.
"""

from __future__ import annotations

import argparse
import io
import os
import re
import shlex
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[1]
GUIDES = tuple(ROOT / "docs" / name for name in ("instructors-guide.md", "students-guide.md"))
BLOCK = re.compile(
    r"^(?:[^\n]*`(?P<file>[\w./-]+)`[^\n`]*:\n\n)?```(?P<kind>\w+)\n(?P<text>.*?)^```$"
    r"|^<!-- picture: (?P<page>\S+) (?P<width>\d+)x(?P<height>\d+)(?: from (?P<top>\d+))? -->\n"
    r"!\[[^\]]*\]\((?P<picture>[^)]+)\)$",
    re.MULTILINE | re.DOTALL,
)
ENVIRONMENT: Mapping[str, str] = {"NO_COLOR": "1", "PYTHONPATH": str(ROOT), "COLUMNS": "100"}
COLOURS = 48
"""How many colours a picture keeps: a page has few, and a small file is read by more."""


@dataclass(frozen=True)
class Written:
    """A file that the reader writes."""

    name: str
    text: str


@dataclass(frozen=True)
class Typed:
    """A command, and what the guide says that it prints."""

    command: str
    printed: str


@dataclass(frozen=True)
class Picture:
    """A part of a page, from a height on, as a file beside the guide."""

    page: str
    file: str
    width: int
    height: int
    top: int


def steps(text: str) -> Iterator[Written | Typed | Picture]:
    """What a guide lets its reader do, in order."""
    for found in BLOCK.finditer(text):
        if found["picture"]:
            sizes = (int(found[name] or 0) for name in ("width", "height", "top"))
            yield Picture(found["page"], found["picture"], *sizes)
        elif found["kind"] == "console":
            yield from _typed(found["text"])
        elif found["file"]:
            yield Written(found["file"], found["text"])


def _typed(block: str) -> Iterator[Typed]:
    for each in re.split(r"^\$ ", block, flags=re.MULTILINE)[1:]:
        command, _, printed = each.partition("\n")
        yield Typed(command, printed)


def run(command: str, folder: Path) -> str:
    """What a command prints in a folder, on both channels; raises ValueError for one that no guide may use."""
    program, *words = shlex.split(command)
    if program == "cat":
        return "".join((folder / name).read_text(encoding="utf-8") for name in words)
    if program == "rm":
        for name in words:
            (folder / name).unlink()
        return ""
    if program != "solve":
        raise ValueError(f"a guide does not use {program}")
    environment = {**os.environ, **ENVIRONMENT}
    done = subprocess.run(
        [sys.executable, "-m", "solver", *words],
        cwd=folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False, timeout=300,
    )  # fmt: skip
    return done.stdout.decode()


def write(step: Written, folder: Path) -> None:
    """Write a file as the reader does."""
    path = folder / step.name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(step.text, encoding="utf-8")


def fits(expected: str, printed: str) -> bool:
    """Whether a command prints what the guide says; a line `...` stands for any lines."""
    pattern = "".join(r"(?:.*\n)*?" if line == "..." else f"{re.escape(line)}\n" for line in expected.splitlines())
    return re.fullmatch(pattern, "".join(f"{line.rstrip()}\n" for line in printed.strip("\n").splitlines())) is not None


def follow(guide: Path, folder: Path) -> Iterator[tuple[Typed, str]]:
    """Follow a guide in an empty folder: each command, and what it prints."""
    for step in steps(guide.read_text(encoding="utf-8")):
        if isinstance(step, Written):
            write(step, folder)
        elif isinstance(step, Typed):
            yield step, run(step.command, folder)


def take_pictures(guide: Path) -> None:
    """Follow a guide, and take its pictures where they stand, as the page is then."""
    from playwright.sync_api import sync_playwright  # noqa: PLC0415 - only pictures need a browser

    with tempfile.TemporaryDirectory() as name, sync_playwright() as playwright:
        folder = Path(name)
        browser = playwright.chromium.launch(executable_path=os.environ.get("CHROMIUM"), args=["--no-sandbox"])
        for step in steps(guide.read_text(encoding="utf-8")):
            if isinstance(step, Written):
                write(step, folder)
            elif isinstance(step, Typed):
                run(step.command, folder)
            else:
                page = browser.new_page(viewport={"width": step.width, "height": 800})
                page.goto((folder / step.page).as_uri())
                clip = {"x": 0, "y": step.top, "width": step.width, "height": step.height}
                _keep(page.screenshot(clip=clip, full_page=True), guide.parent / step.file)
        browser.close()


def _keep(picture: bytes, file: Path) -> None:
    """Write a picture with few colours."""
    from PIL import Image  # noqa: PLC0415 - nor this

    with Image.open(io.BytesIO(picture)) as image:
        image.convert("RGB").quantize(COLOURS).save(file, optimize=True)


def main() -> int:
    """Print what the commands of the guides print now, `!` before those that a guide tells otherwise."""
    parser = argparse.ArgumentParser(prog="python -m tools.guides", description=__doc__.splitlines()[0])
    parser.add_argument("--pictures", action="store_true", help="take the pictures anew")
    parser.add_argument("guides", nargs="*", type=Path, default=GUIDES)
    chosen = parser.parse_args()
    kept = True
    for guide in chosen.guides:
        if chosen.pictures:
            take_pictures(guide)
            continue
        with tempfile.TemporaryDirectory() as name:
            for step, printed in follow(guide, Path(name)):
                right = fits(step.printed, printed)
                kept = kept and right
                print(f"{' ' if right else '!'} $ {step.command}\n{printed}", flush=True)
    return 0 if kept else 1


if __name__ == "__main__":
    sys.exit(main())
