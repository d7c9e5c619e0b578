"""bilby's ``waveform_arguments``: which model, which band, whose zero points."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

from bnserve_client._chosen import ARGUMENTS, chosen_model, number, read_arguments, unknown_argument
from bnserve_client._lal_meaning import read_mode_array
from bnserve_client.bilby._zero_points import ZeroPoints
from bnserve_protocol import Mode, WaveformModel

OWN_ZERO_POINTS = "bnserve"
"""For ``waveform_approximant`` where a program insists on one."""
_ORDERS = ("pn_spin_order", "pn_tidal_order", "pn_phase_order", "pn_amplitude_order")
"""Of LAL's models; ours has none."""
_THEIRS = {"minimum_frequency", "maximum_frequency", "reference_frequency", "waveform_approximant", "mode_array",
           "catch_waveform_errors", *_ORDERS}  # fmt: skip
_GRIDS = {"frequencies", "frequency_nodes", "linear_indices", "quadratic_indices", "frequency_nodes_linear",
          "frequency_nodes_quadratic", "frequency_bin_edges", "fiducial"}  # fmt: skip
_KNOWN = _THEIRS.union(_GRIDS, ARGUMENTS)


class Choice(NamedTuple):
    """The model, its modes and the zero points that ``waveform_arguments`` ask for; hashable."""

    url: str | tuple[str, ...] | None
    model: str | None
    version: str
    digest: str | None
    timeout: float
    modes: tuple[Mode, ...] | None
    zero_points: ZeroPoints

    def find(self) -> WaveformModel:
        """The model; raises as :func:`chosen_model`."""
        return chosen_model(self.url, self.model, version=self.version, digest=self.digest, timeout=self.timeout)


def stated(arguments: Mapping[str, Any], name: str, default: float) -> float:
    """A number among ``waveform_arguments``; None, as programs leave it, is not stated.

    Raises
    ------
    InvalidRequest
        It is no number.
    """
    value = arguments.get(name)
    return default if value is None else number(name, value)


def read_choice(arguments: Mapping[str, Any]) -> Choice:
    """The choice among ``waveform_arguments``; what is not stated is as in bilby.

    Raises
    ------
    InvalidRequest
        A name that is none, a value that is no number, or what is no mode.
    """
    unknown = arguments.keys() - _KNOWN
    if unknown:
        raise unknown_argument(min(unknown), _KNOWN)
    modes = read_mode_array(arguments.get("mode_array"))
    orders = tuple(
        (name, int(number(name, arguments[name], "such as -1"))) for name in _ORDERS if arguments.get(name) is not None
    )
    approximant = arguments.get("waveform_approximant")
    if approximant == OWN_ZERO_POINTS:
        approximant = None
    zero_points = ZeroPoints(stated(arguments, "reference_frequency", 50.0), approximant, orders)
    return Choice(*read_arguments(arguments), modes, zero_points)
