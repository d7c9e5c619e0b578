"""bnserve in GWFish: its models as a waveform class.

::

    compute_network_errors(
        network, parameters, waveform_model="default", waveform_class=bnserve_client.gwfish.Waveform
    )

GWFish is used from a checkout of its repository; what the package index has by its name is empty.
"""

from bnserve_client.gwfish._waveform import Waveform

__all__ = ["Waveform"]
