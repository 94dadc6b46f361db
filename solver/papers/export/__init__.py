"""Exports: an exam as a bank of questions that a learning system imports."""
