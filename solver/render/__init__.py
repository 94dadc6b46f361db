"""Printing of mathematics and the pages it stands on; does no mathematics."""
