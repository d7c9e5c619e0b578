"""The data of an event: strain from files or a simulated signal, noise, and whatever is doubtful about them."""

from bnserve_posterior.data._loading import EventData, load_data, segment_start
from bnserve_posterior.data._noise import noise_curve

__all__ = ["EventData", "load_data", "noise_curve", "segment_start"]
