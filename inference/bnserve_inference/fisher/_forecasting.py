"""Fisher matrices of batches of binaries."""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._derivatives import differentiates
from bnserve_inference._modes import QUADRUPOLE, chosen_modes, orders
from bnserve_inference.fisher._factorisation import Factorisation
from bnserve_inference.fisher._matrix import LARGEST_CONDITION, condition
from bnserve_inference.fisher._network import Network
from bnserve_inference.fisher._nodes import nodes_of
from bnserve_inference.fisher._places import flagged, without_the_unplaced
from bnserve_protocol import (
    DEFAULT_FORECAST,
    DERIVATIVE_NAMES,
    PARAMETER_NAMES,
    SKY_NAMES,
    BatchLike,
    Derivatives,
    EvaluationOptions,
    FieldError,
    Forecast,
    ForecastOptions,
    GridLike,
    InvalidRequest,
    LikelihoodBatch,
    LikelihoodBatchLike,
    ModelDescription,
    RowStatus,
    coordinate_jacobian,
    forecast_batch,
)

Floats = NDArray[np.float64]

NAMES = (*(name if name != "time_shift" else "coalescence_time" for name in PARAMETER_NAMES), *SKY_NAMES)
"""Of a signal, in the order of its derivatives: 13."""
_NUMBERS = 2**18
"""Complex numbers of derivatives at once: 4 MiB, which stay near the processor."""
_ROWS = 1024
"""Whose coordinates are found at once."""
_NARROWEST = 1e-100
"""Of priors: one over its square is a number."""
_REFERENCES = 0.01, 1e6
"""Hz; lower, double precision leaves nothing of a phase."""


class Differentiable(Protocol):
    """A model that has derivatives."""

    @property
    def description(self) -> ModelDescription:
        """Name, ranges, modes."""

    def predict_derivatives(
        self, frequencies: GridLike, batch: BatchLike, *, options: EvaluationOptions
    ) -> Derivatives:
        """Modes and their derivatives."""


