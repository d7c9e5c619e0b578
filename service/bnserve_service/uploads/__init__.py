"""Grids and analyses that callers leave here."""

__all__: list[str] = []
