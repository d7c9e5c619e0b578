"""Several processes of one server: a supervisor, the fork server that workers are copies of, and the workers."""

__all__: list[str] = []
