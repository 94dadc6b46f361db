"""Compensators and PID controllers that meet specifications."""
