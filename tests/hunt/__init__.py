"""A hunt: questions of textbooks and generated ones, judged by other programs and for the form of what is answered."""
