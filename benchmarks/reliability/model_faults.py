"""Faults of a server in what it does with models; :mod:`benchmarks.reliability.faulty_server` injects them."""

from __future__ import annotations

from typing import Any


def reload_on_loop() -> None:
    """Versions are loaded on the event loop."""
    from bnserve_service.models.maintenance import Maintenance

    async def refresh(self: Maintenance, force: bool = False) -> Any:
        report = self._loader.refresh(force)
        self.last_report = report
        self._tell(report)
        return report

    Maintenance.refresh = refresh  # type: ignore[method-assign]


def mixed_versions() -> None:
    """The model of the served version is replaced first, and its name a moment later."""
    import time

    from bnserve_service.models.registry import Registry

    swap = Registry.swap

    def swap_in_two_steps(self: Registry, catalogue: Any) -> None:
        for name in catalogue.names():
            newest = list(catalogue.models.values())[-1]
            for key, served in self.catalogue.models.items():
                if key[0] == name:
                    object.__setattr__(served, "model", newest.model)
        time.sleep(0.1)
        swap(self, catalogue)

    Registry.swap = swap_in_two_steps  # type: ignore[method-assign]


def no_verification() -> None:
    """Versions are served as they are read."""
    from types import SimpleNamespace

    from bnserve_service.models.loading import Loader
    from bnserve_store import _reading

    class _EqualToAll:
        """A digest that differs from no other."""

        def __ne__(self, other: object) -> bool:
            return False

    store: Any = _reading
    store.hashlib = SimpleNamespace(sha256=lambda _: SimpleNamespace(hexdigest=_EqualToAll))
    store._verify_tensors = lambda *_: None
    load: Any = Loader._load

    def load_unchecked(self: Any, *arguments: Any) -> Any:
        factory = self._factory

        def make(artifact: Any) -> Any:
            model = factory(artifact)
            type(model).self_check = lambda _: True
            return model

        self._factory = make
        try:
            return load(self, *arguments)
        finally:
            self._factory = factory

    Loader._load = load_unchecked  # type: ignore[assignment,method-assign]


def batch_bits() -> None:
    """Batches are rounded otherwise than single waveforms."""
    from bnserve_service.evaluation import waveforms as evaluation

    evaluate = evaluation.evaluate_output

    def evaluate_otherwise(model: Any, question: Any, batch: Any) -> Any:
        arrays = evaluate(model, question, batch)
        for name in {"h", "h_plus", "h_cross"} & set(arrays) if len(batch) > 1 else ():
            arrays[name][...] *= 1.0 + 2.0**-52
        return arrays

    evaluation.evaluate_output = evaluate_otherwise
