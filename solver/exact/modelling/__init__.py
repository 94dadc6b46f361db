"""Nonlinear functions of states and inputs: normal forms, derivatives, equations solved for the highest derivatives."""
