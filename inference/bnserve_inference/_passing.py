"""When the modes of a signal pass frequencies: what their phases say, in the stationary-phase approximation."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._fiducial import FiducialBasis
from bnserve_inference._modes import QUADRUPOLE, options_for, orders
from bnserve_inference._splines import cardinal_spline, spline_values
from bnserve_protocol import MergerStencil, Mode, ParameterBatch, WaveformModel

Floats = NDArray[np.float64]

_NODES = 160
"""Logarithmic, between which times of a whole grid are interpolated: to a few microseconds of an hour."""
_POWER = 8.0 / 3.0
"""Of the frequency, that a time until the merger goes with at the lowest order: their product is nearly constant."""


def passing_times(
    model: WaveformModel, batch: ParameterBatch, frequencies: Floats, modes: Sequence[Mode], alignment: str
) -> Floats:
    """When the modes of each order m pass frequencies, in seconds from the coalescence: ``(N, G, M)``.

    t(f) = -(1 / 2 pi) d phase / d f of the strongest mode of each order; those of an order differ by less than a
    millisecond, in which the Earth turns by 1e-7 rad. Rows that the model does not cover are NaN.

    Parameters
    ----------
    model, alignment
        Whose phase, and what its time zero is.
    batch
        N binaries.
    frequencies
        In Hz, increasing, ``(M,)``.
    modes
        Of the signal; there are G orders among them.
    """
    nodes = np.geomspace(frequencies[0], frequencies[-1], min(_NODES, 4 + len(frequencies)))
    stencil = MergerStencil(nodes)
    asked, places = np.unique(stencil.frequencies.ravel(), return_inverse=True)
    x_nodes, x = np.log(nodes), np.log(frequencies)
    cardinal = cardinal_spline(x_nodes)
    found = np.empty((len(batch), len(orders(modes)), len(frequencies)))
    for place, order in enumerate(orders(modes)):
        leading = min(mode for mode in modes if mode[1] == order)
        options = options_for(model, (leading,), alignment=alignment, out_of_domain="flag")
        phases = model.predict_amplitude_phase(asked, batch, options=options).phase[:, places]
        slopes = stencil.slope(phases.reshape(len(batch), *stencil.frequencies.shape))
        # Row by row: the bits of a product of matrices hang on how many rows there are.
        for row, slow in enumerate(slopes * (nodes**_POWER / (-2.0 * np.pi))):
            found[row, place] = spline_values(x_nodes, slow, cardinal @ slow, x)
    return np.asarray(found / frequencies**_POWER)


def reference_times(model: WaveformModel, basis: FiducialBasis) -> tuple[Floats, Floats]:
    """What relative binning compares the modes of each order with: phases (radians) at the nodes, and when they are
    passed (seconds from the coalescence), ``(G, L)`` each.
    """
    f = basis.linear_nodes
    phases = np.array([np.angle(basis.reference(model, order, f)) for order in basis.orders])
    found = []
    for order in basis.orders:  # modes of order m pass f when (2, 2) passes 2 f / m
        stencil = MergerStencil(QUADRUPOLE[1] / order * f)
        asked, places = np.unique(stencil.frequencies.ravel(), return_inverse=True)
        phase = model.predict_amplitude_phase(asked, basis.fiducial, options=basis.options).phase[0]
        found.append(stencil.slope(phase[places].reshape(stencil.frequencies.shape)) / (-2.0 * np.pi))
    return phases, np.array(found)
