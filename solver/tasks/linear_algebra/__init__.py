"""Questions of linear algebra about the system matrix."""
