"""The asynchronous remote model."""

from __future__ import annotations

from collections.abc import Sequence
from typing import overload

import numpy as np
from numpy.typing import DTypeLike, NDArray

from bnserve_client._asynchronous import AsyncConnections
from bnserve_client._likelihoods import AsyncLikelihood
from bnserve_client._pinned import Pinned, connecting
from bnserve_client._settings import Settings, Token, TokenLike, settings_from
from bnserve_client._transport_factory import AsyncTransportLike, TransportFactory
from bnserve_client._trust import VerifyLike
from bnserve_client._waveforms import ConnectedModel
from bnserve_protocol import (
    DEFAULT_FORECAST,
    DEFAULT_OPTIONS,
    AmplitudePhase,
    Analysis,
    BatchLike,
    Derivatives,
    DescribesNetwork,
    EvaluationOptions,
    Factored,
    Forecast,
    ForecastOptions,
    GridLike,
    InvalidRows,
    LikelihoodBatchLike,
    Modes,
    ParametersWithExtrinsic,
    Polarizations,
    RunManifest,
    SignalToNoise,
    TimeSeries,
)


class AsyncModel(ConnectedModel):
    """As :class:`.Model`, for asyncio: every evaluation is awaited.

    May be used from several event loops, which do not share connections; :meth:`close` closes those of its own.
    """

    def __init__(self, settings: Settings, pinned: Pinned, factory: TransportFactory | None = None) -> None:
        super().__init__(settings, pinned, factory)
        self._connections = AsyncConnections(factory, settings.verify)

    @classmethod
    async def connect(
        cls,
        address: str | Sequence[str],
        name: str = "default",
        *,
        version: str = "stable",
        digest: str | None = None,
        token: TokenLike = None,
        timeout: float = 300.0,
        silence: float = 30.0,
        retries: int | None = None,
        parallel: int = 2,
        chunk_samples: int = 2**21,
        progress: bool = False,
        transport: AsyncTransportLike | None = None,
        verify: VerifyLike = True,
    ) -> AsyncModel:
        """Find a model on a service; parameters and errors are those of :meth:`.Model.connect`."""
        settings = settings_from(
            address, progress, token=Token(token), timeout=timeout, silence=silence, retries=retries, parallel=parallel,
            chunk_samples=chunk_samples, resolve=transport is None, verify=verify,
        )  # fmt: skip
        factory = None if transport is None else TransportFactory(transport)
        connections = AsyncConnections(factory, settings.verify)
        try:
            pinned = await connections.run(connecting(settings, name, version, digest))
        except BaseException:
            await connections.close()
            raise
        model = cls(settings, pinned, factory)
        model._connections = connections
        return model

    async def manifest(self) -> RunManifest:
        """What the appendix of a paper needs; see :meth:`.Model.manifest`."""
        return await self._connections.run(self._remote.evaluator.session.manifest())

    async def predict(
        self,
        frequencies: GridLike,
        parameters: ParametersWithExtrinsic,
        *,
        options: EvaluationOptions = DEFAULT_OPTIONS,
        dtype: DTypeLike = "complex128",
    ) -> Polarizations:
        """One waveform; see :meth:`.Model.predict`."""
        return await self._connections.run(self._remote.predict(frequencies, parameters, options, dtype))

    async def predict_batch(
        self,
        frequencies: GridLike,
        batch: BatchLike,
        *,
        options: EvaluationOptions = DEFAULT_OPTIONS,
        dtype: DTypeLike = "complex128",
    ) -> Polarizations:
        """N waveforms on one grid; see :meth:`.Model.predict_batch`."""
        return await self._connections.run(self._remote.predict_batch(frequencies, batch, options, dtype))

    async def predict_modes(
        self,
        frequencies: GridLike,
        batch: BatchLike,
        *,
        options: EvaluationOptions = DEFAULT_OPTIONS,
        dtype: DTypeLike = "complex128",
    ) -> Modes:
        """N waveforms by their modes; see :meth:`.Model.predict_modes`."""
        return await self._connections.run(self._remote.predict_modes(frequencies, batch, options, dtype))

    async def predict_derivatives(
        self, frequencies: GridLike, batch: BatchLike, *, options: EvaluationOptions = DEFAULT_OPTIONS
    ) -> Derivatives:
        """N waveforms by their modes with derivatives; see :meth:`.Model.predict_derivatives`."""
        return await self._connections.run(self._remote.predict_derivatives(frequencies, batch, options))

    async def predict_factored(
        self,
        frequencies: GridLike,
        batch: BatchLike,
        *,
        options: EvaluationOptions = DEFAULT_OPTIONS,
        dtype: DTypeLike = "complex128",
    ) -> Factored:
        """N waveforms before the polarisations are multiplied out; see :meth:`.Model.predict_factored`."""
        return await self._connections.run(self._remote.predict_factored(frequencies, batch, options, dtype))

    async def predict_amplitude_phase(
        self, frequencies: GridLike, batch: BatchLike, *, options: EvaluationOptions = DEFAULT_OPTIONS
    ) -> AmplitudePhase:
        """Amplitude and phase; see :meth:`.Model.predict_amplitude_phase`."""
        return await self._connections.run(self._remote.predict_amplitude_phase(frequencies, batch, options))

    @overload
    async def time_until_merger(self, frequency: float, parameters: ParametersWithExtrinsic) -> float: ...
    @overload
    async def time_until_merger(self, frequency: GridLike, parameters: BatchLike) -> float | NDArray[np.float64]: ...
    async def time_until_merger(self, frequency: GridLike, parameters: BatchLike) -> float | NDArray[np.float64]:
        """Seconds from frequencies to the merger; see :meth:`.Model.time_until_merger`."""
        return await self._connections.run(self._remote.time_until_merger(frequency, parameters))

    async def predict_time_domain(
        self,
        parameters: BatchLike,
        *,
        sampling_rate: float = 8192.0,
        f_min: float | None = None,
        duration: float | None = None,
        options: EvaluationOptions = DEFAULT_OPTIONS,
    ) -> TimeSeries:
        """h_plus(t) and h_cross(t) on a time axis; see :meth:`.Model.predict_time_domain`."""
        how = {"sampling_rate": sampling_rate, "f_min": f_min, "duration": duration, "options": options}
        return await self._connections.run(self._remote.predict_time_domain(parameters, **how))

    async def forecast(
        self, network: DescribesNetwork, samples: LikelihoodBatchLike, options: ForecastOptions = DEFAULT_FORECAST
    ) -> Forecast:
        """What a network of detectors would measure of N binaries; see :meth:`.Model.forecast`."""
        return await self._connections.run(self._remote.forecast(network, samples, options))

    async def signal_to_noise(
        self, network: DescribesNetwork, samples: LikelihoodBatchLike, options: ForecastOptions = DEFAULT_FORECAST
    ) -> SignalToNoise:
        """Optimal signal-to-noise ratios of N binaries; see :meth:`.Model.signal_to_noise`."""
        return await self._connections.run(self._remote.signal_to_noise(network, samples, options))

    async def likelihood(self, analysis: Analysis, *, invalid_rows: InvalidRows = "flag") -> AsyncLikelihood:
        """The likelihood of an analysis; see :meth:`.Model.likelihood`."""
        likelihood = AsyncLikelihood(self, analysis, invalid_rows)
        await self._connections.run(likelihood._introducing())
        return likelihood

    async def close(self) -> None:
        """Close the connections of this event loop."""
        await self._connections.close()

    async def __aenter__(self) -> AsyncModel:
        return self

    async def __aexit__(self, *_: object) -> None:
        await self.close()
