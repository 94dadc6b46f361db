"""Questions about stability."""
