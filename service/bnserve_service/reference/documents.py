"""The structured answers of the metadata paths."""

from __future__ import annotations

import msgspec

from bnserve_protocol import ModelDescription, ModelIdentity, likelihood_nodes, likelihood_samples
from bnserve_service.models.loading import RefreshReport
from bnserve_service.models.registry import Catalogue, LoadedModel
from bnserve_service.settings import ServiceLimits
from bnserve_service.uploads.analyses import StoredAnalysis
from bnserve_service.uploads.networks import StoredNetwork


class ModelDocument(ModelDescription, frozen=True, kw_only=True):
    """A model's description, with what this service adds to it."""

    labels: dict[str, str]
    """Label to version."""
    versions: list[str]
    """All versions served here, oldest first."""
    limits: ServiceLimits


class ModelList(msgspec.Struct, frozen=True):
    """Every model served here, each by its stable version (or its newest, where no version is labelled stable)."""

    models: list[ModelDocument]


class GridDocument(msgspec.Struct, frozen=True):
    """An uploaded grid."""

    sha256: str
    frequencies: int


class ReloadDocument(msgspec.Struct, frozen=True):
    """What a look at the model stores has changed."""

    changed: bool
    loaded: list[ModelIdentity]
    dropped: list[ModelIdentity]
    failures: dict[str, str]
    """What was refused, by name and version, and why; what was served before is served still."""


def reload_document(report: RefreshReport) -> ReloadDocument:
    """Describe a look at the model stores."""
    return ReloadDocument(
        changed=report.changed, loaded=report.loaded, dropped=report.dropped, failures=report.failures
    )


class AnalysisDocument(msgspec.Struct, frozen=True):
    """An uploaded analysis; its data are not told."""

    sha256: str
    kind: str
    detectors: list[str]
    nodes: int
    """Frequencies at which the model is evaluated."""
    samples_per_row: int
    """Work of one log-likelihood, in samples: what the limits and the queue count."""
    stored_bytes: int
    model_digest: str | None
    """The only model it may be evaluated with, if there is one."""
    parameters: list[str]
    """What a sample has to say, all but what is integrated over; in this order they are an UM-Bridge input."""


def analysis_document(stored: StoredAnalysis) -> AnalysisDocument:
    """Describe an uploaded analysis."""
    settings = stored.analysis.settings
    return AnalysisDocument(
        sha256=stored.sha256,
        kind=settings.kind,
        detectors=list(settings.detectors),
        nodes=likelihood_nodes(stored.analysis),
        samples_per_row=likelihood_samples(stored.analysis),
        stored_bytes=stored.nbytes,
        model_digest=settings.model_digest,
        parameters=stored.parameters,
    )


class NetworkDocument(msgspec.Struct, frozen=True):
    """An uploaded network of detectors."""

    sha256: str
    detectors: list[str]
    f_min: float
    f_max: float
    trigger_time: float
    moving: bool
    stored_bytes: int


def network_document(stored: StoredNetwork) -> NetworkDocument:
    """Describe an uploaded network."""
    network = stored.description
    return NetworkDocument(
        sha256=stored.sha256,
        detectors=[detector.name for detector in network.detectors],
        f_min=network.f_min,
        f_max=network.f_max,
        trigger_time=network.trigger_time,
        moving=network.moving,
        stored_bytes=stored.nbytes,
    )


def model_document(loaded: LoadedModel, catalogue: Catalogue, limits: ServiceLimits) -> ModelDocument:
    """Describe one version of a model. What the store says about its identity counts."""
    identity = loaded.identity
    description = msgspec.structs.asdict(loaded.model.description)
    return ModelDocument(
        **(description | {"name": identity.name, "version": identity.version, "digest": identity.digest}),
        labels=dict(catalogue.labels.get(identity.name, {})),
        versions=catalogue.versions(identity.name),
        limits=limits,
    )


def model_list(catalogue: Catalogue, limits: ServiceLimits) -> ModelList:
    """Describe everything that is served."""
    stable = {loaded.identity.name: loaded for loaded in catalogue.defaults()}
    chosen = [stable.get(name) or catalogue.models[name, catalogue.versions(name)[-1]] for name in catalogue.names()]
    return ModelList([model_document(loaded, catalogue, limits) for loaded in chosen])
