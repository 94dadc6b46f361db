"""Questions about the motion of a system in time."""
