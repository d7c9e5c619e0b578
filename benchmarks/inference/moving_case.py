"""A signal in detectors that the Earth turns, made and judged by brute force."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import lal
import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

from benchmarks.inference.brute_force import Mode, Place, signal_over_mode
from benchmarks.inference.fine_sums import Moments
from benchmarks.inference.noises import asds
from bnserve_inference import DetectorData
from bnserve_protocol import EvaluationOptions, LikelihoodBatch, LikelihoodParameters, ParameterBatch
from bnserve_protocol import Mode as ModeName
from bnserve_surrogate import Model

Complex = NDArray[np.complex128]
Floats = NDArray[np.float64]

TRIGGER = 1187008882.43
BINS = 3000
_PIECE = 2**18
_ON_ALL_SIDES = 0.02
"""Of a band, that is projected beyond both of its ends."""


class Case(NamedTuple):
    """Detectors by LAL's names, the extent of the data, the band, and the loudness of the signal."""

    detectors: tuple[str, ...]
    duration: float
    f_min: float
    f_max: float
    snr: float


CASES = {
    "et": Case(("E1", "E2", "E3"), 8192.0, 5.0, 1024.0, 250.0),
    "event": Case(("H1", "L1", "V1"), 128.0, 23.0, 1024.0, 32.0),
}
TRUTH = LikelihoodParameters(
    mass_ratio=1.25, lambda_1=280.0, lambda_2=620.0, chi_1=0.02, chi_2=0.01, inclination=2.2, total_mass=2.756,
    right_ascension=3.44616, declination=-0.408084, polarization_angle=0.6, distance_mpc=100.0,
    coalescence_time=0.0011, reference_phase=1.3,
)  # fmt: skip


class BruteForce:
    """The signal of one sample in the detectors of a case, each mode by itself.

    Times of arrival are relative to the trigger.
    """

    def __init__(self, model: Model, case: Case, modes: Sequence[ModeName], sample: LikelihoodParameters) -> None:
        self._model, self._modes, self._binary = model, modes, LikelihoodBatch.coerce(sample).waveform_batch()
        place = Place(
            sample.right_ascension, sample.declination, sample.polarization_angle, TRIGGER, sample.coalescence_time
        )
        factors = model.predict_modes([30.0], self._binary, options=self._options(modes))
        low, high = case.f_min * (1.0 - _ON_ALL_SIDES), case.f_max * (1.0 + _ON_ALL_SIDES)
        self._edges = np.geomspace(low, high, 1 + round(np.log2(high / low)))
        self._responses: list[list[list[CubicSpline]]] = []
        for name in case.detectors:
            detector = lal.cached_detector_by_prefix[name]
            self._responses.append([])
            for number, mode in enumerate(modes):
                each = Mode(
                    lambda f, mode=mode: self._strain(f, mode),  # type: ignore[misc]  # a lambda with a default
                    complex(factors.plus[0, number]), complex(factors.cross[0, number]), self._seconds(mode),
                )  # fmt: skip
                octaves = zip(self._edges[:-1], self._edges[1:], strict=True)
                self._responses[-1].append(
                    [_smooth(*signal_over_mode(detector, place, each, *ends)) for ends in octaves]
                )

    def parts(self, detector: int, f: Floats) -> list[Complex]:
        """Of each mode, complex ``(M,)``."""
        octave = np.clip(np.searchsorted(self._edges, f, side="right") - 1, 0, len(self._edges) - 2)
        found = []
        for mode, responses in zip(self._modes, self._responses[detector], strict=True):
            signal = self._strain(f, mode)
            for number in np.unique(octave):
                signal[octave == number] *= responses[number](f[octave == number])
            found.append(signal)
        return found

    def _strain(self, f: Floats, mode: ModeName) -> Complex:
        inside = np.maximum(f, 1e-3)  # frequencies that fade out below
        h = self._model.predict_factored(inside, self._binary, options=self._options([mode])).h[0]
        return np.array(h, dtype=np.complex128)

    def _seconds(self, mode: ModeName) -> Callable[[float], float]:
        def seconds(f: float) -> float:
            return 1.1 * float(np.ravel(self._model.time_until_merger(2.0 / mode[1] * f, self._binary))[0])

        return seconds

    def _options(self, modes: Sequence[ModeName]) -> EvaluationOptions:
        return EvaluationOptions(alignment="merger", modes=tuple(modes))


