"""The tests of the project, by room; what they share stands in `tests.helpers`."""
