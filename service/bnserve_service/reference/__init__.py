"""The pages that describe the interface: OpenAPI, and the explorer."""

__all__: list[str] = []
