"""A reduced-order quadrature: what likelihoods use of a basis, wherever it came from; and those that are shipped."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, fields
from importlib.resources import as_file, files
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._modes import QUADRUPOLE
from bnserve_inference._units import real_ranges
from bnserve_inference.roq._errors import BasisFileInvalid, BasisMismatch, PriorNotCovered
from bnserve_inference.roq._file import read_basis, write_basis
from bnserve_inference.roq._interpolant import Alignment, FloatArray, Interpolant, TabulatedInterpolant
from bnserve_protocol import Mode, UniformGrid, WaveformModel


@dataclass(frozen=True, eq=False)
class ReducedOrderQuadrature:
    """Empirical interpolants of h and abs(h)**2 on a uniform grid of frequencies.

    For every binary in the prior, h(f) = sum_j B_j(f) h(F_j) at the linear nodes F_j, and the same for abs(h)**2 at the
    quadratic nodes, so inner products with data and noise are sums over the nodes (Smith et al. 2016).

    Parameters
    ----------
    linear, quadratic
        The interpolants.
    f_min, f_max
        The band in Hz, both ends included in the grid.
    duration
        Of the data in seconds; the grid's step is its inverse.
    alignment
        How the waveforms are aligned, as in ``EvaluationOptions``.
    prior
        (lowest, highest) of every varied parameter: ``chirp_mass`` or ``total_mass``, ``mass_ratio``, ``chi_1``,
        ``chi_2``, ``lambda_1``, ``lambda_2``; a prior beyond is refused.
    model_name, model_version, model_digest
        The model it was built for; empty if unknown, as for files of other programs.
    diagnostics
        What the construction measured, as plain values.
    """

    linear: Interpolant
    quadratic: Interpolant
    f_min: float
    f_max: float
    duration: float
    alignment: Alignment = "merger"
    prior: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    model_name: str = ""
    model_version: str = ""
    model_digest: str = ""
    diagnostics: Mapping[str, Any] = field(default_factory=dict)

    @property
    def modes(self) -> tuple[Mode, ...]:
        """The modes that it holds: (2, 2) alone, whatever others its model has."""
        return (QUADRUPOLE,)

    @property
    def delta_f(self) -> float:
        """Step of the grid in Hz."""
        return 1.0 / self.duration

    @property
    def grid(self) -> UniformGrid:
        """The full grid: f_min, f_min + 1 / duration, ..., f_max."""
        return UniformGrid(f_min=self.f_min, f_max=self.f_max, delta_f=self.delta_f)

    @property
    def linear_nodes(self) -> FloatArray:
        """Increasing frequencies in Hz at which h is needed, ``(n_linear,)``; points of the full grid."""
        return self.linear.nodes

    @property
    def quadratic_nodes(self) -> FloatArray:
        """Increasing frequencies in Hz at which abs(h)**2 is needed, ``(n_quadratic,)``; points of the full grid."""
        return self.quadratic.nodes

    @property
    def tabulated(self) -> bool:
        """Whether rows come from a table, which may be any program's, and not from the model itself."""
        return isinstance(self.linear, TabulatedInterpolant) or isinstance(self.quadratic, TabulatedInterpolant)

    def linear_chunks(self, model: WaveformModel | None = None) -> Iterator[tuple[slice, NDArray[np.complex128]]]:
        """The linear rows B_j(f) piece by piece: ``(place in the full grid, (n_linear, piece) complex128)``.

        Parameters
        ----------
        model
            The one that the basis was built for; not needed for tabulated ones.

        Raises
        ------
        BasisMismatch
            Another model.
        """
        self.check_model(model)
        yield from self.linear.chunks(model, self.grid, self.alignment)

    def quadratic_chunks(self, model: WaveformModel | None = None) -> Iterator[tuple[slice, FloatArray]]:
        """The quadratic rows, as :meth:`linear_chunks`, ``(n_quadratic, piece)`` float64."""
        self.check_model(model)
        yield from self.quadratic.chunks(model, self.grid, self.alignment)

    def check_model(self, model: WaveformModel | None) -> None:
        """Refuse a model other than the one the basis was built for.

        Raises
        ------
        BasisMismatch
            It is another one.
        """
        if model is None or not self.model_digest or model.description.digest == self.model_digest:
            return
        theirs = model.description
        raise BasisMismatch(
            f"This basis was built for {self.model_name} {self.model_version} ({self.model_digest}), and the model "
            f"given is {theirs.name} {theirs.version} ({theirs.digest}). Use that model, or build a basis for this one."
        )

    def check_prior(self, ranges: Mapping[str, tuple[float, float]]) -> None:
        """Refuse ranges that reach beyond the basis; parameters that it does not name are not its concern.

        Raises
        ------
        PriorNotCovered
            Names every parameter that is not covered.
        AnalysisInvalid
            Ranges that are none.
        """
        gaps = [
            f"'{name}' needs {lowest:.10g} to {highest:.10g}, the basis has {least:.10g} to {most:.10g}"
            for name, (lowest, highest) in real_ranges(ranges).items()
            for least, most in [self.prior.get(name, (-math.inf, math.inf))]
            if not (least <= lowest and highest <= most)
        ]
        if gaps:
            raise PriorNotCovered(
                f"The basis does not cover the prior: {'; '.join(gaps)}. Narrow the prior, or build a wider basis."
            )

    def save(self, path: Path | str) -> None:
        """Write the compact file of a basis of waveforms: some megabytes, read by :meth:`load`.

        Raises
        ------
        BasisFileInvalid
            A tabulated basis, which has no compact form.
        BasisUnwritable
            No room, or no permission.
        """
        write_basis(path, {entry.name: getattr(self, entry.name) for entry in fields(self)})

    @classmethod
    def load(cls, path: Path | str) -> ReducedOrderQuadrature:
        """Read a compact file.

        Raises
        ------
        BasisFileInvalid
            Not there, not such a file, or a damaged one.
        """
        return cls(**read_basis(path))


def save_basis(path: Path | str, basis: ReducedOrderQuadrature) -> None:
    """As :meth:`ReducedOrderQuadrature.save`."""
    basis.save(path)


def load_basis(path: Path | str) -> ReducedOrderQuadrature:
    """As :meth:`ReducedOrderQuadrature.load`."""
    return ReducedOrderQuadrature.load(path)


def shipped_bases() -> list[str]:
    """Names of the bases that come with the package; ``configs/roq_NAME.toml`` is what each was built from."""
    folder = files("bnserve_inference") / "bases"
    return sorted(entry.name.removesuffix(".h5") for entry in folder.iterdir() if entry.name.endswith(".h5"))


def load_shipped_basis(name: str) -> ReducedOrderQuadrature:
    """One of :func:`shipped_bases`, such as ``"gw170817_fine"``.

    Raises
    ------
    BasisFileInvalid
        No such basis; the message lists those there are.
    """
    if name not in shipped_bases():
        raise BasisFileInvalid(
            f"No basis '{str(name)[:40]}' comes with the package; there are {', '.join(shipped_bases())}. Build your "
            "own with bnserve roq build, and read its file with load_basis."
        )
    with as_file(files("bnserve_inference") / "bases" / f"{name}.h5") as path:
        return load_basis(path)
