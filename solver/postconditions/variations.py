"""What must hold of what the kernels of variations and finite horizons find."""
