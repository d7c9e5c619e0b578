"""What the processes of one server share: a folder in memory, and the files in it."""

__all__: list[str] = []
