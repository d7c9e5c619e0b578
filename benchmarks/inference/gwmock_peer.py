"""The peer: gwmock-signal's projection of polarisations in time, the Earth turning, in its own process.

    python gwmock_peer.py FILE RESULT

In an environment of gwmock-signal. The file is that of ``python -m benchmarks.inference.moving_projection``; the result
holds the series of each detector, and the GPS time of their first sample.
"""

from __future__ import annotations

import sys

import numpy as np
from gwmock_signal.projection.network import project_polarizations_to_network
from gwmock_signal.timeseries import TimeSeries

if __name__ == "__main__":
    with np.load(sys.argv[1], allow_pickle=False) as given:
        start, rate = float(given["start"]), float(given["rate"])
        series = {name: TimeSeries(given[name], t0=start, sample_rate=rate) for name in ("plus", "cross")}
        found = project_polarizations_to_network(
            series,
            given["detectors"].tolist(),
            right_ascension=float(given["right_ascension"]),
            declination=float(given["declination"]),
            polarization_angle=float(given["polarization_angle"]),
            earth_rotation=True,
        )
    np.savez(sys.argv[2], start=next(iter(found.values())).t0, **{name: each.data for name, each in found.items()})
