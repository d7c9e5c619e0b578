"""Evaluating the likelihood of an analysis with a waveform model in this process, for the rows for which it can be."""

from __future__ import annotations

import functools
import threading
from collections.abc import Callable
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_inference._draws import Draws
from bnserve_inference._gradients import Gradients, Marginal
from bnserve_inference._marginalisation import DistanceIntegral
from bnserve_inference._modes import modes_of, orders
from bnserve_inference._phase_integral import PhaseIntegral
from bnserve_inference._products import ProductsByDetector
from bnserve_inference._rows import check_batch, row_statuses
from bnserve_inference._signals import Tile, signals_of
from bnserve_inference._time_integral import TimeIntegral
from bnserve_inference.marginal_kernel import Integrals, Phase
from bnserve_protocol import (
    Analysis,
    DetectorProducts,
    InvalidRows,
    Likelihood,
    LikelihoodBatch,
    LikelihoodBatchLike,
    LikelihoodCounts,
    LikelihoodGradients,
    LikelihoodValues,
    MarginalisedDraws,
    RowStatus,
    Seed,
    WaveformModel,
    by_given_names,
    check_invalid_rows,
    check_model_of,
    integrated_names,
    random_numbers,
    refuse_rows,
    samples_of,
)

Complex = NDArray[np.complex128]
Floats = NDArray[np.float64]

_TILE_POINTS = 2**16
"""Strain that is worked on at once, in points: a megabyte, which stays in the cache between model and contraction."""
_MOST_ROWS = 256
_MOST_ROWS_DIFFERENTIATED, _TILE_POINTS_DIFFERENTIATED = 1024, 2**18
"""Derivatives do not fit the cache in any case: the more at once, the fewer calls."""
_TILE_TIMES = 2**16
"""Sums over times that are kept at once."""


