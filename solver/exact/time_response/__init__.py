"""Inputs as signals and the responses to them, with their limits and peaks."""
