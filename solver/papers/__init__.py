"""Families of problems and the papers made of them."""
