"""How much of what everybody may have, and what waits for its turn."""

__all__: list[str] = []
