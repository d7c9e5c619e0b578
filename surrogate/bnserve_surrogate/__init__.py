"""The waveform surrogate, evaluated locally: the same methods, results and errors as the remote model."""

from bnserve_protocol import (
    AmplitudePhase,
    EvaluationOptions,
    Factored,
    ParameterBatch,
    ParametersWithExtrinsic,
    Polarizations,
    RowStatus,
    UniformGrid,
)
from bnserve_surrogate._artifact import ModeMetadata, RatioMetadata, SelfCheck, SurrogateMetadata
from bnserve_surrogate._differentiation import Pullback
from bnserve_surrogate._environment import describe_run
from bnserve_surrogate._model import Model

__all__ = [
    "AmplitudePhase",
    "EvaluationOptions",
    "Factored",
    "ModeMetadata",
    "Model",
    "ParameterBatch",
    "ParametersWithExtrinsic",
    "Polarizations",
    "Pullback",
    "RatioMetadata",
    "RowStatus",
    "SelfCheck",
    "SurrogateMetadata",
    "UniformGrid",
    "describe_run",
]
