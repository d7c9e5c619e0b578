"""What operators see: metrics, and the words of the log."""

__all__: list[str] = []
