"""What operators see: metrics and health."""

__all__: list[str] = []
