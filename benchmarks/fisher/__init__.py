"""Forecasts: how many a second."""
