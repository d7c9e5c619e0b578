"""Which model an analysis may be evaluated with."""

from __future__ import annotations

from bnserve_protocol._analyses import Analysis
from bnserve_protocol._answers import ModelIdentity
from bnserve_protocol._errors import AnalysisInvalid, FieldError
from bnserve_protocol._model import ModelDescription


def check_model_of(analysis: Analysis, model: ModelIdentity | ModelDescription) -> None:
    """Refuse to evaluate an analysis with another model than the one it is made for, if it is made for one.

    Raises
    ------
    AnalysisInvalid
    """
    wanted = analysis.settings.model_digest
    if wanted not in (None, model.digest):
        raise AnalysisInvalid(
            f"The analysis was made for the model {wanted}, and this is {model.name} {model.version} ({model.digest}). "
            "Use that model, or build the analysis again for this one.",
            errors=[FieldError(reason="made for another model", parameter="model_digest", value=model.digest)],
        )
