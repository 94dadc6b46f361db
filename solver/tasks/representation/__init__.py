"""Tasks about models and their forms: transfer functions, realizations, coordinates."""
