"""Verdicts of what was submitted, by the verification of its task."""
