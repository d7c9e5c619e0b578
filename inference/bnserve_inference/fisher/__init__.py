"""Forecasts: Fisher matrices of binaries in networks of detectors."""

from bnserve_inference.fisher._drawing import draw_population, luminosity_distance
from bnserve_inference.fisher._forecasting import forecast
from bnserve_inference.fisher._loudness import signal_to_noise
from bnserve_inference.fisher._network import Network, NoiseCurve
from bnserve_inference.fisher._population import as_samples, read_population
from bnserve_inference.fisher._runs import forecast_catalogue
from bnserve_inference.fisher._summary import check_picture, draw_forecasts, summary
from bnserve_protocol import FORECAST_COORDINATES as COORDINATES
from bnserve_protocol import Forecast, ForecastOptions, SignalToNoise

__all__ = [
    "COORDINATES",
    "Forecast",
    "ForecastOptions",
    "Network",
    "NoiseCurve",
    "SignalToNoise",
    "as_samples",
    "check_picture",
    "draw_forecasts",
    "draw_population",
    "forecast",
    "forecast_catalogue",
    "luminosity_distance",
    "read_population",
    "signal_to_noise",
    "summary",
]