class LocalLikelihood:
    """A likelihood evaluated in this process; satisfies :class:`bnserve_protocol.Likelihood`.

    A row's bits depend on the row, the analysis and the model alone. Safe to share between threads. Can be pickled,
    copied and sent to other processes wherever its model can; what arrives there counts its rows from zero.

    Parameters
    ----------
    model
        Any waveform model.
    analysis
        Of any kind.
    invalid_rows
        ``"flag"``: rows outside the prior's or the model's range are -inf and counted. ``"error"``: they raise.

    Raises
    ------
    AnalysisInvalid
        The analysis was made for another model, or for modes that this one lacks.
    """

    def __init__(self, model: WaveformModel, analysis: Analysis, *, invalid_rows: InvalidRows = "flag") -> None:
        check_model_of(analysis, model.description)
        self._model, self._analysis, self._invalid_rows = model, analysis, check_invalid_rows(invalid_rows)
        settings, modes = analysis.settings, modes_of(analysis.settings, model.description)
        distances = settings.distance_marginalisation
        self._distance = None if distances is None else DistanceIntegral(distances)
        prior = None if self._distance is None else self._distance.numbers
        self._phases, self._integrals = None, Integrals(Phase.KEPT, prior)
        if settings.phase_marginalisation and len(orders(modes)) > 1:
            self._phases = PhaseIntegral(orders(modes), prior)
        elif settings.phase_marginalisation:
            self._integrals = Integrals(Phase.BESSEL, prior)
        self._signals = signals_of(model, analysis, self._phases)
        self._fixed = {"reference_phase": 0.0} if settings.phase_marginalisation else {}
        if self._distance is not None:
            self._fixed["distance_mpc"] = self._distance.reference
        self._tile = min(_MOST_ROWS, max(1, _TILE_POINTS // self._signals.samples))
        self._wide_tile = min(_MOST_ROWS_DIFFERENTIATED, max(1, _TILE_POINTS_DIFFERENTIATED // self._signals.samples))
        self._times = None
        if settings.time_marginalisation is not None:
            self._times = TimeIntegral(settings, len(self._signals.frequencies))
            fitting = max(1, _TILE_TIMES // (self._times.times * self._signals.groups))
            self._tile, self._wide_tile = min(self._tile, fitting), min(self._wide_tile, fitting)
        turned = self._phases
        if settings.phase_marginalisation and turned is None:
            turned = PhaseIntegral(orders(modes))
        self._draws = Draws(self._times, turned, self._distance, self._marginalised, self._at_one_phase)
        self._counts = LikelihoodCounts()
        self._lock = threading.Lock()

    @property
    def analysis(self) -> Analysis:
        """What is evaluated."""
        return self._analysis

    @property
    def model(self) -> WaveformModel:
        """What makes the waveforms."""
        return self._model

    @property
    def counts(self) -> LikelihoodCounts:
        """Rows evaluated through this object so far, and how many of them were -inf, by reason."""
        return self._counts

    @property
    def frequencies(self) -> Floats:
        """Where the model is evaluated, ``(M,)`` in Hz."""
        return self._signals.frequencies

    def log_likelihood(self, batch: LikelihoodBatchLike) -> Floats:
        """ln of the ratio of the likelihoods with and without the signal, ``(N,)``.

        Raises
        ------
        InvalidParameters
            Names, shapes or calibration nodes that do not fit the analysis; :func:`.samples_of` says which may be.
        OutOfDomain
            With ``invalid_rows="error"``: rows outside the prior's or the model's range.
        """
        values = self.evaluate(batch)
        if self._invalid_rows == "error":
            refuse_rows(values.status)
        return values.log_likelihood

    def evaluate(self, batch: LikelihoodBatchLike) -> LikelihoodValues:
        """As :meth:`log_likelihood`, with the status of every row; rows that cannot be evaluated never raise."""
        coerced = samples_of(batch, self._analysis.settings)
        result = np.full(len(coerced), -np.inf)

        def keep(rows: NDArray[np.intp], tile: Tile) -> Floats:
            result[rows] = values = self._combine(tile)
            return values

        status = self._by_tiles(coerced, keep)
        if status.any():
            result[status != RowStatus.OK] = -np.inf
        return LikelihoodValues(result, status)

    def gradients(self, batch: LikelihoodBatchLike) -> LikelihoodGradients:
        """As :meth:`evaluate`, with the exact gradient of every row, ``(N, P)``, in the parameters that are sampled.

        Samples by the names of other programs have a gradient by those.

        Raises
        ------
        InvalidParameters
            As :meth:`log_likelihood`.
        InvalidRequest
            The model has no derivatives.
        """
        differentiated = self._gradients
        coerced = samples_of(batch, self._analysis.settings)
        values, gradient = np.full(len(coerced), -np.inf), np.full((len(coerced), len(differentiated.names)), np.nan)

        def keep(rows: NDArray[np.intp], evaluate: Callable[[], tuple[Floats, Floats]]) -> Floats:
            values[rows], gradient[rows] = evaluate()
            return np.where(np.isfinite(gradient[rows]).all(axis=1), values[rows], np.nan)

        status = self._by_tiles(coerced, keep, differentiated.of_rows, self._wide_tile)
        values[status != RowStatus.OK], gradient[status != RowStatus.OK] = -np.inf, np.nan
        found = LikelihoodGradients(values, gradient, differentiated.names, status)
        return by_given_names(batch, coerced, self._analysis.settings, found)

    def products(self, batch: LikelihoodBatchLike) -> DetectorProducts:
        """Inner products, signal-to-noise ratios and ln L by detector, of the signals that samples describe.

        Raises
        ------
        InvalidParameters
            As :meth:`log_likelihood`; also where what the analysis integrates over is left out.
        """
        coerced = samples_of(batch, self._by_detector.settings)
        found = self._by_detector(coerced)
        self._count(found.status)
        return found

    def draw_marginalised(self, batch: LikelihoodBatchLike, *, seed: Seed) -> MarginalisedDraws:
        """One draw for each sample of what is integrated over, by its posterior given the rest.

        Raises
        ------
        InvalidParameters
            As :meth:`log_likelihood`.
        InvalidRequest
            Nothing is integrated over, or the seed is none.
        """
        settings = self._analysis.settings
        coerced = samples_of(batch, settings)
        uniforms = random_numbers(coerced, settings, seed)
        drawn = {name: np.full(len(coerced), np.nan) for name in integrated_names(settings)}
        values = np.full(len(coerced), -np.inf)

        def keep(rows: NDArray[np.intp], tile: Tile) -> Floats:
            found, values[rows] = self._draws.of(tile, uniforms[rows])
            all_finite = np.asarray(values[rows])
            for name, numbers in found.items():
                drawn[name][rows] = numbers
                all_finite = np.where(np.isfinite(numbers), all_finite, np.nan)
            return all_finite

        status = self._by_tiles(coerced, keep)
        for numbers in drawn.values():
            numbers[status != RowStatus.OK] = np.nan
        values[status != RowStatus.OK] = -np.inf
        return MarginalisedDraws(drawn, values, status)

    def __reduce__(self) -> tuple[Any, ...]:
        return _bind_again, (type(self), self._model, self._analysis, self._invalid_rows)

    @functools.cached_property
    def _by_detector(self) -> ProductsByDetector:
        return ProductsByDetector(self._model, self._analysis)

    @functools.cached_property
    def _gradients(self) -> Gradients:
        marginal = Marginal(self._marginalised, self._slopes)
        return Gradients(self._model, self._analysis, self._signals, self._times, marginal)

    def _signals_of(self, batch: LikelihoodBatch, fixed: dict[str, float]) -> tuple[Tile, Tile]:
        tile = self._signals.tile(batch, fixed)
        return tile, tile

    def _by_tiles(
        self,
        batch: LikelihoodBatch,
        keep: Callable[[NDArray[np.intp], Any], Floats],
        ask: Callable[[LikelihoodBatch, dict[str, float]], tuple[Tile, Any]] | None = None,
        size: int = 0,
    ) -> NDArray[np.uint8]:
        """The status of every row; ``keep`` is given the signals of those that can be evaluated, a tile at a time, or
        what ``ask`` has beside them, and returns numbers that are finite where all of a row is."""
        ask, size = ask or self._signals_of, size or self._tile
        check_batch(batch, self._analysis.settings)
        status = row_statuses(batch, self._analysis.settings, self._model.description)
        good = np.flatnonzero(status == RowStatus.OK)
        for start in range(0, len(good), size):
            rows = good[start : start + size]
            tile, given = ask(batch.rows(rows), self._fixed)
            found = np.array(tile.status)
            found[tile.empty & (found == RowStatus.OK)] = RowStatus.OUT_OF_BAND
            # Rows that the model flagged are NaN, and so is what numbers without end make of others.
            with np.errstate(invalid="ignore", over="ignore", divide="ignore"):
                values = keep(rows, given)
            found[(found == RowStatus.OK) & ~np.isfinite(values)] = RowStatus.NOT_FINITE
            status[rows] = found
        self._count(status)
        return status

    def _combine(self, tile: Tile) -> Floats:
        if self._times is not None:
            return self._times.log_likelihood(tile.contract, tile.sky, self._marginalised)
        inner = tile.contract(tile.sky, 1, 0.0, False)
        return self._marginalised(np.ascontiguousarray(inner.data[:, :, 0].T), inner.norms)

    def _marginalised(self, products: Complex, norms: NDArray[Any]) -> Floats:
        """ln L of <d|h>, ``(G, K)``, and <h|h>, ``(C, K)``."""
        if self._phases is not None:
            return self._phases.log_likelihood(products, norms)
        return self._integrals(products, norms)

    def _slopes(self, products: Complex, norms: NDArray[Any]) -> tuple[Floats, Complex, NDArray[Any]]:
        """As :meth:`_marginalised`, and what it changes by with both; a complex z counts as the real part of this times
        dz."""
        if self._phases is not None:
            return self._phases.slopes(products, norms)
        return self._integrals.slopes(products, norms)

    def _at_one_phase(self, products: Floats, norms: Floats) -> Floats:
        if self._distance is not None:
            return self._distance.log_likelihood(products, norms, False)
        return products - 0.5 * norms

    def _count(self, status: NDArray[np.uint8]) -> None:
        found = np.bincount(status, minlength=len(RowStatus))
        with self._lock:
            before = self._counts
            self._counts = msgspec.structs.replace(
                before,
                rows=before.rows + len(status),
                not_finite=before.not_finite + int(found[RowStatus.NOT_FINITE]),
                out_of_domain=before.out_of_domain + int(found[RowStatus.OUT_OF_DOMAIN]),
                out_of_band=before.out_of_band + int(found[RowStatus.OUT_OF_BAND]),
                out_of_prior=before.out_of_prior + int(found[RowStatus.OUT_OF_PRIOR]),
            )


def _bind_again(
    cls: type[LocalLikelihood], model: WaveformModel, analysis: Analysis, invalid_rows: InvalidRows
) -> LocalLikelihood:
    """A likelihood that was pickled or copied."""
    return cls(model, analysis, invalid_rows=invalid_rows)


def likelihood(model: WaveformModel, analysis: Analysis, *, invalid_rows: InvalidRows = "flag") -> Likelihood:
    """The likelihood of an analysis with a model: evaluated where the model is.

    A model that has a method ``likelihood`` of its own, as remote ones do, is asked for it; for any other model it is a
    :class:`LocalLikelihood`. Parameters and errors are the same.
    """
    remote = getattr(model, "likelihood", None)
    if remote is not None:
        found: Likelihood = remote(analysis, invalid_rows=invalid_rows)
        return found
    return LocalLikelihood(model, analysis, invalid_rows=invalid_rows)
