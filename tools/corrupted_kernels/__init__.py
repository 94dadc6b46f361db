"""What becomes of a page where the result of a kernel is a little wrong: nothing wrong may stand under “verified”."""
