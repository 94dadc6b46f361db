"""Sampled plants and what is designed in the z-plane."""
