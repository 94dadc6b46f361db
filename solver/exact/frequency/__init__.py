"""Values on the imaginary axis: corners, crossovers, margins, encirclements."""
