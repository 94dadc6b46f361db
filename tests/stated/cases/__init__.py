"""Cases of stated formulas, one module a family of operations; `test_every_operation` takes them all."""
