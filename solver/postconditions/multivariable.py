"""What must hold of what the kernels of several inputs and outputs find."""
