"""Several processes of one server: a supervisor, the template of which workers are copies, and the workers."""

__all__: list[str] = []
