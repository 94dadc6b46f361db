"""What inputs reach and outputs show: controllability, ranks and their parameters, decompositions, Gramians."""
