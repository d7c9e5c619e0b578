"""Which model an analysis may be evaluated with."""

from __future__ import annotations

from bnserve_protocol._analyses import Analysis
from bnserve_protocol._errors import AnalysisInvalid, FieldError, InvalidRequest
from bnserve_protocol._model import ModelDescription, ModelIdentity


def check_model_of(analysis: Analysis, model: ModelIdentity | ModelDescription) -> None:
    """Refuse to evaluate an analysis with another model than the one it is made for, if it is made for one.

    Raises
    ------
    AnalysisInvalid
    InvalidRequest
        It is no analysis at all.
    """
    if not isinstance(analysis, Analysis):
        raise InvalidRequest(
            f"A likelihood is that of an Analysis; got {type(analysis).__name__}. full_analysis, roq_analysis and "
            "relative_binning_analysis of bnserve_inference build one."
        )
    wanted = analysis.settings.model_digest
    if wanted not in (None, model.digest):
        raise AnalysisInvalid(
            f"The analysis was made for the model {wanted}, and this is {model.name} {model.version} ({model.digest}). "
            "Use that model, or build the analysis again for this one.",
            errors=[FieldError(reason="made for another model", parameter="model_digest", value=model.digest)],
        )
