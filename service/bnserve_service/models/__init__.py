"""The models that are served: found, loaded, checked, followed; whether they may get traffic."""

__all__: list[str] = []
