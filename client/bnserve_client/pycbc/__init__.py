"""bnserve in PyCBC: its models as the approximant ``"bnserve"``.

::

    hp, hc = pycbc.waveform.get_fd_waveform(approximant="bnserve", bnserve_url="http://host:8000", ...)

PyCBC finds these functions by itself, in the entry-point groups of its plug-ins, where the client is installed beside
it. They import it when they are called.
"""

from bnserve_client.pycbc._waveforms import end_frequency, frequency_series, length, samples

__all__ = ["end_frequency", "frequency_series", "length", "samples"]
