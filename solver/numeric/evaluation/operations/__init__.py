"""The evaluation of each stated operation, in the module of its name; `stated` finds it there."""
