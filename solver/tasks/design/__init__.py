"""Design: feedback, observers, tracking."""
