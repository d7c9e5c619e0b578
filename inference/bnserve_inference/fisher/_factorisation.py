"""Calling the compiled factorisation on the signals of a network."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._detectors import Detector
from bnserve_inference._earth import sidereal_rate, sidereal_time
from bnserve_inference._modes import orders
from bnserve_inference._response import LIGHT_SPEED
from bnserve_inference.fisher._gauss import slopes
from bnserve_inference.fisher._network import Network
from bnserve_inference.fisher._nodes import Nodes
from bnserve_inference.fisher_kernel import load_factorisation
from bnserve_inference.fisher_kernel._layout import ARM, ARMS, COLUMNS, FACTORS, VECTORS, Argument, Sky, scratch_size
from bnserve_protocol import Derivatives, LikelihoodBatch, Mode, Modes
from bnserve_protocol.wire import address_of
from bnserve_surrogate.kernel import Workspace
from bnserve_surrogate.kernel._layout import LANES

Floats = NDArray[np.float64]


_workspace = Workspace(len(Argument))


class Factored(NamedTuple):
    """Of N binaries the triangles of the QR factorisation, ``(N, 13, 13)``, and squared signal-to-noise ratios,
    ``(N, D)``; NaN where a row was not evaluated.

    ``whitened``, ``(N, V, 13, 8)`` where it was asked for: the derivatives at V times eight nodes of a detector and
    order, before the delay of the whole network, real and imaginary parts in turn.
    """

    root: Floats
    squares: Floats
    whitened: Floats | None


class Factorisation:
    """Turns modes and their derivatives at nodes into what a Fisher matrix is the square of.

    Parameters
    ----------
    network, nodes
        Detectors, and where they are evaluated.
    modes
        Of the signals.
    """

    def __init__(self, network: Network, nodes: Nodes, modes: tuple[Mode, ...]) -> None:
        different = orders(modes)
        group_of = [different.index(order) for _, order in modes]
        with_curve = np.zeros((len(network.curves), 1 + len(network.noise)), np.int64)
        for line, curve in zip(with_curve, network.curves, strict=True):
            found = network.detectors_with(curve)
            line[0], line[1 : 1 + len(found)] = len(found), found
        f = nodes.frequencies[nodes.places]
        self._detectors, self._modes, self._groups = len(network.noise), len(modes), len(different)
        self._held = [
            np.array([sidereal_time(network.trigger_time)[0], sidereal_rate(network.trigger_time)]),
            np.array([_arms(site) for site in network.sites]),
            np.array([site.location for site in network.sites]) / LIGHT_SPEED,
            with_curve,
            np.array(group_of, np.int64),
            np.array([group_of.index(group) for group in range(self._groups)], np.int64),
            np.array(different, np.int64),
            f,
            np.sqrt(4.0 * nodes.weights),
            np.ascontiguousarray(nodes.places, np.int64),
            np.ascontiguousarray(nodes.curve, np.int64),
            nodes.apart.astype(np.int64),
            np.ascontiguousarray((slopes(np.log(f)) / (-2.0 * np.pi * f[:, :, None])).swapaxes(1, 2)),
        ]
        counts = self._modes, self._groups, len(nodes.frequencies), len(f), self._detectors, int(network.moving)
        self._arguments = [*counts, *map(address_of, self._held)]
        each = 2 * with_curve[nodes.curve, 0] * np.where(nodes.apart, self._groups, 1)
        self._vectors, self._capacity = int(each.sum()), max(VECTORS, int(each.max()))

    def __call__(
        self, found: Derivatives, samples: LikelihoodBatch, jacobian: Floats, priors: Sequence[tuple[int, float]] = (),
        *, whitened: bool = False,
    ) -> Factored:  # fmt: skip
        """Triangles of N binaries.

        Parameters
        ----------
        jacobian
            ``(N, 13, 13)``, d parameter / d coordinate.
        priors
            Gaussian ones: the place of a coordinate, and one over the width.
        whitened
            Whether the derivatives themselves are wanted.
        """
        rows = np.zeros((COLUMNS, -(-len(priors) // LANES) * LANES))
        for place, (coordinate, value) in enumerate(priors):
            rows[coordinate, place] = value
        factors = np.stack(
            [
                found.plus,
                found.cross.real,
                found.cross.imag,
                found.plus_slope,
                found.cross_slope.real,
                found.cross_slope.imag,
            ],
            axis=-1,
        )
        given = {
            Argument.STRAIN: _complex(found.h), Argument.DERIVATIVES: _complex(found.derivatives),
            Argument.MODE_FACTORS: np.ascontiguousarray(factors), Argument.JACOBIAN: np.ascontiguousarray(jacobian),
            Argument.PRIOR_ROWS: rows, Argument.ROOT: np.empty((len(samples), COLUMNS, COLUMNS)),
        }  # fmt: skip
        if whitened:
            given[Argument.WHITENED] = np.empty((len(samples), self._vectors, COLUMNS, LANES))
        squares = self._call(given, found.status, samples, rows.shape[1] // LANES)
        return Factored(given[Argument.ROOT], squares, given.get(Argument.WHITENED))

    def squares(self, found: Modes, phases: Floats | None, samples: LikelihoodBatch) -> Floats:
        """Squared signal-to-noise ratios of N binaries, ``(N, D)``.

        Parameters
        ----------
        phases
            Of the strongest mode of each order, ``(N, G, K)``, which say when it passes the nodes; None for detectors
            that stand.
        """
        factors = np.zeros((*found.plus.shape, FACTORS))
        factors[..., 0], factors[..., 1], factors[..., 2] = found.plus, found.cross.real, found.cross.imag
        given = {Argument.STRAIN: _complex(found.h), Argument.MODE_FACTORS: factors}
        if phases is not None:
            given[Argument.PHASES] = np.ascontiguousarray(phases)
        return self._call(given, found.status, samples)

    def _call(
        self,
        given: dict[Argument, NDArray[np.generic]],
        status: NDArray[np.uint8],
        samples: LikelihoodBatch,
        priors: int = 0,
    ) -> Floats:
        sky, squares = np.empty((len(samples), len(Sky))), np.empty((len(samples), self._detectors))
        names = (
            "right_ascension",
            "declination",
            "polarization_angle",
            "coalescence_time",
            "distance_mpc",
            "total_mass",
        )
        for column, name in enumerate(names):
            sky[:, column] = samples[name]
        given |= {Argument.SKY: sky, Argument.STATUS: np.ascontiguousarray(status), Argument.SQUARES: squares}
        numbers = {argument: address_of(array) for argument, array in given.items()}
        numbers |= {
            Argument.ROWS: len(samples), Argument.PRIORS: priors, Argument.WHITENED_SIZE: self._vectors,
            Argument.CAPACITY: self._capacity,
        }  # fmt: skip
        workspace, needed = _workspace, scratch_size(self._detectors, self._capacity)
        if workspace.scratch.size < needed:
            workspace.reserve(needed)
        numbers[Argument.SCRATCH] = workspace.scratch_at
        rest = [numbers.get(argument, 0) for argument in list(Argument)[len(self._arguments) :]]
        workspace.arguments[:] = [*self._arguments, *rest]
        if load_factorisation()(*workspace.addresses) != 0:
            raise RuntimeError("The factorisation stopped with an error.")
        return squares


def _arms(detector: Detector) -> Floats:
    """``(3, 5)``, as :data:`~bnserve_inference.fisher_kernel._layout.ARM` says."""
    found = np.zeros((ARMS, ARM))
    if detector.arms is None:
        found[:, 3], axes = np.linalg.eigh(0.5 * (detector.response + detector.response.T))
        found[:, :3] = axes.T
        return found
    for line, weight, arm in zip(found, (0.5, -0.5), detector.arms, strict=False):
        length = float(np.linalg.norm(arm))
        line[:3], line[3], line[4] = arm / length, weight, length / LIGHT_SPEED
    return found


def _complex(array: NDArray[np.generic]) -> NDArray[np.complex128]:
    return np.ascontiguousarray(array, np.complex128)
