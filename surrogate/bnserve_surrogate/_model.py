"""The local waveform model."""

from __future__ import annotations

import operator
import os
from typing import Any, NamedTuple, Self, overload

import numpy as np
from numpy.typing import DTypeLike, NDArray

from bnserve_protocol import (
    DEFAULT_OPTIONS,
    AmplitudePhase,
    BatchLike,
    Derivatives,
    EvaluationOptions,
    Factored,
    GridLike,
    InvalidRequest,
    ManifestModel,
    ModelDescription,
    Modes,
    ParameterBatch,
    ParametersWithExtrinsic,
    Polarizations,
    RunManifest,
    TimeSeries,
    check_dtype,
    check_options,
    predict_time_domain,
    the_mode,
    time_until_merger,
)
from bnserve_store import Artifact, ModelStore
from bnserve_surrogate._artifact import MODES, SurrogateMetadata
from bnserve_surrogate._differentiation import Pullback, mode_derivatives, mode_pullback
from bnserve_surrogate._environment import describe_run
from bnserve_surrogate._evaluator import Evaluator
from bnserve_surrogate._pinning import version_with_digest
from bnserve_surrogate._precessing import precessing_polarizations
from bnserve_surrogate._tensors import read_modes
from bnserve_surrogate.kernel import KernelModes, Output


class _Origin(NamedTuple):
    """What finds the artifact of a model again in another process, beside its name, version and digest."""

    store: ModelStore | None
    """None for the models that ship with the package, wherever it is installed there."""
    threads: int


