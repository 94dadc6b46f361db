"""PDF by a TeX that is installed, or by typst: no shell, no files outside a scratch folder, a time limit, no dates."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Mapping
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory
from types import MappingProxyType

from solver.render import tex_text, typst_text

LIMIT = 60.0
"""Seconds for all runs together."""

RUNS = 3
"""Runs of pdflatex at most; a longtable needs two or three to know its columns."""


TEX, TYPST = ENGINES = ("tex", "typst")
"""What makes a PDF, by the names of the option `--pdf-engine`."""

_CLOSED = {
    **dict.fromkeys(("HTTPS_PROXY", "https_proxy", "ALL_PROXY", "all_proxy"), "http://127.0.0.1:9"),
    **dict.fromkeys(("NO_PROXY", "no_proxy"), ""),
}
"""What leaves typst no way to a network, from which it would fetch packages: nothing listens there."""

_BY_HAND = "Without one, write HTML (-f html) and print it from a browser"
PROGRAM = Path(__file__).with_name("typst_program.py")


class PdfUnavailable(Exception):  # noqa: N818 - mostly not an error of ours: there is no TeX here
    """There is no PDF; the message says why and what to do."""


def chosen(wanted: str | None = None) -> str:
    """Return the engine that is wanted, or else TeX where there is one, or else typst.

    Raises PdfUnavailable if it is not installed, or none is.
    """
    if wanted == TYPST and not _has_typst():
        raise PdfUnavailable(f"typst is not installed: pip install 'solve-control[pdf]' installs it. {_BY_HAND}")
    if wanted == TYPST or (not wanted and _has_typst() and not _tex()):
        return TYPST
    engine()
    return TEX


def shows(text: str, wanted: str | None = None) -> bool:
    """Whether the fonts of an engine have all letters of a text; a letter that they lack is named in its place."""
    return typst_text.shows(text) if chosen(wanted) == TYPST else tex_text.shows(text)


def _has_typst() -> bool:
    found = find_spec("typst")
    return found is not None and found.origin is not None  # a folder of this name is no package of ours


def pdf_by_typst(source: str, seconds: float = LIMIT, files: Mapping[str, bytes] = MappingProxyType({})) -> bytes:
    """Return the tagged PDF (PDF/UA-1) of a typst document; `files` are the images that it includes, by name.

    Raises PdfUnavailable if typst stops with an error, or takes longer than `seconds`. It runs in a process of its own,
    reads its scratch folder only and has neither packages nor a network. The same document gives the same bytes.
    """
    with TemporaryDirectory(prefix="solve-typst-") as folder:
        scratch = Path(folder)
        _write(scratch, {"solution.typ": source.encode(), **files})
        command = [sys.executable, "-P", str(PROGRAM)]  # without our folder, whose `numbers` is not Python's
        output = _run(command, scratch, seconds, {**os.environ, **_CLOSED}, "typst")
        if not (scratch / "solution.pdf").is_file():
            raise PdfUnavailable(f"typst stopped: {output.strip() or 'without a message'}")
        return (scratch / "solution.pdf").read_bytes()


def _write(scratch: Path, files: Mapping[str, bytes]) -> None:
    for name, content in files.items():
        (scratch / name).write_bytes(content)


def pdf_of(latex: str, seconds: float = LIMIT, files: Mapping[str, bytes] = MappingProxyType({})) -> bytes:
    """Return the PDF of a document; `files` are what it includes, by name.

    Raises PdfUnavailable if there is no TeX, if it stops with an error, or if it takes longer than `seconds`.
    The same document gives the same bytes with the same TeX. (latexmk only runs pdflatex, so it is not needed.)
    """
    command = engine()
    with TemporaryDirectory(prefix="solve-tex-") as folder:
        scratch = Path(folder)
        _write(scratch, {"solution.tex": latex.encode(), **files})
        before = ""
        for _ in range(RUNS if "pdflatex" in command[0] else 1):
            output = _run(command, scratch, seconds, _environment(scratch), "TeX")
            if not (scratch / "solution.pdf").is_file():
                raise PdfUnavailable(f"TeX stopped: {_complaint(output)}")
            auxiliary = _text(scratch / "solution.aux")
            if auxiliary == before:
                break
            before = auxiliary
        return (scratch / "solution.pdf").read_bytes()


def engine() -> list[str]:
    """Return the command of the TeX to use; raises PdfUnavailable if there is none."""
    if found := _tex():
        return found
    if _has_typst():
        raise PdfUnavailable(
            "there is no TeX on this machine (pdflatex or tectonic); there is typst: --pdf-engine typst"
        )
    raise PdfUnavailable(
        "there is neither TeX (pdflatex or tectonic) nor typst on this machine. The least to install is typst: "
        "pip install 'solve-control[pdf]'. TeX is, for example, the packages texlive-latex-recommended, "
        f"texlive-pictures and lmodern. {_BY_HAND}"
    )


def _tex() -> list[str]:
    if found := shutil.which("pdflatex"):
        return [found, "-no-shell-escape", "-halt-on-error", "-interaction=nonstopmode", "solution.tex"]
    if found := shutil.which("tectonic"):
        return [found, "--untrusted", "--keep-intermediates", "solution.tex"]
    return []


def _run(command: list[str], scratch: Path, seconds: float, environment: Mapping[str, str], name: str) -> str:
    """Run an engine to its end and return what it says; of one that fails there is no PDF in the folder."""
    process = subprocess.Popen(  # noqa: S603 - our own command; the document is in a file
        command,
        cwd=scratch,
        env=environment,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        start_new_session=True,  # so that it can be stopped with all it started
    )
    try:
        output, _ = process.communicate(timeout=seconds)
    except subprocess.TimeoutExpired as error:
        _stop(process)
        raise PdfUnavailable(f"{name} took longer than {seconds:g} s and was stopped") from error
    if process.returncode:
        (scratch / "solution.pdf").unlink(missing_ok=True)
    return output.decode("utf-8", "replace")


def _environment(scratch: Path) -> dict[str, str]:
    """TeX may read and write its own folder and its own installation only, and thinks it is 1970."""
    paranoid = {"openin_any": "p", "openout_any": "p", "TEXMFOUTPUT": str(scratch)}
    return {**os.environ, **paranoid, "SOURCE_DATE_EPOCH": "0", "FORCE_SOURCE_DATE": "1"}


def _stop(process: subprocess.Popen[bytes]) -> None:
    if hasattr(os, "killpg"):
        os.killpg(process.pid, signal.SIGKILL)
    else:
        process.kill()
    process.communicate()


def _complaint(log: str) -> str:
    lines = log.splitlines()
    first = next((i for i, line in enumerate(lines) if line.startswith("!")), None)
    if first is None:
        return lines[-1] if lines else "without a message"
    place = next((line for line in lines[first:] if line.startswith("l.")), "")
    return f"{lines[first].lstrip('! ')} {place}".strip()


def _text(path: Path) -> str:
    return path.read_text(encoding="utf-8", errors="replace") if path.is_file() else ""
