"""The vocabulary of bnserve: parameters, grids, results, errors. Imports nothing else of bnserve.

What travels is read and written by :mod:`bnserve_protocol.wire`.
"""

import typing
import warnings

from bnserve_protocol import _pickles as _pickles
from bnserve_protocol import wire
from bnserve_protocol._analyses import (
    Analysis,
    check_model_of,
    decode_analysis,
    encode_analysis,
    likelihood_nodes,
    likelihood_samples,
)
from bnserve_protocol._analysis_checks import check_arms, check_detector_names, check_location, check_settings
from bnserve_protocol._analysis_settings import (
    DEFAULT_ERROR_BOUND,
    AnalysisKind,
    AnalysisSettings,
    Calibration,
    DistanceMarginalisation,
    Response,
    TimeGrid,
    TimeMarginalisation,
    time_steps,
)
from bnserve_protocol._batches import BatchLike, ParameterBatch, check_names
from bnserve_protocol._constants import MEGAPARSEC_SECONDS, SOLAR_MASS_SECONDS
from bnserve_protocol._conversion import convert
from bnserve_protocol._derivative_coordinates import COORDINATES, DERIVATIVE_NAMES, coordinate_jacobian
from bnserve_protocol._derivatives import Derivatives
from bnserve_protocol._detector_frame import DetectorFrame
from bnserve_protocol._errors import (
    ERRORS_BY_CODE,
    AccessDenied,
    AnalysisInvalid,
    AnalysisUnknown,
    AnswerCorrupted,
    ArtifactCorrupted,
    ArtifactError,
    ArtifactIncomplete,
    BnserveError,
    ConnectionFailed,
    DeadlineExceeded,
    DigestUnknown,
    Draining,
    FieldError,
    Forbidden,
    GridUnknown,
    InternalError,
    InvalidFrequencies,
    InvalidParameters,
    InvalidRequest,
    ModelLoading,
    ModelUnknown,
    NetworkUnknown,
    NotAcceptable,
    NotBnserve,
    NotFound,
    OutOfBand,
    OutOfDomain,
    Overloaded,
    PathUnknown,
    QuotaExceeded,
    SchemaUnknown,
    StoreUnknown,
    TooLarge,
    Unauthorized,
    Unavailable,
    UndecodableBody,
    UnsupportedMediaType,
    UntrustedAnswer,
    VersionExists,
)
from bnserve_protocol._forecasts import (
    DEFAULT_FORECAST,
    FORECAST_COORDINATES,
    SKY_NAMES,
    Forecast,
    ForecastOptions,
    SignalToNoise,
    forecast_batch,
    from_triangle,
    triangle,
)
from bnserve_protocol._given import NotNumbers, as_numbers, as_real_number, as_real_numbers
from bnserve_protocol._gradient_names import by_given_names
from bnserve_protocol._grids import GridLike, UniformGrid, as_frequencies, grid_digest, plain_grid
from bnserve_protocol._likelihood import (
    InvalidRows,
    Likelihood,
    LikelihoodCounts,
    LikelihoodValues,
    check_invalid_rows,
    refuse_rows,
)
from bnserve_protocol._likelihood_batches import LikelihoodBatch, LikelihoodBatchLike
from bnserve_protocol._likelihood_details import (
    DRAWN_NAMES,
    DetectorProducts,
    MarginalisedDraws,
    Seed,
    integrated_names,
    nothing_integrated,
    random_numbers,
)
from bnserve_protocol._likelihood_gradients import LikelihoodGradients, gradient_names
from bnserve_protocol._likelihood_parameters import LIKELIHOOD_NAMES, LikelihoodParameters
from bnserve_protocol._manifest import ManifestModel, ProcessorDescription, RunManifest
from bnserve_protocol._merger_time import MergerStencil, MergerTimes, time_until_merger
from bnserve_protocol._model import (
    Limits,
    ModelDescription,
    ModelIdentity,
    ParameterDescription,
    WaveformModel,
    check_model_digest,
)
from bnserve_protocol._modes import PHASE_AT_REFERENCE, Mode, turn_to_reference
from bnserve_protocol._nearest import nearest_name
from bnserve_protocol._networks import (
    MOST_DETECTORS,
    DescribesNetwork,
    DetectorNetwork,
    NetworkDetector,
    check_band,
    decode_network,
    forecast_work,
)
from bnserve_protocol._options import (
    DEFAULT_OPTIONS,
    DtypeName,
    EvaluationOptions,
    check_dtype,
    check_options,
    chosen_modes,
    plain_options,
    the_mode,
)
from bnserve_protocol._packages import PackageMissing, require
from bnserve_protocol._parameters import (
    IN_PLANE_NAMES,
    INTRINSIC_NAMES,
    PARAMETER_DEFAULTS,
    PARAMETER_NAMES,
    PARAMETER_UNITS,
    ParametersWithExtrinsic,
)
from bnserve_protocol._printable import printable
from bnserve_protocol._prior_checks import PRIOR_NAMES, check_prior
from bnserve_protocol._results import (
    AmplitudePhase,
    ComplexArray,
    Factored,
    Modes,
    Polarizations,
    RowStatus,
    TimeSeries,
)
from bnserve_protocol._sample_names import samples_of
from bnserve_protocol._tables import check_table, read_table
from bnserve_protocol._time_domain import predict_time_domain, time_domain_steps
from bnserve_protocol._version import __version__

