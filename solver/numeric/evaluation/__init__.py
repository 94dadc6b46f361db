"""Values of formulas at points, with what is known of their rounding; claims decided by them."""
