"""The models that are served: found, loaded, checked, followed, described."""

__all__: list[str] = []
