"""Typst as a program of its own: `solution.typ` of this folder becomes `solution.pdf`, tagged, undated."""

from __future__ import annotations

import sys

MEMORY = 4 * 2**30
"""Bytes of address space; a document of a hundred pages takes a tenth of it."""


def main() -> int:
    """Compile; what is wrong is printed. Fonts are typst's own, files those of this folder; there are no packages."""
    import typst  # noqa: PLC0415 - an extra, which this program alone needs

    try:
        import resource  # noqa: PLC0415 - not on every system
    except ImportError:
        pass
    else:
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    try:
        typst.compile(
            "solution.typ",
            output="solution.pdf",
            root=".",
            ignore_system_fonts=True,
            package_path="packages",
            package_cache_path="packages",
            pdf_standards=["ua-1"],
            timestamp=0,
        )
    except RuntimeError as error:
        print(error)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