class Model:
    """A trained surrogate, evaluated in this process.

    Satisfies :class:`bnserve_protocol.WaveformModel`; instances are immutable, safe to share between threads, and
    release the GIL while they compute. A row's bits do not depend on the batch or thread it is evaluated in.

    A model from a store (:meth:`load`, :meth:`default`) can be pickled and sent to other processes: it travels as
    store, name, version and digest, without its weights, and is loaded again there, as the very same artifact or not
    at all. One that was made in memory (:meth:`from_artifact`) refuses to be pickled. A copy of a model is the model.

    Parameters
    ----------
    metadata
        What the manifest says.
    description
        Name, version, digest.
    modes
        The kernel arrays of every mode.
    threads
        Among how many threads a large batch is divided; the bits do not depend on it.
    """

    quick_work = 2**13
    """Rows times (frequencies + 1000) that are evaluated in less than 100 us: a server need not hand them to a
    thread."""

    precesses = True
    """Whether spins in the orbital plane count; a server does not hand them to a model that does not say so."""

    def __init__(
        self,
        metadata: SurrogateMetadata,
        description: ModelDescription,
        modes: KernelModes,
        threads: int = 1,
    ) -> None:
        self._metadata = metadata
        threads = _checked(threads)
        self._description = description
        self._evaluator = Evaluator(modes, description.parameters, metadata.total_mass[0], threads)
        self._origin: _Origin | None = None

    @classmethod
    def default(cls, *, threads: int = 1) -> Model:
        """The model called ``default``, which ships with the package: 5 to 2048 Hz."""
        return cls.load("default", threads=threads)

    @classmethod
    def load(
        cls,
        name: str,
        version: str = "stable",
        store: str | os.PathLike[str] | ModelStore | None = None,
        *,
        digest: str | None = None,
        threads: int = 1,
    ) -> Model:
        """A model from a store.

        Parameters
        ----------
        name
            Such as ``"default"``.
        version
            A version or a label.
        store
            A directory or a store; None for the models that ship with the package.
        digest
            That of the artifact it must be, ``"sha256:..."``, whatever a label stands for now; a ``version`` that is
            not a label must be the one with this digest.
        threads
            Among how many threads a large batch is divided.

        Raises
        ------
        ModelUnknown, StoreUnknown, ArtifactError
            There is no such model or version, no such store, or the artifact is damaged.
        InvalidRequest
            ``threads`` is no positive number of threads, ``digest`` no digest or ``store`` none.
        DigestUnknown
            No version of this model has the ``digest``.
        """
        if store is not None and not isinstance(store, ModelStore):
            store = ModelStore(store)
        there = ModelStore.default() if store is None else store
        exact = version if digest is None else version_with_digest(there, name, version, digest)
        model = cls.from_artifact(there.load(name, exact), threads=threads)
        model._origin = _Origin(store, threads)
        return model

    @classmethod
    def from_artifact(cls, artifact: Artifact, *, threads: int = 1) -> Model:
        """A model from a verified artifact.

        Raises
        ------
        ArtifactIncomplete, ArtifactCorrupted
            Tensors are missing or do not fit together.
        """
        manifest = artifact.manifest
        metadata = SurrogateMetadata.read(manifest.metadata)
        modes = read_modes(metadata, artifact.tensors)
        description = metadata.describe(manifest.name, manifest.version, manifest.digest)
        return cls(metadata, description, modes, threads)

    @property
    def description(self) -> ModelDescription:
        """Name, version, digest, ranges, band, accuracy."""
        return self._description

    def manifest(self) -> RunManifest:
        """What the appendix of a paper needs: this model, the programs and the processor, with a digest of it all."""
        own = self._description
        return describe_run([ManifestModel(name=own.name, version=own.version, digest=own.digest)])

    def predict(
        self,
        frequencies: GridLike,
        parameters: ParametersWithExtrinsic,
        *,
        options: EvaluationOptions = DEFAULT_OPTIONS,
        dtype: DTypeLike = "complex128",
    ) -> Polarizations:
        """One waveform: ``hp, hc``, complex ``(M,)`` in 1/Hz, on increasing frequencies in Hz.

        ``dtype`` is ``"complex128"`` or ``"complex64"``, which has a relative error of 2.5e-8 and half the size. Strain
        is so small (1e-24 1/Hz) that squares of ``complex64`` underflow in single precision: ``(abs(h) ** 2).sum()`` is
        too small or zero. Convert to ``complex128``, or multiply by 1e22, before squaring.

        Raises
        ------
        InvalidParameters
            A parameter is missing, unknown, no number, or too large or small to be evaluated.
        OutOfDomain
            One is outside its trained range.
        InvalidFrequencies
            They are not positive and increasing.
        OutOfBand
            They reach beyond the band, and the options forbid it.
        """
        if type(frequencies) is np.ndarray and type(parameters) is ParametersWithExtrinsic:
            answer = self._evaluator.one(frequencies, parameters, options, dtype)
            if answer is not None:
                return answer
        batch = self.predict_batch(frequencies, ParameterBatch.one(parameters), options=options, dtype=dtype)
        return Polarizations(
            plus=batch.plus[0], cross=batch.cross[0], status=batch.status, estimated_mismatch=batch.estimated_mismatch
        )

    def predict_batch(
        self,
        frequencies: GridLike,
        batch: BatchLike,
        *,
        options: EvaluationOptions = DEFAULT_OPTIONS,
        dtype: DTypeLike = "complex128",
    ) -> Polarizations:
        """N waveforms on one grid: ``hp, hc``, complex ``(N, M)`` in 1/Hz. ``dtype`` and errors as :meth:`predict`.

        Binaries with spins in the orbital plane precess, and need a ``reference_frequency`` in the options
        (``docs/explanations/precession.md``).
        """
        precision, coerced = check_dtype(dtype), ParameterBatch.coerce(batch)
        if coerced.in_plane is not None:
            return precessing_polarizations(self._evaluator, frequencies, coerced, options, precision)
        kind = Output.POLARIZATIONS if precision == "complex128" else Output.POLARIZATIONS_SINGLE
        answer = self._evaluator.batch(frequencies, coerced, options, kind)
        return Polarizations(
            plus=answer.first, cross=answer.second, status=answer.status, estimated_mismatch=answer.estimates
        )

    def predict_modes(
        self,
        frequencies: GridLike,
        batch: BatchLike,
        *,
        options: EvaluationOptions = DEFAULT_OPTIONS,
        dtype: DTypeLike = "complex128",
    ) -> Modes:
        """N waveforms by their modes, ``h`` complex ``(N, L, M)`` in 1/Hz. ``dtype`` and errors as :meth:`predict`."""
        answer = self._evaluator.batch(frequencies, batch, options, _strain(dtype))
        one = answer.first.ndim == 2
        return Modes(
            modes=options.modes or self._evaluator.modes,
            h=answer.first[:, None] if one else answer.first,
            plus=answer.plus[:, None] if one else answer.plus,
            cross=answer.cross[:, None] if one else answer.cross,
            status=answer.status,
            estimated_mismatch=answer.estimates,
        )

    def predict_derivatives(
        self, frequencies: GridLike, batch: BatchLike, *, options: EvaluationOptions = DEFAULT_OPTIONS
    ) -> Derivatives:
        """N waveforms by their modes, with the derivatives of each: exact ones, of what :meth:`predict_modes` gives.

        With respect to mass ratio, tides, spins and total mass, complex ``(N, L, 6, M)``; its
        ``polarizations()`` has all ten parameters, and :func:`bnserve_protocol.coordinate_jacobian` other coordinates.
        Where tides are weaker than the least ones trained on (1.5) only the baseline changes with them. A step in
        Lambda across 1, below which a star has the quadrupole of a black hole, is no slope: to either side it has its
        own. Errors as :meth:`predict`.
        """
        check_options(options)
        return mode_derivatives(self._evaluator, frequencies, batch, options)

    def predict_pullback(
        self, frequencies: GridLike, batch: BatchLike, *, options: EvaluationOptions = DEFAULT_OPTIONS
    ) -> Pullback:
        """N waveforms by their modes, and what takes the gradient of a function of them back to the parameters, at a
        fraction of the price of their derivatives: see :meth:`Pullback.pull_back`. Errors as :meth:`predict`."""
        check_options(options)
        return mode_pullback(self._evaluator, frequencies, batch, options)

    def predict_factored(
        self,
        frequencies: GridLike,
        batch: BatchLike,
        *,
        options: EvaluationOptions = DEFAULT_OPTIONS,
        dtype: DTypeLike = "complex128",
    ) -> Factored:
        """N waveforms before the polarisations are multiplied out, of one mode. ``dtype`` and errors as
        :meth:`predict`."""
        check_options(options)
        the_mode(options, self._evaluator.modes)
        answer = self._evaluator.batch(frequencies, batch, options, _strain(dtype))
        one = answer.first.ndim == 2
        return Factored(
            h=answer.first if one else answer.first[:, 0],
            plus=answer.plus if one else answer.plus[:, 0],
            cross=answer.cross if one else answer.cross[:, 0],
            status=answer.status,
            estimated_mismatch=answer.estimates,
        )

    def predict_amplitude_phase(
        self, frequencies: GridLike, batch: BatchLike, *, options: EvaluationOptions = DEFAULT_OPTIONS
    ) -> AmplitudePhase:
        """Amplitude (1/Hz) and continuous phase (rad); ``(M,)`` for one binary, ``(N, M)`` for a batch.

        Above the band the amplitude is zero and the phase goes on as a straight line; that of m = 3 and 4 as a smooth
        one. Raises as :meth:`predict`.
        """
        answer = self._evaluator.batch(frequencies, batch, options, Output.AMPLITUDE_PHASE)
        amplitude, phase = answer.first, answer.second
        if isinstance(batch, ParametersWithExtrinsic):
            amplitude, phase = amplitude[0], phase[0]
        return AmplitudePhase(
            amplitude=amplitude, phase=phase, status=answer.status, estimated_mismatch=answer.estimates
        )

    @overload
    def time_until_merger(self, frequency: float, parameters: ParametersWithExtrinsic) -> float: ...
    @overload
    def time_until_merger(self, frequency: GridLike, parameters: BatchLike) -> float | NDArray[np.float64]: ...
    def time_until_merger(self, frequency: GridLike, parameters: BatchLike) -> float | NDArray[np.float64]:
        """Seconds from the moment that the (2, 2) mode passes ``frequency`` (Hz) to the merger.

        One frequency, or a vector in any order; one ``ParametersWithExtrinsic``, or a batch: a number, ``(M,)``,
        ``(N,)`` or ``(N, M)``, in one evaluation.

        Raises
        ------
        OutOfBand
            A frequency is above the band at the mass of a binary.
        """
        return time_until_merger(self, frequency, parameters)

    def predict_time_domain(
        self,
        parameters: BatchLike,
        *,
        sampling_rate: float = 8192.0,
        f_min: float | None = None,
        duration: float | None = None,
        options: EvaluationOptions = DEFAULT_OPTIONS,
    ) -> TimeSeries:
        """h_plus(t) and h_cross(t), real ``(T,)`` or ``(N, T)``, on a time axis; see
        :func:`bnserve_protocol.predict_time_domain`."""
        return predict_time_domain(
            self, parameters, sampling_rate=sampling_rate, f_min=f_min, duration=duration, options=options
        )

    def warm_up(self) -> None:
        """Compile everything, so that the first request is as fast as the next."""
        frequencies = np.geomspace(*self._metadata.frequency_band, 8)
        self.predict(frequencies, self.typical_binary())

    def typical_binary(self) -> ParametersWithExtrinsic:
        """A binary in the middle of the trained box, and of the masses that its ``frequency_band`` is for."""
        values: dict[str, Any] = {"distance_mpc": 40.0, "inclination": 0.5}
        for entry in self._description.parameters:
            if entry.minimum is not None and entry.maximum is not None:
                values[entry.name] = 0.5 * (entry.minimum + entry.maximum)
        values["total_mass"] = 0.5 * sum(self._metadata.total_mass)
        return ParametersWithExtrinsic(**values)

    def self_check(self) -> bool:
        """Whether an evaluation gives the answer that was recorded when the model was published."""
        check = self._metadata.self_check
        if check is None:
            return bool(np.isfinite(self.predict(self._metadata.frequency_band, self.typical_binary()).plus).all())
        f, binary = np.array(check.frequencies), ParametersWithExtrinsic(**check.parameters)
        answer = self.predict_amplitude_phase(f, binary, options=EvaluationOptions(modes=((2, 2),)))
        for name, expected in check.amplitudes.items():
            mode = EvaluationOptions(modes=(MODES[name],))
            if not np.allclose(abs(self.predict_factored(f, binary, options=mode).h), expected, rtol=1e-9, atol=0.0):
                return False
        amplitude = np.allclose(answer.amplitude, check.amplitude, rtol=1e-9, atol=0.0)
        return amplitude and np.allclose(answer.phase, check.phase, rtol=1e-12, atol=1e-8)

    def __copy__(self) -> Self:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        if self._origin is None:
            raise InvalidRequest(
                f"The model '{self._description.name}' was made in memory and cannot be sent to another process, "
                "because weights do not travel. Publish it in a store and load it from there: Model.load(name, "
                "store=...)."
            )
        own = self._description
        return _load_again, (type(self), own.name, own.version, own.digest, *self._origin)


def _strain(dtype: DTypeLike) -> Output:
    return Output.STRAIN if check_dtype(dtype) == "complex128" else Output.STRAIN_SINGLE


def _checked(threads: int) -> int:
    try:
        count = operator.index(threads)
    except TypeError:
        count = 0
    if count < 1:
        raise InvalidRequest(f"'threads' must be a whole number of at least 1; got {threads!r}.")
    return count


def _load_again(
    cls: type[Model], name: str, version: str, digest: str, store: ModelStore | None, threads: int
) -> Model:
    """A model that was pickled; the very same artifact, or an error."""
    return cls.load(name, version, store, digest=digest, threads=threads)
