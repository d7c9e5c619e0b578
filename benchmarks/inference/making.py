"""What making an analysis takes: seconds, and memory beyond the data that the user holds.

    python -m benchmarks.inference.making                  # every case, each in a process of its own
    python -m benchmarks.inference.making et-seven-narrow --compare 20

A case is an instrument, the modes and the prior: ``et`` is the triangle of the Einstein Telescope, 8192 s from 5 Hz
with a signal of signal-to-noise ratio 250, and ``event`` three detectors, 128 s from 23 Hz, ratio 32. ``narrow``
is some ten times as wide as the posterior, ``wide`` states a range of the chirp mass and leaves the rest to the model.

- ``wall_s``, ``cpu_s``: of ``relative_binning_analysis``, the first in its process.
- ``memory_mb``: the highest resident size while it ran, less that before, when the data and the model were there.
- ``edges``: of the bins, ``size_mb``: of the analysis.
- ``max_abs_delta_lnl`` with ``--compare N``: against sums over the full grid at N binaries around the signal.
"""

from __future__ import annotations

import argparse
import dataclasses
import json
import subprocess
import sys
import time
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from benchmarks.inference import noises
from bnserve_inference import (
    Detector,
    DetectorData,
    LikelihoodOptions,
    detector_strain,
    likelihood,
    relative_binning_analysis,
)
from bnserve_protocol import LIKELIHOOD_NAMES, Analysis, LikelihoodBatch, LikelihoodParameters, Mode
from bnserve_surrogate import Model

Floats = NDArray[np.float64]
TRIGGER = 1187008882.43
SEED = 16
PIECE = 2**17
"""Frequencies that data are made for at once, in 30 MB."""


class Instrument(NamedTuple):
    """Detectors, the data's extent and the band."""

    detectors: tuple[str, ...]
    duration: float
    f_min: float
    f_max: float
    snr: float
    chirp_mass_width: tuple[float, float]
    """Half the range of the chirp mass in solar masses, narrow and wide."""


INSTRUMENTS = {
    "et": Instrument(("E1", "E2", "E3"), 8192.0, 5.0, 1024.0, 250.0, (2e-5, 2e-3)),
    "et2048": Instrument(("E1", "E2", "E3"), 8192.0, 5.0, 2048.0, 250.0, (2e-5, 2e-3)),
    "event": Instrument(("H1", "L1", "V1"), 128.0, 23.0, 2000.0, 32.0, (1e-3, 5e-2)),
}
MODES: dict[str, list[Mode] | None] = {"quadrupole": [(2, 2)], "seven": None}
NARROW = {"mass_ratio": (1.0, 1.6), "chi_1": (-0.05, 0.05), "chi_2": (-0.05, 0.05)}
CASES = [
    f"{instrument}-{modes}-{prior}" for instrument in INSTRUMENTS for modes in MODES for prior in ("narrow", "wide")
]
TRUTH = LikelihoodParameters(
    mass_ratio=1.25, lambda_1=280.0, lambda_2=620.0, chi_1=0.02, chi_2=0.01, inclination=2.2, total_mass=2.756,
    right_ascension=3.44616, declination=-0.408084, polarization_angle=0.6, distance_mpc=100.0,
    coalescence_time=0.0011, reference_phase=1.3,
)  # fmt: skip


def chirp_fraction(mass_ratio: Floats | float) -> Any:
    """Chirp mass over total mass."""
    return (mass_ratio / (1.0 + mass_ratio) ** 2) ** 0.6


def made_data(instrument: Instrument, model: Model, modes: list[Mode] | None) -> tuple[list[DetectorData], float]:
    """A signal of the instrument's ratio in seeded noise, and its distance in Mpc; in pieces, as it is measured."""
    asds = noises.asds(instrument.detectors, instrument.duration, instrument.f_max)
    start = TRIGGER - instrument.duration + 2.0
    first = round(instrument.f_min * instrument.duration)
    strains = [np.zeros(len(asd), dtype=np.complex128) for asd in asds]
    square = 0.0
    for piece in range(first, len(asds[0]), PIECE):
        f = np.arange(piece, min(piece + PIECE, len(asds[0]))) / instrument.duration
        place = slice(piece, piece + len(f))
        for name, asd, strain in zip(instrument.detectors, asds, strains, strict=True):
            signal = detector_strain(Detector.named(name), f, model, TRUTH, trigger_time=TRIGGER, modes=modes)
            square += 4.0 / instrument.duration * float(np.sum(np.abs(signal / asd[place]) ** 2))
            strain[place] = signal * np.exp(-2j * np.pi * f * (TRIGGER - start))
    scale = instrument.snr / np.sqrt(square)
    for asd, strain, random in zip(asds, strains, np.random.default_rng(SEED).spawn(len(asds)), strict=True):
        for piece in range(first, len(asd), PIECE):
            place = slice(piece, piece + PIECE)
            size = np.where(np.isfinite(asd[place]), asd[place], 0.0) * np.sqrt(instrument.duration / 4.0)
            parts = random.standard_normal((2, len(size)))
            strain[place] = scale * strain[place] + size * (parts[0] + 1j * parts[1])
    data = [
        DetectorData(name, strain, asd, start_time=start, duration=instrument.duration)
        for name, strain, asd in zip(instrument.detectors, strains, asds, strict=True)
    ]
    return data, TRUTH.distance_mpc / scale


