"""Small semantic slips made in the program one at a time, to see whether its tests see them."""
