"""Root loci: segments, asymptotes, breakaway points, crossings, angles."""
