"""The synchronous remote model."""

from __future__ import annotations

from collections.abc import Sequence
from typing import overload

import numpy as np
from numpy.typing import DTypeLike, NDArray

from bnserve_client._blocking import Connections
from bnserve_client._likelihoods import Likelihood
from bnserve_client._pinned import Pinned, connecting
from bnserve_client._settings import Settings, Token, TokenLike, settings_from
from bnserve_client._transport_factory import TransportFactory, TransportLike
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


class Model(ConnectedModel):
    """A waveform model that is evaluated by a bnserve service; made by :meth:`connect`.

    Same methods, results (to the bit) and errors as ``bnserve_surrogate.Model``. The version that a label stood for
    when connecting stays for the life of the object, and every answer is checked to come from it, to be whole, and to
    belong to its question. Safe to share between threads, to use after a fork, and to pickle (connections are opened
    when they are needed). A context manager; after :meth:`close`, a call opens new connections.
    """

    def __init__(self, settings: Settings, pinned: Pinned, factory: TransportFactory | None = None) -> None:
        super().__init__(settings, pinned, factory)
        self._connections = Connections(factory, settings.verify)

    @classmethod
    def connect(
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
        transport: TransportLike | None = None,
        verify: VerifyLike = True,
    ) -> Model:
        """Find a model on a service.

        Parameters
        ----------
        address
            ``"http://host:8000"``, ``"https://host/prefix"`` or ``"unix:/path/to/socket"``; several replicas as a list
            or separated by commas: requests take turns, and one that fails is tried on another.
        name, version
            Which model; a label is resolved now, once.
        digest
            ``"sha256:..."``, as ``description.digest`` of an earlier run says it: every request names this digest, so
            that the answers come from this very artifact or not at all, whatever the label stands for by then.
            A ``version`` that is not a label must be the one with this digest.
        token
            Sent as ``Authorization: Bearer``: the token, a ``pathlib.Path`` of a file that holds it, or a module-level
            function that returns it. None for that of the environment variable ``BNSERVE_TOKEN``, where there is one,
            or of the file that ``BNSERVE_TOKEN_FILE`` names. A file or function is asked again when the service refuses
            the token. A pickled model holds the path or the function, never the token, and takes it from there; a token
            that was given itself is taken from the environment in other processes.
        timeout
            Seconds that one request may take with all its retries; more than 600 to outlive an outage of ten minutes.
        silence
            Seconds without a byte from the server after which an attempt has failed.
        retries
            How often a request is tried again (in the first contact at most 3 times); None for as often as fits into
            ``timeout``. Waiting times grow to 5 s, are jittered, and honour ``Retry-After``.
        parallel
            Chunks of one large batch that are under way at the same time.
        chunk_samples
            Rows times frequencies of a chunk (2**21 are 32 MiB); the service's limits may make it smaller.
        progress
            Show a progress bar for batches of several chunks (needs tqdm).
        transport
            An httpx client or transport, for authentication, proxies or TLS of your own, or for tests; or a function
            that makes one, which is needed where the model is pickled or used after a fork.
        verify
            Of ``https://``: True for the authorities that this machine trusts, or those in the file or folder that
            ``SSL_CERT_FILE`` or ``SSL_CERT_DIR`` names; the path of a PEM file or a folder for those in there; False
            for whoever answers, which protects nothing. With a ``transport``, that decides.

        Warns
        -----
        TokenInClear
            A token is sent to another machine over ``http://``.

        Raises
        ------
        InvalidRequest
            An argument that cannot be.
        ConnectionFailed, NotBnserve
            Nobody answers at the address, or something else.
        ModelUnknown, DigestUnknown
            The service has no such model or version; or not the one with this digest.
        Unauthorized
            The token is missing or wrong.
        """
        settings = settings_from(
            address, progress, token=Token(token), timeout=timeout, silence=silence, retries=retries, parallel=parallel,
            chunk_samples=chunk_samples, resolve=transport is None, verify=verify,
        )  # fmt: skip
        factory = None if transport is None else TransportFactory(transport)
        connections = Connections(factory, settings.verify)
        try:
            pinned = connections.run(connecting(settings, name, version, digest))
        except BaseException:
            connections.close()
            raise
        model = cls(settings, pinned, factory)
        model._connections = connections
        return model

    def manifest(self) -> RunManifest:
        """What the appendix of a paper needs: the models, programs, processor and limits of the service that answers.

        Raises
        ------
        Unavailable, AccessDenied, UntrustedAnswer
            No replica answers now, the token is refused, or what answers cannot be trusted.
        """
        return self._connections.run(self._remote.evaluator.session.manifest())

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
        InvalidParameters, OutOfDomain, InvalidFrequencies, OutOfBand
            As the local model.
        TooLarge, Unavailable, UntrustedAnswer, ModelUnknown, AccessDenied, InternalError
            What a service can add to that, after the retries.
        """
        return self._connections.run(self._remote.predict(frequencies, parameters, options, dtype))

    def predict_batch(
        self,
        frequencies: GridLike,
        batch: BatchLike,
        *,
        options: EvaluationOptions = DEFAULT_OPTIONS,
        dtype: DTypeLike = "complex128",
    ) -> Polarizations:
        """N waveforms on one grid: ``hp, hc``, complex ``(N, M)`` in 1/Hz. ``dtype`` and errors as :meth:`predict`."""
        return self._connections.run(self._remote.predict_batch(frequencies, batch, options, dtype))

    def predict_modes(
        self,
        frequencies: GridLike,
        batch: BatchLike,
        *,
        options: EvaluationOptions = DEFAULT_OPTIONS,
        dtype: DTypeLike = "complex128",
    ) -> Modes:
        """N waveforms by their modes, ``h`` complex ``(N, L, M)`` in 1/Hz. ``dtype`` and errors as :meth:`predict`."""
        return self._connections.run(self._remote.predict_modes(frequencies, batch, options, dtype))

    def predict_derivatives(
        self, frequencies: GridLike, batch: BatchLike, *, options: EvaluationOptions = DEFAULT_OPTIONS
    ) -> Derivatives:
        """N waveforms by their modes, with exact derivatives of each with respect to mass ratio, tides, spins and total
        mass, complex ``(N, L, 6, M)``; see :class:`bnserve_protocol.Derivatives`. Errors as :meth:`predict`, and
        InvalidRequest of a model that has none."""
        return self._connections.run(self._remote.predict_derivatives(frequencies, batch, options))

    def predict_factored(
        self,
        frequencies: GridLike,
        batch: BatchLike,
        *,
        options: EvaluationOptions = DEFAULT_OPTIONS,
        dtype: DTypeLike = "complex128",
    ) -> Factored:
        """N waveforms before the polarisations are multiplied out. ``dtype`` and errors as :meth:`predict`."""
        return self._connections.run(self._remote.predict_factored(frequencies, batch, options, dtype))

    def predict_amplitude_phase(
        self, frequencies: GridLike, batch: BatchLike, *, options: EvaluationOptions = DEFAULT_OPTIONS
    ) -> AmplitudePhase:
        """Amplitude (1/Hz) and continuous phase (rad); ``(M,)`` for one binary, ``(N, M)`` for a batch.

        Raises as :meth:`predict`.
        """
        return self._connections.run(self._remote.predict_amplitude_phase(frequencies, batch, options))

    @overload
    def time_until_merger(self, frequency: float, parameters: ParametersWithExtrinsic) -> float: ...
    @overload
    def time_until_merger(self, frequency: GridLike, parameters: BatchLike) -> float | NDArray[np.float64]: ...
    def time_until_merger(self, frequency: GridLike, parameters: BatchLike) -> float | NDArray[np.float64]:
        """Seconds from the moment that the (2, 2) mode passes ``frequency`` (Hz) to the merger.

        One frequency, or a vector in any order; one ``ParametersWithExtrinsic``, or a batch: a number, ``(M,)``,
        ``(N,)`` or ``(N, M)``, in one evaluation of the service.

        Raises
        ------
        OutOfBand
            A frequency is above the band at the mass of a binary.
        """
        return self._connections.run(self._remote.time_until_merger(frequency, parameters))

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
        :func:`bnserve_protocol.predict_time_domain`.
        """
        how = {"sampling_rate": sampling_rate, "f_min": f_min, "duration": duration, "options": options}
        return self._connections.run(self._remote.predict_time_domain(parameters, **how))

    def forecast(
        self, network: DescribesNetwork, samples: LikelihoodBatchLike, options: ForecastOptions = DEFAULT_FORECAST
    ) -> Forecast:
        """What a network of detectors would measure of N binaries: Fisher matrices made where the model is.

        As ``bnserve_inference.fisher.forecast``, to the bit; the network is uploaded wherever it is not known.

        Parameters
        ----------
        network
            A :class:`bnserve_protocol.DetectorNetwork`, or a ``bnserve_inference.fisher.Network``.
        samples
            The binaries, as a likelihood takes them, with distance and ``coalescence_time``.

        Raises
        ------
        AnalysisInvalid, InvalidRequest, InvalidParameters
            A network, options or binaries that are none, or a model without derivatives.
        TooLarge
            More detectors or modes than the service takes.
        """
        return self._connections.run(self._remote.forecast(network, samples, options))

    def signal_to_noise(
        self, network: DescribesNetwork, samples: LikelihoodBatchLike, options: ForecastOptions = DEFAULT_FORECAST
    ) -> SignalToNoise:
        """Optimal signal-to-noise ratios of N binaries alone, many times as fast; arguments and errors as of
        :meth:`forecast`."""
        return self._connections.run(self._remote.signal_to_noise(network, samples, options))

    def likelihood(self, analysis: Analysis, *, invalid_rows: InvalidRows = "flag") -> Likelihood:
        """The likelihood of an analysis, evaluated where the model is: eight bytes per sample travel back.

        The analysis is uploaded now, unless the service has it, and again whenever the service has it no more.

        Parameters
        ----------
        analysis
            Built by ``bnserve_inference``.
        invalid_rows
            ``"flag"``: rows outside the prior's or the model's range are -inf and counted. ``"error"``: they raise.

        Raises
        ------
        AnalysisInvalid
            Made for another model, or refused by the service.
        TooLarge
            Larger than the service takes.
        """
        likelihood = Likelihood(self, analysis, invalid_rows)
        self._connections.run(likelihood._introducing())
        return likelihood

    def close(self) -> None:
        """Close the connections."""
        self._connections.close()

    def __enter__(self) -> Model:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()