def _smooth(f: Floats, response: Complex) -> CubicSpline:
    most = max(1, len(f) // 20000)  # some radians in all: one in 10^4 of them is a part in 10^13
    places = np.unique(np.append(np.arange(0, len(f), most), len(f) - 1))
    return CubicSpline(f[places], response[places])


class Observed(NamedTuple):
    """Data with a signal, that signal, and what judges others."""

    data: list[DetectorData]
    truth: LikelihoodParameters
    moments: list[Moments]


def observed(model: Model, case: Case, modes: Sequence[ModeName], seed: int) -> Observed:
    """A signal of the case's loudness in seeded noise: projected by brute force."""
    start, noises, found = TRIGGER - case.duration + 2.0, asds(case.detectors, case.duration, case.f_max), []
    first = round(case.f_min * case.duration)
    f = np.arange(first, len(noises[0])) / case.duration
    unit = BruteForce(model, case, modes, TRUTH)
    strains = [_in_pieces(unit, number, f) for number in range(len(case.detectors))]
    square = sum(
        4.0 / case.duration * float(np.sum(np.abs(strain / asd[first:]) ** 2))
        for strain, asd in zip(strains, noises, strict=True)
    )
    scale = case.snr / np.sqrt(square)
    moments = []
    random = np.random.default_rng(seed).spawn(len(noises))
    for number, (name, asd, strain) in enumerate(zip(case.detectors, noises, strains, strict=True)):
        there = asd[first:]
        size = there * np.sqrt(case.duration / 4.0)
        strain *= scale
        strain += size * (random[number].standard_normal(len(f)) + 1j * random[number].standard_normal(len(f)))
        moments.append(
            Moments.of(f, strain, there, case.duration, BINS, lambda at, d=number: unit.parts(d, at))  # type: ignore[misc]
        )
        whole = np.zeros(len(asd), dtype=np.complex128)
        whole[first:] = strain * np.exp(-2j * np.pi * f * (TRIGGER - start))
        found.append(DetectorData(name, whole, asd, start_time=start, duration=case.duration))
    values = {field: getattr(TRUTH, field) for field in TRUTH.__dataclass_fields__}
    truth = LikelihoodParameters(**(values | {"distance_mpc": TRUTH.distance_mpc / scale}))
    return Observed(found, truth, moments)


def _in_pieces(signal: BruteForce, detector: int, f: Floats) -> Complex:
    pieces = [sum(signal.parts(detector, f[start : start + _PIECE])) for start in range(0, len(f), _PIECE)]
    return np.concatenate(pieces)


def brute_log_likelihood(
    model: Model, case: Case, modes: Sequence[ModeName], sample: LikelihoodParameters, moments: Sequence[Moments]
) -> float:
    """ln L of a sample near the signal, its response by brute force."""
    signal = BruteForce(model, case, modes, sample)
    return sum(
        each.log_likelihood(lambda f, d=number: signal.parts(d, f))  # type: ignore[misc]  # a lambda with a default
        for number, each in enumerate(moments)
    )


def one_of(batch: LikelihoodBatch | ParameterBatch, row: int) -> LikelihoodParameters:
    """A row of a batch."""
    names = [name for name in TRUTH.__dataclass_fields__ if not name.startswith("calibration")]
    values: dict[str, Any] = {name: float(batch[name][row]) for name in names}
    return LikelihoodParameters(**values)
