"""A waveform model of three modes, as a user of the registry would write one."""

import msgspec
import numpy as np

from bnserve_protocol import (
    DEFAULT_OPTIONS,
    AmplitudePhase,
    Factored,
    Modes,
    ParameterBatch,
    Polarizations,
    as_frequencies,
    chosen_modes,
    the_mode,
)
from tests.service.chirp import ChirpModel

MODES = ((2, 2), (3, 3), (2, 1))


class ModesModel(ChirpModel):
    """Mode m at f has m / 2 times the phase of (2, 2) at 2 f / m; the factors of the inclination are made up."""

    def __init__(self, name="modes", **options):
        super().__init__(name=name, **options)
        self.description = msgspec.structs.replace(self.description, modes=list(MODES))

    def predict_modes(self, frequencies, batch, *, options=DEFAULT_OPTIONS, dtype="complex128"):
        chosen = chosen_modes(options, self.description.modes)
        rows = ParameterBatch.coerce(batch)
        curves = [self._curves(frequencies, rows, mode, options) for mode in chosen]
        iota = rows["inclination"]
        return Modes(
            modes=chosen,
            h=np.stack([one.amplitude * np.exp(1j * one.phase) for one in curves], axis=1).astype(dtype),
            plus=np.stack([np.cos(degree * iota) for degree, _ in chosen], axis=1),
            cross=np.stack([-1j * np.sin(order * iota) for _, order in chosen], axis=1),
            status=curves[0].status,
            estimated_mismatch=np.full(len(rows), 1e-9 * len(chosen)),
        )

    def predict(self, frequencies, parameters, *, options=DEFAULT_OPTIONS, dtype="complex128"):
        both = self.predict_batch(frequencies, parameters, options=options, dtype=dtype)
        return Polarizations(both.plus[0], both.cross[0], both.status, both.estimated_mismatch)

    def predict_batch(self, frequencies, batch, *, options=DEFAULT_OPTIONS, dtype="complex128"):
        """Summed in the order of the model's modes, whatever that of the options is."""
        chosen = chosen_modes(options, self.description.modes)
        ordered = msgspec.structs.replace(options, modes=[mode for mode in MODES if mode in chosen])
        found = self.predict_modes(frequencies, batch, options=ordered, dtype=dtype)
        first, *others = (_of(found, place).polarizations() for place in range(len(chosen)))
        for one in others:
            first.plus[...] += one.plus
            first.cross[...] += one.cross
        return first

    def predict_factored(self, frequencies, batch, *, options=DEFAULT_OPTIONS, dtype="complex128"):
        the_mode(options, self.description.modes)
        return _of(self.predict_modes(frequencies, batch, options=options, dtype=dtype), 0)

    def predict_amplitude_phase(self, frequencies, batch, *, options=DEFAULT_OPTIONS):
        return self._curves(frequencies, batch, the_mode(options, self.description.modes), options)

    def _curves(self, frequencies, batch, mode, options):
        degree, order = mode
        carrier = super().predict_amplitude_phase(2.0 * as_frequencies(frequencies) / order, batch, options=options)
        return AmplitudePhase(carrier.amplitude / degree, 0.5 * order * carrier.phase, carrier.status)


def _of(found, place):
    """One of its modes."""
    h, plus, cross = found.h[:, place], found.plus[:, place], found.cross[:, place]
    return Factored(h=h, plus=plus, cross=cross, status=found.status, estimated_mismatch=found.estimated_mismatch)


class QuickModesModel(ModesModel):
    """Promises to answer small questions at once."""

    quick_work = 2**14