def forecast(
    model: Differentiable,
    network: Network,
    samples: LikelihoodBatchLike,
    options: ForecastOptions = DEFAULT_FORECAST,
) -> Forecast:
    """Fisher matrices and signal-to-noise ratios of N binaries in a network.

    Parameters
    ----------
    model
        Whose waveforms; it has derivatives. A remote one makes the forecasts where it is, to the same bits.
    network
        The detectors, their noise and the band.
    samples
        N binaries, as a likelihood takes them, with distance (Mpc) and ``coalescence_time`` (s from the network's
        trigger); those whose declination is beyond a pole, or who merge before 1980 or after 2100, are flagged as
        ``OUT_OF_DOMAIN``.
    options
        Coordinates, priors, modes.

    Returns
    -------
    N matrices of P = 13 coordinates, and what follows from them. Rows outside the model's ranges are flagged and NaN.

    Raises
    ------
    InvalidRequest
        The model has no derivatives, coordinates are none or do not tell binaries apart, or priors have no width.
    InvalidParameters
        Samples that are none.
    """
    if (own := getattr(model, "forecast", None)) is not None:  # a remote one, which makes them where it is
        remote: Forecast = own(network, samples, options)
        return remote
    instead = "take one that has, as all shipped ones do, or ask for signal-to-noise ratios alone"
    differentiate = differentiates(model, "predict_derivatives", advice=f", which forecasts are made of: {instead}")
    batch, lost = without_the_unplaced(forecast_batch(samples), network)
    names, widths = options.names, dict(options.priors or {})
    _check(options)
    modes = chosen_modes(options.modes, model.description)
    nodes = nodes_of(network, orders(modes))
    factorisation = Factorisation(network, nodes, modes)
    inverse_widths = [(names.index(name), 1.0 / width) for name, width in widths.items()]
    asked = EvaluationOptions(modes=modes, alignment=options.alignment, out_of_domain="flag")  # type: ignore[arg-type]
    size = max(1, _NUMBERS // (len(nodes.frequencies) * len(modes) * len(DERIVATIVE_NAMES)))
    roots, squares = [np.zeros((0, len(names), len(names)))], [np.zeros((0, len(network.noise)))]
    status = [np.zeros(0, np.uint8)]
    for first, block in zip(range(0, len(batch), _ROWS), batch.split(_ROWS), strict=True):
        jacobian, held = _jacobian(model, block, options, first)
        for start in range(0, len(block), size):
            rows = slice(start, start + size)
            part = block.rows(rows)
            found = differentiate(nodes.frequencies, part.waveform_batch(), options=asked)
            factored = factorisation(found, part, jacobian[rows], inverse_widths)
            roots.append(factored.root)
            squares.append(factored.squares)
            status.append(np.maximum(found.status, held[rows]))
    flags = flagged(np.concatenate(status), lost)
    return _forecast(names, model, batch, np.concatenate(roots), np.concatenate(squares), flags)


def _check(options: ForecastOptions) -> None:
    """Refuse priors and a reference frequency that are none."""
    for name, width in (options.priors or {}).items():
        if name not in options.names or not _NARROWEST <= width < np.inf:
            raise InvalidRequest(
                f"A prior is a positive width, {_NARROWEST:g} or more, of one of {', '.join(options.names)}; got "
                f"{width!r} for '{str(name)[:80]}'.",
                errors=[FieldError(reason="no prior", parameter=str(name)[:80])],
            )
    least, most = _REFERENCES
    if not least <= options.reference_frequency <= most:
        raise InvalidRequest(
            f"The reference frequency of a forecast is {least:g} to {most:g} Hz; got {options.reference_frequency!r}.",
            errors=[FieldError(reason="no reference", parameter="reference_frequency")],
        )


def _jacobian(
    model: Differentiable, block: LikelihoodBatch, options: ForecastOptions, first: int = 0
) -> tuple[Floats, NDArray[np.uint8]]:
    """Of parameters by coordinates, ``(N, 13, 13)``: those of the sky are kept; and a RowStatus each. Rows that are not
    evaluated stand for nothing; ``first`` is the number of the block's first row.

    The phase of the (2, 2) at the reference frequency, which has to be in the band, is held while other coordinates
    change.
    """
    plain = tuple("time_shift" if name == "coalescence_time" else name for name in options.coordinates)
    how = {"modes": (QUADRUPOLE,), "alignment": options.alignment, "out_of_domain": "flag", "above_band": "error"}
    alone = EvaluationOptions(**how)  # type: ignore[arg-type]  # checked there
    there = model.predict_derivatives(np.array([options.reference_frequency]), block.waveform_batch(), options=alone)
    good = np.flatnonzero(there.status == RowStatus.OK)
    out, count = np.zeros((len(block), len(NAMES), len(NAMES))), len(PARAMETER_NAMES)
    out[:, range(count, len(NAMES)), range(count, len(NAMES))] = 1.0
    if not len(good):
        return out, there.status
    out[good, :count, :count] = coordinate_jacobian(block.waveform_batch().rows(good), plain, rows=first + good)
    slopes = (there.derivatives[good, 0, :, 0] / there.h[good, 0]).imag
    changes = out[good][:, [NAMES.index(name) for name in DERIVATIVE_NAMES]]
    out[good, NAMES.index("reference_phase")] -= (slopes[:, :, None] * changes).sum(axis=1)
    return out, there.status


def _forecast(
    names: tuple[str, ...], model: Differentiable, batch: LikelihoodBatch, root: Floats, squares: Floats,
    status: NDArray[np.uint8],
) -> Forecast:  # fmt: skip
    status = np.where(np.isfinite(squares).all(axis=1), status, np.maximum(status, RowStatus.NOT_FINITE)).astype(
        np.uint8
    )
    bad = status != RowStatus.OK
    root[bad], squares[bad] = np.nan, np.nan
    found = condition(root)
    singular = found > LARGEST_CONDITION
    plain = Forecast(
        names=names, snr=np.sqrt(squares.sum(axis=1)), detector_snr=np.sqrt(squares), root=root, condition=found,
        singular=singular, beyond=np.zeros((len(root), len(names)), bool), status=status,
    )  # fmt: skip
    beyond, errors = plain.beyond, plain.errors()
    for entry in model.description.parameters:
        if entry.name in names and entry.minimum is not None and entry.maximum is not None:
            value, sigma = batch[entry.name], errors[entry.name]
            beyond[:, names.index(entry.name)] = (value - sigma < entry.minimum) | (value + sigma > entry.maximum)
    return plain
