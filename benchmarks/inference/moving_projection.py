"""Signals in detectors that move, beside those that gwmock-signal projects in time.

    python -m benchmarks.inference.moving_projection --gwmock PYTHON   # of an environment of gwmock-signal

All modes of the default model from 8 Hz are made a time series, which gwmock-signal delays and weighs sample by sample.
Its Fourier transform is compared with ``detector_strain(..., response="moving")`` from 17 Hz on, where all modes are
whole. For each detector and either response: the largest difference relative to the signal (``largest``), the same when
the time is fitted (``timed``), that time (``seconds``), and the mismatch with the noise of the Einstein Telescope.
gwmock-signal has sidereal time from UT1, and we from UTC, as LAL: delays differ by up to some 1e-7 s.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.inference.moving_case import TRIGGER, TRUTH
from benchmarks.inference.noises import ET_NOISE
from bnserve_inference import Detector, detector_strain, read_asd
from bnserve_protocol import LikelihoodBatch
from bnserve_surrogate import Model

Floats = NDArray[np.float64]

DETECTORS = ("E1", "H1", "L1")
F_MIN, LOW, HIGH, RATE = 8.0, 17.0, 400.0, 1024.0
"""Hz: where the signal begins to be whole, what is compared, and samples a second."""


def projected(python: str, times: Floats, plus: Floats, cross: Floats) -> dict[str, NDArray[Any]]:
    """What gwmock-signal makes of polarisations whose times are relative to the coalescence."""
    sky = {name: getattr(TRUTH, name) for name in ("right_ascension", "declination", "polarization_angle")}
    with tempfile.TemporaryDirectory() as folder:
        given, found = Path(folder) / "given.npz", Path(folder) / "found.npz"
        start = TRIGGER + TRUTH.coalescence_time + times[0]
        np.savez(given, start=start, rate=RATE, plus=plus, cross=cross, detectors=np.array(DETECTORS), **sky)
        peer = [python, str(Path(__file__).with_name("gwmock_peer.py")), str(given), str(found)]
        answer = subprocess.run(peer, capture_output=True, text=True, check=False)
        if answer.returncode:
            raise RuntimeError(answer.stderr[-2000:])
        with np.load(found, allow_pickle=False) as file:
            return {name: np.array(file[name]) for name in file.files}


def difference(
    ours: NDArray[np.complex128], theirs: NDArray[np.complex128], f: Floats, asd: Floats
) -> dict[str, float]:
    """Of signals, at the same frequencies."""
    ratio, weight = theirs / ours, np.abs(ours / asd) ** 2
    overlap = np.sum(weight * ratio) / np.sqrt(np.sum(weight) * np.sum(weight * np.abs(ratio) ** 2))
    phase, kept = np.unwrap(np.angle(ratio)), np.sqrt(weight)
    slope, _ = np.polyfit(f, phase, 1, w=kept)
    timed = ratio * np.exp(-1j * slope * f)
    timed /= np.sum(weight * timed) / np.sum(weight)
    return {
        "largest": float(np.abs(ratio - 1.0).max()),
        "timed": float(np.abs(timed - 1.0).max()),
        "seconds": float(-slope / (2.0 * np.pi)),
        "mismatch": float(1.0 - np.real(overlap)),
    }


def main() -> None:
    """Compare, and print one JSON object."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--gwmock", metavar="PYTHON", required=True, help="a Python that has gwmock-signal")
    python = parser.parse_args().gwmock
    model, binary = Model.default(), LikelihoodBatch.coerce(TRUTH).waveform_batch()
    made = model.predict_time_domain(binary, sampling_rate=RATE, f_min=F_MIN)
    found = projected(python, made.times, made.plus[0], made.cross[0])
    start, duration = float(found.pop("start")) - TRIGGER, len(next(iter(found.values()))) / RATE
    f = np.arange(round(LOW * duration), round(HIGH * duration)) / duration
    asd = read_asd(ET_NOISE, duration, round(HIGH * duration) + 1, psd=True)[round(LOW * duration) : -1]
    result: dict[str, Any] = {}
    for name, series in found.items():
        spectrum = np.fft.rfft(series)[round(LOW * duration) : round(HIGH * duration)] / RATE
        theirs = spectrum * np.exp(-2j * np.pi * f * start)
        for response in ("moving", "static"):
            ours = detector_strain(Detector.named(name), f, model, TRUTH, trigger_time=TRIGGER, response=response)
            result[f"{name} {response}"] = difference(ours, theirs, f, asd[: len(f)])
    print(json.dumps(result, indent=2))


if __name__ == "__main__":
    main()
