"""Whether this server should get traffic: loaded, warm, right, alive, not draining."""

from __future__ import annotations

import logging
import time
from collections.abc import Callable

from bnserve_protocol import BnserveError, Draining, ModelLoading, Overloaded, Unavailable
from bnserve_service.admission.control import Lifecycle
from bnserve_service.models.registry import LoadedModel, Registry

logger = logging.getLogger("bnserve.health")

STALE_CHECKS = 6.0
"""Missed self checks after which the last good one counts no more."""
LEAST_STALE_SECONDS = 10.0
"""However often it is checked: busy machines pause."""


class Health:
    """Answers the probes from memory, so that they are never shed, whatever the load.

    Parameters
    ----------
    registry, lifecycle:
        What is served, and whether the server is stopping.
    longest_evaluation:
        Seconds that the slowest worker has been busy.
    check_interval:
        Seconds between two calls of :meth:`check_models`.
    stuck_seconds:
        An evaluation that takes longer will not come back.
    missing:
        Says what this server cannot do without and has lost.
    """

    def __init__(
        self,
        registry: Registry,
        lifecycle: Lifecycle,
        longest_evaluation: Callable[[], float],
        check_interval: float,
        stuck_seconds: float,
        missing: Callable[[], BnserveError | None],
    ) -> None:
        self._missing = missing
        self._registry = registry
        self._lifecycle = lifecycle
        self._longest_evaluation = longest_evaluation
        self._stuck_seconds = stuck_seconds
        self._stale_after = max(STALE_CHECKS * check_interval, LEAST_STALE_SECONDS)
        self._wrong: dict[LoadedModel, str] = {}
        self._checked = time.monotonic()

    def check_models(self) -> None:
        """Evaluate every default model's stored example; what is wrong stays unready until it is right again."""
        wrong: dict[LoadedModel, str] = {}
        for loaded in self._registry.catalogue.defaults():
            try:
                if not loaded.model.self_check():
                    wrong[loaded] = "does not reproduce the answer stored with it"
            except Exception:
                logger.exception("the self check of %s failed", loaded.identity.name)
                wrong[loaded] = "fails its self check"
        self._wrong = wrong
        self._checked = time.monotonic()

    def reason_unready(self) -> BnserveError | None:
        """Why this server should not get traffic, or None."""
        if self._lifecycle.draining:
            return Draining("This server is shutting down.")
        missing = self._missing()
        if missing is not None:
            return missing
        if not self._registry.loaded:
            return ModelLoading("The models are being loaded.")
        if not self._registry.catalogue.models:
            return ModelLoading("No model could be loaded; the log and `bnserve models verify` say why.")
        if time.monotonic() - self._checked > self._stale_after:
            return Unavailable("The self check of the models has not run for too long.")
        if self._longest_evaluation() > self._stuck_seconds:
            return Overloaded("A worker does not come back from its evaluation.")
        for loaded, reason in self._wrong.items():
            return Unavailable(f"Model '{loaded.identity.name}' {reason}.")
        return None

    def reason_model_unready(self, name: str) -> BnserveError | None:
        """Why this model should not get traffic here, or None."""
        reason = self.reason_unready()
        if reason is not None:
            return reason
        try:
            self._registry.find(name)
        except BnserveError as error:
            return error
        return None
