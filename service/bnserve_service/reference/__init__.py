"""The pages that describe the interface: OpenAPI, the documents it describes, and the explorer."""

__all__: list[str] = []
