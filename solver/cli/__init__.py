"""The command line: `solve`. Imports nothing heavy until a command needs it."""

from solver.cli.app import main

__all__ = ["main"]
