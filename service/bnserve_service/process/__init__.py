"""What belongs to a process: its name, memory, processors, sockets and files."""

__all__: list[str] = []
