"""Where the public names of this package are; `__init__.py` reads it."""

__all__: list[str] = []
