"""What belongs to a process: its name, memory, processors, sockets and output."""

__all__: list[str] = []
