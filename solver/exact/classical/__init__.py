"""Numbers of transfer functions and of their step responses: gains, time constants, reduced models."""
