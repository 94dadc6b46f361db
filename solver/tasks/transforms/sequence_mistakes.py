"""Usual mistakes with z-transforms and difference equations, as the values that they lead to."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from solver.derivation import Task


def name_mistakes_of_sequences(task: Task[Any, Any]) -> None:
    """Register what goes wrong with the sequence f of an image F."""


def name_mistakes_of_z_images(task: Task[Any, Any]) -> None:
    """Register what goes wrong with the transform F of a sequence."""


def name_mistakes_of_differences(task: Task[Any, Any]) -> None:
    """Register what goes wrong with difference equations."""
