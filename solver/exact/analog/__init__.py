"""Machine equations, their scaling, and the programs that compute them."""
