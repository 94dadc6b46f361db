"""State space and transfer functions: from one to the other, canonical forms, coordinates."""
