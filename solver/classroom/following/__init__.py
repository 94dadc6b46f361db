"""What is right from the student's own earlier values: of the same part, and of earlier ones."""
