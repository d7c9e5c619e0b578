"""A user's own function as a waveform generator."""

from __future__ import annotations

import hashlib
import importlib
import inspect
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from bnserve_surrogate.training.data.generators._interface import AmplitudePhasePair
from bnserve_surrogate.training.data.residuals import FloatArray
from bnserve_surrogate.training.errors import GeneratorUnknown


@dataclass(frozen=True)
class CallableGenerator:
    """Wraps ``function(theta, mf) -> (amplitude, psi)``, in the conventions of :class:`WaveformGenerator`.

    Any exception that the function raises loses that waveform, not the run. If it has the attributes ``phase_start``
    and ``check_box`` of that interface, they count.

    Parameters
    ----------
    function
        The user's function.
    label
        Name of the waveform model; by default the function's.
    release
        Version of the waveform model; by default a digest of the function's source text, so that data made by an edited
        function are not mistaken for those of the old one (what the function calls is not seen: give a version).
    """

    function: Callable[[FloatArray, FloatArray], AmplitudePhasePair]
    label: str | None = None
    release: str | None = None
    _source: str = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        # Kept from the beginning: in a worker process the source may not be found.
        object.__setattr__(self, "_source", _source_digest(self.function))

    @classmethod
    def from_path(cls, path: str, release: str | None = None) -> CallableGenerator:
        """The function at ``module:function``, imported; a class there is instantiated without arguments.

        Raises
        ------
        GeneratorUnknown
            The path cannot be imported, or what it names cannot be called.
        """
        module, separator, attribute = path.partition(":")
        if not (module and separator and attribute):
            raise GeneratorUnknown(f"A generator function is named as 'module:function'; got '{path}'.")
        try:
            found: Any = importlib.import_module(module)
            for part in attribute.split("."):
                found = getattr(found, part)
        except Exception as error:  # importing runs the user's module
            raise GeneratorUnknown(f"The generator function '{path}' cannot be imported: {error}.") from error
        function = found() if inspect.isclass(found) else found
        if not callable(function):
            raise GeneratorUnknown(f"'{path}' is not a function of (theta, mf).")
        return cls(function, label=path, release=release)

    @property
    def name(self) -> str:
        """The label, or the function's qualified name."""
        if self.label is not None:
            return self.label
        return str(getattr(self.function, "__qualname__", type(self.function).__qualname__))

    @property
    def version(self) -> str:
        """The version given, or a digest of the function's source."""
        return self.release if self.release is not None else self._source

    @property
    def settings(self) -> Mapping[str, str | float | None]:
        """Nothing beyond the version."""
        return {}

    @property
    def phase_start(self) -> float:
        """The function's, or 0: its signal's phase is not said to be zero anywhere."""
        return float(getattr(self.function, "phase_start", 0.0))

    def check_box(self, lower: FloatArray, upper: FloatArray) -> None:
        """The function's; without one, every box will do."""
        getattr(self.function, "check_box", lambda lower, upper: None)(lower, upper)

    def __call__(self, theta: FloatArray, mf: FloatArray) -> AmplitudePhasePair:
        """What the function returns."""
        return self.function(theta, mf)


def _source_digest(function: Callable[..., Any]) -> str:
    subject = function if inspect.isroutine(function) else type(function)
    try:
        text = inspect.getsource(subject)
    except (OSError, TypeError):
        return "unversioned"
    return "source-" + hashlib.sha256(text.encode()).hexdigest()[:16]