__all__ = [
    "COORDINATES", "DEFAULT_ERROR_BOUND", "DEFAULT_FORECAST", "DEFAULT_OPTIONS", "DERIVATIVE_NAMES", "DRAWN_NAMES",
    "ERRORS_BY_CODE", "FORECAST_COORDINATES", "INTRINSIC_NAMES", "IN_PLANE_NAMES", "LIKELIHOOD_NAMES",
    "MEGAPARSEC_SECONDS", "MOST_DETECTORS", "PARAMETER_DEFAULTS", "PARAMETER_NAMES", "PARAMETER_UNITS",
    "PHASE_AT_REFERENCE", "PRIOR_NAMES", "SKY_NAMES", "SOLAR_MASS_SECONDS", "AccessDenied", "AmplitudePhase",
    "Analysis", "AnalysisInvalid", "AnalysisKind", "AnalysisSettings", "AnalysisUnknown", "AnswerCorrupted",
    "ArtifactCorrupted", "ArtifactError", "ArtifactIncomplete", "BatchLike", "BnserveError", "Calibration",
    "ComplexArray", "ConnectionFailed", "DeadlineExceeded", "Derivatives", "DescribesNetwork", "DetectorFrame",
    "DetectorNetwork", "DetectorProducts", "DigestUnknown", "DistanceMarginalisation", "Draining", "DtypeName",
    "EvaluationOptions", "Factored", "FieldError", "Forbidden", "Forecast", "ForecastOptions", "GridLike",
    "GridUnknown", "InternalError", "InvalidFrequencies", "InvalidParameters", "InvalidRequest", "InvalidRows",
    "Likelihood", "LikelihoodBatch", "LikelihoodBatchLike", "LikelihoodCounts", "LikelihoodGradients",
    "LikelihoodParameters", "LikelihoodValues", "Limits", "ManifestModel", "MarginalisedDraws", "MergerStencil",
    "MergerTimes", "Mode", "ModelDescription", "ModelIdentity", "ModelLoading", "ModelUnknown", "Modes",
    "NetworkDetector", "NetworkUnknown", "NotAcceptable", "NotBnserve", "NotFound", "NotNumbers", "OutOfBand",
    "OutOfDomain", "Overloaded", "PackageMissing", "ParameterBatch", "ParameterDescription", "ParametersWithExtrinsic",
    "PathUnknown", "Polarizations", "ProcessorDescription", "QuotaExceeded", "Response", "RowStatus", "RunManifest",
    "SchemaUnknown", "Seed", "SignalToNoise", "StoreUnknown", "TimeGrid", "TimeMarginalisation", "TimeSeries",
    "TooLarge", "Unauthorized", "Unavailable", "UndecodableBody", "UniformGrid", "UnsupportedMediaType",
    "UntrustedAnswer", "VersionExists", "WaveformModel", "__version__", "as_frequencies", "as_numbers",
    "as_real_number", "as_real_numbers", "by_given_names", "check_arms", "check_band", "check_detector_names",
    "check_dtype", "check_invalid_rows", "check_location", "check_model_digest", "check_model_of", "check_names",
    "check_options", "check_prior", "check_settings", "check_table", "chosen_modes", "convert", "coordinate_jacobian",
    "decode_analysis", "decode_network", "encode_analysis", "forecast_batch", "forecast_work", "from_triangle",
    "gradient_names", "grid_digest", "integrated_names", "likelihood_nodes", "likelihood_samples", "nearest_name",
    "nothing_integrated", "plain_grid", "plain_options", "predict_time_domain", "printable", "random_numbers",
    "read_table", "refuse_rows", "require", "samples_of", "the_mode", "time_domain_steps", "time_steps",
    "time_until_merger", "triangle", "turn_to_reference",
]  # fmt: skip  # each has a line of its own above

if not typing.TYPE_CHECKING:

    def __getattr__(name: str) -> typing.Any:
        """Names that have another, or that :mod:`bnserve_protocol.wire` has, since 0.2; for one version."""
        if name == "ShareExceeded":
            warnings.warn("ShareExceeded is QuotaExceeded.", DeprecationWarning, stacklevel=2)
            return QuotaExceeded
        if name not in wire.__all__:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        warnings.warn(f"Import {name} from bnserve_protocol.wire.", DeprecationWarning, stacklevel=2)
        return getattr(wire, name)
