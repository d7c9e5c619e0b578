"""A small waveform model of our own, as a user of the registry would write one: the Newtonian chirp."""

import threading
import time
from dataclasses import dataclass, field

import numpy as np

from bnserve_protocol import (
    DEFAULT_OPTIONS,
    SOLAR_MASS_SECONDS,
    AmplitudePhase,
    Factored,
    ModelDescription,
    ModelUnknown,
    Modes,
    OutOfDomain,
    ParameterBatch,
    ParameterDescription,
    ParametersWithExtrinsic,
    Polarizations,
    RowStatus,
    as_frequencies,
    time_until_merger,
)

RANGES = {"mass_ratio": (1.0, 3.0), "lambda_1": (0.0, 5000.0), "lambda_2": (0.0, 5000.0), "total_mass": (2.0, 4.0)}


class ChirpModel:
    """Amplitude f^(-7/6), phase of the leading post-Newtonian order; one row at a time, so that batches keep bits."""

    def __init__(self, name="chirp", version="1.0.0", digest="sha256:0", scale=1.0, healthy=True):
        parameters = [
            ParameterDescription(name=key, unit="1", minimum=low, maximum=high) for key, (low, high) in RANGES.items()
        ]
        self.description = ModelDescription(
            name=name, version=version, digest=digest, modes=[(2, 2)], parameters=parameters,
            frequency_band=(5.0, 2048.0), training_band=(5.0, 2048.0), reference_mass=2.8,
            accuracy={"median_mismatch": 1e-7}, citation="The Newtonian chirp",
        )  # fmt: skip
        self.scale = scale
        self.healthy = healthy
        self.warmed_up = False
        self.calls: list[int] = []

    def warm_up(self):
        self.warmed_up = True

    def self_check(self):
        return self.healthy

    def predict(self, frequencies, parameters, *, options=DEFAULT_OPTIONS, dtype="complex128"):
        both = self.predict_batch(frequencies, parameters, options=options, dtype=dtype)
        return Polarizations(plus=both.plus[0], cross=both.cross[0], status=both.status)

    def predict_batch(self, frequencies, batch, *, options=DEFAULT_OPTIONS, dtype="complex128"):
        return self.predict_factored(frequencies, batch, options=options, dtype=dtype).polarizations()

    def predict_factored(self, frequencies, batch, *, options=DEFAULT_OPTIONS, dtype="complex128"):
        curves = self.predict_amplitude_phase(frequencies, ParameterBatch.coerce(batch), options=options)
        cosine = np.cos(ParameterBatch.coerce(batch)["inclination"])
        h = (curves.amplitude * np.exp(1j * curves.phase)).astype(dtype)
        return Factored(h=h, plus=0.5 * (1.0 + cosine**2), cross=-1j * cosine, status=curves.status)

    def predict_modes(self, frequencies, batch, *, options=DEFAULT_OPTIONS, dtype="complex128"):
        return Modes.of_one((2, 2), self.predict_factored(frequencies, batch, options=options, dtype=dtype))

    def predict_amplitude_phase(self, frequencies, batch, *, options=DEFAULT_OPTIONS):
        grid = as_frequencies(frequencies)
        rows = ParameterBatch.coerce(batch)
        self.calls.append(len(rows))
        status = np.zeros(len(rows), dtype=np.uint8)
        for name, (low, high) in RANGES.items():
            bad = ~((rows[name] >= low) & (rows[name] <= high))
            if bad.any() and options.out_of_domain == "error":
                raise OutOfDomain(f"Row {int(np.argmax(bad))}: '{name}' is outside [{low}, {high}].")
            status[bad] = RowStatus.OUT_OF_DOMAIN
        curves = [self._row(grid, rows.row(index), status[index]) for index in range(len(rows))]
        amplitude = np.array([curve[0] for curve in curves]).reshape(len(rows), len(grid))
        phase = np.array([curve[1] for curve in curves]).reshape(len(rows), len(grid))
        if isinstance(batch, ParametersWithExtrinsic):
            return AmplitudePhase(amplitude=amplitude[0], phase=phase[0], status=status)
        return AmplitudePhase(amplitude=amplitude, phase=phase, status=status)

    def _row(self, grid, binary, status):
        if status:
            return np.full(len(grid), np.nan), np.full(len(grid), np.nan)
        chirp_mass = binary.total_mass * (binary.mass_ratio / (1.0 + binary.mass_ratio) ** 2) ** 0.6
        chirp_time = chirp_mass * SOLAR_MASS_SECONDS
        phase = -0.0234375 * (np.pi * chirp_time * grid) ** (-5.0 / 3.0) + binary.reference_phase
        amplitude = self.scale * 1e-22 / binary.distance_mpc * grid ** (-7.0 / 6.0)
        return amplitude, phase + 2.0 * np.pi * grid * binary.time_shift

    def time_until_merger(self, frequency, parameters):
        return time_until_merger(self, frequency, parameters)


class QuickChirpModel(ChirpModel):
    """Promises to answer small questions at once, and remembers in which threads it did."""

    quick_work = 2**14

    def __init__(self, **options):
        super().__init__(**options)
        self.threads = set()

    def predict_amplitude_phase(self, frequencies, batch, *, options=DEFAULT_OPTIONS):
        self.threads.add(threading.current_thread().name)
        return super().predict_amplitude_phase(frequencies, batch, options=options)


class GatedModel(ChirpModel):
    """Evaluates only while its gate is open: what a test needs to see a server that is busy."""

    def __init__(self, **options):
        super().__init__(**options)
        self.gate = threading.Event()
        self.gate.set()
        self.entered = threading.Semaphore(0)

    def predict_amplitude_phase(self, frequencies, batch, *, options=DEFAULT_OPTIONS):
        self.entered.release()
        assert self.gate.wait(60.0), "the test forgot to open the gate"
        return super().predict_amplitude_phase(frequencies, batch, options=options)

    def wait_until_entered(self):
        assert self.entered.acquire(timeout=30.0), "no evaluation began"


@dataclass(frozen=True)
class Manifest:
    digest: str


@dataclass
class MemorySource:
    """A source of models in memory; what it loads is a model already, so that its factory is the identity."""

    models: dict = field(default_factory=dict)
    label_table: dict = field(default_factory=dict)
    broken: dict = field(default_factory=dict)
    unreadable: Exception | None = None

    def add(self, model, label="stable"):
        key = (model.description.name, model.description.version)
        self.models[key] = model
        if label:
            self.label_table.setdefault(key[0], {})[label] = key[1]
        return self

    def names(self):
        if self.unreadable is not None:
            raise self.unreadable
        return sorted({name for name, _ in self.models})

    def versions(self, name):
        found = [version for known, version in self.models if known == name]
        if not found:
            raise ModelUnknown(f"There is no model '{name}'.")
        return sorted(found)

    def labels(self, name):
        return dict(self.label_table.get(name, {}))

    def manifest(self, name, version):
        return Manifest(self.models[name, version].description.digest)

    def load(self, name, version):
        if (name, version) in self.broken:
            raise self.broken[name, version]
        return self.models[name, version]


def as_it_is(model):
    """The factory for a :class:`MemorySource`."""
    return model


def until(condition, what, seconds=30.0):
    """Wait until something is so; the limit only ends a test that would hang."""
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, f"did not happen: {what}"
        time.sleep(0.005)
