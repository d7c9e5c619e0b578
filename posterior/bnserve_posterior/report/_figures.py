"""The pictures of a run: the posterior, the data with the signal found in them, and what each detector says."""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_inference import DetectorData, detector_strain
from bnserve_posterior.results import Samples
from bnserve_posterior.running import Outcome
from bnserve_protocol import LIKELIHOOD_NAMES, LikelihoodParameters, Response, require

Floats = NDArray[np.float64]

_STYLE = {
    "font.size": 11,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.axisbelow": True,
    "legend.frameon": False,
    "savefig.dpi": 110,
}
_BLUE, _ORANGE, _GREY = "#0072b2", "#d55e00", "#8a97a5"
_SHOWN = {
    "chirp_mass": "$\\mathcal{M}$ [$M_\\odot$]", "mass_ratio": "$q$", "chi_eff": "$\\chi_{eff}$",
    "lambda_tilde": "$\\tilde\\Lambda$", "luminosity_distance": "$d_L$ [Mpc]", "theta_jn": "$\\theta_{JN}$",
    "ra": "ra", "dec": "dec",
}  # fmt: skip
_WINDOW = 0.12
"""Seconds before the merger that whitened data are shown of; as much as the eye can follow of them."""
_AFTER = 0.02
_BAND = (30.0, 400.0)
"""Hz of whitened data that are shown: where signals of neutron stars are, and most of the noise is not."""
_LASTS = 128.0
"""Seconds; no signal of two neutron stars is longer from the lowest of these frequencies on."""
_INTERVAL = (0.05, 0.5, 0.95)
_CURVES = 20
"""Samples whose signals are shown."""
_NEEDED = "The page of a run", "analyse"


def all_figures(outcome: Outcome) -> Iterator[tuple[str, Any]]:
    """Captions and figures, one after the other."""
    with _style():
        yield "The posterior: contours hold 50 and 90 %" + _lines(outcome), corner_figure(outcome)
        yield (
            f"Whitened data of each detector, {_BAND[0]:g} to {_BAND[1]:g} Hz, around the time at which the signal is "
            f"largest in that band, and the signals of {_CURVES} samples of the posterior over each other",
            data_figure(outcome),
        )
        yield "What each detector says: ln L by detector over the samples of the posterior", budget_figure(outcome)


def _lines(outcome: Outcome) -> str:
    return "; orange lines are the injection" if outcome.prepared.data.injection is not None else ""


def shown_columns(outcome: Outcome) -> dict[str, Floats]:
    """Columns of the corner plot by name: those that vary."""
    columns = {name: outcome.samples.values[name] for name in _SHOWN if name in outcome.samples.values}
    return {name: values for name, values in columns.items() if np.ptp(values) > 0.0}


def corner_figure(outcome: Outcome) -> Any:
    """Histograms of parameters and of pairs of them."""
    corner = require("corner", *_NEEDED)
    columns = shown_columns(outcome)
    truths = _truths(outcome, list(columns))
    figure = corner.corner(
        np.stack(list(columns.values()), axis=1), labels=[_SHOWN[name] for name in columns], truths=truths,
        levels=(0.5, 0.9), smooth=1.0, bins=30, color=_BLUE, truth_color=_ORANGE, plot_datapoints=False,
        plot_density=False, quantiles=_INTERVAL, max_n_ticks=3, labelpad=0.15, label_kwargs={"fontsize": 12},
        fig=require("matplotlib.figure", *_NEEDED).Figure(figsize=(1.9 * len(columns), 1.9 * len(columns))),
    )  # fmt: skip
    for axis in figure.axes:
        axis.tick_params(labelsize=8)
    for axis, (name, values) in zip(figure.axes[:: len(columns) + 1], columns.items(), strict=True):
        axis.set_title(f"{_SHOWN[name]} = {interval(values)}", fontsize=10)
    return figure


def interval(values: Floats) -> str:
    """Median and 90 % of samples, ``(N,)``, with two digits of the smaller distance, as mathematics."""
    low, middle, high = np.quantile(values, _INTERVAL)
    smaller = min(high - middle, middle - low)
    digits = max(0, 1 - math.floor(math.log10(smaller))) if smaller > 0.0 else 3
    return f"${middle:.{digits}f}^{{+{high - middle:.{digits}f}}}_{{-{middle - low:.{digits}f}}}$"


def _truths(outcome: Outcome, names: list[str]) -> list[float | None] | None:
    injection = outcome.prepared.data.injection
    if injection is None:
        return None
    from bnserve_posterior.priors import derived_parameters

    values = derived_parameters({name: np.array([value]) for name, value in injection.items()})
    return [float(values[name][0]) if name in values else None for name in names]


