"""Riccati equations by spectral factors, over towers of square roots."""
