"""Questions to models: read, evaluated, packed, answered."""

__all__: list[str] = []
