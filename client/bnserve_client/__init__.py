"""The thin client of bnserve: a remote waveform model that looks like the local one.

::

    from bnserve_client import Model, ParametersWithExtrinsic

    model = Model.connect("http://host:8000", "default")
    hp, hc = model.predict(frequencies, ParametersWithExtrinsic.gw170817())

Every error is one of :mod:`bnserve_protocol`; those that a remote model adds to the local ones are re-exported here.
"""

import typing
import warnings

from bnserve_client._async_model import AsyncModel
from bnserve_client._likelihoods import AsyncLikelihood, Likelihood
from bnserve_client._model import Model
from bnserve_client._together import Together
from bnserve_client._trust import TokenInClear
from bnserve_protocol import (
    AmplitudePhase,
    Analysis,
    AnalysisInvalid,
    AnalysisUnknown,
    BnserveError,
    ConnectionFailed,
    DeadlineExceeded,
    DetectorFrame,
    DetectorNetwork,
    DigestUnknown,
    EvaluationOptions,
    Factored,
    Forecast,
    ForecastOptions,
    InvalidFrequencies,
    InvalidParameters,
    InvalidRequest,
    LikelihoodBatch,
    LikelihoodParameters,
    ModelDescription,
    ModelUnknown,
    NetworkDetector,
    NotBnserve,
    OutOfBand,
    OutOfDomain,
    ParameterBatch,
    ParametersWithExtrinsic,
    Polarizations,
    QuotaExceeded,
    RowStatus,
    RunManifest,
    SignalToNoise,
    TooLarge,
    Unauthorized,
    Unavailable,
    UniformGrid,
    UntrustedAnswer,
    __version__,
    convert,
)

__all__ = [
    "AmplitudePhase", "Analysis", "AnalysisInvalid", "AnalysisUnknown", "AsyncLikelihood", "AsyncModel", "BnserveError",
    "ConnectionFailed", "DeadlineExceeded", "DetectorFrame", "DetectorNetwork", "DigestUnknown", "EvaluationOptions",
    "Factored", "Forecast", "ForecastOptions", "InvalidFrequencies", "InvalidParameters", "InvalidRequest",
    "Likelihood", "LikelihoodBatch", "LikelihoodParameters", "Model", "ModelDescription", "ModelUnknown",
    "NetworkDetector", "NotBnserve", "OutOfBand", "OutOfDomain", "ParameterBatch", "ParametersWithExtrinsic",
    "Polarizations", "QuotaExceeded", "RowStatus", "RunManifest", "SignalToNoise", "Together", "TokenInClear",
    "TooLarge", "Unauthorized", "Unavailable", "UniformGrid", "UntrustedAnswer", "__version__", "convert",
]  # fmt: skip  # each has a line of its own above

if not typing.TYPE_CHECKING:

    def __getattr__(name: str) -> typing.Any:
        """A name that has another since 0.2, for one version."""
        if name != "ShareExceeded":
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        warnings.warn("ShareExceeded is QuotaExceeded.", DeprecationWarning, stacklevel=2)
        return QuotaExceeded
