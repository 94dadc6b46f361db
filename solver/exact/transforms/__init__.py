"""Transforms by rules, their inverses, and what solves linear differential equations."""