def prior_of(instrument: Instrument, wide: bool) -> dict[str, tuple[float, float]]:
    """Ranges around the signal."""
    middle, half = float(TRUTH.total_mass * chirp_fraction(TRUTH.mass_ratio)), instrument.chirp_mass_width[wide]
    return {
        "coalescence_time": (-0.1, 0.1),
        "chirp_mass": (middle - half, middle + half),
        **({} if wide else NARROW),
    }


def around(distance: float, count: int, chirp_mass_width: float) -> LikelihoodBatch:
    """Binaries about as far from the signal as its posterior reaches."""
    random = np.random.default_rng(SEED)
    columns = {name: np.full(count, getattr(TRUTH, name)) for name in LIKELIHOOD_NAMES} | {
        "distance_mpc": distance * random.uniform(0.995, 1.005, count)
    }
    for name, width in {"lambda_1": 5.0, "lambda_2": 5.0, "reference_phase": 5e-3, "coalescence_time": 2e-6}.items():
        columns[name] = columns[name] + width * random.standard_normal(count)
    q = columns["mass_ratio"]
    chirp_mass = TRUTH.total_mass * chirp_fraction(q) + chirp_mass_width * random.standard_normal(count)
    return LikelihoodBatch.coerce(columns | {"total_mass": chirp_mass / chirp_fraction(q)})


def on_the_grid(
    instrument: Instrument, model: Model, data: list[DetectorData], batch: LikelihoodBatch, modes: list[Mode] | None
) -> Floats:
    """ln L by sums over all frequencies of the band."""
    found = np.zeros(len(batch))
    values: list[dict[str, Any]] = [
        {name: float(batch[name][k]) for name in LIKELIHOOD_NAMES} for k in range(len(batch))
    ]
    rows = [dataclasses.replace(TRUTH, **each) for each in values]
    for piece in range(round(instrument.f_min * instrument.duration), len(data[0].asd), PIECE):
        f = np.arange(piece, min(piece + PIECE, len(data[0].asd))) / instrument.duration
        place = slice(piece, piece + len(f))
        turn = np.exp(2j * np.pi * f * (TRIGGER - data[0].start_time))
        for detector in data:
            weights, strain = 4.0 / instrument.duration / detector.asd[place] ** 2, detector.strain[place] * turn
            for k, row in enumerate(rows):
                h = detector_strain(detector.site(), f, model, row, trigger_time=TRIGGER, modes=modes)
                found[k] += float(np.sum(weights * ((strain.conj() * h).real - 0.5 * np.abs(h) ** 2)))
    return found


def memory(entry: str) -> float:
    """``VmRSS`` or ``VmHWM`` of this process in MB: its resident size, now or at most since :func:`forget_highest`."""
    line = next(line for line in Path("/proc/self/status").read_text().splitlines() if line.startswith(entry))
    return int(line.split()[1]) * 1024 / 1e6


def forget_highest() -> None:
    """Begin anew with the highest resident size."""
    Path("/proc/self/clear_refs").write_text("5")  # see proc_pid_clear_refs(5)


def measured(case: str, compare: int) -> dict[str, Any]:
    """The figures of one case, whose data are made first."""
    name, which, prior = case.split("-")
    instrument, modes, model = INSTRUMENTS[name], MODES[which], Model.default()
    data, distance = made_data(instrument, model, modes)
    fiducial = LikelihoodBatch.coerce(TRUTH).waveform_batch()
    forget_highest()
    before, wall, cpu = memory("VmRSS"), time.perf_counter(), time.process_time()
    analysis = relative_binning_analysis(
        data, trigger_time=TRIGGER, f_min=instrument.f_min, f_max=instrument.f_max, fiducial=fiducial, model=model,
        options=LikelihoodOptions(prior=prior_of(instrument, prior == "wide"), modes=modes),
    )  # fmt: skip
    found: dict[str, Any] = {
        "case": case,
        "wall_s": round(time.perf_counter() - wall, 2),
        "cpu_s": round(time.process_time() - cpu, 2),
        "memory_mb": round(memory("VmHWM") - before),
        "data_mb": round(sum(d.strain.nbytes + d.asd.nbytes for d in data) / 1e6),
        "edges": len(analysis.linear_nodes),
        "size_mb": round(analysis.nbytes / 1e6, 1),
    }
    if compare:
        found |= compared(instrument, model, data, analysis, modes, around(distance, compare, 2e-8))
    return found


def compared(
    instrument: Instrument, model: Model, data: list[DetectorData], analysis: Analysis, modes: list[Mode] | None,
    batch: LikelihoodBatch,
) -> dict[str, Any]:  # fmt: skip
    """Errors of an analysis."""
    exact, ours = on_the_grid(instrument, model, data, batch, modes), likelihood(model, analysis).log_likelihood(batch)
    relevant = exact > exact.max() - 25.0
    return {
        "compared": int(relevant.sum()),
        "best_lnl": round(float(exact.max()), 1),
        "max_abs_delta_lnl": float(np.abs(ours - exact)[relevant].max()),
        "max_abs_delta_lnl_all": float(np.abs(ours - exact).max()),
    }


def main() -> None:
    """Measure and print, a JSON object for every case."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("case", nargs="?", choices=CASES, help="one, in this process; all of them where none is named")
    parser.add_argument("--compare", type=int, default=0, help="binaries that are compared with the full grid")
    options = parser.parse_args()
    if options.case is not None:
        print(json.dumps(measured(options.case, options.compare)), flush=True)
        return
    for case in CASES:
        subprocess.run(
            [sys.executable, "-m", "benchmarks.inference.making", case, "--compare", str(options.compare)], check=True
        )


if __name__ == "__main__":
    main()
