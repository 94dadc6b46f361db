"""A marking as data, as text, as a sheet to hand back, and as a table of marks."""
