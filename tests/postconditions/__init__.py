"""What must hold of the results of kernels."""
