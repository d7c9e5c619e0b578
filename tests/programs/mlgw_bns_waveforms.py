"""Waveforms of mlgw_bns itself, and how long one takes, into a file that ``bajes_waveform.py`` compares with.

    python tests/programs/mlgw_bns_waveforms.py waveforms.npz

It runs in an environment of its own: mlgw_bns 0.12.1 needs numpy 1.23.
"""

import dataclasses
import sys
import time

import mlgw_bns
import numpy as np

GRID = np.arange(20.0, 1024.0, 0.25)
LOW_GRID = np.arange(1.0, 200.0, 0.25)
"""It begins below the band: the phase is that of its first point."""


def binaries() -> list[mlgw_bns.ParametersWithExtrinsic]:
    """Binaries over the range, and three that differ in one of phase, time and inclination alone."""
    first = mlgw_bns.ParametersWithExtrinsic.gw170817()
    turned = [dataclasses.replace(first, **{name: value}) for name, value in
              [("reference_phase", 0.7), ("time_shift", 0.01), ("inclination", 0.3)]]  # fmt: skip
    random = np.random.default_rng(1)
    low = [1.0, 100.0, 100.0, -0.3, -0.3, 20.0, 0.1, 2.4, 0.0, -0.1]
    high = [2.0, 2000.0, 2000.0, 0.3, 0.3, 200.0, 3.0, 3.4, 6.0, 0.1]
    return [first, *turned, *(type(first)(*row) for row in random.uniform(low, high, (24, 10)).tolist())]


def seconds_of_one(model: mlgw_bns.Model, binary: mlgw_bns.ParametersWithExtrinsic) -> float:
    """The best of 200, each of another binary."""
    best = np.inf
    for n in range(200):
        another = dataclasses.replace(binary, lambda_1=400.0 + n)
        started = time.perf_counter()
        model.predict(GRID, another)
        best = min(best, time.perf_counter() - started)
    return best


def main() -> None:
    """Write the file."""
    model = mlgw_bns.Model.default()
    rows = binaries()
    waveforms = np.array([model.predict(GRID, row) for row in rows])
    amplitude, phase = np.moveaxis([model._predict_amplitude_phase(GRID, row) for row in rows], 1, 0)
    np.savez(
        sys.argv[1], rows=[dataclasses.astuple(row) for row in rows], waveforms=waveforms, amplitude=amplitude,
        phase=phase, low=np.array([model.predict(LOW_GRID, row) for row in rows]),
        until_merger=[model.time_until_merger(25.0, row) for row in rows], grid=GRID, low_grid=LOW_GRID,
        seconds=seconds_of_one(model, rows[0]), module=mlgw_bns.__file__,
    )  # fmt: skip


if __name__ == "__main__":
    main()
