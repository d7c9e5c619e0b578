"""The local waveform model."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import (
    DEFAULT_OPTIONS,
    AmplitudePhase,
    ArtifactIncomplete,
    BatchLike,
    DtypeName,
    EvaluationOptions,
    Factored,
    GridLike,
    ModelDescription,
    ParameterBatch,
    ParametersWithExtrinsic,
    Polarizations,
    RowStatus,
    check_dtype,
    time_until_merger,
)
from bnserve_store import Artifact, ModelStore
from bnserve_surrogate._domain import row_status
from bnserve_surrogate._metadata import SurrogateMetadata
from bnserve_surrogate._prepared_grid import GridCache
from bnserve_surrogate._tensors import read_modes
from bnserve_surrogate.kernel import KernelModel, evaluate_amplitude_phase, evaluate_strain


class Model:
    """A trained surrogate, evaluated in this process.

    Satisfies :class:`bnserve_protocol.WaveformModel`; instances are immutable, safe to share between threads, and
    release the GIL while they compute. A row's bits do not depend on the batch or thread it is evaluated in.

    Parameters
    ----------
    metadata:
        What the manifest says.
    description:
        Name, version, digest.
    modes:
        The kernel arrays of every mode; today (2, 2) alone.
    """

    quick_work = 2**13
    """Rows times (frequencies + 1000) that are evaluated in less than 100 us: a server need not hand them to a
    thread."""

    def __init__(
        self, metadata: SurrogateMetadata, description: ModelDescription, modes: dict[str, KernelModel]
    ) -> None:
        self._metadata = metadata
        self._description = description
        self._mode = modes["22"]
        self._grids = GridCache()

    @classmethod
    def default(cls) -> Model:
        """The model called ``default``, which ships with the package: 5 to 2048 Hz."""
        return cls.load("default")

    @classmethod
    def load(cls, name: str, version: str = "stable", store: str | Path | ModelStore | None = None) -> Model:
        """A model from a store.

        Parameters
        ----------
        name:
            Such as ``"default"``.
        version:
            A version or a label.
        store:
            A directory or a store; None for the models that ship with the package.

        Raises
        ------
        ModelUnknown, StoreUnknown, ArtifactError
        """
        if store is None:
            store = ModelStore.default()
        elif not isinstance(store, ModelStore):
            store = ModelStore([store])
        return cls.from_artifact(store.load(name, version))

    @classmethod
    def from_artifact(cls, artifact: Artifact) -> Model:
        """A model from a verified artifact.

        Raises
        ------
        ArtifactIncomplete, ArtifactCorrupted
            Tensors are missing or do not fit together.
        """
        manifest = artifact.manifest
        metadata = SurrogateMetadata.read(manifest.metadata)
        modes = read_modes(metadata, artifact.tensors)
        if "22" not in modes:
            raise ArtifactIncomplete("The model has no (2, 2) mode.")
        return cls(metadata, metadata.describe(manifest.name, manifest.version, manifest.digest), modes)

    @property
    def description(self) -> ModelDescription:
        """Name, version, digest, ranges, band, accuracy."""
        return self._description

    def predict(
        self,
        frequencies: GridLike,
        parameters: ParametersWithExtrinsic,
        *,
        options: EvaluationOptions = DEFAULT_OPTIONS,
        dtype: DtypeName = "complex128",
    ) -> Polarizations:
        """One waveform: ``hp, hc``, complex ``(M,)`` in 1/Hz, on increasing frequencies in Hz.

        Raises
        ------
        InvalidParameters, OutOfDomain, InvalidFrequencies, OutOfBand
        """
        batch = self.predict_batch(frequencies, ParameterBatch.one(parameters), options=options, dtype=dtype)
        return Polarizations(
            plus=batch.plus[0],
            cross=batch.cross[0],
            status=batch.status,
            estimated_mismatch=batch.estimated_mismatch,
        )

    def predict_batch(
        self,
        frequencies: GridLike,
        batch: BatchLike,
        *,
        options: EvaluationOptions = DEFAULT_OPTIONS,
        dtype: DtypeName = "complex128",
    ) -> Polarizations:
        """N waveforms on one grid: ``hp, hc``, complex ``(N, M)`` in 1/Hz. Raises as :meth:`predict`."""
        return self.predict_factored(frequencies, batch, options=options, dtype=dtype).polarizations()

    def predict_factored(
        self,
        frequencies: GridLike,
        batch: BatchLike,
        *,
        options: EvaluationOptions = DEFAULT_OPTIONS,
        dtype: DtypeName = "complex128",
    ) -> Factored:
        """N waveforms before the polarisations are multiplied out. Raises as :meth:`predict`."""
        grid, coerced, status = self._check(frequencies, batch, options)
        check_dtype(dtype)
        valid = status == RowStatus.OK
        h, estimates = evaluate_strain(coerced.values[valid], grid, self._mode, options.alignment, dtype)
        plus, cross = _polarization_factors(coerced["inclination"], status)
        return Factored(
            h=_spread(h, valid), plus=plus, cross=cross, status=status, estimated_mismatch=_spread(estimates, valid)
        )

    def predict_amplitude_phase(
        self, frequencies: GridLike, batch: BatchLike, *, options: EvaluationOptions = DEFAULT_OPTIONS
    ) -> AmplitudePhase:
        """Amplitude (1/Hz) and continuous phase (rad); ``(M,)`` for one binary, ``(N, M)`` for a batch.

        Above the band both are zero. Raises as :meth:`predict`.
        """
        grid, coerced, status = self._check(frequencies, batch, options)
        valid = status == RowStatus.OK
        amplitude, phase, estimates = (
            _spread(array, valid)
            for array in evaluate_amplitude_phase(coerced.values[valid], grid, self._mode, options.alignment)
        )
        if isinstance(batch, ParametersWithExtrinsic):
            amplitude, phase = amplitude[0], phase[0]
        return AmplitudePhase(amplitude=amplitude, phase=phase, status=status, estimated_mismatch=estimates)

    def time_until_merger(self, frequency: float, parameters: ParametersWithExtrinsic) -> float:
        """Seconds from the moment the signal passes ``frequency`` (Hz) to the merger."""
        return time_until_merger(self, frequency, parameters)

    def warm_up(self) -> None:
        """Compile everything, so that the first request is as fast as the next."""
        frequencies = np.geomspace(*self._metadata.frequency_band, 8)
        self.predict(frequencies, self._typical())

    def self_check(self) -> bool:
        """Whether an evaluation gives the answer that was recorded when the model was published."""
        check = self._metadata.self_check
        if check is None:
            return bool(np.isfinite(self.predict(self._metadata.frequency_band, self._typical()).plus).all())
        answer = self.predict_amplitude_phase(np.array(check.frequencies), ParametersWithExtrinsic(**check.parameters))
        amplitude = np.allclose(answer.amplitude, check.amplitude, rtol=1e-9, atol=0.0)
        return amplitude and np.allclose(answer.phase, check.phase, rtol=1e-12, atol=1e-8)

    def _typical(self) -> ParametersWithExtrinsic:
        """A binary in the middle of the trained box."""
        values: dict[str, Any] = {"distance_mpc": 40.0, "inclination": 0.5}
        for entry in self._description.parameters:
            if entry.minimum is not None and entry.maximum is not None:
                values[entry.name] = 0.5 * (entry.minimum + entry.maximum)
        return ParametersWithExtrinsic(**values)

    def _check(self, frequencies: GridLike, batch: BatchLike, options: EvaluationOptions) -> Any:
        grid = self._grids.prepare(frequencies)
        coerced = ParameterBatch.coerce(batch)
        band = self._mode.mf_band
        status = row_status(coerced, grid.frequencies, self._description.parameters, band, options)
        return grid, coerced, status


def _spread(rows: NDArray[Any] | None, valid: NDArray[np.bool_]) -> Any:
    """Put the rows that were evaluated back into their places; the others are NaN."""
    if rows is None or valid.all():
        return rows
    spread = np.full((len(valid), *rows.shape[1:]), np.nan, dtype=rows.dtype)
    spread[valid] = rows
    return spread


def _polarization_factors(
    inclination: NDArray[np.float64], status: NDArray[np.uint8]
) -> tuple[NDArray[np.float64], NDArray[np.complex128]]:
    with np.errstate(invalid="ignore"):
        cosine = np.cos(inclination)
    cosine[status != RowStatus.OK] = np.nan
    cross = np.zeros(len(cosine), dtype=np.complex128)
    cross.imag = -cosine
    return 0.5 * (1.0 + cosine * cosine), cross
