"""The panels of the picture."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import FuncFormatter, NullFormatter

from bnserve_service.demo.chirp import Chirp
from bnserve_surrogate.training.data.noise import advanced_ligo_design, einstein_telescope_d

INK, PALE, FAINT = "#1f2933", "#5f6c7b", "#e4e8ee"
SIGNAL, MERGER, NOISE = "#17508f", "#c8452d", "#7a8b99"
MODES = {1: "#2a8c6f", 2: "#5b8cc4", 3: "#b5652a", 4: "#8a4fa3"}
"""Of the further modes, by their order m."""

STYLE: dict[str, Any] = {
    "font.size": 10.5,
    "text.color": INK,
    "axes.edgecolor": "#b6c0cb",
    "axes.labelcolor": INK,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.titlelocation": "left",
    "axes.titlesize": 11.5,
    "axes.titleweight": "bold",
    "grid.color": FAINT,
    "grid.linewidth": 0.8,
    "xtick.color": PALE,
    "ytick.color": PALE,
    "xtick.minor.size": 0.0,
    "ytick.minor.size": 0.0,
    "xtick.major.size": 0.0,
    "ytick.major.size": 0.0,
}

LAST_SECONDS = 2.0
INSET = (-0.028, 0.0025)
"""Seconds from the merger."""
LIGO_FROM = 20.0
"""Hz: below, the fit of the design curve leaves the curve by more than a tenth."""
TRACK_UNTIL = 1e-3
"""Seconds before the merger; later, there is no frequency that the signal passes slowly."""


def strain_panel(axes: Axes, chirp: Chirp) -> None:
    """h_plus(t): the last seconds, and the last cycles in an inset."""
    shown = (chirp.times > -LAST_SECONDS) & (chirp.times < 0.04)
    strain = 1e22 * chirp.strain
    largest = 1.08 * float(np.abs(strain[shown]).max()) or 1.0  # nothing, where no mode is seen from this direction
    axes.set_title("Strain")
    axes.plot(chirp.times[shown], strain[shown], color=SIGNAL, linewidth=0.35)
    axes.set(xlim=(-LAST_SECONDS, 0.04), ylim=(-largest, 1.9 * largest), xlabel="time from the merger (s)")
    axes.set_yticks([tick for tick in axes.get_yticks() if abs(tick) < 0.9 * largest])  # the inset has none of them
    axes.set_ylabel(r"$h_+(t)$   ($10^{-22}$)")
    inset = axes.inset_axes((0.03, 0.57, 0.72, 0.43))
    zoomed = (chirp.times > INSET[0]) & (chirp.times < INSET[1])
    inset.plot(1e3 * chirp.times[zoomed], strain[zoomed], color=SIGNAL, linewidth=1.3)
    inset.axvline(0.0, color=MERGER, linewidth=1.0, linestyle=(0, (4, 3)))
    inset.set(xlim=(1e3 * INSET[0], 1e3 * INSET[1]), ylim=(-largest, largest), yticks=[])
    inset.set_xlabel("the last cycles (ms)", fontsize=9.5, labelpad=2)
    inset.tick_params(labelsize=9)
    inset.spines["left"].set_visible(False)
    inset.text(1e3 * INSET[1], 0.86 * largest, "merger", color=MERGER, fontsize=9.5, ha="right")


def amplitude_panel(axes: Axes, chirp: Chirp) -> None:
    """2 sqrt(f) abs(h_plus(f)), mode by mode, against the amplitude spectral densities of noise.

    The squared signal-to-noise ratio of a mode is the integral of (their ratio)^2 over ln f.
    """
    frequencies = chirp.frequencies
    effective = 2.0 * np.sqrt(frequencies) * chirp.amplitude
    telescope = np.sqrt(einstein_telescope_d(frequencies))
    above_20 = frequencies[frequencies >= LIGO_FROM]
    axes.set_title("Amplitude against noise" if len(chirp.amplitudes) == 1 else "Modes against noise")
    axes.fill_between(frequencies, telescope, effective, where=(effective > telescope).tolist(), color=SIGNAL,
                      alpha=0.07, linewidth=0)  # fmt: skip
    axes.loglog(frequencies, effective, color=SIGNAL, linewidth=2.0)
    axes.loglog(above_20, np.sqrt(advanced_ligo_design(above_20)), color=NOISE, linewidth=1.4)
    axes.loglog(frequencies, telescope, color=NOISE, linewidth=1.4, linestyle=(0, (5, 2)))
    lowest = 1.2e-25 if len(chirp.amplitudes) == 1 else 3e-28
    axes.set(xlim=(frequencies[0], 3000.0), ylim=(lowest, max(4e-21, 2.0 * float(effective.max()))))
    axes.set(xlabel="frequency (Hz)", ylabel=r"spectral amplitude  (Hz$^{-1/2}$)")
    axes.annotate(r"$2\sqrt{f}\,|h_+(f)|$", (10.0, float(np.interp(10.0, frequencies, effective))), (6, 8),
                  textcoords="offset points", color=SIGNAL)  # fmt: skip
    axes.text(58.0, 6.0e-24, "Advanced LIGO", color=PALE, fontsize=9.5)
    axes.text(6.5 if len(chirp.amplitudes) == 1 else 40.0, 2.1e-25, "Einstein Telescope (D)", color=PALE, fontsize=9.5,
              bbox={"facecolor": "white", "alpha": 0.75, "linewidth": 0.0, "pad": 0.5})  # fmt: skip
    _further_modes(axes, chirp)
    _plain_frequencies(axes.xaxis)


def _further_modes(axes: Axes, chirp: Chirp) -> None:
    """All but the first, each with its (l, m) near the left, side by side, so that none hides another."""
    frequencies, bottom = chirp.frequencies, axes.get_ylim()[0]
    for place, ((degree, order), amplitude) in enumerate(list(chirp.amplitudes.items())[1:]):
        effective = 2.0 * np.sqrt(frequencies) * amplitude
        seen = effective > bottom
        if not seen.any():  # in this direction
            continue
        axes.loglog(frequencies[seen], effective[seen], color=MODES[order], linewidth=1.3)
        at = int(np.searchsorted(frequencies[seen], 5.2 * 1.55 ** (place % 4)))
        axes.annotate(
            f"({degree}, {order})", (float(frequencies[seen][at]), float(effective[seen][at])), (0, 3),
            textcoords="offset points", color=MODES[order], fontsize=8.5,
        )  # fmt: skip


def track_panel(axes: Axes, chirp: Chirp) -> None:
    """The frequency that the signal passes, against the time that is left."""
    shown = chirp.until_merger > TRACK_UNTIL
    until, frequencies = chirp.until_merger[shown], chirp.frequencies[shown]
    axes.set_title("Time-frequency track")
    axes.loglog(until, frequencies, color=SIGNAL, linewidth=2.0)
    axes.set(xlim=(1.6 * until[0], TRACK_UNTIL), ylim=(frequencies[0] * 0.8, 2400.0))
    axes.set(xlabel="time until the merger", ylabel="frequency (Hz)")
    marks = {3600.0: "1 h", 60.0: "1 min", 1.0: "1 s", 1e-2: "10 ms", 1e-3: "1 ms"}
    axes.set_xticks(list(marks), list(marks.values()))
    axes.xaxis.set_minor_formatter(NullFormatter())
    for frequency, offset, side in ((10.0, (9, -6), "left"), (20.0, (9, -6), "left"), (100.0, (9, -6), "left"),
                                    (1000.0, (-9, 3), "right")):  # fmt: skip
        left = chirp.seconds_from(frequency)
        axes.plot([left], [frequency], "o", color=MERGER, markersize=5)
        axes.annotate(
            f"{frequency:g} Hz, {spoken(left)}", (left, frequency), offset, textcoords="offset points", ha=side,
            color=PALE, fontsize=9.5,
        )  # fmt: skip
    _plain_frequencies(axes.yaxis)


def spoken(seconds: float) -> str:
    """A time to a few digits, in the unit that a reader would choose."""
    for unit, size in (("h", 3600.0), ("min", 60.0), ("s", 1.0)):
        if seconds >= size * (1.0 if unit == "s" else 5.0):
            return f"{seconds / size:.3g} {unit}"
    return f"{1e3 * seconds:.2g} ms"


def _plain_frequencies(axis: Any) -> None:
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axis.set_minor_formatter(NullFormatter())
