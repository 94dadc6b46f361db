"""Exams: questions from problem files, a paper and a key for each variant or student, the marks of a class."""
