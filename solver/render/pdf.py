"""LaTeX to PDF by a TeX that is installed: no shell, no files outside a scratch folder, a time limit, no dates."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
from collections.abc import Mapping
from pathlib import Path
from tempfile import TemporaryDirectory
from types import MappingProxyType

LIMIT = 60.0
"""Seconds for all runs of TeX together."""

RUNS = 3
"""Runs of pdflatex at most; a longtable needs two or three to know its columns."""


class PdfUnavailable(Exception):  # noqa: N818 - mostly not an error of ours: there is no TeX here
    """There is no PDF; the message says why and what to do."""


def pdf_of(latex: str, seconds: float = LIMIT, files: Mapping[str, bytes] = MappingProxyType({})) -> bytes:
    """Return the PDF of a document; `files` are what it includes, by name.

    Raises PdfUnavailable if there is no TeX, if it stops with an error, or if it takes longer than `seconds`.
    The same document gives the same bytes with the same TeX. (latexmk only runs pdflatex, so it is not needed.)
    """
    command = engine()
    with TemporaryDirectory(prefix="solve-tex-") as folder:
        scratch = Path(folder)
        (scratch / "solution.tex").write_text(latex, encoding="utf-8")
        for name, content in files.items():
            (scratch / name).write_bytes(content)
        before = ""
        for _ in range(RUNS if "pdflatex" in command[0] else 1):
            _run(command, scratch, seconds)
            auxiliary = _text(scratch / "solution.aux")
            if auxiliary == before:
                break
            before = auxiliary
        return (scratch / "solution.pdf").read_bytes()


def engine() -> list[str]:
    """Return the command of the TeX to use; raises PdfUnavailable if there is none."""
    if found := shutil.which("pdflatex"):
        return [found, "-no-shell-escape", "-halt-on-error", "-interaction=nonstopmode", "solution.tex"]
    if found := shutil.which("tectonic"):
        return [found, "--untrusted", "--keep-intermediates", "solution.tex"]
    raise PdfUnavailable(
        "there is no TeX on this machine (pdflatex or tectonic). Install one, for example the packages "
        "texlive-latex-recommended, texlive-pictures and lmodern, or write HTML (-f html) and print it from a browser"
    )


def _run(command: list[str], scratch: Path, seconds: float) -> None:
    process = subprocess.Popen(  # noqa: S603 - our own command; the document is in a file
        command,
        cwd=scratch,
        env=_environment(scratch),
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        start_new_session=True,  # so that it can be stopped with all it started
    )
    try:
        output, _ = process.communicate(timeout=seconds)
    except subprocess.TimeoutExpired as error:
        _stop(process)
        raise PdfUnavailable(f"TeX took longer than {seconds:g} s and was stopped") from error
    if process.returncode or not (scratch / "solution.pdf").is_file():
        raise PdfUnavailable(f"TeX stopped: {_complaint(output.decode('utf-8', 'replace'))}")


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
