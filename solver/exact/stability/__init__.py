"""Where eigenvalues lie and which matrices are definite, also for ranges of parameters."""
