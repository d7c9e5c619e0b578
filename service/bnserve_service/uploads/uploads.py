"""All that callers have uploaded to a server."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Self

from bnserve_service.settings import Settings
from bnserve_service.telemetry.metrics import Metrics
from bnserve_service.uploads.analyses import AnalysisStore
from bnserve_service.uploads.grids import GridStore
from bnserve_service.uploads.networks import NetworkStore
from bnserve_service.uploads.stores import Kind, UploadStore


@dataclass(frozen=True, slots=True)
class Uploads:
    """The stores of one server, which several of its parts look into."""

    grids: GridStore
    analyses: AnalysisStore
    networks: NetworkStore

    @classmethod
    def of(cls, settings: Settings, shared: Path | None) -> Self:
        """Those with the limits of the settings; parameters as of the stores."""
        return cls(GridStore(settings, shared), AnalysisStore(settings, shared), NetworkStore(settings, shared))

    @property
    def by_kind(self) -> dict[Kind, UploadStore[Any]]:
        """Every one of them."""
        return {store.kind: store for store in (self.grids, self.analyses, self.networks)}

    def tidy(self) -> None:
        """Give back the memory of what another worker has dropped."""
        for store in self.by_kind.values():
            store.tidy()

    def watch(self, metrics: Metrics) -> None:
        """Show how much is kept."""
        grids, analyses, networks = self.grids, self.analyses, self.networks
        metrics.watch("bnserve_grids_bytes", "Memory of uploaded grids", lambda: grids.stored_bytes, is_common=True)
        metrics.watch("bnserve_analyses", "Uploaded analyses", lambda: len(analyses), is_common=True)
        metrics.watch(
            "bnserve_analyses_bytes", "Memory of uploaded analyses", lambda: analyses.stored_bytes, is_common=True
        )
        metrics.watch("bnserve_networks", "Uploaded networks", lambda: len(networks), is_common=True)
        metrics.watch(
            "bnserve_networks_bytes", "Memory of uploaded networks", lambda: networks.stored_bytes, is_common=True
        )
