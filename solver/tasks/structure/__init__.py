"""What the input reaches and what the output shows."""
