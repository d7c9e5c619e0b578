"""Outside of a model's range there is no waveform, in PyCBC's word; imported when it happens, for it imports PyCBC."""

from pycbc.waveform.waveform import NoWaveformError

from bnserve_protocol import OutOfDomain


class NoWaveform(OutOfDomain, NoWaveformError):  # type: ignore[misc]  # PyCBC has no annotations
    """A binary outside the range in which the model was trained; PyCBC's likelihoods are -inf there."""
