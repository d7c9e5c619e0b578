"""Grids and analyses that callers leave here, within their quotas."""

__all__: list[str] = []