def data_figure(outcome: Outcome) -> Any:
    """Whitened data and signals, a row for each detector."""
    detectors = outcome.prepared.data.detectors
    figure = require("matplotlib.figure", *_NEEDED).Figure(figsize=(9.0, 2.4 * len(detectors)), layout="constrained")
    axes = figure.subplots(len(detectors), 1, squeeze=False, sharex=True)[:, 0]
    for axis, data in zip(axes, detectors, strict=True):
        end = last_seconds(data)
        signals = [whitened(end, signal) for signal in _signals(outcome, end)]
        late = end.start_time - data.start_time
        peak = late + signals[0][0][int(np.argmax(np.abs(signals[0][1])))]
        for place, (times, values) in enumerate([whitened(data, data.strain), *signals]):
            since = times - peak + (late if place else 0.0)
            near = (since > -_WINDOW) & (since < _AFTER)
            if place == 0:
                axis.plot(since[near], values[near], color=_GREY, lw=0.8, label="data")
            else:
                label = "signals of the posterior" if place == 1 else None
                axis.plot(since[near], values[near], color=_BLUE, lw=1.0, alpha=0.4, label=label)
        axis.set_ylabel(f"{data.name} [sigma]")
    figure.legend(*axes[0].get_legend_handles_labels(), loc="outside upper left", ncols=2)
    axes[-1].set_xlabel("time from the largest amplitude at the detector [s]")
    return figure


def last_seconds(data: DetectorData) -> DetectorData:
    """A grid for signals at the end of long data: of fewer frequencies, with the data's samples and no strain."""
    steps, most = len(data.asd) - 1, int(data.duration / _LASTS)
    stride = next(one for one in range(max(1, most), 0, -1) if steps % one == 0)
    asd, duration = data.asd[::stride], data.duration / stride
    start = data.start_time + data.duration - duration
    return replace(data, strain=np.zeros(len(asd), dtype=np.complex128), asd=asd, start_time=start, duration=duration)


def whitened(data: DetectorData, strain: NDArray[np.complex128]) -> tuple[Floats, Floats]:
    """Strain over the noise against time, in units of the noise within the band that is shown.

    Returns
    -------
    Seconds from the start of the segment, and values, ``(n,)`` each; of noise alone these have variance one.
    """
    frequencies = np.arange(len(data.asd)) / data.duration
    _, density = data.weighted(slice(0, len(data.asd)))
    band = (frequencies >= _BAND[0]) & (frequencies <= _BAND[1]) & (density > 0.0)
    white = np.zeros(len(data.asd), dtype=np.complex128)
    np.divide(strain, data.asd, out=white, where=band)
    samples = 2 * (len(white) - 1)
    # A real series has twice the power of its positive frequencies, each of which is T / 2 for noise.
    unit = np.sqrt(data.duration * max(1, int(np.count_nonzero(band))))
    return np.arange(samples) * data.duration / samples, np.fft.irfft(white) * samples / unit


def _signals(outcome: Outcome, data: DetectorData) -> Iterator[NDArray[np.complex128]]:
    prepared = outcome.prepared
    band = prepared.event.data
    frequencies = np.arange(len(data.asd)) / data.duration
    inside = np.flatnonzero((frequencies >= band.f_min) & (frequencies <= min(band.f_max, _BAND[1])))
    turn = np.exp(-2j * np.pi * frequencies[inside] * (band.trigger_time - data.start_time))
    response: Response = "moving" if prepared.analysis.settings.response == "moving" else "static"
    for row in range(min(_CURVES, len(outcome.samples))):
        strain = np.zeros(len(data.asd), dtype=np.complex128)
        strain[inside] = turn * detector_strain(
            data.site(), frequencies[inside], prepared.model, _binary(outcome.samples, row),
            trigger_time=band.trigger_time, modes=prepared.event.likelihood.modes, response=response,
        )  # fmt: skip
        yield strain


def _binary(samples: Samples, row: int) -> LikelihoodParameters:
    return LikelihoodParameters(**dict(zip(LIKELIHOOD_NAMES, samples.whole.values[row].tolist(), strict=True)))


def budget_figure(outcome: Outcome) -> Any:
    """Histograms of ln L by detector."""
    figure = require("matplotlib.figure", *_NEEDED).Figure(figsize=(9.0, 3.2), layout="constrained")
    axis = figure.subplots()
    values = outcome.samples.values
    names = [data.name for data in outcome.prepared.data.detectors]
    for name, colour in zip(names, (_BLUE, _ORANGE, "#009e73", "#cc79a7", _GREY), strict=False):
        axis.hist(values[f"{name}_log_likelihood"], bins=60, histtype="step", lw=1.8, color=colour, label=name)
    axis.set(xlabel="ln L of the detector", ylabel="samples", yscale="log")
    figure.legend(loc="outside upper left", ncols=len(names))
    return figure


@contextmanager
def _style() -> Iterator[None]:
    matplotlib = require("matplotlib", *_NEEDED)
    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        matplotlib.rcParams.update(_STYLE)
        yield
