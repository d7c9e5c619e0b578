"""The endpoints that are no evaluation: models, grids, analyses, limits, health and metrics."""

__all__: list[str] = []
