"""The noise estimated from strain: medians over pieces (Welch 1967; Allen et al. 2012, Phys. Rev. D 85, 122006)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_inference.strain._quality import usable
from bnserve_inference.strain._samples import Strain
from bnserve_protocol import AnalysisInvalid, FieldError

LEAST_PIECES = 4
"""Fewer say nothing of a median."""


class Spectrum(NamedTuple):
    """Amplitude spectral density ``asd`` in 1/sqrt(Hz) at ``frequencies`` (Hz), each ``(K,)``; of how many pieces it is
    the median, and how many were left out for gaps."""

    frequencies: NDArray[np.float64]
    asd: NDArray[np.float64]
    pieces: int
    left_out: int


def estimate_asd(strain: Strain, start_time: float, duration: float, segment: float) -> Spectrum:
    """The noise of a stretch of strain, by the median of periodograms.

    Pieces overlap by half, have a Hann window, and are corrected for the median of few exponential variables being less
    than their mean. Pieces with gaps, or with a signal injected into the hardware, are left out.

    Parameters
    ----------
    strain
        Of a file.
    start_time, duration
        Of the stretch: GPS seconds, and seconds.
    segment
        Seconds of a piece; the estimate is at multiples of its inverse.

    Raises
    ------
    AnalysisInvalid
        A stretch that is not inside the file, or has fewer than four good pieces.
    """
    values, good = strain.piece(start_time, duration), usable(strain)
    first = round((start_time - strain.start) / strain.interval)
    length = round(segment / strain.interval)
    if not 2 <= length <= len(values):
        raise AnalysisInvalid(
            f"Pieces of {segment:g} s do not fit into {duration:g} s of {strain.source}: give a shorter psd_segment, "
            "or a longer stretch.",
            errors=[FieldError(reason="longer than the stretch", parameter="psd_segment", value=segment)],
        )
    window = 0.5 * (1.0 - np.cos(2.0 * np.pi * np.arange(length) / length))
    starts = range(0, len(values) - length + 1, length // 2)
    kept = [begin for begin in starts if good[first + begin : first + begin + length].all()]
    if len(kept) < LEAST_PIECES:
        raise AnalysisInvalid(
            f"The noise of {strain.source} has only {len(kept)} of {len(starts)} pieces of {segment:g} s without a "
            f"gap, and at least {LEAST_PIECES} are needed: give a longer stretch, shorter pieces, or an ASD.",
            errors=[FieldError(reason="too few pieces", parameter="psd_duration", value=len(kept))],
        )
    powers = np.empty((len(kept), length // 2 + 1))
    for row, begin in zip(powers, kept, strict=True):
        piece = values[begin : begin + length]
        row[:] = np.square(np.abs(np.fft.rfft(window * (piece - piece.mean()))))
    density = 2.0 * strain.interval / np.sum(window**2) * np.median(powers, axis=0) / _median_of_mean(len(kept))
    frequencies = np.arange(len(density)) / (length * strain.interval)
    inside = slice(2, -1)  # the window mixes the mean into the first two, and the last is real
    return Spectrum(frequencies[inside], np.sqrt(density[inside]), len(kept), len(starts) - len(kept))


def _median_of_mean(pieces: int) -> float:
    """Median of so many exponential variables over their mean, on average: 1 - 1/2 + 1/3 - ..."""
    odd = pieces - 1 + pieces % 2
    return float(np.sum((-1.0) ** np.arange(odd) / (1.0 + np.arange(odd))))
