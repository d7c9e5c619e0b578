"""Forecasts: Fisher matrices of binaries in networks of detectors."""

from bnserve_inference.fisher._forecasting import COORDINATES, ForecastOptions, forecast
from bnserve_inference.fisher._matrix import Forecast
from bnserve_inference.fisher._network import Network, NoiseCurve

__all__ = ["COORDINATES", "Forecast", "ForecastOptions", "Network", "NoiseCurve", "forecast"]
