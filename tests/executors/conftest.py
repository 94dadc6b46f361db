"""The command line, run here."""

from tests.cli.conftest import solve

__all__ = ["solve"]
