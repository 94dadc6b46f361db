"""Where the public names of this topic are; `solver.exact` reads it."""

__all__: list[str] = []
