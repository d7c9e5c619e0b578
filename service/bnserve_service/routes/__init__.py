"""The paths of the service, one module for each kind of thing. Handlers translate; the decisions are elsewhere."""

__all__: list[str] = []
