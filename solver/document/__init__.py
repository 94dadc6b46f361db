"""A solved problem as one document: texts, formulas and numbers, no objects of algebra; every format is made of it."""
